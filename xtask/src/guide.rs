//! Compiles the kernel of docs/adding-a-kernel.md like a reader of that page: as a file of the shader crate.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use organza_build::{Compiler, Project, build, isolate, lower};

/// Name of the kernel, of its file and of its module.
const KERNEL: &str = "blend";

/// Copies the sources of the shader crate, adds the page's file and its line in `lib.rs`, and compiles the copy.
pub fn run(project: &Project) -> Result<()> {
    isolate();
    let shader_crate = project.root.join(&project.shader_crate);
    let compiler = Compiler::find(&shader_crate)?;
    let copy = project.target.join("guide");
    if copy.exists() {
        fs::remove_dir_all(&copy)?;
    }
    for folder in &project.sources {
        copy_tree(&project.root.join(folder), &copy.join(folder))?;
    }
    let shader_crate = copy.join(&project.shader_crate);
    fs::copy(project.root.join("Cargo.lock"), copy.join("Cargo.lock"))?;
    let manifest = fs::read_to_string(project.root.join("Cargo.toml"))?;
    fs::write(copy.join("Cargo.toml"), reduced(&manifest, &project.sources)?)?;
    let source = project.root.join("tests/guide").join(format!("{KERNEL}.rs"));
    fs::copy(&source, shader_crate.join("src").join(format!("{KERNEL}.rs")))
        .with_context(|| format!("cannot copy {}", source.display()))?;
    let lib = shader_crate.join("src/lib.rs");
    fs::write(&lib, fs::read_to_string(&lib)? + &format!("\npub mod {KERNEL};\n"))?;

    let mut modules = build(&shader_crate, &project.target, &compiler)?;
    let module = modules.remove(KERNEL).context("the page's kernel has no entry point")?;
    let module = lower(&module, false)?;
    println!("docs/adding-a-kernel.md: `{KERNEL}` compiles to {} bytes", module.len());
    others_are_as_before(&modules, &project.root.join(&project.kernels))
}

/// Checks that one more kernel, or a changed one, leaves all other modules unchanged, byte for byte.
fn others_are_as_before(modules: &BTreeMap<String, Vec<u8>>, folder: &Path) -> Result<()> {
    for kernel in organza_kernel::kernels() {
        for name in kernel.entry_points().map(|point| point.name) {
            let module = modules.get(name).with_context(|| format!("`{name}` is missing"))?;
            let before = folder.join(format!("{name}.spv"));
            let before =
                fs::read(&before).with_context(|| format!("cannot read {}", before.display()))?;
            let is_same = lower(module, kernel.fused)? == before;
            ensure!(
                is_same,
                "`{KERNEL}` has changed `{name}` (if `cargo xtask kernels --check` passes)"
            );
        }
    }
    println!("it leaves the {} other modules as they are", modules.len());
    Ok(())
}

/// The workspace's manifest with only the kernels' sources as members: Cargo reads no others.
fn reduced(manifest: &str, sources: &[String]) -> Result<String> {
    let is_list = |line: &str| line.starts_with("members") || line.starts_with("default-members");
    ensure!(manifest.lines().any(is_list), "the workspace's manifest lists no members");
    let line = |line: &str| match line.split_once('=') {
        Some(("members ", _)) => format!("members = {sources:?}\n"),
        Some(("default-members ", _)) => String::new(),
        _ => format!("{line}\n"),
    };
    Ok(manifest.lines().map(line).collect())
}

pub fn copy_tree(from: &Path, to: &Path) -> Result<()> {
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
