//! Programs that others wrote: whether they are there, and running them.

use std::env;
use std::ffi::OsStr;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use organza::{Error, Result};

use crate::cli::console::Console;
use crate::cli::refuse;

/// A program, how it says its version, and how to get it.
#[derive(Clone, Copy, Debug)]
pub struct Needed {
    name: &'static str,
    version: &'static str,
    purpose: &'static str,
    page: &'static str,
}

pub const FFMPEG: Needed = Needed {
    name: "ffmpeg",
    version: "-version",
    purpose: "takes the frames of a video",
    page: "https://ffmpeg.org",
};
pub const COLMAP: Needed = Needed {
    name: "colmap",
    version: "help",
    purpose: "finds out where the camera stood",
    page: "https://colmap.github.io",
};

/// Options that have had another name. The newest is first, and a comment says since when.
const RENAMED: [[&str; 2]; 3] = [
    // COLMAP 3.13
    ["--FeatureExtraction.use_gpu", "--SiftExtraction.use_gpu"],
    ["--FeatureMatching.use_gpu", "--SiftMatching.use_gpu"],
    // COLMAP 4.0
    ["--FeatureExtraction.max_image_size", "--SiftExtraction.max_image_size"],
];

/// How often a running program is looked at, to stop it after a signal.
const INTERVAL: Duration = Duration::from_millis(100);
/// Last lines of a program's output that are kept for its error.
const KEPT_LINES: usize = 12;

/// Runs programs, and keeps what they say in a log.
pub struct Programs<'a> {
    log: PathBuf,
    stop: &'a AtomicBool,
    console: Console,
}

/// A command of COLMAP, with options as the installed version names them.
pub struct Call {
    command: Command,
    /// What the command's help says.
    help: String,
    console: Console,
}

/// The names and versions of programs.
///
/// # Errors
/// If one is not installed. The message has all of them, and how to install them.
pub fn find(needed: &[Needed]) -> Result<String> {
    let mut found = Vec::new();
    let mut missing = Vec::new();
    for program in needed {
        match command(program.name).arg(program.version).output() {
            Err(error) if error.kind() == ErrorKind::NotFound => missing.push(program),
            Err(error) => return refuse(format!("cannot run {}: {error}", program.name)),
            Ok(output) => {
                let version = version(&String::from_utf8_lossy(&output.stdout));
                found.push(format!("{} {version}", program.name));
            }
        }
    }
    if missing.is_empty() {
        return Ok(found.join(" and "));
    }
    let all = |say: fn(&&Needed) -> String, between: &str| {
        missing.iter().map(say).collect::<Vec<_>>().join(between)
    };
    let names = all(|program| program.name.to_owned(), " ");
    let purposes = all(|program| format!("{} {}", program.name, program.purpose), ", and ");
    let pages = all(|program| program.page.to_owned(), " and ");
    let manager = match env::consts::OS {
        "linux" => format!("with `apt install {names}` (Debian, Ubuntu), or "),
        "macos" => format!("with `brew install {names}`, or "),
        _ => String::new(),
    };
    refuse(format!("not installed: {names}. {purposes}. Install {manager}from {pages}"))
}

/// The version that a program says: its first word with a digit.
fn version(said: &str) -> String {
    let mut words = said.split_whitespace();
    let number = words.find(|word| word.contains(|c: char| c.is_ascii_digit()));
    number.unwrap_or("of an unknown version").to_owned()
}

/// A command that reads nothing from the terminal.
pub fn command(name: &str) -> Command {
    let mut command = Command::new(name);
    command.stdin(Stdio::null());
    command
}

/// All that a command prints.
pub fn output(command: &mut Command) -> Result<String> {
    match command.output() {
        Ok(output) => {
            Ok(String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned())
        }
        Err(error) => refuse(format!("cannot run {}: {error}", command.get_program().display())),
    }
}

