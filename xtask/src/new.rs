//! Makes a separate project: the example in `kit/examples/`, with paths to the kit's crates.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use muslin_build::Project;

/// Path of the example in the workspace.
const EXAMPLE: &str = "kit/examples/picture";

/// Beginning of the paths to the kit's crates.
const KIT: &str = "path = \"../..";

/// Copies the example to a folder, and adapts the paths to the kit of this workspace.
pub fn run(project: &Project, folder: &Path) -> Result<()> {
    let is_empty = fs::read_dir(folder).map_or(!folder.exists(), |mut all| all.next().is_none());
    ensure!(is_empty, "{} is there already, and not empty", folder.display());
    copy_tree(&project.root.join(EXAMPLE), folder)?;
    let manifest = folder.join("Cargo.toml");
    let text = fs::read_to_string(&manifest)?;
    ensure!(text.contains(KIT), "{EXAMPLE}/Cargo.toml names the kit's crates by other paths");
    let kit = project.root.canonicalize()?.join("kit");
    let kit = kit.to_str().context("the workspace's folder has a name that is not UTF-8")?;
    fs::write(&manifest, text.replace(KIT, &format!("path = \"{}", kit.replace('\\', "/"))))?;
    // the versions that the kit was tested with; cargo removes packages that the project does not use
    fs::copy(project.root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
    println!(
        "{0} has three kernels and their tests. Now:\n  \
         cd {0}\n  \
         cargo test -p picture-kernels   # the kernels as functions, on the CPU\n  \
         cargo xtask kernels             # compiles them for GPUs\n  \
         cargo test                      # on the CPU, and on a GPU in two ways",
        folder.display()
    );
    Ok(())
}

fn copy_tree(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        // cargo's build output
        if entry.file_name() == "target" {
            continue;
        }
        let target = to.join(entry.file_name());
        match entry.file_type()?.is_dir() {
            true => copy_tree(&entry.path(), &target)?,
            false => drop(fs::copy(entry.path(), target)?),
        }
    }
    Ok(())
}
