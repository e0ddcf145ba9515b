#!/usr/bin/env bash
# Checks the pages' scripts by the types in their comments. TypeScript only reads them: there is nothing to build.
# npm brings it into the target folder, once.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${CARGO_TARGET_DIR:-$PWD/target}/typescript
[[ -x $folder/node_modules/.bin/tsc ]] ||
  npm install --prefix "$folder" --silent --no-audit --no-fund typescript@5.9.3 @webgpu/types@0.1.74
"$folder/node_modules/.bin/tsc" --project host/view/src/jsconfig.json --typeRoots "$folder/node_modules"
