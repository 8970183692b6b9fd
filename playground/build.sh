#!/usr/bin/env bash
# Builds the page: one HTML file with everything in it.
#   playground/build.sh [--accept]
# It stands in playground/target/page/page.html. With --accept it becomes the one that the command carries, cli/src/view/page.html.
# Exit status 77: the compiler's target or the packages of npm cannot be had here, and nothing was built.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

accept=false
case ${1:-} in
  '') ;;
  --accept) accept=true ;;
  *) echo "usage: playground/build.sh [--accept]" >&2; exit 2 ;;
esac
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  echo "page: no node and npm here" >&2
  exit 77
fi
target=wasm32-unknown-unknown
if ! { rustc --print sysroot >/dev/null && [[ -d $(rustc --print sysroot)/lib/rustlib/$target ]]; } && ! rustup target add "$target" >/dev/null 2>&1; then
  echo "page: the target $target cannot be had here" >&2
  exit 77
fi
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")
export CARGO_TARGET_DIR=$built
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! cargo fetch --locked >"$log" 2>&1; then
  cat "$log" >&2
  grep -q 'lock file' "$log" && exit 1
  echo "page: the crates cannot be downloaded: no network?" >&2
  exit 77
fi
if ! (cd page && npm ci --no-progress) >"$log" 2>&1; then
  tail -n 5 "$log" >&2
  echo "page: the packages of npm cannot be had here: no network?" >&2
  exit 77
fi
cargo build --release --locked -p denhart-bind
# No path of this machine gets into the page: the same sources give the same bytes.
registry=$(realpath -m "${CARGO_HOME:-$HOME/.cargo}")/registry/src
RUSTFLAGS="--remap-path-prefix=$(realpath ..)= --remap-path-prefix=$registry=" \
  cargo build --release --locked -p denhart-page --target "$target"
"$built/release/denhart-bind" "$built/$target/release/denhart_page.wasm" page/pkg
mkdir -p "$built/page"
(cd page && npx tsc -p . && node build.mjs "$built/page/page.html")
if $accept; then
  mkdir -p ../cli/src/view
  cp "$built/page/page.html" ../cli/src/view/page.html
  ./digest.sh >digest.txt
fi
