//! Finds the SPIR-V compiler: a rustc, and Rust-GPU's backend for exactly that rustc.

use std::env;
use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use cargo_gpu_install::install::Install;
use spirv_builder::SpirvBuilder;

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
