//! Handles Ctrl-C and SIGTERM, from the first moment of a training to its last, and while a film is rendered.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, mpsc};
use std::time::{Duration, Instant};
use std::{io, thread};

use organza::Result;
use organza::train::RunFolder;
use parking_lot::Mutex;

use super::output::Folder;
use super::{FAILURE, refuse};

/// Handles signals. Until there is something to keep, a signal ends the program at once and leaves nothing behind.
/// Afterwards, the first signal asks to save and stop, and the second ends the program at once.
#[derive(Debug)]
pub struct Signals {
    stop: Arc<AtomicBool>,
    begun: Arc<Mutex<Begun>>,
}

/// The state that a signal finds.
#[derive(Debug, Default)]
struct Begun {
    /// Whether there are results to keep.
    keeps_results: bool,
    /// The run's folder, and the folders created for it, innermost first.
    folder: Option<(PathBuf, Vec<PathBuf>)>,
}

impl Signals {
    /// Starts to listen.
    pub fn listen() -> Result<Self> {
        let signals = Self { stop: Arc::default(), begun: Arc::default() };
        let stop = signals.stop.clone();
        let begun = signals.begun.clone();
        let handler = move || {
            // Held to the end, so that nothing starts while created folders are removed.
            let begun = begun.lock();
            if !begun.keeps_results {
                begun.remove();
                end("stopped before training began; nothing was written");
            }
            if stop.swap(true, Ordering::Relaxed) {
                end("stopped by a second signal; what was saved stays");
            }
        };
        handle(handler)?;
        Ok(signals)
    }

    /// The flag that asks to save and stop.
    pub fn stop(&self) -> &AtomicBool {
        &self.stop
    }

    /// Makes a run's folder, which is removed if it stays empty, and locks it. A signal waits meanwhile: it removes the folders that
    /// were made, and a lock by the name inside.
    pub fn lock_run(&self, path: &Path, resume: bool) -> Result<(Folder, RunFolder)> {
        let mut begun = self.begun.lock();
        let folder = Folder::make(path)?;
        begun.folder = Some((path.to_owned(), folder.made().to_owned()));
        let locked = RunFolder::lock(path, resume)?;
        Ok((folder, locked))
    }

    /// From now on, a signal keeps the results.
    pub fn keeps_results(&self) {
        self.begun.lock().keeps_results = true;
    }
}

impl Begun {
    fn remove(&self) {
        if let Some((folder, made)) = &self.folder {
            RunFolder::clear(folder);
            for folder in made {
                // Fails on purpose if the folder is not empty.
                let _ = std::fs::remove_dir(folder);
            }
        }
    }
}

/// Signals that come within this time of the first one are the same. `timeout`, Slurm and terminals signal a process and its group.
const TOGETHER: Duration = Duration::from_millis(500);

/// Calls `handler` at each Ctrl-C, SIGTERM and SIGHUP, and once for those that come together. Where SIGHUP is ignored, as under
/// `nohup`, it stays ignored: a training must outlive the login.
pub fn handle(mut handler: impl FnMut() + Send + 'static) -> Result<()> {
    let mut first = None::<Instant>;
    let handler = move || {
        if first.is_none_or(|first| first.elapsed() >= TOGETHER) {
            first.get_or_insert_with(Instant::now);
            handler();
        }
    };
    #[cfg(unix)]
    // SAFETY: no handler runs before the next call
    let before = unsafe { libc::signal(libc::SIGHUP, libc::SIG_IGN) };
    ctrlc::set_handler(handler)
        .or_else(|error| refuse(format!("cannot listen to signals: {error}")))?;
    #[cfg(unix)]
    if before == libc::SIG_IGN {
        // SAFETY: ignoring a signal runs no code
        unsafe { libc::signal(libc::SIGHUP, libc::SIG_IGN) };
    }
    Ok(())
}

/// Ends the program, even while other threads are waiting.
fn end(text: &str) -> ! {
    let text = format!("error: {text}\n");
    let (sender, written) = mpsc::channel();
    // Writing to a pipe without a reader would block.
    thread::spawn(move || {
        let _ = io::stderr().write_all(text.as_bytes());
        let _ = sender.send(());
    });
    let _ = written.recv_timeout(Duration::from_millis(500));
    exit()
}

/// Exits without the destructors of a driver, which another thread may be using.
#[cfg(unix)]
fn exit() -> ! {
    // SAFETY: ends the process; nothing runs afterwards
    unsafe { libc::_exit(i32::from(FAILURE)) }
}

#[cfg(not(unix))]
fn exit() -> ! {
    std::process::exit(i32::from(FAILURE))
}
