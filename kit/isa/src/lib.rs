//! Machine code and register counts of compiled kernels, from a GPU's compiler, without the GPU.
//!
//! RADV, Mesa's driver for AMD GPUs, reads the environment variable `RADV_FORCE_FAMILY` when it is loaded. So each family gets a process
//! of its own: [`compile`] starts it, and [`answer`] is what it does.

mod driver;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fmt, fs};

use serde::{Deserialize, Serialize};

pub use driver::Loop;

/// Families of AMD GPUs to look at: one of the generation before RDNA with its subgroups of 64, and RDNA2.
pub const FAMILIES: [&str; 2] = ["polaris10", "navi21"];

/// The place for the answer of a process that [`compile`] has started.
const ANSWER: &str = "MUSLIN_ISA_ANSWER";

/// The folder of the kernels that this process compiles.
const FOLDER: &str = "MUSLIN_ISA_FOLDER";

/// Why there is no report.
#[derive(Debug, thiserror::Error, Serialize, Deserialize)]
pub enum Error {
    /// There is no RADV on this machine, or it does not know the family.
    #[error("no RADV for `{family}`: {reason} (Debian's package mesa-vulkan-drivers has it)")]
    NoDriver {
        /// The family of GPUs.
        family: String,
        /// The missing program or file.
        reason: String,
    },
    /// A kernel could not be read or compiled.
    #[error("{0}")]
    Failed(String),
}

/// The compiled code of all kernels for a family of GPUs.
#[derive(Debug, Serialize, Deserialize)]
pub struct Report {
    /// The family, as RADV names it.
    pub family: String,
    /// The driver with its version, such as `Mesa 22.3.6`. Another version compiles otherwise.
    pub driver: String,
    /// The kernels, in the manifest's order.
    pub kernels: Vec<Kernel>,
}

/// The compiled code of a kernel.
#[derive(Debug, Serialize, Deserialize)]
pub struct Kernel {
    /// The name of the entry point.
    pub name: String,
    /// Vector registers of an invocation.
    pub registers: u64,
    /// Registers that do not fit and lie in memory.
    pub spills: u64,
    /// Bytes of memory for an invocation's own arrays and spills.
    pub scratch: u64,
    /// Bytes of workgroup memory.
    pub shared: u64,
    /// Subgroups that a SIMD unit holds at once. The more there are, the better it hides how long memory takes.
    pub subgroups: u64,
    /// Instructions of the whole kernel.
    pub instructions: u64,
    /// Multiplications of 32-bit integers of the whole kernel: they take four times as long as other instructions.
    pub integer_multiplies: usize,
    /// The innermost loops, the one with the most instructions first.
    pub loops: Vec<Loop>,
}

/// Compiles the kernels of a manifest's folder for a family of GPUs. `child` must start a process that calls [`answer`] before it does anything
/// else: the program itself, usually.
///
/// # Errors
/// [`Error::NoDriver`] without RADV, and [`Error::Failed`] where a kernel cannot be compiled.
pub fn compile(folder: &Path, family: &str, child: &mut Command) -> Result<Report, Error> {
    let failed = |reason: &dyn std::fmt::Display| Error::Failed(format!("{family}: {reason}"));
    let place = tempfile::tempdir().map_err(|error| failed(&error))?;
    let file = place.path().join("answer.json");
    child.env("RADV_FORCE_FAMILY", family).env(ANSWER, &file).env(FOLDER, folder);
    // Other drivers take longer to load than all kernels to compile.
    child.env("VK_LOADER_DRIVERS_SELECT", "*radeon*").env("MESA_SHADER_CACHE_DISABLE", "true");
    child.env_remove("VK_INSTANCE_LAYERS");
    let output = child.output().map_err(|error| failed(&error))?;
    let Ok(text) = fs::read(&file) else {
        let said = String::from_utf8_lossy(&output.stderr);
        let reason = match said.lines().find(|line| line.contains("Unknown family")) {
            Some(line) => line.to_owned(),
            None => {
                return Err(failed(&format_args!("no answer for {}: {said}", folder.display())));
            }
        };
        return Err(Error::NoDriver { family: family.into(), reason });
    };
    let answer: Result<Report, Error> =
        serde_json::from_slice(&text).map_err(|error| failed(&error))?;
    answer
}

/// In a process that [`compile`] has started, this compiles the kernels and returns true: the process is to end then.
///
/// # Panics
/// Where the answer cannot be written.
#[must_use]
pub fn answer() -> bool {
    let [file, family, folder] = [ANSWER, "RADV_FORCE_FAMILY", FOLDER].map(env::var_os);
    let (Some(file), Some(family), Some(folder)) = (file, family, folder) else { return false };
    let report = driver::report(Path::new(&folder), &family.to_string_lossy());
    let text = serde_json::to_vec(&report).expect("a report is plain data");
    fs::write(PathBuf::from(file), text).expect("the folder of the answer is there");
    true
}

/// One line for each kernel. A line depends on nothing but its kernel.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{}, {}; of the largest innermost loop on the right",
            self.family, self.driver
        )?;
        writeln!(
            f,
            "{:28} {:>9} {:>6} {:>7} {:>6} {:>9} {:>12} {:>4} | {:>12} {:>5} {:>4} {:>4} {:>5} {:>12}",
            "kernel",
            "registers",
            "spills",
            "scratch",
            "shared",
            "subgroups",
            "instructions",
            "imul",
            "instructions",
            "moves",
            "fma",
            "imul",
            "loads",
            "scalar loads"
        )?;
        self.kernels.iter().try_for_each(|kernel| kernel.write(f))
    }
}

impl Kernel {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, registers, spills, scratch, shared, subgroups, instructions, .. } = self;
        write!(
            f,
            "{name:28} {registers:>9} {spills:>6} {scratch:>7} {shared:>6} {subgroups:>9} \
             {instructions:>12} {:>4} |",
            self.integer_multiplies
        )?;
        if let Some(hot) = self.loops.first() {
            write!(
                f,
                " {:>12} {:>5} {:>4} {:>4} {:>5} {:>12}",
                hot.instructions,
                hot.moves,
                hot.multiply_adds,
                hot.integer_multiplies,
                hot.loads,
                hot.scalar_loads
            )?;
        }
        writeln!(f)
    }
}
