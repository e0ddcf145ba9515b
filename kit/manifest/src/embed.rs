//! Embeds compiled kernels in a program. Its build script calls this.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{Manifest, source_hash};

/// What [`Manifest::is_stale`] means, and what to do.
pub const STALE: &str =
    "the compiled kernels are older than their sources: run `cargo xtask kernels`";

/// Makes the crate embed the modules of a folder and their manifest. The manifest's sources are relative to
/// `workspace`. A build script calls this; `muslin_device::modules!()` is the counterpart in the crate.
///
/// Nothing here fails. If kernels are missing or older than their sources, the crate still compiles. Its program then
/// says at run time which kernel it lacks, and how to compile it.
///
/// # Panics
/// If cargo does not run it, or if its output folder cannot be written to.
pub fn embed(kernels: &Path, workspace: &Path) {
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    println!("cargo::rerun-if-changed=build.rs");
    // Watching a missing folder would run the script at every build.
    let watched = if kernels.is_dir() { kernels } else { kernels.parent().unwrap_or(kernels) };
    println!("cargo::rerun-if-changed={}", watched.display());

    let mut manifest = Manifest::load(kernels).unwrap_or_else(|error| {
        println!("cargo::warning=no compiled kernels ({error}): run `cargo xtask kernels`");
        Manifest::empty()
    });
    manifest.is_stale = is_stale(workspace, &manifest);
    if manifest.is_stale {
        println!("cargo::warning={STALE}");
    }
    fs::write(out.join("manifest.json"), manifest.to_json()).expect("OUT_DIR is writable");
    fs::write(out.join("kernels.rs"), table(kernels, &manifest)).expect("OUT_DIR is writable");
}

/// Like [`embed`], but for a package at the root of its workspace whose modules are in `compiled`. This is the whole
/// build script of a project that `cargo xtask new` makes.
///
/// # Panics
/// If [`embed`] panics.
pub fn embed_compiled() {
    let folder = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    embed(&folder.join("compiled"), &folder);
}

/// Rust source: an array of the existing modules, each with its kernel's name, and in WGSL if that exists.
fn table(kernels: &Path, manifest: &Manifest) -> String {
    let mut table = String::from("[\n");
    for kernel in &manifest.kernels {
        let path = kernels.join(&kernel.spirv);
        if path.is_file() {
            let name = &kernel.name;
            let wgsl = kernel.wgsl.as_ref().map(|wgsl| kernels.join(&wgsl.file));
            let wgsl = match wgsl.filter(|path| path.is_file()) {
                Some(path) => format!("Some(include_str!({path:?}))"),
                None => "None".to_owned(),
            };
            writeln!(table, "    ({name:?}, &Aligned(*include_bytes!({path:?})), {wgsl}),")
                .expect("a string can be written to");
        }
    }
    table + "]\n"
}

/// Whether the GPU still runs an old version of a kernel. Without sources, this is unknown.
fn is_stale(workspace: &Path, manifest: &Manifest) -> bool {
    let folders: Vec<_> = manifest.sources.iter().map(|folder| workspace.join(folder)).collect();
    if folders.is_empty() || !folders.iter().all(|folder| folder.is_dir()) {
        return false;
    }
    for folder in folders {
        println!("cargo::rerun-if-changed={}", folder.display());
    }
    source_hash(workspace, &manifest.sources).is_ok_and(|hash| hash != manifest.source_hash)
}