impl Call {
    /// Adds an option, by its newest name. One that the program does not know is left out: it may be of a version that nobody
    /// has seen yet.
    pub fn option(&mut self, name: &str, value: impl AsRef<OsStr>) {
        // A program that lists nothing does not say what it knows.
        let lists_options = self.help.lines().any(|line| line.trim_start().starts_with('-'));
        let known = if lists_options { known(name, &self.help) } else { Some(name) };
        match known {
            Some(name) => {
                self.command.arg(name).arg(value);
            }
            None => self.console.warn(&format!("colmap has no option `{name}`, so it is left out")),
        }
    }
}

impl From<Call> for Command {
    fn from(call: Call) -> Self {
        call.command
    }
}

/// Starts a program, whose output is piped. Returns its name, too.
fn spawn(mut command: Command) -> Result<(String, Child)> {
    let name = command.get_program().to_string_lossy().into_owned();
    match command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn() {
        Ok(child) => Ok((name, child)),
        Err(error) => refuse(format!("cannot run {name}: {error}")),
    }
}

/// The name by which a help lists an option; `None` if it does not.
fn known<'n>(name: &'n str, help: &str) -> Option<&'n str> {
    let renamed = RENAMED.iter().find(|names| names[0] == name);
    let mut names = renamed.map_or_else(|| vec![name], |names| names.to_vec()).into_iter();
    let is_end = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || "._".contains(c));
    let is_listed = |name: &str| {
        help.lines().any(|line| line.trim_start().strip_prefix(name).is_some_and(is_end))
    };
    names.find(|name| is_listed(name))
}

impl<'a> Programs<'a> {
    pub fn new(work: &Path, stop: &'a AtomicBool, console: Console) -> Self {
        Self { log: work.join("log.txt"), stop, console }
    }

    /// A command of COLMAP, which has a help of its own.
    pub fn colmap(&self, name: &str) -> Result<Call> {
        let help = output(command("colmap").args([name, "-h"]))?;
        let mut command = command("colmap");
        command.arg(name);
        Ok(Call { command, help, console: self.console })
    }

    /// Fails after a signal.
    pub fn check(&self) -> Result<()> {
        if self.stop.load(Ordering::Relaxed) {
            return refuse("stopped by a signal; the same command continues from here");
        }
        Ok(())
    }

    /// Runs a program to its end. `on_line` gets each line that it prints.
    pub fn run(&self, call: impl Into<Command>, mut on_line: impl FnMut(&str)) -> Result<()> {
        let (name, mut child) = spawn(call.into())?;
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

    /// Runs a program, and passes what it writes to stdout, in pieces of `size` bytes. `on_line` gets the lines of stderr.
    pub fn read(
        &self,
        command: Command,
        size: usize,
        mut on_piece: impl FnMut(&[u8]),
        mut on_line: impl FnMut(&str),
    ) -> Result<()> {
        let (name, mut child) = spawn(command)?;
        let (sender, lines) = mpsc::channel();
        let mut error = None;
        let mut hear = |line: String| {
            on_line(&line);
            let said = ["[error] ", "[fatal] "].iter().find_map(|level| line.split_once(level));
            error = error.take().or_else(|| said.map(|(_, said)| said.to_owned()));
        };
        read_lines(child.stderr.take().expect("it is piped"), sender);
        let mut reader =
            BufReader::with_capacity(1 << 20, child.stdout.take().expect("it is piped"));
        let mut piece = vec![0; size];
        while reader.read_exact(&mut piece).is_ok() {
            on_piece(&piece);
            lines.try_iter().for_each(&mut hear);
            if self.check().is_err() {
                end(&mut child);
                return self.check();
            }
        }
        lines.iter().for_each(hear);
        self.finish(&name, &mut child, || error.unwrap_or_else(|| "it says no reason".to_owned()))
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

/// Ends a program at once. It has finished if that fails.
fn end(child: &mut Child) {
    let _ = child.kill();
    let _ = child.wait();
}

/// Sends each line, which a return or a line feed ends, to a channel.
fn read_lines(stream: impl Read + Send + 'static, sender: Sender<String>) {
    thread::spawn(move || {
        for line in BufReader::new(stream).split(b'\n').map_while(std::result::Result::ok) {
            if sender.send(String::from_utf8_lossy(&line).into_owned()).is_err() {
                break;
            }
        }
    });
}
