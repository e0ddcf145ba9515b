//! Finds the SPIR-V compiler: a rustc, and Rust-GPU's backend for exactly that rustc. Compiles a crate of kernels with it.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio, exit};
use std::time::SystemTime;
use std::{env, fmt, fs};

use crate::artifacts::Artifacts;
use crate::lower::{self, lower};
use crate::{Project, errors, module, rules, small_integers, tiles, validate};
use anyhow::{Context, Result, anyhow, bail};
use cargo_gpu_install::install::Install;
use muslin_kernel::{EntryPoint, KernelInfo};
use muslin_manifest as manifest;
use muslin_manifest::{Interface, KernelEntry, Manifest};
use spirv_builder::{ModuleResult, SpirvBuilder, SpirvMetadata};

/// Variable that names the compiler: a rustup toolchain, a sysroot, or [`PINNED`].
const VARIABLE: &str = "MUSLIN_RUST_GPU";

/// The rustup toolchain that is used if it exists.
const TOOLCHAIN: &str = "rust-gpu";

/// The value of [`VARIABLE`] that asks for the nightly that Rust-GPU pins, even if there are others.
const PINNED: &str = "pinned";

/// Advice if there is no compiler.
const ADVICE: &str = "the README of muslin-build says how to get it";

/// Variables that would change the compiler's options, besides all `CARGO_PROFILE_*`. The modules must depend only on the
/// sources and the compiler.
const UNWANTED: [&str; 7] = [
    "CARGO_BUILD_RUSTC",
    "CARGO_BUILD_RUSTC_WRAPPER",
    "CARGO_BUILD_RUSTFLAGS",
    "CARGO_BUILD_TARGET",
    "RUSTGPU_CARGOFLAGS",
    "RUSTGPU_CODEGEN_ARGS",
    "RUSTGPU_RUSTFLAGS",
];

/// The profile of the kernels, independent of the workspace's. With debug information, a module would contain the
/// whole source text, and paths of the machine that compiled it.
const PROFILE: [(&str, &str); 3] = [
    ("CARGO_PROFILE_RELEASE_DEBUG", "false"),
    ("CARGO_PROFILE_RELEASE_INCREMENTAL", "false"),
    ("CARGO_PROFILE_RELEASE_OPT_LEVEL", "3"),
];

/// A rustc with Rust-GPU's backend.
pub struct Compiler {
    /// The source of this rustc. A toolchain is an argument of cargo; others are in the search path.
    origin: Origin,
    backend: PathBuf,
    /// Version of the rustc.
    pub rustc: String,
}

enum Origin {
    Toolchain(String),
    Sysroot(PathBuf),
}

/// Protects builds of this process from the user's environment. Call it before any thread starts.
pub fn isolate() {
    for (name, _) in env::vars_os() {
        if name.to_str().is_some_and(unwanted) {
            eprintln!("ignoring the environment variable {}", name.display());
            // SAFETY: this process has one thread.
            unsafe { env::remove_var(name) };
        }
    }
    for (name, value) in PROFILE {
        // SAFETY: this process has one thread.
        unsafe { env::set_var(name, value) };
    }
}

fn unwanted(name: &str) -> bool {
    UNWANTED.contains(&name) || name.starts_with("CARGO_PROFILE_")
}

impl Compiler {
    /// Finds the compiler, or lets rustup install the one that Rust-GPU documents. Call it before any thread starts.
    pub fn find(shader_crate: &Path) -> Result<Self> {
        match env::var(VARIABLE).unwrap_or_default().as_str() {
            "" if toolchain_exists(TOOLCHAIN)? => Self::toolchain(TOOLCHAIN),
            "" | PINNED => Self::pinned(shader_crate),
            value if Path::new(value).is_dir() => Self::sysroot(Path::new(value)),
            value => Self::toolchain(value),
        }
        .with_context(|| format!("no SPIR-V compiler ({ADVICE})"))
    }

    /// A rustup toolchain with the backend in its own `lib`.
    fn toolchain(name: &str) -> Result<Self> {
        let sysroot = output(Command::new("rustup").args(["run", name, "rustc"]).args(SYSROOT))
            .with_context(|| format!("the rustup toolchain `{name}` does not work"))?;
        let origin = Origin::Toolchain(name.to_owned());
        Self::new(origin, backend_in(Path::new(&sysroot))?)
    }

    /// A toolchain, backend included, that rustup need not know.
    fn sysroot(sysroot: &Path) -> Result<Self> {
        let sysroot = sysroot.canonicalize()?;
        for tool in ["rustc", "cargo"] {
            let tool = sysroot.join("bin").join(tool).with_extension(env::consts::EXE_EXTENSION);
            if !tool.is_file() {
                bail!("{VARIABLE} names a sysroot without {}", tool.display());
            }
        }
        let backend = backend_in(&sysroot)?;
        // Its cargo and rustc must be found before rustup's.
        let mut path = OsString::from(sysroot.join("bin"));
        if let Some(rest) = env::var_os("PATH") {
            path.push(if cfg!(windows) { ";" } else { ":" });
            path.push(rest);
        }
        // SAFETY: this process has one thread.
        unsafe { env::set_var("PATH", path) };
        Self::new(Origin::Sysroot(sysroot), backend)
    }

