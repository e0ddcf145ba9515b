#!/usr/bin/env bash
# Builds the Rust-GPU compiler from packages, for Linux machines on which rustup cannot download
# the nightly that rust-gpu pins (nightly-2026-07-03 with rustc-dev, rust-src, llvm-tools).
#
#   rustc 1.98.1      from Debian's `rust-src` package (the whole compiler tree is in it);
#                     1.98 is the release that nightly-2026-07-03 became
#   LLVM 22           from Debian's `llvm-22-dev`
#   codegen backend   rustc_codegen_spirv 0.10.0 from the Cargo registry, unpatched
#   stage0            the machine's own nightly (1.97 or 1.98), or STAGE0=<sysroot>
#
# Result: $PREFIX/toolchain, linked as the rustup toolchain `rust-gpu`, with the backend at
# $PREFIX/toolchain/lib/librustc_codegen_spirv.so. Does nothing when that toolchain works already.
# It needs Debian 12 or later on x86-64, and root where Debian packages are missing.
set -euo pipefail

given_prefix=${PREFIX:-}
PREFIX=${PREFIX:-${XDG_CACHE_HOME:-$HOME/.cache}/rust-gpu}
RUSTC_VERSION=1.98.1
BACKEND_VERSION=0.10.0
HOST=x86_64-unknown-linux-gnu
TOOLCHAIN=$PREFIX/toolchain
BACKEND=$TOOLCHAIN/lib/librustc_codegen_spirv.so
PATH=$PATH:/usr/sbin:/sbin
# What a surrounding cargo or its user sets is meant for other builds.
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET CARGO_TARGET_DIR RUSTC RUSTC_WRAPPER RUSTUP_TOOLCHAIN

