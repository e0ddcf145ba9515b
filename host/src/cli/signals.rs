//! Ctrl-C and SIGTERM, from the first moment of a training to its last, and while a film is rendered.

use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};
use std::time::Duration;
use std::{io, thread};

use organza::Result;
use organza::train::RunFolder;

use super::output::Folder;
use super::{FAILURE, refuse};

/// Who listens: until there is something to keep a signal ends the program at once and leaves nothing; then the
/// first one asks to save and stop, and the second ends at once.
#[derive(Debug)]
pub struct Signals {
    stop: Arc<AtomicBool>,
    begun: Arc<Mutex<Begun>>,
}

/// What a signal finds.
#[derive(Debug, Default)]
struct Begun {
    /// Whether something was written that is to be kept.
    keeps_results: bool,
    /// The run's folder, and those that were made for it, innermost first.
    folder: Option<(PathBuf, Vec<PathBuf>)>,
}

impl Signals {
    /// Listens from now on.
    pub fn listen() -> Result<Self> {
        let signals = Self { stop: Arc::default(), begun: Arc::default() };
        let (stop, begun) = (signals.stop.clone(), signals.begun.clone());
        let handler = move || {
            // Held to the end, so that nothing begins while what was made is removed.
            let begun = lock(&begun);
            if !begun.keeps_results {
                begun.remove();
                end("stopped before training began; nothing was written");
            }
            if stop.swap(true, Ordering::Relaxed) {
                end("stopped by a second signal; what was saved stays");
            }
        };
        match ctrlc::set_handler(handler) {
            Ok(()) => Ok(signals),
            Err(error) => refuse(format!("cannot listen to signals: {error}")),
        }
    }

    /// Set to save and stop.
    pub fn stop(&self) -> &AtomicBool {
        &self.stop
    }

    /// From now on there is a folder, to be removed where nothing comes into it.
    pub fn has_made(&self, folder: &Folder) {
        lock(&self.begun).folder = Some((folder.path().to_owned(), folder.made().to_owned()));
    }

    /// From now on what was written is kept.
    pub fn keeps_results(&self) {
        lock(&self.begun).keeps_results = true;
    }
}

impl Begun {
    fn remove(&self) {
        if let Some((folder, made)) = &self.folder {
            RunFolder::clear(folder);
            for folder in made {
                // Fails, as it should, where there is something in it.
                let _ = std::fs::remove_dir(folder);
            }
        }
    }
}

fn lock(begun: &Mutex<Begun>) -> MutexGuard<'_, Begun> {
    begun.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the program, whatever its other threads are waiting for.
fn end(text: &str) -> ! {
    let text = format!("error: {text}\n");
    let (sender, written) = mpsc::channel();
    // A pipe that nobody empties would block.
    thread::spawn(move || {
        let _ = io::stderr().write_all(text.as_bytes());
        let _ = sender.send(());
    });
    let _ = written.recv_timeout(Duration::from_millis(500));
    exit()
}

/// Without the destructors of a driver that another thread is in the middle of.
#[cfg(unix)]
fn exit() -> ! {
    // SAFETY: ends the process; nothing runs afterwards
    unsafe { libc::_exit(i32::from(FAILURE)) }
}

#[cfg(not(unix))]
fn exit() -> ! {
    std::process::exit(i32::from(FAILURE))
}
