#!/usr/bin/env bash
# Runs every fuzzer, or those that are named, for SECONDS each (60 by default). It needs rustup's
# toolchain `nightly`, a C++ compiler and cargo-fuzz (`cargo install cargo-fuzz`).
#
#   SECONDS_EACH=600 scripts/fuzz.sh ply photograph
#
# What it finds is in fuzz/artifacts. New inputs go to fuzz/found, not into the committed corpus.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${SECONDS_EACH:-60}
mapfile -t targets < <(cargo +nightly fuzz list)
(( $# )) && targets=("$@")
for target in "${targets[@]}"; do
  mkdir -p "fuzz/found/$target" "fuzz/corpus/$target"
  cargo +nightly fuzz run --release "$target" "fuzz/found/$target" "fuzz/corpus/$target" -- \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536
done
