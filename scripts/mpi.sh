#!/usr/bin/env bash
# Builds the program with MPI, and tests ranks that are its processes. Needs Debian's packages
# libopenmpi-dev, openmpi-bin and libclang-dev.
set -euo pipefail
cd "$(dirname "$0")/.."

target=${CARGO_TARGET_DIR:-$PWD/target}
# With an example, dependencies have the features that they have in the tests, so only organza is compiled again.
cargo build --workspace --bin organza --example render_tiles --features organza/mpi
# the other tests build the program without MPI in the same place
cp "$target/debug/organza" "$target/organza-mpi"
ORGANZA_MPI=$target/organza-mpi cargo test --workspace --test program -- --ignored train::mpi
