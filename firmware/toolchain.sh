#!/usr/bin/env bash
# Private cross compilers and an emulator under FOLDER, from Debian 12 packages; nothing is installed system-wide.
#   firmware/toolchain.sh FOLDER
# The compilers are Debian's rustc-web, of which `core` is built for the target, and gcc-arm-none-eabi; the emulator is
# QEMU. Needs apt-get, dpkg-deb, and rustup's cargo with rust-lld. Downloads 200 MB, takes 700 MB. Exit status 77: no
# network, or no Debian.
set -euo pipefail

folder=$(realpath -m "${1:?usage: toolchain.sh FOLDER}")
# What is measured, and what else is built for.
targets=(thumbv7em-none-eabihf thumbv6m-none-eabi riscv32imac-unknown-none-elf riscv32imafc-unknown-none-elf)
# What is made here changes with this number: an older folder is made anew.
version=1
made() { [[ -f $folder/$1 && $(<"$folder/$1") == "$version" ]]; }
made ready && made ready_c && made ready_targets && exit 0

cannot() {
  echo "firmware: $*" >&2
  exit 77
}
for tool in apt-get dpkg-deb cargo rustc; do
  command -v "$tool" >/dev/null || cannot "no $tool here: the toolchain is made from Debian 12 packages with rustup's cargo"
done

# A folder of something else is left alone.
if ! made ready && [[ -e $folder && ! -e $folder/made-by-denhart && -n $(ls -A "$folder" 2>/dev/null) ]]; then
  echo "firmware: $folder is not empty and no toolchain of firmware/toolchain.sh" >&2
  exit 1
fi
made ready || rm -rf "$folder"
mkdir -p "$folder/bin"
touch "$folder/made-by-denhart"

# Package lists of its own: the machine's need root, and may be old.
apt=(-qq -o "Dir::State::Lists=$folder/lists" -o "Dir::Cache=$folder/debs" -o "Dir::Cache::archives=$folder/debs"
  -o APT::Sandbox::User=root -o Acquire::Retries=2 -o Acquire::http::Timeout=20 -o Acquire::https::Timeout=20)
# Downloads packages to `debs`, with what they need and the machine has not; those named also if the machine has them.
fetch() {
  local closure names
  rm -rf "$folder/debs" "$folder/lists"
  mkdir -p "$folder/debs/partial" "$folder/lists/partial"
  apt-get "${apt[@]}" -o APT::Update::Error-Mode=any update >"$folder/apt.log" 2>&1 ||
    { tail -n 5 "$folder/apt.log" >&2; cannot "the package lists cannot be fetched: no network?"; }
  closure=$(apt-get "${apt[@]}" install --no-install-recommends --print-uris -y "$@" 2>>"$folder/apt.log" |
    sed -n "s/^'[^']*' \([^_]*\)_.*/\1/p") || cannot "apt-get knows no $1: $(tail -n 1 "$folder/apt.log")"
  cd "$folder/debs"
  mapfile -t names < <(printf '%s\n' $closure "$@" | sort -u)
  apt-get "${apt[@]}" download "${names[@]}" >>"$folder/apt.log" 2>&1 ||
    { tail -n 5 "$folder/apt.log" >&2; cannot "the packages cannot be downloaded: no network?"; }
}
unpack() { dpkg-deb --fsys-tarfile "$1" | tar -x -C "$folder" "${@:2}"; }

libraries=$folder/usr/lib/x86_64-linux-gnu:$folder/lib/x86_64-linux-gnu
wrapper() {
  printf '#!/bin/sh\nLD_LIBRARY_PATH=%s${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} exec %s "$@"\n' "$libraries" "$2" >"$folder/bin/$1"
  chmod +x "$folder/bin/$1"
}
if ! made ready; then
  fetch rustc-web libstd-rust-web-dev rust-web-src qemu-system-arm qemu-system-common qemu-system-data
  for package in *.deb; do
    case $package in
      rust-web-src_*) unpack "$package" --wildcards './usr/lib/rustlib/src*' './usr/src/rustc-*/library' ;;
      *) unpack "$package" --exclude=./usr/share/doc --exclude=./usr/share/man ;;
    esac
  done
  wrapper rustc "$folder/usr/bin/rustc"
  wrapper qemu-system-arm "$folder/usr/bin/qemu-system-arm -L $folder/usr/share/qemu"

  # Debian's compiler has no linker for the target; rustup's has one.
  lld=$(cd / && rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld
  [[ -x $lld ]] || cannot "no rust-lld in the installed toolchain"
  mkdir -p "$folder/usr/lib/rustlib/x86_64-unknown-linux-gnu/bin"
  ln -sfn "$lld" "$folder/usr/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld"
  echo "$version" >"$folder/ready"
fi

# `core`, once for each target, with object code and bitcode, so that programs link with and without link-time optimization.
# Building it is all that needs unstable options.
if ! made ready_targets; then
  mkdir -p "$folder/core/src"
  cd "$folder/core"
  echo '#![no_std]' >src/lib.rs
  printf '[package]\nname = "core-only"\nversion = "0.1.0"\nedition = "2024"\n[profile.release]\npanic = "abort"\n[workspace]\n' >Cargo.toml
  for target in "${targets[@]}"; do
    kept=$folder/usr/lib/rustlib/$target/lib
    compgen -G "$kept/libcore-*.rlib" >/dev/null && continue
    env -u RUSTFLAGS -u CARGO_TARGET_DIR -u CARGO_ENCODED_RUSTFLAGS RUSTC="$folder/bin/rustc" RUSTC_BOOTSTRAP=1 \
      cargo build -q --release -Zbuild-std=core --target "$target" --offline --target-dir target \
      --config 'build.rustflags=["-C","embed-bitcode=yes"]' --config 'source.crates-io.replace-with="vendored"' \
      --config "source.vendored.directory=\"$folder/usr/lib/rustlib/src/rust/library/vendor\""
    mkdir -p "$kept"
    cp "target/$target/release/deps/"lib{core,compiler_builtins}-*.rlib "$kept/"
  done
  rm -rf "$folder/core"
  echo "$version" >"$folder/ready_targets"
fi

# For C: the compiler alone. Its libraries are not needed; the routines that it calls are in Rust's.
if ! made ready_c; then
  fetch gcc-arm-none-eabi
  for package in *.deb; do
    unpack "$package" --exclude=./usr/share --exclude='*.a' --exclude='*/cc1plus' --exclude='*/lto1'
  done
  wrapper arm-none-eabi-gcc "$folder/usr/bin/arm-none-eabi-gcc"
  echo "$version" >"$folder/ready_c"
fi
cd "$folder"
rm -rf "$folder/debs" "$folder/lists"
