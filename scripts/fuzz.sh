#!/usr/bin/env bash
# Runs every fuzzer, or those that are named, for SECONDS_EACH seconds (60 by default). It needs cargo-fuzz
# (`cargo install --locked cargo-fuzz`) and a C++ compiler.
#
#   SECONDS_EACH=600 scripts/fuzz.sh ply photograph
#
# The parsers are safe Rust, so panics, overflows, memory and time are watched, and no sanitizer. With
# SANITIZER=address, rustup's toolchain `nightly` adds AddressSanitizer, for the crates below them.
#
# What it finds is in fuzz/artifacts. New inputs go to fuzz/found, not into the committed corpus.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${SECONDS_EACH:-60}
sanitizer=${SANITIZER:-none}
toolchain=()
[[ $sanitizer == none ]] || toolchain=(+nightly)
# A folder of the corpus for each parser.
targets=("$@")
(( $# )) || targets=($(ls fuzz/corpus))
for target in "${targets[@]}"; do
  mkdir -p "fuzz/found/$target" "fuzz/artifacts/$target"
  printf '=== %s\n' "$target"
  ORGANZA_FUZZ=$target cargo "${toolchain[@]}" fuzz run --dev --sanitizer "$sanitizer" parsers "fuzz/found/$target" "fuzz/corpus/$target" -- \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536 \
    -artifact_prefix="fuzz/artifacts/$target/"
done
