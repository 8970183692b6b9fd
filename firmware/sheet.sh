#!/usr/bin/env bash
# Measures more arms of specs/ than check.sh, in f32 at opt-level 3, and writes sheet.txt: the arms beside
# those of measured.txt that `denhart check --target cortex-m4f` compares an arm with.
#   firmware/sheet.sh [ARM ...]    without arms those of sheet.txt; with arms the others stay
# After firmware/check.sh, whose toolchain and programs it uses. Then the table:
#   DENHART_ACCEPT=1 cargo test -p denhart-cli --test cost
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
if (($# == 0)); then
  mapfile -t arms < <(awk '!/^#/ && $2 == "forward" {print $1}' sheet.txt)
  set -- "${arms[@]}"
fi
tools=${DENHART_FIRMWARE_TOOLCHAIN:-${XDG_CACHE_HOME:-$HOME/.cache}/denhart/firmware}
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")
target=thumbv7em-none-eabihf
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS
CARGO_TARGET_DIR=$built/host cargo build --locked --quiet --release -p firmware-host
host() { "$built/host/release/firmware-host" "$@"; }
chip() {
  RUSTC=$tools/bin/rustc CARGO_TARGET_DIR=$built/chip cargo build --locked --quiet --release --target $target \
    -p firmware-chip --bin "$1" --features "fpu,extra$2"
}
flash() {
  chip size "$1"
  host flash "$built/chip/$target/release/size"
}
rows=$(mktemp)
trap 'rm -f "$rows" "$rows.all"' EXIT
for arm; do
  export DENHART_FIRMWARE_ARM=$arm
  chip measure ''
  measured=$("$tools/bin/qemu-system-arm" -M mps2-an386 -icount shift=0,sleep=off -display none -monitor none -serial none \
    -chardev stdio,id=output -semihosting-config enable=on,target=native,chardev=output \
    -kernel "$built/chip/$target/release/measure" </dev/null)
  empty=$(flash '')
  for function in forward forward_and_jacobian inverse inverse_near inverse_branch; do
    bytes=$(($(flash ",$function") - empty))
    awk -v arm="$arm" -v function_="$function" -v bytes="$bytes" '
      $2 == function_ { if ($7 > stack) stack = $7; if ($3 == "random") { median = $4; p99 = $5 } }
      END { printf "%-22s %-20s %7d %7d %8d %8d\n", arm, function_, bytes, stack, median, p99 }' <<<"$measured" | tee -a "$rows"
  done
  bytes=$(($(flash ,forward,forward_and_jacobian,inverse,inverse_near) - empty))
  printf '%-22s %-20s %7d %7s %8s %8s\n' "$arm" together "$bytes" - - - | tee -a "$rows"
done
kept=$(awk -v arms=" $* " '!/^#/ && $1 != "arm" && !index(arms, " " $1 " ")' sheet.txt)
{
  echo "# Measured by firmware/sheet.sh as measured.txt is: f32, opt-level 3. stack: the most of all cases; median, p99: of random targets."
  echo "# compiler: $("$tools/bin/rustc" -V)"
  printf '%-22s %-20s %7s %7s %8s %8s\n' arm function flash stack median p99
  [[ -z $kept ]] || echo "$kept"
  cat "$rows"
} >"$rows.all"
mv "$rows.all" sheet.txt
