//! The files for the repository: one module per entry point, and their manifest.

use std::collections::BTreeMap;
use std::path::Path;
use std::{fmt, fs};

use anyhow::{Context, Result, bail};
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

    /// Fails with a list of differences if a folder has other content.
    pub fn check(&self, folder: &Path) -> Result<()> {
        let mut differences = Vec::new();
        for name in stale(self, folder)? {
            differences.push(format!("{name}: belongs to no kernel"));
        }
        for (name, contents) in &self.0 {
            match fs::read(folder.join(name)) {
                Err(_) => differences.push(format!("{name}: missing")),
                Ok(found) if &found == contents => {}
                Ok(found) => {
                    differences.push(difference(name, &found, contents));
                    if name == FILE_NAME {
                        differences.extend(changed_lines(&found, contents));
                    }
                }
            }
        }
        if !differences.is_empty() {
            bail!(
                "{} is not what the sources give (`cargo xtask kernels` makes it so):\n  {}",
                folder.display(),
                differences.join("\n  ")
            );
        }
        Ok(())
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

fn difference(name: &str, found: &[u8], want: &[u8]) -> String {
    let at = found.iter().zip(want).take_while(|(a, b)| a == b).count();
    let found = found.len();
    let want = want.len();
    format!("{name}: differs from byte {at} on ({found} bytes there, {want} from the sources)")
}

/// The first lines of a manifest that differ. The compiler and the hash of the sources are among the first of all.
fn changed_lines(found: &[u8], want: &[u8]) -> Vec<String> {
    let [found, want] = [found, want].map(String::from_utf8_lossy);
    let lines = found.lines().map(str::trim).zip(want.lines().map(str::trim)).zip(1..);
    let changed = lines.filter(|((found, want), _)| found != want).take(4);
    let describe = |((found, want), number): (_, u32)| {
        format!("{FILE_NAME}:{number}: `{found}` there, `{want}` from the sources")
    };
    changed.map(describe).collect()
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
        new.check(folder.path()).unwrap();
    }

    #[test]
    fn checking_lists_every_difference_and_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        artifacts(&[("a.spv", b"1"), ("b.spv", b"2")]).write(folder.path()).unwrap();
        let new = artifacts(&[("a.spv", b"9"), ("c.spv", b"3")]);
        let error = new.check(folder.path()).unwrap_err().to_string();
        for line in ["a.spv: differs", "b.spv: belongs to no kernel", "c.spv: missing"] {
            assert!(error.contains(line), "{error}");
        }
        assert_eq!(fs::read(folder.path().join("a.spv")).unwrap(), b"1");
    }

    #[test]
    fn the_compilers_versions_are_part_of_the_check() {
        let newer = Compiler { rustc: "2.0.0".into(), ..Compiler::default() };
        let found = Manifest::empty().to_json();
        let want = Manifest::new(Vec::new(), String::new(), newer, Vec::new()).to_json();
        let lines = changed_lines(found.as_bytes(), want.as_bytes());
        let line = r#"manifest.json:7: `"rustc": "",` there, `"rustc": "2.0.0",` from the sources"#;
        assert_eq!(lines, [line]);
    }
}