    /// The nightly that this release of Rust-GPU pins, and the backend built with it. It is installed as `cargo gpu`
    /// does it, the way that Rust-GPU documents.
    fn pinned(shader_crate: &Path) -> Result<Self> {
        output(Command::new("rustup").arg("--version"))?;
        eprintln!(
            "using the nightly that Rust-GPU pins; where it is missing, rustup installs it and \
             cargo builds the backend, once (some minutes, 1 GB)"
        );
        let installed = Install::from_shader_crate(shader_crate.to_owned())
            .run()
            .context("the nightly that Rust-GPU pins could not be made ready")?;
        let origin = Origin::Toolchain(installed.toolchain_channel);
        Self::new(origin, installed.rustc_codegen_spirv_location)
    }

    fn new(origin: Origin, backend: PathBuf) -> Result<Self> {
        let mut rustc = match &origin {
            Origin::Toolchain(name) => {
                let mut rustup = Command::new("rustup");
                rustup.args(["run", name, "rustc"]);
                rustup
            }
            Origin::Sysroot(sysroot) => Command::new(sysroot.join("bin/rustc")),
        };
        let version = output(rustc.arg("--version"))?;
        // "rustc 1.98.0-nightly (hash date)": the part in parentheses depends on who built it.
        let version = version.split(' ').nth(1).context("rustc does not tell its version")?;
        Ok(Self { origin, backend, rustc: version.to_owned() })
    }

    /// Makes a build use this compiler.
    pub fn configure(&self, builder: &mut SpirvBuilder) {
        builder.rustc_codegen_spirv_location = Some(self.backend.clone());
        builder.toolchain_overwrite = match &self.origin {
            Origin::Toolchain(name) => Some(name.clone()),
            Origin::Sysroot(_) => None,
        };
        // This is no build script: cargo's messages go to the terminal unchanged.
        builder.build_script.defaults = false;
    }
}

impl fmt::Display for Compiler {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.origin {
            Origin::Toolchain(name) => write!(f, "the rustup toolchain `{name}`")?,
            Origin::Sysroot(sysroot) => write!(f, "the sysroot {}", sysroot.display())?,
        }
        write!(f, " (rustc {})", self.rustc)
    }
}

const SYSROOT: [&str; 2] = ["--print", "sysroot"];

/// Whether rustup has a toolchain; false without rustup.
fn toolchain_exists(name: &str) -> Result<bool> {
    let Ok(list) = output(Command::new("rustup").args(["toolchain", "list", "-q"])) else {
        return Ok(false);
    };
    Ok(list.lines().any(|line| line.split_whitespace().next() == Some(name)))
}

fn backend_in(sysroot: &Path) -> Result<PathBuf> {
    let prefix = env::consts::DLL_PREFIX;
    let suffix = env::consts::DLL_SUFFIX;
    let backend = sysroot.join("lib").join(format!("{prefix}rustc_codegen_spirv{suffix}"));
    if !backend.is_file() {
        bail!("this toolchain has no SPIR-V backend: there is no {}", backend.display());
    }
    Ok(backend)
}

/// The trimmed output of a command that must succeed.
fn output(command: &mut Command) -> Result<String> {
    let program = command.get_program().display().to_string();
    // With this variable, rustup would add its own backtrace to the message for the user.
    let output = command.env_remove("RUST_BACKTRACE").output();
    let output = output.with_context(|| format!("cannot run {program}"))?;
    if !output.status.success() {
        let message = String::from_utf8_lossy(&output.stderr);
        bail!("{}", message.trim().trim_start_matches("error: "));
    }
    Ok(String::from_utf8(output.stdout)?.trim().to_owned())
}

/// SPIR-V 1.5, of Vulkan 1.2, is the newest version that all our drivers read.
pub const TARGET: &str = "spirv-unknown-vulkan1.2";

