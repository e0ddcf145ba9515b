//! Errors of a device, and allocations that fail with one.
//!
//! The `Display` text of an [`Error`] is complete: what happened, where, and what to do about it.

pub mod memory;

/// The result of every fallible operation of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why an operation on a device failed.
#[derive(Clone, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A setting is not valid on this machine.
    #[error("{reason}")]
    Argument {
        /// The mistake, and the allowed values.
        reason: String,
    },

    /// No usable GPU.
    #[error("no usable GPU: {reason}; the CPU backend needs none")]
    NoGpu {
        /// GPUs that were requested and found.
        reason: String,
    },

    /// The memory of the host or of the device is not enough.
    #[error("{}", describe_memory(*needed, *available, what))]
    OutOfMemory {
        /// Bytes requested; 0 if the driver did not say.
        needed: u64,
        /// Bytes available, if known.
        available: Option<u64>,
        /// Purpose of the memory.
        what: String,
    },

    /// The GPU stopped answering.
    #[error(
        "the GPU was lost: {reason}; the work in flight is gone, so start again (shorter dispatches \
         help where a watchdog ended it)"
    )]
    DeviceLost {
        /// The driver's message.
        reason: String,
    },

    /// A kernel could not be loaded or launched.
    #[error("kernel `{kernel}`: {reason}")]
    Kernel {
        /// The kernel's entry point.
        kernel: String,
        /// The cause.
        reason: String,
    },

    /// The compiled kernels do not belong to this program.
    #[error(
        "the compiled kernels are stale: {reason}; build them again with `cargo xtask kernels`"
    )]
    StaleKernels {
        /// The kernels, and the difference.
        reason: String,
    },
}

/// The text of `Display`: it is what `unwrap` in a test shows.
impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

/// Formats a size in the largest binary unit that keeps it at least 1, such as `1.50 GiB`.
#[must_use]
pub fn format_bytes(bytes: u64) -> String {
    const UNITS: [(u64, &str); 3] = [(1 << 30, "GiB"), (1 << 20, "MiB"), (1 << 10, "KiB")];
    match UNITS.iter().find(|(unit, _)| bytes >= *unit) {
        Some((unit, name)) => format!("{:.2} {name}", bytes as f64 / *unit as f64),
        None => format!("{bytes} bytes"),
    }
}

fn describe_memory(needed: u64, available: Option<u64>, what: &str) -> String {
    // A driver may run out of memory without giving a size.
    let needed = match needed {
        0 => String::new(),
        bytes => format!(" needs {}", format_bytes(bytes)),
    };
    let available = match available {
        Some(bytes) => format!(" but {} are available", format_bytes(bytes)),
        None => String::new(),
    };
    format!("out of memory: {what}{needed}{available}; do the work in smaller parts")
}
