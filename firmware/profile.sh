#!/usr/bin/env bash
# Where the instructions of a function go, by symbol: the mean of 100 calls at random targets.
#   firmware/profile.sh puma560_f32 inverse
# After firmware/check.sh, whose toolchain and programs it uses.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
arm=${1:?usage: profile.sh ARM FUNCTION} function=${2:?usage: profile.sh ARM FUNCTION}
tools=${DENHART_FIRMWARE_TOOLCHAIN:-${XDG_CACHE_HOME:-$HOME/.cache}/denhart/firmware}
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")
CARGO_TARGET_DIR=$built/host cargo build --locked --quiet --release -p firmware-host
RUSTC=$tools/bin/rustc CARGO_TARGET_DIR=$built/chip cargo build --locked --quiet --release --target thumbv7em-none-eabihf \
  -p firmware-chip --bin profile --features "fpu,$arm,$function"
program=$built/chip/thumbv7em-none-eabihf/release/profile
# One line for each instruction.
"$tools/bin/qemu-system-arm" -M mps2-an386 -singlestep -d exec,nochain -D /dev/stderr -display none -monitor none -serial none \
  -chardev file,id=output,path=/dev/null -semihosting-config enable=on,target=native,chardev=output -kernel "$program" \
  2>&1 </dev/null | "$built/host/release/firmware-host" profile "$program" "$function"
