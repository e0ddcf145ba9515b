#!/usr/bin/env bash
# Holds every dependency to deny.toml: licenses, second versions, sources; and, with `advisories`, to
# what is known to be unsafe, for which RustSec's database must be reachable. It needs cargo-deny
# (`cargo install --locked --debug cargo-deny`).
#
#   scripts/deny.sh [advisories]
set -euo pipefail
cd "$(dirname "$0")/.."

cargo deny --all-features check "$@" bans licenses sources
