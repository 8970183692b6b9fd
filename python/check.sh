#!/usr/bin/env bash
# The Python package as a user gets it: a wheel, in a fresh virtual environment, with its tests and type stubs.
#   python/check.sh
# PYTHON names the interpreter [default: python3]. Exit status 77: no Python from 3.11 on, or no network for the packages
# of the tests, and nothing was checked.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

python=${PYTHON:-python3}
if ! "$python" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1; then
  echo "python: no $python from 3.11 on, with venv, here" >&2
  exit 77
fi
export CARGO_TERM_COLOR=never PIP_DISABLE_PIP_VERSION_CHECK=1
root=$(realpath ..)
# The command `denhart`, built apart from what `cargo test --workspace` has built: beside it, with another CARGO_HOME, cargo
# would write the same files anew while doc tests read them.
command=$(realpath -m "${CARGO_TARGET_DIR:-../target}")/command
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")
export CARGO_TARGET_DIR=$built
mkdir -p "$built"
out=$(mktemp -d -p "$built")
trap 'rm -rf "$out"' EXIT

# Runs a command quietly; shows what it printed only if it fails.
step() {
  local title=$1 start=$SECONDS
  shift
  if "$@" >"$out/log" 2>&1; then
    printf '%s ... ok (%d s)\n' "$title" $((SECONDS - start))
  else
    local status=$?
    printf '%s ... FAILED\n' "$title"
    tail -n 60 "$out/log"
    exit "$status"
  fi
}

"$python" -m venv "$out/venv"
bin=$out/venv/bin
if ! "$bin/pip" install --quiet -r tests/requirements.txt >"$out/log" 2>&1; then
  tail -n 5 "$out/log" >&2
  echo "python: the packages of the tests cannot be had here: no network?" >&2
  exit 77
fi
if ! cargo fetch --locked >"$out/log" 2>&1; then
  cat "$out/log" >&2
  grep -q 'lock file' "$out/log" && exit 1
  echo "python: the crates cannot be downloaded: no network?" >&2
  exit 77
fi

step 'cargo fmt' cargo fmt --check
step 'cargo clippy' cargo clippy --locked -- -D warnings
step 'wheel' "$bin/maturin" build --release --locked --out "$out/wheels" --interpreter "$bin/python"
size=$(stat -c %s "$out"/wheels/*.whl)
echo "wheel: $((size / 1024)) KiB"
if ((size > 4 * 1024 * 1024)); then
  echo "the wheel is larger than 4 MiB"
  exit 1
fi
step 'install' "$bin/pip" install --no-deps "$out"/wheels/*.whl
# Away from the folder, where Python would find the sources before the wheel.
cp -r tests "$out/tests"
cp pyproject.toml "$out"
ln -s "$(realpath ../specs)" "$out/specs"
ln -s "$(realpath ../docs)" "$out/docs"
mkdir "$out/python"
cp tour.ipynb README.md "$out/python"
cd "$out"
step 'the command' env CARGO_TARGET_DIR="$command" cargo build --locked --manifest-path "$root/Cargo.toml" -p denhart-cli
step 'type stubs' "$bin/python" -m mypy.stubtest denhart --ignore-missing-stub --ignore-disjoint-bases
step 'types of the tests' "$bin/mypy" --strict tests/typed.py
step 'tests' env DENHART_ROOT="$out" DENHART="$command/debug/denhart" "$bin/pytest" -q -p no:cacheprovider tests
tail -n 1 "$out/log"
