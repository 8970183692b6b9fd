#!/usr/bin/env bash
# Instructions of 4096 inverses of a UR5 in lanes, over those of single calls of its generated code, by callgrind: the
# difference of two numbers of calls, so that setting up does not count. A function that is not inlined into the code of an
# instruction set makes that set many times slower without a warning; here it fails. Status 77: no valgrind.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v valgrind >/dev/null || { echo "no valgrind: nothing was counted" >&2; exit 77; }
cargo build --quiet --release --locked -p denhart-dynamic --features batch --example counts
binary=${CARGO_TARGET_DIR:-target}/release/examples/counts

count() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$binary" "$@" 2>&1 | sed -n 's/.*Collected : //p'
}
of_4096() { echo $(($(count "$1" "$2" 5120) - $(count "$1" "$2" 1024))); }

single=$(of_4096 single none)
status=0
# valgrind has no AVX-512. Generated code has bars of its own. That of the evaluator on AVX2 is a time, 0.55 of a single call, which
# `--bench batch` measures: each instruction of its program loads and stores lanes, so that it has 69 % of the instructions. A function
# that is not inlined makes them 12 times as many; the limit stands a tenth above what was counted.
for entry in generated:SSE2:80 generated:AVX2:50 dynamic:SSE2:120 dynamic:AVX2:76; do
  IFS=: read -r way set most <<<"$entry"
  "$binary" 2>/dev/null | grep -qx "$set" || continue
  lanes=$(of_4096 "$way" "$set")
  echo "$way, $set: $((lanes / 4096)) instructions an inverse, single calls $((single / 4096)): $((100 * lanes / single)) %, at most $most"
  ((100 * lanes <= most * single)) || status=1
done
exit $status
