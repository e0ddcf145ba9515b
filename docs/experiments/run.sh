#!/usr/bin/env bash
# The runs of docs/experiments.md: each leaves out one part of the method, or changes it. Prints the table.
#   docs/experiments/run.sh RUNS ORGANZA CAPTURE...
# The same command goes on after Ctrl-C, and repeats nothing.
set -euo pipefail
runs=$1 organza=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$runs"
grep -v '^#' "$here/parts.txt" | while IFS='|' read -r name part options; do
    echo "$name:$part" >&2
    # shellcheck disable=SC2086  # options are words
    "$organza" benchmark "$@" -o "$runs/$name" --steps 400 --backend cpu --quiet $options >/dev/null </dev/null
done
"$here/table.py" "$runs"
