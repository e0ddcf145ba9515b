#!/usr/bin/env bash
# Thousands of mutations of each file of the corpus, and a fault at each system call that writes: what
# the tests try some of. Each round of mutations takes another seed.
#
#   ROUNDS=10 INPUTS=2000 scripts/mutations.sh
set -euo pipefail
cd "$(dirname "$0")/.."

export ORGANZA_REQUIRE_STRACE=1
for (( round = 0; round < ${ROUNDS:-4}; round++ )); do
  seed=$RANDOM
  echo "mutations, seed $seed"
  ORGANZA_MUTATIONS=${INPUTS:-2000} ORGANZA_MUTATION_SEED=$seed \
    cargo test --workspace --test program -- corpus --nocapture
done
ORGANZA_ALL_FAULTS=1 cargo test --workspace --test program -- faults --nocapture
