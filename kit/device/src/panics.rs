//! Turns a kernel's panic into an error with its place and its invocation.

use std::any::Any;
use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

use muslin_kernel::running;

thread_local! {
    /// The place of the thread's last panic.
    static LOCATION: Cell<Option<String>> = const { Cell::new(None) };
}

/// Suppresses the output of kernels' panics, which are returned as errors. With `RUST_BACKTRACE` they are still
/// printed.
pub fn install() {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        let wants_backtrace = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if running::current().is_none() || wants_backtrace {
                previous(panic);
            }
            LOCATION.set(panic.location().map(ToString::to_string));
        }));
    });
}

/// Runs workgroups, each of which calls [`running::begin`].
pub fn supervise(workgroups: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
    let result = panic::catch_unwind(AssertUnwindSafe(workgroups));
    let result = result.unwrap_or_else(|payload| Err(describe(payload.as_ref())));
    running::begin(None);
    result
}

fn describe(payload: &(dyn Any + Send)) -> String {
    let mut text = payload
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| payload.downcast_ref::<&str>().copied())
        .unwrap_or("it panicked")
        .to_owned();
    if let Some(location) = LOCATION.take() {
        text += &format!(", at {location}");
    }
    if let Some(place) = running::current() {
        text += &format!(", in {place}");
    }
    text
}
