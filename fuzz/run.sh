#!/usr/bin/env bash
# Fuzzes on a stable compiler: fuzz/run.sh SECONDS [TARGET..], by libFuzzer with the compiler's own coverage counters.
# Needs a C++ compiler; status 77 without one. What fails is written to fuzz/artifacts/, what is new to target/corpus/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

seconds=${1:-60}
targets=("${@:2}")
if ((${#targets[@]} == 0)); then targets=(arm_file back_ends inverse); fi
if ! command -v c++ >/dev/null; then
  echo "no C++ compiler: nothing was fuzzed"
  exit 77
fi

# Coverage counters at every edge, and the operands of comparisons. An explicit target keeps build scripts without them.
coverage="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters"
coverage+=" -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1"
host=$(rustc -vV | sed -n 's/^host: //p')
build=${CARGO_TARGET_DIR:-target}
RUSTFLAGS="$coverage" cargo build --quiet --release --locked --features libfuzzer --bins --target "$host" --target-dir "$build"

for target in "${targets[@]}"; do
  mkdir -p "target/corpus/$target" artifacts
  echo "$target: $seconds s"
  # Only new files are kept; the committed corpus stays as it is.
  "$build/$host/release/$target" "target/corpus/$target" "corpus/$target" -max_total_time="$seconds" -timeout=20 \
    -max_len=8192 -artifact_prefix="artifacts/$target-" -print_final_stats=1 2>&1 | grep -Ev '^#|^INFO|NEW_FUNC' | tail -n 40
done
