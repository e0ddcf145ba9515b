//! The hash that connects compiled kernels with their sources.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use sha2::{Digest, Sha256};

use crate::{Error, Manifest};

/// Packages whose code or whose compiler influences the SPIR-V: with another version, the same sources may give other
/// modules.
const COMPILED_IN: [&str; 7] = [
    "glam",
    "libm",
    "num-traits",
    "muslin-kernel",
    "muslin-macros",
    "spirv-std",
    "spirv-std-macros",
];

/// The hash of the kernel sources: of every `.rs` file and `Cargo.toml` in the folders, which are relative to the
/// workspace, and of the versions in the workspace's lock file of the packages that are compiled into kernels.
///
/// Line breaks count as `\n`, and paths have `/`, so that checkouts on all systems agree.
///
/// # Errors
/// [`Error::Read`]; [`Error::NotLocked`] if the lock file lacks one of the packages.
pub fn source_hash(workspace: &Path, folders: &[String]) -> Result<String, Error> {
    let mut files = Vec::new();
    for folder in folders {
        collect(&workspace.join(folder), &format!("{folder}/"), &mut files)?;
    }
    files.sort();
    let mut hash = Sha256::new();
    for (name, path) in files {
        let contents = fs::read(&path).map_err(|reason| Error::Read { path, reason })?;
        // Lengths are hashed, too, so that text cannot move from one file to the next unnoticed.
        let contents = without_carriage_returns(&contents);
        hash.update(format!("file {name} {}\n", contents.len()));
        hash.update(contents);
    }
    let lock = workspace.join("Cargo.lock");
    for package in COMPILED_IN {
        hash.update(format!("package {package} {}\n", locked_version(&lock, package)?));
    }
    Ok(format!("{:x}", hash.finalize()))
}

/// The version of a package in a `Cargo.lock`; all of them if several are locked.
pub fn locked_version(lock: &Path, package: &str) -> Result<String, Error> {
    let text =
        fs::read_to_string(lock).map_err(|reason| Error::Read { path: lock.to_owned(), reason })?;
    let name = format!("name = \"{package}\"");
    let mut versions = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        // Cargo writes a package's version on the line after its name.
        if line == name
            && let Some(version) = lines.next().and_then(|line| line.strip_prefix("version = \""))
        {
            versions.push(version.trim_end_matches('"').to_owned());
        }
    }
    if versions.is_empty() {
        return Err(Error::NotLocked { path: lock.to_owned(), package: package.to_owned() });
    }
    Ok(versions.join(", "))
}

/// Finds the files to hash below a folder, with their names relative to the workspace.
fn collect(folder: &Path, prefix: &str, files: &mut Vec<(String, PathBuf)>) -> Result<(), Error> {
    let unreadable = |reason| Error::Read { path: folder.to_owned(), reason };
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let relative = format!("{prefix}{name}");
        if entry.file_type().map_err(unreadable)?.is_dir() {
            if name != "target" && !name.starts_with('.') {
                collect(&entry.path(), &format!("{relative}/"), files)?;
            }
        } else if name == "Cargo.toml" || (name.ends_with(".rs") && !name.starts_with('.')) {
            files.push((relative, entry.path()));
        }
    }
    Ok(())
}

fn without_carriage_returns(text: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(text.len());
    for (i, &byte) in text.iter().enumerate() {
        if byte != b'\r' || text.get(i + 1) != Some(&b'\n') {
            out.push(byte);
        }
    }
    out
}

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
    let hash = hash_now(workspace, &manifest);
    manifest.is_stale = hash.is_some_and(|hash| hash != manifest.source_hash);
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

/// Rust source: an array of the existing modules, each with its kernel's name.
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

/// The hash of the sources as they are now: with another than the manifest's, a GPU still runs an old version of a kernel. Without sources,
/// this is unknown.
fn hash_now(workspace: &Path, manifest: &Manifest) -> Option<String> {
    let folders: Vec<_> = manifest.sources.iter().map(|folder| workspace.join(folder)).collect();
    if folders.is_empty() || !folders.iter().all(|folder| folder.is_dir()) {
        return None;
    }
    for folder in folders {
        println!("cargo::rerun-if-changed={}", folder.display());
    }
    source_hash(workspace, &manifest.sources).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A workspace with a shader crate of one file, and a lock file with the given version of `glam`.
    fn workspace(source: &str, glam: &str) -> tempfile::TempDir {
        let root = tempfile::tempdir().unwrap();
        let lock: String = COMPILED_IN
            .iter()
            .map(|name| (name, if *name == "glam" { glam } else { "1.0.0" }))
            .map(|(name, version)| {
                format!("[[package]]\nname = \"{name}\"\nversion = \"{version}\"\n\n")
            })
            .collect();
        fs::write(root.path().join("Cargo.lock"), lock).unwrap();
        fs::create_dir_all(root.path().join("shader-crate/src")).unwrap();
        fs::write(root.path().join("shader-crate/Cargo.toml"), "[package]\n").unwrap();
        fs::write(root.path().join("shader-crate/src/lib.rs"), source).unwrap();
        root
    }

    fn hash_of(root: &tempfile::TempDir) -> String {
        source_hash(root.path(), &["shader-crate".to_owned()]).unwrap()
    }

    #[test]
    fn line_ends_and_build_outputs_do_not_count() {
        let unix = workspace("a\nb\n", "0.33.0");
        let windows = workspace("a\r\nb\r\n", "0.33.0");
        fs::create_dir(windows.path().join("shader-crate/target")).unwrap();
        fs::write(windows.path().join("shader-crate/target/x.rs"), "x").unwrap();
        fs::write(windows.path().join("shader-crate/notes.txt"), "x").unwrap();
        assert_eq!(hash_of(&unix), hash_of(&windows));
    }

    #[test]
    fn sources_names_and_versions_count() {
        let base = hash_of(&workspace("a\n", "0.33.0"));
        assert_ne!(base, hash_of(&workspace("b\n", "0.33.0")));
        assert_ne!(base, hash_of(&workspace("a\n", "0.33.1")));
        let renamed = workspace("a\n", "0.33.0");
        let src = renamed.path().join("shader-crate/src");
        fs::rename(src.join("lib.rs"), src.join("other.rs")).unwrap();
        assert_ne!(base, hash_of(&renamed));
    }

    #[test]
    fn a_package_missing_from_the_lock_is_named() {
        let root = workspace("", "0.33.0");
        let error = locked_version(&root.path().join("Cargo.lock"), "nothing").unwrap_err();
        assert!(error.to_string().contains("`nothing`"));
    }
}
