//! Errors, in words that say what happened, where, and what to do about it.
//!
//! The `Display` text of an [`Error`] does not repeat its source. [`chain`] joins both.

#[cfg(test)]
mod tests;

use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};

pub use muslin_error::{Error as DeviceError, format_bytes};

/// The result of every fallible operation of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// The `origin` of an error about a value that did not come from a file.
pub const IN_MEMORY: &str = "";

/// Why an operation failed.
///
/// `origin` is the file that a value came from. It is empty for a value that a caller built.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file could not be opened or read.
    #[error("cannot read {path}")]
    ReadFile {
        /// The file.
        path: PathBuf,
        /// Why, and what to do about it.
        source: io::Error,
    },

    /// A file could not be written. An old file of that name is untouched.
    #[error("cannot write {path}")]
    WriteFile {
        /// The file.
        path: PathBuf,
        /// Why, and what to do about it.
        source: io::Error,
    },

    /// A file is not safetensors, or was cut short or damaged.
    #[error("{origin} is not a whole safetensors file: {reason}")]
    BadSafetensors {
        /// The file.
        origin: PathBuf,
        /// The mismatch.
        reason: String,
    },

    /// A safetensors file holds something other than a scene.
    #[error(
        "{origin} is not a scene: its metadata `format` is {found}, expected \"organza.scene\"; \
         was another file meant?"
    )]
    WrongFormat {
        /// The file.
        origin: PathBuf,
        /// The `format` it has, quoted, or `missing`.
        found: String,
    },

    /// A scene was written in a version that this program does not know.
    #[error(
        "{origin} has scene version {found}; this program reads version \"1\": use a program that \
         matches the file, or write the scene again"
    )]
    UnknownVersion {
        /// The file.
        origin: PathBuf,
        /// The `version` it has, quoted, or `missing`.
        found: String,
    },

    /// Training, or a gradient, has diverged.
    #[error("{reason}: lower the learning rates, or look for values that are too large")]
    Diverged {
        /// The value found, and its place.
        reason: String,
    },

    /// A value in the scene's configuration is out of range.
    #[error("{}config field `{field}`: {reason}", place(origin))]
    BadConfig {
        /// The file.
        origin: PathBuf,
        /// The field's path in the JSON, such as `color_grid.levels`.
        field: String,
        /// The value found, the values allowed, and why.
        reason: String,
    },

    /// A text is not JSON, or not of the expected structure.
    #[error("{}{what}, line {line} column {column}: {reason}", place(origin))]
    BadJson {
        /// The file.
        origin: PathBuf,
        /// Which JSON of the file: the file itself, or its `config` metadata.
        what: &'static str,
        /// 1-based line.
        line: usize,
        /// 1-based column, in bytes.
        column: usize,
        /// The parser's message, and the text before the error.
        reason: String,
    },

    /// A file or a value is wrong: a tensor, a camera, a tile or another part, which `reason` names.
    #[error("{}{reason}", place(origin))]
    Invalid {
        /// The file.
        origin: PathBuf,
        /// The mistake, and the allowed values.
        reason: String,
    },

    /// An argument of a call or of the command line is invalid.
    #[error("unexpected argument: {reason}")]
    Argument {
        /// The mistake, and the allowed values.
        reason: String,
    },

    /// Another rank has failed, so this one cannot go on.
    #[error("rank {rank}: {message}")]
    Rank {
        /// The rank that has failed.
        rank: usize,
        /// The message of that rank.
        message: String,
    },

    /// A device could not be opened, ran out of memory, was lost, or could not run a kernel.
    #[error(transparent)]
    Device(#[from] muslin_error::Error),
}

