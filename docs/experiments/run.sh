#!/usr/bin/env bash
# Runs the comparison of docs/experiments.md: every configuration beside this script with two seeds, and the long run.
#   docs/experiments/run.sh DATA RUNS [ORGANZA]
set -euo pipefail
data=$1 runs=$2 organza=${3:-organza}
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$runs"
for seed in 0 1; do
    for config in "$here"/*.toml; do
        "$organza" train "$data" -o "$runs/$(basename "$config" .toml)-$seed" --config "$config" --seed "$seed" \
            --backend cpu --quiet
    done
done
"$organza" train "$data" -o "$runs/hour-$(basename "$data")" --preset best --minutes 60 --backend cpu --quiet
"$here/plot.py" "$runs"