/// Compiles every kernel that the caller is linked with, each to one module.
pub fn compile(project: &Project, compiler: &Compiler) -> Result<Artifacts> {
    rules::check(&project.root.join(&project.shader_crate))?;
    // Before the build: if a file is saved while it runs, the kernels must be stale.
    let source_hash = manifest::source_hash(&project.root, &project.sources)?;
    let mut modules = build(project, compiler)?;
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
        let context = || format!("{}the kernel `{name}`", errors::declaration(name, &project.root));
        let spirv = lower(&spirv, kernel.fused, kernel.workgroup_size).with_context(context)?;
        if point.tiles.is_some() {
            // naga cannot read it: the compiler has validated it
            tiles::check(&spirv).with_context(context)?;
        } else {
            module::check(kernel, &point, &spirv).with_context(context)?;
            validate::check(&spirv).with_context(context)?;
        }
        if project.wgsl && point.name == kernel.name {
            let text = manifest::to_wgsl(&spirv);
            let text = text.map_err(|reason| anyhow!("the module is not for browsers: {reason}"));
            files.insert(format!("{name}.wgsl"), text.with_context(context)?.into_bytes());
        }
        let entry = entry(kernel, &point, &spirv);
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
    Ok(Artifacts(files))
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

/// Set in the process that runs the compiler for another one, which explains its errors.
const COMPILES: &str = "MUSLIN_COMPILES";

/// Runs the compiler on a crate of kernels, in another process of this program. Returns the modules by entry point.
fn build(project: &Project, compiler: &Compiler) -> Result<BTreeMap<String, Vec<u8>>> {
    if env::var_os(COMPILES).is_some() {
        let mut modules = build_here(project, compiler, false)?;
        let points = muslin_kernel::kernels().filter_map(|kernel| kernel.variant);
        let names: Vec<_> =
            points.filter(|point| point.tiles.is_some()).map(|point| point.name).collect();
        if !names.is_empty() {
            let found = build_here(project, compiler, true)?.into_iter();
            modules.extend(found.filter(|(name, _)| names.contains(&name.as_str())));
        }
        modules.into_iter().for_each(|(name, path)| println!("{name}\t{}", path.display()));
        exit(0);
    }
    let mut child = Command::new(env::current_exe()?);
    // a crash of the compiler leaves a file otherwise
    child
        .args(env::args_os().skip(1))
        .env(COMPILES, "1")
        .env("RUSTC_ICE", "0")
        .env("CARGO_TERM_COLOR", "never");
    let start = SystemTime::now();
    let output = child.stdin(Stdio::null()).output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        let crashed = unwritten(project, start).filter(|_| said.contains("(signal: "));
        bail!("{}", errors::explain(&said, crashed, &project.root));
    }
    // warnings of the kernels' crate
    said.split_inclusive('\n')
        .skip_while(|line| !line.starts_with("warning"))
        .for_each(|line| eprint!("{line}"));
    let modules = String::from_utf8(output.stdout)?;
    let read = |line: &str| {
        let (name, path) = line.split_once('\t')?;
        Some(fs::read(path).map(|module| (name.to_owned(), module)))
    };
    Ok(modules.lines().filter_map(read).collect::<Result<_, _>>()?)
}

/// The entry point after the last one that has a module since `start`: the compiler writes them in the order of their names.
fn unwritten(project: &Project, start: SystemTime) -> Option<&'static str> {
    let folder = project.target.join(format!("spirv/{TARGET}/release/deps"));
    let mut modules: Vec<_> =
        fs::read_dir(folder).ok()?.flatten().map(|file| file.path()).collect();
    modules.retain(|path| path.extension().is_some_and(|name| name == "spvs"));
    let is_new = |name: &&str| {
        let files = modules.iter().map(|folder| folder.join(name).with_extension("spv"));
        let times = files.filter_map(|file| fs::metadata(file).ok()?.modified().ok());
        times.max().is_some_and(|time| time >= start)
    };
    let points = muslin_kernel::kernels().flat_map(|kernel| kernel.entry_points());
    let mut names: Vec<_> = points.map(|point| point.name).collect();
    names.sort_unstable();
    let last = names.iter().rposition(is_new)?;
    names.get(last + 1).copied()
}

/// Runs the compiler on a crate of kernels, for the entry points with cooperative matrices or for all others. Returns the files of the modules by entry
/// point.
fn build_here(
    project: &Project,
    compiler: &Compiler,
    has_tiles: bool,
) -> Result<BTreeMap<String, PathBuf>> {
    let shader_crate = project.root.join(&project.shader_crate);
    let mut builder = SpirvBuilder::new(shader_crate, TARGET)
        .release(true)
        .multimodule(true)
        .spirv_metadata(SpirvMetadata::None)
        .target_dir_path(project.target.join(if has_tiles { "spirv-tiles" } else { "spirv" }));
    builder.capabilities =
        [&lower::SUBGROUPS[..], &lower::WIDE, &small_integers::CAPABILITIES, &[lower::AS_WRITTEN]]
            .concat();
    if has_tiles {
        builder.capabilities.extend(tiles::CAPABILITIES);
        builder = builder.extension("SPV_KHR_cooperative_matrix");
    }
    compiler.configure(&mut builder);
    let result = builder.build().context("the kernels do not compile")?;
    let ModuleResult::MultiModule(paths) = result.module else {
        bail!("the compiler gave one module for all kernels, not one for each");
    };
    Ok(paths.into_iter().collect())
}

fn entry(kernel: &KernelInfo, point: &EntryPoint, spirv: &[u8]) -> KernelEntry {
    KernelEntry {
        name: point.name.to_owned(),
        package: kernel.package.to_owned(),
        file: kernel.source(),
        spirv: format!("{}.spv", point.name),
        spirv_bytes: spirv.len() as u64,
        spirv_sha256: manifest::sha256(spirv),
        interface: Interface::new(kernel, point),
    }
}
