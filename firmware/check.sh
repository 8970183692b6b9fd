#!/usr/bin/env bash
# Generated code on an emulated Cortex-M4F: no panic, no heap, no double precision in f32, the bits of the host, and what
# it costs, compared with measured.txt; an exported arm in C, and for other processors. See docs/microcontroller.md.
#   firmware/check.sh             fails if a number grew by more than 3 %
#   firmware/check.sh --accept    writes measured.txt
# On a fresh Debian 12 machine it downloads cross compilers and an emulator first (200 MB), to
# DENHART_FIRMWARE_TOOLCHAIN or ~/.cache/denhart/firmware. Exit status 77: these cannot be had here (no network, or no
# Debian), and nothing was checked.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

accept=()
case ${1:-} in
  '') ;;
  --accept) accept=(--accept) ;;
  *)
    sed -n 's/^# \{0,1\}//; 2,8p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac

export CARGO_TERM_COLOR=never
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS
tools=${DENHART_FIRMWARE_TOOLCHAIN:-${XDG_CACHE_HOME:-$HOME/.cache}/denhart/firmware}
target=thumbv7em-none-eabihf
# The command `denhart`, built apart from what `cargo test --workspace` has built: beside it, with another CARGO_HOME, cargo
# would write the same files anew while doc tests read them.
command=$(realpath -m "${CARGO_TARGET_DIR:-../target}")/command
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")
out=$built/check
rm -rf "$out"
mkdir -p "$out"
export CARGO_TARGET_DIR=$built

# Runs a command quietly; shows what it printed only if it fails.
step() {
  local title=$1 start=$SECONDS log
  shift
  log=$(mktemp -p "$out")
  # Not as a condition, where a function would go on after a command that fails.
  (
    set -e
    "$@"
  ) >"$log" 2>&1 &
  if wait $!; then
    printf '%s ... ok (%d s)\n' "$title" $((SECONDS - start))
  else
    local status=$?
    printf '%s ... FAILED\n' "$title"
    tail -n 60 "$log"
    exit "$status"
  fi
}

# The command fails, and says what it has to.
refused() {
  local says=$1 printed
  shift
  if printed=$("$@" 2>&1); then
    echo "not refused: $*"
    return 1
  fi
  grep -q "$says" <<<"$printed" || { echo "refused for another reason: $printed"; return 1; }
}

toolchain_start=$SECONDS
./toolchain.sh "$tools"
echo "toolchain in $tools ($((SECONDS - toolchain_start)) s): $("$tools/bin/rustc" -V)"
if ! cargo fetch --locked >"$out/fetch" 2>&1; then
  cat "$out/fetch" >&2
  grep -q 'lock file' "$out/fetch" && exit 1
  echo "firmware: the crates cannot be downloaded: no network?" >&2
  exit 77
fi
"$tools/bin/rustc" -V >"$out/compiler"
# What another build of `core` made does not link with this one.
made_by="$tools of $(stat -c %y "$tools/ready_targets")"
[[ -f $built/made_by && $(<"$built/made_by") == "$made_by" ]] || rm -rf "$built/chip" "$built/elsewhere"
echo "$made_by" >"$built/made_by"

# Of the host: the installed toolchain. Of the chip: the private one.
host() { "$built/host/release/firmware-host" "$@"; }
chip() { RUSTC=$tools/bin/rustc CARGO_TARGET_DIR=$built/chip cargo build --locked --quiet --target $target "$@"; }
run() {
  timeout 600 "$tools/bin/qemu-system-arm" -M mps2-an386 "${@:2}" -display none -monitor none -serial none \
    -chardev stdio,id=output -semihosting-config enable=on,target=native,chardev=output -kernel "$1" </dev/null
}
program() { echo "$built/chip/$target/$1/$2"; }

step "host: the tool" env CARGO_TARGET_DIR="$built/host" cargo build --locked --release -p firmware-host
mapfile -t arms < <(host arms)
mapfile -t followed < <(host followed)
without_fpu=puma560_f32

