//! Programs that others wrote: whether they are there, and running them.

use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use organza::{Error, Result};

use crate::cli::refuse;

/// A program, and how to get it.
#[derive(Clone, Copy, Debug)]
pub struct Needed {
    pub name: &'static str,
    purpose: &'static str,
}

pub const FFMPEG: Needed = Needed { name: "ffmpeg", purpose: "takes the frames of a video" };
pub const COLMAP: Needed = Needed { name: "colmap", purpose: "finds out where the camera stood" };

/// How often a running program is looked at, to stop it after a signal.
const INTERVAL: Duration = Duration::from_millis(100);
/// Last lines of a program's output that are kept for its error.
const KEPT_LINES: usize = 12;

/// Runs programs, and keeps what they say in a log.
pub struct Programs<'a> {
    log: PathBuf,
    stop: &'a AtomicBool,
}

/// Fails unless all programs are installed. The message has all of them, and how to install them.
pub fn find(needed: &[Needed]) -> Result<()> {
    let is_missing = |program: &&Needed| {
        let found =
            command(program.name).arg("-h").stdout(Stdio::null()).stderr(Stdio::null()).status();
        found.is_err_and(|error| error.kind() == ErrorKind::NotFound)
    };
    let missing: Vec<_> = needed.iter().filter(is_missing).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let names: Vec<_> = missing.iter().map(|program| program.name).collect();
    let purposes: Vec<_> =
        missing.iter().map(|program| format!("{} {}", program.name, program.purpose)).collect();
    let purposes = purposes.join(", and ");
    let names = names.join(" ");
    refuse(format!(
        "not installed: {names}. {purposes}. Install with `apt install {names}` (Debian, Ubuntu), \
         `brew install {names}` (macOS), or from https://colmap.github.io and https://ffmpeg.org"
    ))
}

/// A command that reads nothing from the terminal.
pub fn command(name: &str) -> Command {
    let mut command = Command::new(name);
    command.stdin(Stdio::null());
    command
}

impl<'a> Programs<'a> {
    pub fn new(work: &Path, stop: &'a AtomicBool) -> Self {
        Self { log: work.join("log.txt"), stop }
    }

    /// Fails after a signal.
    pub fn check(&self) -> Result<()> {
        if self.stop.load(Ordering::Relaxed) {
            return refuse("stopped by a signal; the same command continues from here");
        }
        Ok(())
    }

    /// Runs a program to its end. `on_line` gets each line that it prints.
    pub fn run(&self, mut command: Command, mut on_line: impl FnMut(&str)) -> Result<()> {
        let name = command.get_program().to_string_lossy().into_owned();
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = spawn(&mut command)?;
        let (sender, lines) = mpsc::channel();
        read_lines(child.stdout.take().expect("it is piped"), sender.clone());
        read_lines(child.stderr.take().expect("it is piped"), sender);
        let mut log = File::options().create(true).append(true).open(&self.log).ok();
        let mut last = Vec::new();
        loop {
            match lines.recv_timeout(INTERVAL) {
                Ok(line) => {
                    if let Some(log) = &mut log {
                        // A log that cannot be written is no reason to stop.
                        let _ = writeln!(log, "{line}");
                    }
                    on_line(&line);
                    last.push(line);
                    if last.len() > KEPT_LINES {
                        last.remove(0);
                    }
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
            if self.check().is_err() {
                end(&mut child);
                return self.check();
            }
        }
        self.finish(&name, &mut child, || {
            let said = last.iter().rev().find(|line| !line.trim().is_empty());
            let said = said.map_or("it printed nothing", |line| line.trim());
            format!("{said}. Its whole output is in {}", self.log.display())
        })
    }

    /// Runs a program, and passes what it writes to stdout, in pieces of `size` bytes.
    pub fn read(
        &self,
        mut command: Command,
        size: usize,
        mut on_piece: impl FnMut(&[u8]),
    ) -> Result<()> {
        let name = command.get_program().to_string_lossy().into_owned();
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = spawn(&mut command)?;
        let (sender, errors) = mpsc::channel();
        read_lines(child.stderr.take().expect("it is piped"), sender);
        let mut reader =
            BufReader::with_capacity(1 << 20, child.stdout.take().expect("it is piped"));
        let mut piece = vec![0; size];
        while reader.read_exact(&mut piece).is_ok() {
            on_piece(&piece);
            if self.check().is_err() {
                end(&mut child);
                return self.check();
            }
        }
        self.finish(&name, &mut child, || {
            errors.iter().next().unwrap_or_else(|| "it printed nothing".to_owned())
        })
    }

    /// Waits for the end of a program. If it fails, the error has what it said.
    fn finish(&self, name: &str, child: &mut Child, said: impl FnOnce() -> String) -> Result<()> {
        let status = child.wait().map_err(|source| Error::read(&self.log, source))?;
        self.check()?;
        if status.success() {
            return Ok(());
        }
        refuse(format!("{name} failed ({status}): {}", said()))
    }
}

fn spawn(command: &mut Command) -> Result<Child> {
    let name = command.get_program().to_string_lossy().into_owned();
    command.spawn().or_else(|error| refuse(format!("cannot run {name}: {error}")))
}

/// Ends a program at once. It has finished if that fails.
fn end(child: &mut Child) {
    let _ = child.kill();
    let _ = child.wait();
}

/// Sends each line, which a return or a line feed ends, to a channel.
fn read_lines(stream: impl Read + Send + 'static, sender: Sender<String>) {
    thread::spawn(move || {
        for line in BufReader::new(stream).split(b'\n').map_while(std::result::Result::ok) {
            let line = String::from_utf8_lossy(&line).into_owned();
            if sender.send(line).is_err() {
                break;
            }
        }
    });
}
