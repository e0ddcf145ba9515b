#!/usr/bin/env bash
# Makes what people install without a compiler: the program for Linux and Windows on x86-64 and for macOS on ARM, the Python wheel for Linux, their
# checksums, and the release's notes. Linux's work with glibc 2.17, of 2012, and later: the script installs both into empty folders, and runs the first
# training of the README and the first block of the Python page.
#
# usage: scripts/release.sh [FOLDER]      (target/release-files by default)
#
# It needs rustup, Python with venv, and jq. Zig is the linker, because it knows the symbols of old versions of glibc, and of Windows. macOS
# needs Apple's SDK in SDKROOT. What cannot be linked here is left out, and a message says what it takes.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
out=$(mkdir -p "${1:-target/release-files}" && cd "${1:-target/release-files}" && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
tools=$target/release-tools
glibc=2.17
platform=x86_64-unknown-linux-gnu
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)

python3 -m venv "$tools"
"$tools/bin/pip" install --quiet --disable-pip-version-check 'ziglang>=0.13' 'cargo-zigbuild>=0.20' 'maturin[zig]>=1.10,<2'
export PATH=$tools/bin:$PATH

# The license texts of the crates that a platform's package is made of.
licenses() {
  local name version license manifest file
  cargo metadata --format-version 1 --locked --filter-platform "$1" \
    | jq -r '.packages[] | [.name, .version, .license // "see below", .manifest_path] | @tsv' >"$target/packages.tsv"
  cargo tree --locked --package organza --edges normal --target "$1" --prefix none --format '{p}' \
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

# Whether programs for a platform can be linked here.
can_link() {
  if [[ $1 == *-apple-* && -z ${SDKROOT:-} ]]; then
    echo "left out $1: set SDKROOT to a macOS SDK, such as \`xcrun --show-sdk-path\` prints on a Mac" >&2
    return 1
  fi
  if [[ ! -d $(rustc --print target-libdir --target "$1") ]] && ! timeout 300 rustup target add "$1"; then
    echo "left out $1: \`rustup target add $1\` must work here, once" >&2
    return 1
  fi
}

# The program for a platform: an archive NAME.tar.gz, or NAME.zip for Windows.
program() {
  local name=organza-$version-$2 built=$target/$1/release/organza
  cargo zigbuild --release --locked --package organza --bin organza --target "$1${3:-}"
  rm -rf "${out:?}/$name"
  mkdir "$out/$name"
  if [[ $1 == *-windows-* ]]; then built+=.exe; fi
  cp "$built" LICENSE-MIT LICENSE-APACHE README.md "$out/$name/"
  licenses "$1" >"$out/$name/LICENSES-OF-DEPENDENCIES"
  if [[ $1 == *-windows-* ]]; then
    (cd "$out" && python3 -m zipfile -c "$name.zip" "$name")
  else
    tar -C "$out" -czf "$out/$name.tar.gz" "$name"
  fi
  rm -rf "${out:?}/$name"
}

wheel() {
  (cd python && maturin build --release --locked --zig --compatibility manylinux2014 --target "$platform" --out "$out")
}

# Both, where nothing of the repository is.
check() {
  local folder command
  folder=$(mktemp -d)
  tar -C "$folder" --strip-components 1 -xzf "$out/organza-$version-x86_64-linux.tar.gz"
  command=$(scripts/readme-command.sh run)
  command=${command/cargo run --release -p organza --/organza}
  (cd "$folder" && PATH=$folder:$PATH bash -euxo pipefail -c "$command")
  test -s "$folder/run/report.html"
  python3 -m venv "$folder/venv"
  "$folder/venv/bin/pip" install --quiet --disable-pip-version-check "$out/organza-$version"-*manylinux*.whl
  awk '/^```python/ { inside = 1; next } /^```/ && inside { exit } inside' python/README.md >"$folder/first.py"
  (cd "$folder" && venv/bin/python first.py && test -s turntable.png)
  rm -rf "$folder"
}

# What the changelog says of the version, and the checksums of its files.
notes() {
  awk -v title="## $version" '/^## / { inside = $0 == title; next } inside' CHANGELOG.md >"$out/NOTES.md"
  grep -q . "$out/NOTES.md" || { echo "error: CHANGELOG.md says nothing of $version" >&2; exit 1; }
  (cd "$out" && shopt -s nullglob && sha256sum organza-"$version"-*.{tar.gz,zip,whl} >SHA256SUMS)
}

program "$platform" x86_64-linux ".$glibc"
wheel
check
if can_link x86_64-pc-windows-gnu; then program x86_64-pc-windows-gnu x86_64-windows; fi
if can_link aarch64-apple-darwin; then program aarch64-apple-darwin aarch64-macos; fi
notes
ls -lh "$out"
