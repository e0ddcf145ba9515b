//! Long calls: other Python threads run meanwhile, and Ctrl-C ends the wait.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::error::raise;

/// Longest delay until Ctrl-C is noticed.
const PATIENCE: Duration = Duration::from_millis(50);

/// Runs `work` in a separate thread. After Ctrl-C the thread finishes alone, and its result is dropped.
pub fn run<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> organza::Result<T> + Send + 'static,
) -> PyResult<T> {
    run_while_awaited(py, |_| work())
}

/// Like [`run`], but for work that takes minutes or has side effects. `work` gets a function to call now and then.
/// After Ctrl-C, that function returns an error, with which `work` must end.
pub fn run_while_awaited<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Fn() -> organza::Result<()>) -> organza::Result<T> + Send + 'static,
) -> PyResult<T> {
    let (sender, mut receiver) = channel();
    let waits = Arc::new(());
    let wait = Arc::downgrade(&waits);
    let thread = spawn(move || {
        let awaited = || match wait.strong_count() {
            0 => Err(organza::Error::Argument { reason: "interrupted".to_owned() }),
            _ => Ok(()),
        };
        // the caller may have gone
        let _ = sender.send(work(&awaited));
    })?;
    match receive(py, &mut receiver)? {
        Some(result) => result.map_err(raise),
        None => Err(panicked(thread)),
    }
}

/// Starts a thread.
pub fn spawn(work: impl FnOnce() + Send + 'static) -> PyResult<JoinHandle<()>> {
    let named = thread::Builder::new().name("organza".to_owned());
    named
        .spawn(work)
        .map_err(|error| PyRuntimeError::new_err(format!("cannot start a thread: {error}")))
}

/// The next message of a thread; `None` if it has ended.
pub fn receive<T: Send>(py: Python<'_>, receiver: &mut Receiver<T>) -> PyResult<Option<T>> {
    loop {
        let receiver = &mut *receiver;
        match py.detach(move || receiver.recv_timeout(PATIENCE)) {
            Ok(value) => return Ok(Some(value)),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
        }
    }
}

/// Propagates the panic of a thread, which pyo3 turns into an exception.
pub fn panicked(thread: JoinHandle<()>) -> PyErr {
    match thread.join() {
        Err(payload) => resume_unwind(payload),
        Ok(()) => PyRuntimeError::new_err("a thread of organza ended early"),
    }
}
