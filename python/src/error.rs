//! Converts organza's errors to Python exceptions.

use std::io::ErrorKind;

use organza::error::{DeviceError, chain};
use pyo3::exceptions::{
    PyFileNotFoundError, PyMemoryError, PyOSError, PyPermissionError, PyRuntimeError, PyValueError,
};
use pyo3::{PyErr, create_exception};

create_exception!(
    organza,
    Error,
    PyRuntimeError,
    "organza cannot go on: there is no usable GPU, a GPU was lost, or training has overflowed."
);

/// The exception for an error. Its text is the program's.
pub fn raise(error: organza::Error) -> PyErr {
    let text = chain(&error);
    match &error {
        organza::Error::ReadFile { source, .. } | organza::Error::WriteFile { source, .. } => {
            match source.kind() {
                ErrorKind::NotFound => PyFileNotFoundError::new_err(text),
                ErrorKind::PermissionDenied => PyPermissionError::new_err(text),
                _ => PyOSError::new_err(text),
            }
        }
        organza::Error::Device(DeviceError::OutOfMemory { .. }) => PyMemoryError::new_err(text),
        organza::Error::Device(DeviceError::Argument { .. }) => PyValueError::new_err(text),
        organza::Error::Device(_) | organza::Error::Diverged { .. } => Error::new_err(text),
        _ => PyValueError::new_err(text),
    }
}

/// The exception for an invalid value.
pub fn invalid(reason: impl Into<String>) -> PyErr {
    PyValueError::new_err(reason.into())
}
