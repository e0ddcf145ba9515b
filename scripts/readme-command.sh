#!/usr/bin/env bash
# Prints a command of the README: the fenced block right after the line `<!-- ci:NAME -->`.
# So what is tested is what the README says.
#
# usage: scripts/readme-command.sh NAME [FILE]
set -euo pipefail

name=$1
file=${2:-$(dirname "$0")/../README.md}
block=$(awk -v marker="<!-- ci:$name -->" '
  { sub(/\r$/, "") }
  inside && /^```/ { exit }
  inside { print; next }
  marked && /^```/ { inside = 1; next }
  marked && NF { marked = 0 }
  $0 == marker { marked = 1 }
' "$file")
if [[ -z $block ]]; then
  echo "error: $file has no fenced block after the line '<!-- ci:$name -->'" >&2
  exit 1
fi
printf '%s\n' "$block"
