//! What the user sees: notes and progress on stderr, data on stdout.

use std::fmt;
use std::io::{self, Write};
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use organza::{Error, Result};

/// Where notes go.
#[derive(Clone, Copy, Debug)]
pub struct Console {
    quiet: bool,
}

/// A bar or a spinner that is gone when it is dropped; where stderr is no terminal it never shows.
#[derive(Debug)]
pub struct Progress(ProgressBar);

impl Console {
    /// A console that says nothing but warnings where `quiet`.
    pub fn new(quiet: bool) -> Self {
        Self { quiet }
    }

    /// Says something, unless told to be quiet.
    pub fn note(self, text: &str) {
        if !self.quiet {
            write(&format!("{text}\n"));
        }
    }

    /// Says something that should not be missed.
    pub fn warn(self, text: &str) {
        line("warning", text);
    }

    /// A bar over `len` steps.
    pub fn progress(self, len: u64, unit: &str) -> Progress {
        let template = format!("{{msg}} [{{wide_bar}}] {{pos}}/{{len}} {unit}, {{left}} left");
        self.show(ProgressBar::new(len), &template)
    }

    /// A spinner beside a task of unknown length.
    pub fn during<T>(self, what: &str, task: impl FnOnce() -> T) -> T {
        let spinner = self.show(ProgressBar::new_spinner(), "{spinner} {msg} ({elapsed})");
        spinner.say(what);
        task()
    }

    fn show(self, bar: ProgressBar, template: &str) -> Progress {
        if self.quiet {
            return Progress(ProgressBar::hidden());
        }
        // Before the first step is done nobody knows how long one takes.
        let left = |state: &ProgressState, text: &mut dyn fmt::Write| {
            let _ = match state.pos() {
                0 => text.write_str("?"),
                _ => write!(text, "{:#}", HumanDuration(state.eta())),
            };
        };
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> ").with_key("left", left));
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress(bar)
    }
}

impl Progress {
    /// What is being done.
    pub fn say(&self, what: &str) {
        self.0.set_message(what.to_owned());
    }

    /// So many steps are done, in all.
    pub fn set(&self, steps: usize) {
        self.0.set_position(steps as u64);
    }

    /// So many of so many steps are done.
    pub fn set_of(&self, steps: usize, all: usize) {
        self.0.set_length(all as u64);
        self.set(steps);
    }

    /// What was done before does not tell how long the rest takes.
    pub fn restart_clock(&self) {
        self.0.reset_eta();
    }

    /// Says something above the bar.
    pub fn note(&self, console: Console, text: &str) {
        self.0.suspend(|| console.note(text));
    }

    /// So many steps are done.
    pub fn advance(&self, steps: usize) {
        self.0.inc(steps as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// `kind: text` on stderr.
pub fn line(kind: &str, text: &str) {
    write(&format!("{kind}: {text}\n"));
}

/// Where nobody listens to stderr there is nobody to tell.
fn write(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Writes data to stdout. A reader that has seen enough, such as `head`, is no error.
pub fn print(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::WriteFile { path: "standard output".into(), source })
        }
        _ => Ok(()),
    }
}

/// A value as indented JSON on stdout.
pub fn print_json(value: &impl serde::Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| Error::Argument { reason: error.to_string() })?;
    print(&(text + "\n"))
}