# The functions of a program that is measured for its size, as features.
features() {
  case $1 in
    empty) ;;
    together) echo ,forward,forward_and_jacobian,inverse,inverse_near ;;
    *) echo ",$1" ;;
  esac
}
sizes() {
  local profile=$1 level=$2 arm function
  for arm in "${arms[@]}"; do
    mkdir -p "$out/flash/$arm"
    for function in empty forward forward_and_jacobian inverse inverse_into inverse_near inverse_branch together; do
      chip --profile "$profile" -p firmware-chip --bin size --features "fpu,$arm$(features $function)"
      cp "$(program "$profile" size)" "$out/flash/$arm/$function.$level"
    done
  done
  for arm in "${followed[@]}"; do
    chip --profile "$profile" -p firmware-chip --bin size --features "fpu,$arm,follower"
    cp "$(program "$profile" size)" "$out/flash/$arm/follower.$level"
  done
  # A second arm of the same structure.
  chip --profile "$profile" -p firmware-chip --bin size --features "fpu,puma560_f32,abb_irb2400_f32$(features together)"
  cp "$(program "$profile" size)" "$out/flash/two.together.$level"
}
programs() {
  local arm
  mkdir -p "$out/programs"
  for arm in "${arms[@]}"; do
    for name in measure bits; do
      chip --profile release -p firmware-chip --bin $name --features "fpu,$arm"
      cp "$(program release $name)" "$out/programs/$arm.$name"
    done
  done
  for arm in "${followed[@]}"; do
    chip --profile release -p firmware-chip --bin follow --features "fpu,$arm"
    cp "$(program release follow)" "$out/programs/$arm.follow"
  done
  # The square root in integers, where there is no feature `fpu`.
  for arm in $without_fpu; do
    chip --profile release -p firmware-chip --bin bits --features "$arm"
    cp "$(program release bits)" "$out/programs/$arm.integer.bits"
  done
  chip --profile release -p control-loop
  cp "$(program release control-loop)" "$out/programs/loop"
}
# Every function of every arm in specs/ links without a panic handler.
proof() {
  local profile=$1 scalar
  for scalar in f32 f64; do
    chip --profile "$profile" -p firmware-proof --bin "proof_$scalar"
    cp "$(program "$profile" "proof_$scalar")" "$out/proof_$scalar.$profile"
  done
  host doubles "$out/proof_f32.$profile"
  # What finds double precision finds it where it is.
  refused 'double precision: .*__aeabi_dadd' host doubles "$out/proof_f64.$profile"
  refused a_panic_path_is_left chip --profile "$profile" -p firmware-proof --bin planted_panic
  refused 'crate for `alloc`\|no global memory allocator' chip --profile "$profile" -p firmware-proof --bin planted_heap
}
measure() {
  mkdir -p "$out/measured"
  run "$out/programs/$1.measure" -icount shift=0,sleep=off >"$out/measured/$1.txt" || { tail -n 3 "$out/measured/$1.txt"; return 1; }
}
# After `measure`.
measure_follower() {
  run "$out/programs/$1.follow" -icount shift=0,sleep=off >>"$out/measured/$1.txt" || { tail -n 3 "$out/measured/$1.txt"; return 1; }
}
bits() {
  mkdir -p "$out/bits"
  run "$out/programs/$1.bits" >"$out/bits/$1.txt" || { tail -n 3 "$out/bits/$1.txt"; return 1; }
  host bits "$out/bits/$1.txt" | tee "$out/bits/$1.equal"
  # What compares them sees a bit that differs.
  sed '3s/ [0-9a-f]*$/ 00000000/' "$out/bits/$1.txt" >"$out/bits/$1.wrong"
  refused 'differ between chip and host' host bits "$out/bits/$1.wrong"
}
# The arm of specs/salman_rrr.yaml as a library for C, a program in C with it, and its results beside those of Rust.
in_c() {
  local crate=$out/c/salman_rrr
  CARGO_TARGET_DIR=$command cargo build --locked --quiet --manifest-path ../Cargo.toml -p denhart-cli
  "$command/debug/denhart" export c ../specs/salman_rrr.yaml -o "$crate" --scalar f32 --crate-path ../runtime
  # The versions of this repository.
  cp ../Cargo.lock "$crate/"
  RUSTC=$tools/bin/rustc CARGO_TARGET_DIR=$built/chip cargo build --quiet --release --target $target \
    --manifest-path "$crate/Cargo.toml" --features fpu
  "$tools/bin/arm-none-eabi-gcc" -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2 -ffp-contract=off \
    -std=c99 -Wall -Wextra -Werror -ffreestanding -nostdlib -Wl,--gc-sections,-z,noexecstack -I "$crate/include" -L board -T c/link.ld \
    c/main.c c/board.c "$(program release libsalman_rrr_c.a)" -o "$out/c/program"
  host panics "$out/c/program"
  run "$out/c/program" >"$out/c/digests.txt" || { tail -n 3 "$out/c/digests.txt"; return 1; }
  host c "$out/c/digests.txt" | tee "$out/c/equal"
  # What compares them sees a bit that differs.
  sed '3s/ [0-9a-f]*$/ 00000000/' "$out/c/digests.txt" >"$out/c/wrong"
  refused 'differ between C on the chip and Rust' host c "$out/c/wrong"
}
# Exported arms on other processors: all their functions link, without a path to a panic.
elsewhere() {
  local arm scalar target crate roots features lld
  lld=$(cd / && rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld
  for arm in salman_rrr:f32 puma560:f64; do
    scalar=${arm#*:} arm=${arm%:*}
    crate=$out/elsewhere/$arm
    "$command/debug/denhart" export c "../specs/$arm.yaml" -o "$crate" --scalar "$scalar" --crate-path ../runtime
    cp ../Cargo.lock "$crate/"
    mapfile -t roots < <(sed -n 's/^int32_t \([a-z0-9_]*\)(.*/--undefined=\1/p' "$crate/include/$arm.h")
    for target in thumbv6m-none-eabi riscv32imac-unknown-none-elf riscv32imafc-unknown-none-elf; do
      features=()
      [[ $target == riscv32imafc* ]] && features=(--features fpu)
      RUSTC=$tools/bin/rustc CARGO_TARGET_DIR=$built/elsewhere cargo build --quiet --release --target "$target" \
        --manifest-path "$crate/Cargo.toml" ${features[@]+"${features[@]}"}
      "$lld" -flavor gnu --gc-sections --entry="${arm}_forward" "${roots[@]}" \
        "$built/elsewhere/$target/release/lib${arm}_c.a" -o "$crate/$target"
      host panics "$crate/$target"
      echo "$arm $scalar $target: $(host flash "$crate/$target") bytes" | tee -a "$out/elsewhere/sizes"
    done
  done
  # What finds a panic finds it where it is: without optimization.
  CARGO_PROFILE_RELEASE_OPT_LEVEL=0 RUSTC=$tools/bin/rustc CARGO_TARGET_DIR=$built/elsewhere/0 cargo build --quiet --release \
    --target "$target" --manifest-path "$crate/Cargo.toml"
  "$lld" -flavor gnu --gc-sections --entry="${arm}_forward" "${roots[@]}" \
    "$built/elsewhere/0/$target/release/lib${arm}_c.a" -o "$crate/unoptimized"
  refused 'path to a panic' host panics "$crate/unoptimized"
}
control_loop() { run "$out/programs/loop" -icount shift=0,sleep=off >"$out/loop.txt" || { cat "$out/loop.txt"; return 1; }; }

# Runs what `programs` built.
runs() {
  local arm
  for arm in "${arms[@]}"; do
    step "$arm: instructions and stack" measure "$arm"
    step "$arm: chip and host" bits "$arm"
  done
  for arm in "${followed[@]}"; do
    step "$arm: instructions of a follower" measure_follower "$arm"
  done
  for arm in $without_fpu; do
    step "$arm, square root in integers: chip and host" bits "$arm.integer"
  done
  step 'control loop' control_loop
  step 'the arm in C: chip and Rust' in_c
  step 'thumbv6m, riscv32imac, riscv32imafc: exported arms link without a panic' elsewhere
}

# Two lanes, one for each profile: cargo builds one program of a profile at a time. Where one fails the others end too.
set -m
(
  step 'opt-level s: sizes' sizes small s
  step 'opt-level s: no panic, no heap, f32 without f64' proof small
) &
lane=$!
set +m
trap 'kill -- -$lane ${running:-} 2>/dev/null || true' EXIT
step 'opt-level 3: programs' programs
runs &
running=$!
step 'opt-level 3: sizes' sizes release 3
step 'opt-level 3: no panic, no heap, f32 without f64' proof release
wait $running
wait $lane
trap - EXIT

echo
cat "$out"/bits/*.equal "$out/c/equal" "$out/elsewhere/sizes"
cat "$out/loop.txt"
echo
host table "$out" measured.txt ../docs/microcontroller.md ${accept[@]+"${accept[@]}"}
