#!/usr/bin/env bash
# Makes what people install without a compiler: the program for Linux on x86-64, and the Python wheel. Both work with glibc 2.17, of 2012,
# and later. Then it installs both into empty folders, and runs the first training of the README and the first block of the Python page.
#
# usage: scripts/release.sh [FOLDER]      (target/release-files by default)
#
# It needs rustup, Python with venv, and jq. Zig is the linker, because it knows the symbols of old versions of glibc.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
out=$(mkdir -p "${1:-target/release-files}" && cd "${1:-target/release-files}" && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
tools=$target/release-tools
glibc=2.17
platform=x86_64-unknown-linux-gnu

python3 -m venv "$tools"
"$tools/bin/pip" install --quiet --disable-pip-version-check 'ziglang>=0.13' 'cargo-zigbuild>=0.20' 'maturin[zig]>=1.10,<2'
export PATH=$tools/bin:$PATH

# The license texts of the crates that a package is made of.
licenses() {
  local name version license manifest file
  cargo metadata --format-version 1 --locked --filter-platform "$platform" \
    | jq -r '.packages[] | [.name, .version, .license // "see below", .manifest_path] | @tsv' >"$target/packages.tsv"
  cargo tree --locked --package organza --edges normal --target "$platform" --prefix none --format '{p}' \
    | awk '{ print $1 "\t" substr($2, 2) }' | sort -u >"$target/linked.tsv"
  while IFS=$'\t' read -r name version license manifest; do
    grep -qxF "$name"$'\t'"$version" "$target/linked.tsv" || continue
    printf '==== %s %s: %s\n\n' "$name" "$version" "$license"
    find "$(dirname "$manifest")" -maxdepth 1 -type f \( -iname 'licen[cs]e*' -o -iname 'copying*' -o -iname 'notice*' \) | sort | while read -r file; do
      cat "$file"
      echo
    done
  done <"$target/packages.tsv"
}

program() {
  local version name
  cargo zigbuild --release --locked --package organza --bin organza --target "$platform.$glibc"
  version=$(cargo metadata --format-version 1 --no-deps | jq -r '.packages[] | select(.name == "organza") | .version')
  name=organza-$version-x86_64-linux
  rm -rf "${out:?}/$name"
  mkdir "$out/$name"
  cp "$target/$platform/release/organza" LICENSE-MIT LICENSE-APACHE README.md "$out/$name/"
  licenses >"$out/$name/LICENSES-OF-DEPENDENCIES"
  tar -C "$out" -czf "$out/$name.tar.gz" "$name"
  rm -rf "${out:?}/$name"
}

wheel() {
  # the versions that everything else is built with
  cp Cargo.lock python/Cargo.lock
  (cd python && CARGO_TARGET_DIR=$target/python maturin build --release --zig --compatibility manylinux2014 --target "$platform" --out "$out")
}

# Both, where nothing of the repository is.
check() {
  local folder command
  folder=$(mktemp -d)
  tar -C "$folder" --strip-components 1 -xzf "$out"/organza-*-x86_64-linux.tar.gz
  command=$(scripts/readme-command.sh run)
  command=${command/cargo install*--locked/}
  (cd "$folder" && PATH=$folder:$PATH bash -euxo pipefail -c "$command")
  test -s "$folder/run/report.html"
  python3 -m venv "$folder/venv"
  "$folder/venv/bin/pip" install --quiet --disable-pip-version-check "$out"/organza-*manylinux*.whl
  awk '/^```python/ { inside = 1; next } /^```/ && inside { exit } inside' python/README.md >"$folder/first.py"
  (cd "$folder" && venv/bin/python first.py && test -s turntable.png)
  rm -rf "$folder"
}

program
wheel
check
ls -lh "$out"
