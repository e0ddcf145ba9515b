//! Long calls: other threads of Python run meanwhile, and Ctrl-C ends the wait.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::error::raise;

/// How long Ctrl-C can go unnoticed.
const PATIENCE: Duration = Duration::from_millis(50);

/// Does `work` in a thread of its own. After Ctrl-C the thread ends its work alone, and its result is dropped.
pub fn run<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> organza::Result<T> + Send + 'static,
) -> PyResult<T> {
    run_while_awaited(py, |_| work())
}

/// Like [`run`], for work that takes minutes or leaves something behind. It calls what it is given now and then, and ends with the
/// error of that after Ctrl-C.
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
        // nobody waits anymore
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

/// What a thread sends next; none if it has ended.
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

/// Goes on with the panic of a thread, which pyo3 makes an exception.
pub fn panicked(thread: JoinHandle<()>) -> PyErr {
    match thread.join() {
        Err(payload) => resume_unwind(payload),
        Ok(()) => PyRuntimeError::new_err("a thread of organza ended early"),
    }
}
