#!/bin/sh
# Instructions per call of every case, by callgrind: the difference of two numbers of calls, so that setting up and
# loading do not count. Needs valgrind.
set -eu
cd "$(dirname "$0")"
cargo build --release --quiet --bin instructions
binary="${CARGO_TARGET_DIR:-target}/release/instructions"

count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$binary" "$1" "$2" 2>&1 | sed -n 's/.*Collected : //p'
}

printf '%-46s %12s\n' case instructions
for case in $("$binary"); do
    few=$(count "$case" 100)
    many=$(count "$case" 1100)
    printf '%-46s %12s\n' "$case" "$(((many - few) / 1000))"
done
