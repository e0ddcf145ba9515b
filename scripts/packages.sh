#!/usr/bin/env bash
# Makes the package of every crate that is published, and holds each to what it needs: a README, both licenses, words
# to find it by, and in organza-render's the compiled kernels. Takes seconds and compiles nothing.
#
# usage: scripts/packages.sh
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}

fail() {
  echo "error: $*" >&2
  exit 1
}

# The value of a key of a manifest.
value() { sed -n "s/^$2 = \"\(.*\)\"$/\1/p" "$1" | head -n 1; }

version=$(value Cargo.toml version)
manifests=()
for manifest in host/Cargo.toml host/*/Cargo.toml shader-crate/Cargo.toml kit/*/Cargo.toml tests/Cargo.toml xtask/Cargo.toml; do
  grep -q '^publish = false' "$manifest" || manifests+=("$manifest")
done
packages=()
for manifest in "${manifests[@]}"; do packages+=(--package "$(value "$manifest" name)"); done
cargo package --quiet --no-verify --allow-dirty --target-dir "$target" "${packages[@]}"

for manifest in "${manifests[@]}"; do
  name=$(value "$manifest" name)
  for key in description readme keywords categories license.workspace; do
    grep -q "^$key = " "$manifest" || fail "$manifest has no $key"
  done
  needed=(Cargo.toml README.md LICENSE-MIT LICENSE-APACHE src/lib.rs)
  if [[ $name == organza ]]; then needed+=(src/main.rs); fi
  if [[ $name == organza-train ]]; then needed+=(build.rs); fi
  if [[ $name == organza-render ]]; then
    mapfile -t modules < <(cd host/render && find kernels -name '*.spv')
    (( ${#modules[@]} )) || fail "there are no compiled kernels"
    needed+=(build.rs kernels/manifest.json "${modules[@]}")
  fi
  files=$(tar -tzf "$target/package/$name-$version.crate")
  for file in "${needed[@]}"; do
    grep -qxF "$name-$version/$file" <<<"$files" || fail "the package $name lacks $file"
  done
  echo "$name $version: $(wc -l <<<"$files") files"
done
