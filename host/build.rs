//! Embeds the compiled kernels of `kernels/` and their manifest.
//!
//! Nothing here fails: where kernels are missing or older than their sources, organza compiles all
//! the same, and says at run time which kernel it lacks and how to compile it.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use organza_manifest::{Manifest, source_hash};

fn main() {
    let host = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    let kernels = host.join("kernels");
    println!("cargo::rerun-if-changed=build.rs");
    // A missing folder would have this script run at every build.
    let watched = if kernels.is_dir() { &kernels } else { &host };
    println!("cargo::rerun-if-changed={}", watched.display());

    let manifest = Manifest::load(&kernels).unwrap_or_else(|error| {
        println!("cargo::warning=no compiled kernels ({error}): run `cargo xtask kernels`");
        Manifest::empty()
    });
    warn_when_stale(&host.join("../shader-crate"), &manifest);
    fs::write(out.join("manifest.json"), manifest.to_json()).expect("OUT_DIR is writable");
    fs::write(out.join("kernels.rs"), table(&kernels, &manifest)).expect("OUT_DIR is writable");
}

/// Rust source: an array of the modules that are there, each with its kernel's name.
fn table(kernels: &Path, manifest: &Manifest) -> String {
    let mut table = String::from("[\n");
    for kernel in &manifest.kernels {
        let path = kernels.join(&kernel.spirv);
        if path.is_file() {
            let name = &kernel.name;
            writeln!(table, "    ({name:?}, &Aligned(*include_bytes!({path:?}))),")
                .expect("a string can be written to");
        }
    }
    table + "]\n"
}

/// Tells the author of a kernel that the GPU still runs the last version. Outside the workspace
/// there are no kernel sources, and nothing to tell.
fn warn_when_stale(shader_crate: &Path, manifest: &Manifest) {
    if manifest.kernels.is_empty() || !shader_crate.is_dir() {
        return;
    }
    println!("cargo::rerun-if-changed={}", shader_crate.display());
    if source_hash(shader_crate).is_ok_and(|hash| hash != manifest.source_hash) {
        println!(
            "cargo::warning=the compiled kernels are older than shader-crate: \
             run `cargo xtask kernels`"
        );
    }
}