/// Joins the messages of an error and of its sources.
///
/// ```
/// use organza_core::{Scene, error};
///
/// let error = Scene::load("nowhere.safetensors").unwrap_err();
/// assert_eq!(error.to_string(), "cannot read nowhere.safetensors");
/// let message = error::chain(&error);
/// assert_eq!(message, "cannot read nowhere.safetensors: there is no such file; check the path");
/// ```
pub fn chain(error: &(dyn std::error::Error + 'static)) -> String {
    let mut message = error.to_string();
    let is_of_memory = |error: &(dyn std::error::Error + 'static)| {
        // some purposes name an option of their own
        let needs = |error: &Error| {
            let Error::Device(DeviceError::OutOfMemory { what, .. }) = error else { return false };
            !what.contains("`--")
        };
        error.downcast_ref::<Error>().is_some_and(needs)
    };
    let mut needs_memory = is_of_memory(error);
    let mut source = error.source();
    while let Some(error) = source {
        // Writing to a String does not fail.
        let _ = write!(message, ": {error}");
        needs_memory |= is_of_memory(error);
        source = error.source();
    }
    if needs_memory {
        message += ": render fewer or smaller tiles at once, or use a smaller scene";
    }
    message
}

/// [`Error::Invalid`] of a file, or of a value in it.
///
/// # Errors
/// Always.
pub fn invalid<T>(origin: impl AsRef<Path>, reason: impl Into<String>) -> Result<T> {
    Err(Error::Invalid { origin: origin.as_ref().to_owned(), reason: reason.into() })
}

/// [`Error::Invalid`] of what a user has asked for.
///
/// # Errors
/// Always.
pub fn refuse<T>(reason: impl Into<String>) -> Result<T> {
    invalid(IN_MEMORY, reason)
}

/// [`Error::Argument`].
///
/// # Errors
/// Always.
pub fn argument<T>(reason: impl Into<String>) -> Result<T> {
    Err(Error::Argument { reason: reason.into() })
}

/// The error of a configuration field that is out of range.
pub(crate) fn bad_config<T>(field: impl Into<String>, reason: String) -> Result<T> {
    Err(Error::BadConfig { origin: IN_MEMORY.into(), field: field.into(), reason })
}

impl Error {
    /// Whether the host or the device ran out of memory.
    pub fn is_out_of_memory(&self) -> bool {
        matches!(self, Self::Device(DeviceError::OutOfMemory { .. }))
    }

    /// The same error, of a value that a file holds. An error that names a file already stays as it is.
    #[must_use]
    pub fn in_file(mut self, file: &Path) -> Self {
        if let Self::BadConfig { origin, .. } | Self::Invalid { origin, .. } = &mut self
            && origin == Path::new(IN_MEMORY)
        {
            *origin = file.to_owned();
        }
        self
    }

    /// A failure to read `path`.
    pub fn read(path: &Path, source: io::Error) -> Self {
        let source = io::Error::new(source.kind(), describe_read(&source));
        Self::ReadFile { path: path.to_owned(), source }
    }

    /// A failure to write `path`.
    pub fn write(path: &Path, source: io::Error) -> Self {
        let source = io::Error::new(source.kind(), describe_write(path, &source));
        Self::WriteFile { path: path.to_owned(), source }
    }

    /// Wraps an error of `serde_json` about `text`, which is `what` of `origin`.
    pub fn json(origin: &Path, what: &'static str, text: &[u8], error: &serde_json::Error) -> Self {
        let line = error.line();
        let column = error.column();
        let suffix = format!(" at line {line} column {column}");
        let mut reason = error.to_string();
        if let Some(bare) = reason.strip_suffix(&suffix) {
            reason.truncate(bare.len());
        }
        if let Some(before) = text_before(text, line, column) {
            // Writing to a String does not fail.
            let _ = write!(reason, ", after `{before}`");
        }
        if is_no_number(text, line, column) {
            reason += "; JSON has no NaN and no Infinity, but Python writes them: write a number or null in its place, or \
                       leave the key out";
        }
        Self::BadJson { origin: origin.to_owned(), what, line, column, reason }
    }
}

/// Whether a parser stopped at NaN or Infinity.
fn is_no_number(text: &[u8], line: usize, column: usize) -> bool {
    let rest = text.split(|&byte| byte == b'\n').nth(line.saturating_sub(1)).unwrap_or_default();
    // a parser stops at the first letter, or behind a sign
    let rest = rest.get(column.saturating_sub(2)..).unwrap_or_default().trim_ascii_start();
    let rest = rest.strip_prefix(b"-").unwrap_or(rest);
    rest.starts_with(b"NaN") || rest.starts_with(b"Infinity")
}

/// The end of the text before a parser's position. serde names no field, so this shows which one it is.
fn text_before(text: &[u8], line: usize, column: usize) -> Option<String> {
    const LENGTH: usize = 48;
    let bytes = text.split(|&byte| byte == b'\n').nth(line.checked_sub(1)?)?;
    let bytes = bytes.get(..column.min(bytes.len()))?;
    let bytes = &bytes[bytes.len().saturating_sub(LENGTH)..];
    let before = String::from_utf8_lossy(bytes).trim().to_owned();
    (!before.is_empty()).then_some(before)
}

/// The start of a message: the file, if there is one.
fn place(origin: &Path) -> String {
    if origin == Path::new(IN_MEMORY) {
        return String::new();
    }
    format!("{}: ", origin.display())
}

fn describe_read(source: &io::Error) -> String {
    match source.kind() {
        io::ErrorKind::NotFound => "there is no such file; check the path".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied; check the file's mode".to_owned(),
        _ => source.to_string(),
    }
}

fn describe_write(path: &Path, source: &io::Error) -> String {
    match source.kind() {
        kind @ (io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded) => {
            let is_quota = kind == io::ErrorKind::QuotaExceeded;
            let what = if is_quota { "the disk quota is used up" } else { "the disk is full" };
            let old = if path.is_file() { "this file is as it was before; " } else { "" };
            format!("{what}; {old}free some space")
        }
        io::ErrorKind::NotFound => match path.parent() {
            // For example /proc: only the system makes files there.
            Some(folder) if folder.is_dir() => {
                format!(
                    "the file system of {} takes no new files; choose another folder",
                    folder.display()
                )
            }
            Some(folder) => format!("folder {} does not exist; create it first", folder.display()),
            None => source.to_string(),
        },
        io::ErrorKind::PermissionDenied => {
            "permission denied; check the mode of the folder".to_owned()
        }
        _ => source.to_string(),
    }
}
