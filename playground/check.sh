#!/usr/bin/env bash
# The page: built anew, its size, and its tests in a real browser.
#   playground/check.sh
# CHROMIUM names the browser [default: /usr/bin/chromium, which is installed where apt-get may]. With DENHART_RELEASE=1 a page of
# the command that is older than its sources is a failure; else it is told. Exit status 77: no browser, no node, no target or no
# network here, and the page was not tested.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

export CARGO_TERM_COLOR=never CHROMIUM=${CHROMIUM:-/usr/bin/chromium}
root=$(realpath ..)
# The command `denhart`, built apart from what `cargo test --workspace` has built: beside it, with another CARGO_HOME, cargo
# would write the same files anew while doc tests read them.
command=$(realpath -m "${CARGO_TARGET_DIR:-../target}")/command
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")
export CARGO_TARGET_DIR=$built
mkdir -p "$built"
out=$(mktemp -d -p "$built")
trap 'rm -rf "$out"' EXIT
# Bytes of the page as gzip has it.
most=1300000

# Runs a command quietly; shows what it printed only if it fails. A status of 77 is handed on.
step() {
  local title=$1 start=$SECONDS
  shift
  if "$@" >"$out/log" 2>&1; then
    printf '%s ... ok (%d s)\n' "$title" $((SECONDS - start))
  else
    local status=$?
    if ((status == 77)); then
      tail -n 3 "$out/log" >&2
    else
      printf '%s ... FAILED\n' "$title"
      tail -n 60 "$out/log"
    fi
    exit "$status"
  fi
}

step 'cargo fmt' cargo fmt --all --check
step 'build' ./build.sh
tail -n 1 "$out/log"
step 'cargo clippy' cargo clippy --release --locked -p denhart-bind -- -D warnings
step 'cargo test' cargo test --release --locked -p denhart-bind
size=$(gzip -9 -c "$built/page/page.html" | wc -c)
if ((size > most)); then
  echo "the page has $size bytes as gzip, more than $most"
  exit 1
fi
if [[ $(./digest.sh) != "$(cat digest.txt)" ]]; then
  echo "the page of the command is older than its sources: playground/build.sh --accept"
  if [[ ${DENHART_RELEASE:-0} == 1 ]]; then exit 1; fi
fi
if [[ ! -x $CHROMIUM ]] && ! { command -v apt-get >/dev/null && apt-get install -y chromium >"$out/log" 2>&1 && [[ -x $CHROMIUM ]]; }; then
  echo "page: no browser $CHROMIUM here" >&2
  exit 77
fi
step 'the command' env CARGO_TARGET_DIR="$command" cargo build --locked --manifest-path "$root/Cargo.toml" -p denhart-cli
node page/tests/browser.mjs "$built/page/page.html" "$command/debug/denhart" "$built/page/shots"
