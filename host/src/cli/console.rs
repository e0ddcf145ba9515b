//! Output: notes and progress on stderr, data on stdout.

use std::borrow::Cow;
use std::fmt;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use muslin_device::grouped;
use organza::error::argument;
use organza::{Error, Result};

/// Prints notes for the user: the options of every command.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Console {
    /// Print only warnings and errors
    #[arg(short, long, global = true, display_order = 1000)]
    quiet: bool,
    /// Also print details: files, sizes, settings and times
    #[arg(short, long, global = true, display_order = 1001, conflicts_with = "quiet")]
    verbose: bool,
}

/// A bar or a spinner. It disappears when it is dropped. If stderr is no terminal, a bar is a line from time to time.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    log: Option<Log>,
}

/// The lines of a bar in a log.
#[derive(Debug)]
struct Log {
    unit: String,
    /// Time of the last line, from the begin of the bar.
    last: Mutex<Duration>,
}

/// Time between two images of a bar.
const TICK: Duration = Duration::from_millis(100);
/// Seconds until the first line of a bar in a log.
const FIRST_LINE: f64 = 10.0;

/// Seconds between lines in a log: a tenth of the seconds so far, from `shortest` to a minute. An hour gives about 100 lines.
pub fn between_lines(so_far: f64, shortest: f64) -> f64 {
    (0.1 * so_far).clamp(shortest, 60.0)
}

/// The end of a line: `, 3m left`, or nothing if the seconds are unknown.
pub fn left(seconds: Option<f64>) -> String {
    // far longer than anybody waits
    let time = |seconds: f64| HumanDuration(Duration::from_secs_f64(seconds.min(1e9)));
    seconds.map_or_else(String::new, |seconds| format!(", {:#} left", time(seconds)))
}

/// [`left`] of this many steps, of which so many are done in a second; none yet are 0.
fn left_of(steps: u64, speed: f64) -> String {
    left((speed > 0.0).then(|| steps as f64 / speed))
}

impl Log {
    /// Whether there is a line now, at this time from `begin`.
    fn is_due(&self, now: Duration) -> bool {
        let Ok(mut last) = self.last.try_lock() else { return false };
        let wait = between_lines(now.as_secs_f64(), FIRST_LINE);
        let is_due = now.saturating_sub(*last).as_secs_f64() >= wait;
        if is_due {
            *last = now;
        }
        is_due
    }
}

impl Console {
    /// One that prints only warnings and errors.
    pub const QUIET: Self = Self { quiet: true, verbose: false };

    /// Prints a note, only with `--verbose`.
    pub fn detail(self, text: &str) {
        if self.verbose {
            line("detail", text);
        }
    }

    /// Whether the user can see bars.
    pub fn has_terminal(self) -> bool {
        io::stderr().is_terminal()
    }

    /// Prints a note, unless `--quiet` is given.
    pub fn note(self, text: &str) {
        if !self.quiet {
            write(&format!("{}\n", plain(text)));
        }
    }

    /// Prints a note that the user needs, even with `--quiet`.
    pub fn always(self, text: &str) {
        write(&format!("{}\n", plain(text)));
    }

    /// Prints a warning.
    pub fn warn(self, text: &str) {
        line("warning", text);
    }

    /// A bar over `steps` of a task.
    pub fn progress(self, what: &str, steps: usize, unit: &str) -> Progress {
        let template = format!("{{msg}} [{{wide_bar}}] {{pos}}/{{len}} {unit}{{left}}");
        let mut progress = self.show(ProgressBar::new(steps as u64), &template);
        progress.say(what);
        if !self.quiet && !self.has_terminal() {
            progress.log = Some(Log { unit: unit.to_owned(), last: Mutex::default() });
        }
        progress
    }

    /// Shows a spinner during a task of unknown length.
    pub fn during<T>(self, what: &str, task: impl FnOnce() -> T) -> T {
        self.show(ProgressBar::new_spinner(), "{spinner} {msg} ({elapsed})").say(what);
        task()
    }

    /// A progress that never shows.
    pub fn hidden(self) -> Progress {
        Progress { bar: ProgressBar::hidden(), log: None }
    }

    fn show(self, bar: ProgressBar, template: &str) -> Progress {
        if self.quiet {
            return self.hidden();
        }
        let show = |state: &ProgressState, text: &mut dyn fmt::Write| {
            let steps = state.len().unwrap_or(0).saturating_sub(state.pos());
            let _ = text.write_str(&left_of(steps, state.per_sec()));
        };
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> ").with_key("left", show));
        }
        bar.enable_steady_tick(TICK);
        Progress { bar, log: None }
    }
}

impl Progress {
    /// Sets the text beside the bar.
    pub fn say(&self, what: &str) {
        self.bar.set_message(shortened(&plain(what).replace('\n', " "), MAX_NAME));
    }

    /// Sets the number of finished steps.
    pub fn set(&self, steps: usize) {
        self.bar.set_position(steps as u64);
        self.log();
    }

    /// Sets the number of finished steps, and the total number.
    pub fn set_of(&self, steps: usize, all: usize) {
        self.bar.set_length(all as u64);
        self.set(steps);
    }

    /// Estimates the remaining time only from steps after this call.
    pub fn restart_clock(&self) {
        // with its ticker, the bar would count the steps so far as just done
        self.bar.disable_steady_tick();
        self.bar.tick();
        self.bar.reset_eta();
        self.bar.enable_steady_tick(TICK);
    }

