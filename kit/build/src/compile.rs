//! Compiles a crate of kernels and describes the modules.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use muslin_kernel::{EntryPoint, KernelInfo};
use muslin_manifest as manifest;
use muslin_manifest::{Interface, KernelEntry, Manifest, Translation};
use spirv_builder::{ModuleResult, SpirvBuilder, SpirvMetadata};

use crate::artifacts::Artifacts;
use crate::compiler::Compiler;
use crate::lower::{self, lower};
use crate::{Project, module, naga_check, rules, small_integers};

/// SPIR-V 1.5, of Vulkan 1.2, is the newest version that all our drivers read.
pub const TARGET: &str = "spirv-unknown-vulkan1.2";

/// Compiles every kernel that the caller is linked with, each to one module.
///
/// # Errors
/// The compiler's errors, and an error if a kernel does not match its module.
pub fn compile(project: &Project, compiler: &Compiler) -> Result<Artifacts> {
    rules::check(&project.root.join(&project.shader_crate))?;
    // Before the build: if a file is saved while it runs, the kernels must be stale.
    let source_hash = manifest::source_hash(&project.root, &project.sources)?;
    let mut modules = build(&project.root.join(&project.shader_crate), &project.target, compiler)?;
    let mut entries = Vec::new();
    let mut files = BTreeMap::new();
    refuse_one_name_twice()?;
    let kernels = muslin_kernel::kernels();
    let all = kernels.flat_map(|kernel| kernel.entry_points().map(move |entry| (kernel, entry)));
    for (kernel, point) in all {
        let name = point.name;
        let Some(spirv) = modules.remove(name) else {
            bail!("{}: the kernel `{name}` has no entry point in the SPIR-V", kernel.source());
        };
        let context = || format!("{}: kernel `{name}`", kernel.source());
        let spirv = lower(&spirv, kernel.fused, kernel.workgroup_size).with_context(context)?;
        module::check(kernel, &point, &spirv).with_context(context)?;
        naga_check::check(&spirv).with_context(context)?;
        let wgsl = match project.wgsl && point.name == kernel.name {
            true => naga_check::to_wgsl(&spirv).with_context(context)?,
            false => None,
        };
        let entry = entry(kernel, &point, &spirv, wgsl.as_deref());
        if let (Some(translation), Some(text)) = (&entry.wgsl, wgsl) {
            files.insert(translation.file.clone(), text.into_bytes());
        }
        files.insert(entry.spirv.clone(), spirv);
        entries.push(entry);
    }
    if let Some(name) = modules.keys().next() {
        bail!("the SPIR-V has an entry point `{name}` that is no kernel of the registry");
    }
    let lock = project.root.join("Cargo.lock");
    let versions = manifest::Compiler {
        rust_gpu: manifest::locked_version(&lock, "spirv-std")?,
        rustc: compiler.rustc.clone(),
        target: TARGET.to_owned(),
    };
    let manifest = Manifest::new(project.sources.clone(), source_hash, versions, entries);
    files.insert(manifest::FILE_NAME.to_owned(), manifest.to_json().into_bytes());
    Ok(Artifacts::new(files))
}

/// All entry points are compiled together, so two kernels must not have the same name.
fn refuse_one_name_twice() -> Result<()> {
    let mut found: BTreeMap<_, &KernelInfo> = BTreeMap::new();
    for kernel in muslin_kernel::kernels() {
        if let Some(other) = found.insert(kernel.name, kernel) {
            let one = kernel.source();
            let other = other.source();
            bail!("two kernels are named `{}`: in {other} and in {one}", kernel.name);
        }
    }
    Ok(())
}

/// Runs the compiler on a crate of kernels. Returns the modules by entry point.
///
/// # Errors
/// The compiler's errors.
pub fn build(
    shader_crate: &Path,
    target: &Path,
    compiler: &Compiler,
) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut builder = SpirvBuilder::new(shader_crate, TARGET)
        .release(true)
        .multimodule(true)
        .spirv_metadata(SpirvMetadata::None)
        .target_dir_path(target.join("spirv"));
    builder.capabilities =
        [&lower::SUBGROUPS[..], &lower::WIDE, &small_integers::CAPABILITIES, &[lower::AS_WRITTEN]]
            .concat();
    compiler.configure(&mut builder);
    let result = builder.build().context("the kernels do not compile")?;
    let ModuleResult::MultiModule(paths) = result.module else {
        bail!("the compiler gave one module for all kernels, not one for each");
    };
    let read = |(name, path)| Ok((name, fs::read(&path)?));
    paths.into_iter().map(read).collect()
}

fn entry(kernel: &KernelInfo, point: &EntryPoint, spirv: &[u8], wgsl: Option<&str>) -> KernelEntry {
    let translation = |text: &str| Translation {
        file: format!("{}.wgsl", point.name),
        sha256: manifest::sha256(text.as_bytes()),
    };
    KernelEntry {
        name: point.name.to_owned(),
        package: kernel.package.to_owned(),
        file: kernel.source(),
        spirv: format!("{}.spv", point.name),
        spirv_bytes: spirv.len() as u64,
        spirv_sha256: manifest::sha256(spirv),
        wgsl: wgsl.map(translation),
        interface: Interface::new(kernel, point),
    }
}
