#!/usr/bin/env bash
# Prints a digest of everything that the page is made from.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C
{
  find core runtime codegen dynamic draw tools -path '*/tests' -prune -o -type f \( -name '*.rs' -o -name Cargo.toml -o -name '*.txt' -o -name '*.ttf' \) -print
  find playground/wasm playground/bind playground/page/src -type f -print
  ls playground/Cargo.toml playground/Cargo.lock
  for file in index.html style.css build.mjs package.json package-lock.json; do echo "playground/page/$file"; done
} | sort | xargs sha256sum | sha256sum | cut -d' ' -f1