    /// Steps a second, lately; 0 before the first.
    pub fn speed(&self) -> f64 {
        self.bar.per_sec()
    }

    /// Prints a note above the bar.
    pub fn note(&self, console: Console, text: &str) {
        self.bar.suspend(|| console.note(text));
    }

    /// Prints a warning above the bar.
    pub fn warn(&self, console: Console, text: &str) {
        self.bar.suspend(|| console.warn(text));
    }

    /// Adds to the number of finished steps.
    pub fn advance(&self, steps: usize) {
        self.bar.inc(steps as u64);
        self.log();
    }

    /// Writes a line if it is time for one.
    fn log(&self) {
        let Some(log) = &self.log else { return };
        let elapsed = self.bar.elapsed();
        if log.is_due(elapsed) {
            let done = self.bar.position();
            let all = self.bar.length().unwrap_or(done);
            // The mean of all steps. The bar's own speed falls to nearly nothing while one step takes long.
            let left = left_of(all.saturating_sub(done), done as f64 / elapsed.as_secs_f64());
            let what = self.bar.message();
            let unit = &log.unit;
            write(&format!("{what}: {} of {} {unit}{left}\n", grouped(done), grouped(all)));
        }
    }

    /// A function that advances the bar by a part of the whole. Its arguments are the number of finished steps of the
    /// part, and of all its steps.
    pub fn part(&self) -> impl FnMut(usize, usize) {
        let mut before = 0;
        move |done, _| self.advance(done - std::mem::replace(&mut before, done))
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Prints `kind: text` on stderr, in one line.
pub fn line(kind: &str, text: &str) {
    let text = plain(text).replace('\n', "\\n");
    write(&format!("{kind}: {}\n", shortened(&text, MAX_MESSAGE)));
}

/// Longest message, in characters: names and values in files may be of any length.
const MAX_MESSAGE: usize = 1200;
/// Longest name beside a bar, in characters.
const MAX_NAME: usize = 80;

/// Escapes all control characters but `\n`. Names come from untrusted files, and a terminal obeys control characters.
/// Unicode's line ends are escaped too, and so are the marks that change the direction of text.
fn plain(text: &str) -> Cow<'_, str> {
    let is_plain = |c: char| c == '\n' || !(c.is_control() || is_mark(c));
    escaped(text, is_plain, |c| c.escape_default().to_string())
}

/// A text with some characters escaped.
fn escaped(
    text: &str,
    is_plain: impl Fn(char) -> bool,
    escape: impl Fn(char) -> String,
) -> Cow<'_, str> {
    if text.chars().all(&is_plain) {
        return text.into();
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_plain(c) { escaped.push(c) } else { escaped += &escape(c) }
    }
    escaped.into()
}

/// Characters with Unicode's property `Bidi_Control`, and its separators of lines and paragraphs.
fn is_mark(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The beginning and the end of a text that is too long.
fn shortened(text: &str, max: usize) -> String {
    let length = text.chars().count();
    if length <= max {
        return text.to_owned();
    }
    let begin = max * 2 / 3;
    let end = max / 3;
    let first: String = text.chars().take(begin).collect();
    let last: String = text.chars().skip(length - end).collect();
    format!("{first} ... {last}")
}

/// Writes to stderr. Errors are ignored, because they could not be reported either.
fn write(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Writes data to stdout. It is no error if a reader such as `head` has closed the pipe.
pub fn print(text: &str) -> Result<()> {
    print_as_is(&plain(text))
}

/// Writes the program's own text to stdout, without escaping control characters.
pub fn print_as_is(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::write(Path::new("standard output"), source))
        }
        _ => Ok(()),
    }
}

/// Writes a value to stdout as indented JSON.
pub fn print_json(value: &impl serde::Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(value).or_else(|error| argument(error.to_string()))?;
    // JSON itself escapes characters below the space.
    let is_plain = |c: char| !('\u{7f}'..='\u{9f}').contains(&c) && !is_mark(c);
    print_as_is(&escaped(&(text + "\n"), is_plain, |c| format!("\\u{:04x}", u32::from(c))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_escaped() {
        assert_eq!(plain("a\nb é"), "a\nb é");
        assert_eq!(plain("\x1b[31m\r\x07\u{9b}"), "\\u{1b}[31m\\r\\u{7}\\u{9b}");
        assert_eq!(plain("exe\u{202e}gnp"), "exe\\u{202e}gnp");
        assert_eq!(plain("\u{61c}a\u{2028}b\u{2069}"), "\\u{61c}a\\u{2028}b\\u{2069}");
    }

    #[test]
    fn lines_in_a_log_become_rare() {
        let log = Log { unit: String::new(), last: Mutex::default() };
        let due = (0..7200).filter(|&second| log.is_due(Duration::from_secs(second)));
        let due: Vec<_> = due.collect();
        assert_eq!(due[..3], [10, 20, 30]);
        assert_eq!(due[due.len() - 1] - due[due.len() - 2], 60);
        assert!((130..160).contains(&due.len()), "{} lines in two hours", due.len());
    }

    #[test]
    fn long_texts_keep_both_ends() {
        let short = shortened(&format!("begin{}end", "é".repeat(10_000)), 300);
        assert!(short.starts_with("begin") && short.ends_with("end"), "{short}");
        assert!(short.chars().count() < 310);
        assert_eq!(shortened("short", 5), "short");
    }
}
