#!/usr/bin/env bash
# Does a wrong kernel fail a test? cargo-mutants changes one operator or function of the kernels at a time, and runs
# their tests on the CPU. All of them take a day or more on two cores, so this runs one part of 40; other arguments go to
# cargo-mutants. .cargo/mutants.toml says what is changed and tested, target/mutants.out has the results.
#
#   SHARD=7/40 scripts/mutants.sh
#   SHARD=0/1 scripts/mutants.sh --file shader-crate/src/scan.rs
set -euo pipefail
cd "$(dirname "$0")/.."

command -v cargo-mutants >/dev/null || cargo install --locked cargo-mutants@27.1.0
# The copy of the sources has the dependencies that are compiled here.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
# GPUs run SPIR-V, which is not compiled again: the tests have the CPU alone.
export VK_DRIVER_FILES=/dev/null INSTA_UPDATE=no MUSLIN_REQUIRE_GPU=0
# Round-robin: each part has mutants of all files.
exec cargo mutants --shard "${SHARD:-0/40}" --sharding round-robin --output target "$@"