say() { printf '\033[1m== %s\033[0m\n' "$*" >&2; }
die() { printf 'error: %s\n' "$1" >&2; shift; (( $# == 0 )) || printf '  %s\n' "$@" >&2; exit 1; }

# The package manager's lock may be held by the machine's own updates: wait for it.
apt_get() { apt-get -o DPkg::Lock::Timeout=600 "$@"; }

# Installs the packages that are missing.
need() {
  local package missing=()
  for package; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  (( ${#missing[@]} )) || return 0
  (( EUID == 0 )) || die "Debian packages are missing, and only root can install them:" \
    "sudo apt-get install --no-install-recommends ${missing[*]}"
  apt_get update -q
  apt_get install -qy --no-install-recommends "${missing[@]}"
}

link() {
  if command -v rustup >/dev/null; then
    rustup toolchain link rust-gpu "$TOOLCHAIN"
  else
    say "there is no rustup: name the compiler by MUSLIN_RUST_GPU=$TOOLCHAIN"
  fi
}

# Whether a sysroot holds a compiler that runs, and the backend.
works() { [[ -f $1/lib/librustc_codegen_spirv.so ]] && "$1/bin/rustc" --version >/dev/null 2>&1; }

# With a place in the command, the toolchain is built there.
if [[ -z $given_prefix ]] && linked=$(rustup run rust-gpu rustc --print sysroot 2>/dev/null) && works "$linked"; then
  say "already there: the rustup toolchain \`rust-gpu\` at $linked"
  exit 0
fi
use_what_is_built() {
  [[ -f $BACKEND ]] || return 0
  # The compiler loads LLVM from Debian's library, which a restored cache does not bring.
  works "$TOOLCHAIN" || need libllvm22
  works "$TOOLCHAIN" || die "$TOOLCHAIN is damaged: remove it, and run this again"
  link
  say "already built: $TOOLCHAIN"
  exit 0
}
use_what_is_built

[[ $(uname -sm) == "Linux x86_64" ]] || die "this script builds for x86-64 Linux alone"
command -v apt-get >/dev/null || die "this script takes LLVM and the compiler's sources from Debian: there is no apt-get"
STAGE0=${STAGE0:-$(rustc +nightly --print sysroot 2>/dev/null)} || STAGE0=
[[ -x $STAGE0/bin/rustc && -x $STAGE0/bin/cargo ]] || die \
  "rustc is built with an earlier rustc, and there is no nightly toolchain to do it." \
  "Either have rustup install one: rustup toolchain install nightly-2026-05-20, and then" \
  "STAGE0=\$(rustc +nightly-2026-05-20 --print sysroot) $0" \
  "or name the sysroot of a nightly of rustc 1.97 or 1.98 by STAGE0=<sysroot>."
stage0_version=$("$STAGE0/bin/rustc" --version)
[[ $stage0_version =~ ^rustc\ 1\.9[78]\..*nightly ]] || die \
  "rustc $RUSTC_VERSION is built with a nightly of rustc 1.97 or 1.98; $STAGE0 is $stage0_version." \
  "Name another by STAGE0=<sysroot>."

mkdir -p "$PREFIX"
cd "$PREFIX"
exec 9>lock
flock -n 9 || { say "another build is running in $PREFIX: waiting for it"; flock 9; }
use_what_is_built
free=$(df --output=avail -BG . | tail -n 1 | tr -dc 0-9)
say "building rustc $RUSTC_VERSION and rust-gpu $BACKEND_VERSION in $PREFIX:" \
  "about 25 minutes on 2 cores, 3 GB of disk meanwhile ($free GB are free), 0.4 GB afterwards"
(( free >= 3 )) || die "not enough disk: point PREFIX at a folder with 3 GB"

say "1/5 Debian packages"
need llvm-22-dev g++ pkg-config zlib1g-dev libzstd-dev python3
if [[ ! -d src/compiler ]]; then
  # a package list of its own: the machine's sources stay as they are
  mkdir -p apt/lists/partial apt/cache/archives/partial
  # shellcheck disable=SC2016  # apt-get fills in $(REPO_URI)
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/$' | head -n 1) || true
  [[ -n $mirror ]] || die "no Debian mirror among this machine's package sources"
  for suite in experimental sid; do
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main"
  done >apt/sources.list
  apt=(-o "Dir::Etc::sourcelist=$PREFIX/apt/sources.list" -o Dir::Etc::sourceparts=-
       -o "Dir::State::lists=$PREFIX/apt/lists" -o "Dir::Cache=$PREFIX/apt/cache" -o APT::Sandbox::User=root)
  apt_get "${apt[@]}" update -q
  package=$(apt-cache "${apt[@]}" madison rust-src | awk -v v="$RUSTC_VERSION" '$3 ~ "^"v && !found {print $3; found = 1}')
  [[ -n $package ]] || die "rust-src $RUSTC_VERSION is no longer in Debian's archive"
  apt_get "${apt[@]}" download "rust-src=$package"
  dpkg-deb -x rust-src_*.deb unpacked
  mv "unpacked/usr/src/rustc-$RUSTC_VERSION" src
  rm -rf unpacked rust-src_*.deb apt
fi

say "2/5 rustc $RUSTC_VERSION (about 15 minutes)"
cat >src/bootstrap.toml <<TOML
change-id = "ignore"
profile = "user"
[llvm]
download-ci-llvm = false
link-shared = true
[build]
build = "$HOST"
host = ["$HOST"]
target = ["$HOST"]
rustc = "$STAGE0/bin/rustc"
cargo = "$STAGE0/bin/cargo"
docs = false
compiler-docs = false
submodules = false
vendor = false
extended = false
tools = []
optimized-compiler-builtins = false
[rust]
channel = "nightly"
optimize = 1
debug = false
debuginfo-level = 0
incremental = false
codegen-units = 16
deny-warnings = false
rpath = true
lld = false
llvm-tools = false
llvm-bitcode-linker = false
download-rustc = false
codegen-tests = false
omit-git-hash = true
remap-debuginfo = false
jemalloc = false
[target.$HOST]
llvm-config = "$(command -v llvm-config-22)"
TOML
(cd src && python3 x.py build --stage 1 library --build-dir "$PREFIX/build")
built=$PREFIX/build/$HOST

say "3/5 a stage0 sysroot that holds the compiler's crates"
# The backend is loaded by the stage1 compiler, whose crates stage0 compiled: so stage0 compiles it.
dev=$PREFIX/stage0-dev
rm -rf "$dev" && mkdir -p "$dev/lib/rustlib/rustc-src/rust"
cp -a "$STAGE0/bin" "$dev/"
cp -a "$STAGE0"/lib/*.so* "$dev/lib/"
cp -a "$built/stage0-sysroot/lib/rustlib/$HOST" "$dev/lib/rustlib/"
ln -s "$PREFIX/src/compiler" "$dev/lib/rustlib/rustc-src/rust/compiler"

say "4/5 rustc_codegen_spirv $BACKEND_VERSION (about 9 minutes)"
mkdir -p fetch/src && : >fetch/src/lib.rs
cat >fetch/Cargo.toml <<TOML
[package]
name = "fetch"
version = "0.0.0"
edition = "2021"
[dependencies]
rustc_codegen_spirv = "=$BACKEND_VERSION"
[workspace]
TOML
RUSTC="$STAGE0/bin/rustc" "$STAGE0/bin/cargo" fetch --manifest-path fetch/Cargo.toml
rm -rf backend
sources=("${CARGO_HOME:-$HOME/.cargo}"/registry/src/*/"rustc_codegen_spirv-$BACKEND_VERSION")
cp -r "${sources[0]}" backend
# The release's rustc_codegen_ssa wants one feature gate that the pinned nightly did not yet need.
(cd backend && RUSTC="$dev/bin/rustc" RUSTGPU_SKIP_TOOLCHAIN_CHECK=1 "$dev/bin/cargo" rustc --release --locked --lib \
  -- '-Zcrate-attr=feature(option_into_flat_iter)')

say "5/5 $TOOLCHAIN"
rm -rf "$TOOLCHAIN.new" && mkdir -p "$TOOLCHAIN.new/lib/rustlib/src/rust" "$TOOLCHAIN.new/bin"
cp "$built/stage1/bin/rustc" "$STAGE0/bin/cargo" "$TOOLCHAIN.new/bin/"
cp -aL "$built"/stage1/lib/*.so "$TOOLCHAIN.new/lib/"
cp -aL "$built/stage1/lib/rustlib/$HOST" "$TOOLCHAIN.new/lib/rustlib/"
cp -r src/library src/Cargo.lock "$TOOLCHAIN.new/lib/rustlib/src/rust/"
cp backend/target/release/librustc_codegen_spirv.so "$TOOLCHAIN.new/lib/"
strip --strip-unneeded "$TOOLCHAIN.new"/lib/*.so
rm -rf "$TOOLCHAIN" && mv "$TOOLCHAIN.new" "$TOOLCHAIN"
rm -rf build backend fetch stage0-dev src
link
say "done: $("$TOOLCHAIN/bin/rustc" --version), backend $BACKEND"
