//! The files for the repository: one module per entry point, and their manifest.

use std::collections::BTreeMap;
use std::path::Path;
use std::{fmt, fs};

use anyhow::{Context, Result};
use muslin_manifest::FILE_NAME;

/// The compiled kernels and their manifest, by file name.
pub struct Artifacts(pub BTreeMap<String, Vec<u8>>);

impl Artifacts {
    /// The modules with their file names.
    pub fn modules(&self) -> impl Iterator<Item = (&str, &[u8])> {
        let files = self.0.iter().filter(|(name, _)| is_module(name));
        files.map(|(name, contents)| (name.as_str(), contents.as_slice()))
    }

    /// Updates a folder, and returns the number of changed files. The manifest comes last: if this is interrupted,
    /// the manifest's hashes reveal the mixture.
    pub fn write(&self, folder: &Path) -> Result<usize> {
        fs::create_dir_all(folder)?;
        let mut changed = 0;
        for name in stale(self, folder)? {
            fs::remove_file(folder.join(name))?;
            changed += 1;
        }
        let (manifest, modules): (Vec<_>, Vec<_>) =
            self.0.iter().partition(|(name, _)| *name == FILE_NAME);
        for (name, contents) in modules.into_iter().chain(manifest) {
            changed += usize::from(replace(&folder.join(name), contents)?);
        }
        Ok(changed)
    }
}

impl fmt::Display for Artifacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.0.keys().map(String::len).max().unwrap_or(0);
        writeln!(f, "{:width$}  {:>9}", "module", "bytes")?;
        let mut total = 0;
        for (name, contents) in self.modules() {
            writeln!(f, "{name:width$}  {:>9}", contents.len())?;
            total += contents.len();
        }
        write!(f, "{:width$}  {total:>9}", format!("{} modules", self.modules().count()))
    }
}

fn is_module(name: &str) -> bool {
    name.ends_with(".spv")
}

/// Whether this program writes files of this name, besides the manifest.
fn is_ours(name: &str) -> bool {
    is_module(name) || name.ends_with(".wgsl")
}

/// The modules and translations in a folder that do not belong to any kernel anymore.
fn stale(artifacts: &Artifacts, folder: &Path) -> Result<Vec<String>> {
    let mut stale = Vec::new();
    // A folder that does not exist yet is empty.
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if is_ours(&name) && !artifacts.0.contains_key(&name) {
            stale.push(name);
        }
    }
    stale.sort();
    Ok(stale)
}

/// Writes a temporary file and renames it, so that no reader sees half a file. Does not touch a file whose content is
/// right already, so that the host crate is not compiled again.
fn replace(path: &Path, contents: &[u8]) -> Result<bool> {
    if fs::read(path).is_ok_and(|found| found == contents) {
        return Ok(false);
    }
    let beside = path.with_extension("new");
    fs::write(&beside, contents)
        .and_then(|()| fs::rename(&beside, path))
        .with_context(|| format!("cannot write {}", path.display()))?;
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use muslin_manifest::{Compiler, Manifest};

    fn artifacts(modules: &[(&str, &[u8])]) -> Artifacts {
        let manifest = Manifest::new(Vec::new(), "hash".into(), Compiler::default(), Vec::new());
        let mut files: BTreeMap<_, _> =
            modules.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())).collect();
        files.insert(FILE_NAME.to_owned(), manifest.to_json().into_bytes());
        Artifacts(files)
    }

    #[test]
    fn writing_replaces_changed_files_and_removes_stale_ones() {
        let folder = tempfile::tempdir().unwrap();
        let old = artifacts(&[("a.spv", b"1"), ("b.spv", b"2"), ("b.wgsl", b"3")]);
        assert_eq!(old.write(folder.path()).unwrap(), 4);
        assert_eq!(old.write(folder.path()).unwrap(), 0);
        let new = artifacts(&[("a.spv", b"1"), ("c.spv", b"3")]);
        assert_eq!(new.write(folder.path()).unwrap(), 3);
        assert!(!folder.path().join("b.spv").exists());
        assert_eq!(fs::read(folder.path().join("c.spv")).unwrap(), b"3");
    }
}
