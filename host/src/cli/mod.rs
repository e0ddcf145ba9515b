//! The command line: one file for each subcommand, and one in `help` for its examples.

mod bench;
mod capture;
mod channels;
mod compare;
mod completions;
mod console;
mod demo;
mod device;
mod edit;
mod eval;
mod explain;
mod export;
mod export_web;
mod film;
mod import;
mod info;
mod inputs;
mod mesh;
mod output;
mod parity;
mod picture;
mod progress;
mod ranks;
mod render;
mod signals;
mod split;
mod summary;
mod tiles;
mod train;
mod view;
mod views;

use std::ops::{RangeBounds, RangeInclusive};
use std::panic;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};
use std::process::{ExitCode, Termination};
use std::sync::Mutex;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Parser, Subcommand};
use organza::Result;
use organza::camera::MAX_IMAGE_SIDE;
use organza::error::{self, refuse};

use console::Console;

/// The exit code of every failure; clap uses the same.
const FAILURE: u8 = 2;

/// Sort-free Gaussian rendering and training
#[derive(Debug, Parser)]
#[command(version, after_help = include_str!("help/organza.txt"), max_term_width = 100)]
struct Cli {
    #[command(flatten)]
    console: Console,
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Capture(capture::Args),
    Split(split::Args),
    Train(train::Args),
    Tiles(tiles::Args),
    Render(render::Args),
    Film(film::Args),
    Demo(demo::Args),
    Info(info::Args),
    View(view::Args),
    ExportWeb(export_web::Args),
    Export(export::Args),
    Mesh(mesh::Args),
    Import(import::Args),
    Edit(edit::Args),
    Explain(explain::Args),
    Eval(eval::Args),
    Compare(compare::Args),
    Parity(parity::Args),
    Bench(bench::Args),
    Completions(completions::Args),
}

/// Runs the program, and returns its exit code.
pub fn main() -> ExitCode {
    remember_panics();
    let Cli { console, command } = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return report(error),
    };
    let run = || match &command {
        Command::Capture(args) => capture::run(args, console).map(Termination::report),
        Command::Split(args) => split::run(args, console).map(Termination::report),
        Command::Train(args) => train::run(args, console).map(Termination::report),
        Command::Tiles(args) => tiles::run(args, console).map(Termination::report),
        Command::Render(args) => render::run(args, console).map(Termination::report),
        Command::Film(args) => film::run(args, console).map(Termination::report),
        Command::Demo(args) => demo::run(args, console).map(Termination::report),
        Command::Info(args) => info::run(args, console).map(Termination::report),
        Command::View(args) => view::run(args, console).map(Termination::report),
        Command::ExportWeb(args) => export_web::run(args, console).map(Termination::report),
        Command::Export(args) => export::run(args, console).map(Termination::report),
        Command::Mesh(args) => mesh::run(args, console).map(Termination::report),
        Command::Import(args) => import::run(args, console).map(Termination::report),
        Command::Edit(args) => edit::run(args, console).map(Termination::report),
        Command::Explain(args) => explain::run(args, console).map(Termination::report),
        Command::Eval(args) => eval::run(args, console).map(Termination::report),
        Command::Compare(args) => compare::run(args, console).map(Termination::report),
        Command::Parity(args) => parity::run(args, console),
        Command::Bench(args) => bench::run(args, console).map(Termination::report),
        Command::Completions(args) => completions::run(args, console).map(Termination::report),
    };
    let message = match panic::catch_unwind(run) {
        Ok(Ok(code)) => return code,
        Ok(Err(error)) => error::chain(&error),
        Err(_) => {
            let panic = LAST_PANIC.lock().map(|panic| panic.clone()).unwrap_or_default();
            format!("this is a bug in organza, please report it. {panic}")
        }
    };
    console::line("error", &message);
    ExitCode::from(FAILURE)
}

/// Prints what clap reports: help, or an error with each paragraph in one line.
fn report(mut error: clap::Error) -> ExitCode {
    if !error.use_stderr() {
        // It is no error if the reader has closed the pipe.
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        console::line("error", "no subcommand is named; `organza --help` lists them");
        return ExitCode::from(FAILURE);
    }
    // clap names the nearest one last
    if let Some(ContextValue::Strings(mut named)) = error.remove(ContextKind::SuggestedSubcommand) {
        named.reverse();
        error.insert(ContextKind::SuggestedSubcommand, ContextValue::Strings(named));
    }
    let text = error.render().to_string();
    // The message, then hints, then the usage. Some of these paragraphs have several lines.
    let one_line = |lines: &str| lines.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut paragraphs = text.split("\n\n").map(one_line).filter(|text| !text.is_empty());
    let message = paragraphs.next().unwrap_or_default();
    console::line("error", message.strip_prefix("error: ").unwrap_or(&message));
    for hint in paragraphs.filter(|hint| !hint.contains("try '--help'")).take(3) {
        match hint.split_once(": ") {
            Some((kind @ ("tip" | "Usage"), text)) => console::line(kind, text),
            _ => console::line("help", &hint),
        }
    }
    let named = named_command().map(|command| format!(" {}", command.get_name()));
    console::line("help", &format!("organza help{}", named.unwrap_or_default()));
    ExitCode::from(FAILURE)
}

/// The command that the user has named.
fn named_command() -> Option<clap::Command> {
    let program = Cli::command();
    std::env::args_os().skip(1).find_map(|word| program.find_subcommand(word).cloned())
}

/// The named command with its arguments and the options that it needs, such as `organza mesh SCENE CAMERAS -o FILE`.
fn usage() -> String {
    let command = named_command().unwrap_or_default();
    let mut usage = format!("organza {}", command.get_name());
    for argument in command.get_positionals() {
        usage += &format!(" {}", argument.get_id().as_str().to_uppercase());
    }
    for option in command.get_opts().filter(|option| option.is_required_set()) {
        if let (Some(short), Some([value])) = (option.get_short(), option.get_value_names()) {
            usage += &format!(" -{short} {value}");
        }
    }
    usage
}

static LAST_PANIC: Mutex<String> = Mutex::new(String::new());

/// Keeps the text of a panic, which is a bug. It is then reported like other errors, unless a backtrace is asked for.
fn remember_panics() {
    if std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0") {
        return;
    }
    panic::set_hook(Box::new(|panic| {
        if let Ok(mut last) = LAST_PANIC.lock() {
            // The text has two lines.
            *last = panic.to_string().replace('\n', " ");
        }
    }));
}

/// Width and height in pixels, such as `1280x720`.
fn size(text: &str, sides: RangeInclusive<u32>) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse().ok().filter(|side| sides.contains(side));
    let size = text.split_once('x').and_then(|(w, h)| Some([side(w)?, side(h)?]));
    let min = sides.start();
    let max = sides.end();
    size.ok_or_else(|| format!("expected pixels such as 1280x720, each side {min} to {max}"))
}

/// [`size`] of an image.
fn image_size(text: &str) -> Result<[u32; 2], String> {
    size(text, 1..=MAX_IMAGE_SIDE)
}

/// `N` finite numbers with commas between them, such as `0,0,1.5`.
fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let number = |text: &str| text.trim().parse().ok().filter(|value: &f64| value.is_finite());
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    numbers?.try_into().ok()
}

/// Parses one finite number in a range; `expected` names the range in the error.
fn number_in(
    range: impl RangeBounds<f64> + Clone + Send + Sync + 'static,
    expected: &'static str,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    move |text: &str| match numbers(text) {
        Some([number]) if range.contains(&number) => Ok(number),
        _ => Err(format!("expected {expected}")),
    }
}

/// A path in JSON, as messages show it: text holds no other bytes than UTF-8.
fn text_of(path: &Path) -> String {
    path.display().to_string()
}

/// A path as a word of a shell's command.
fn quoted(path: &Path) -> String {
    let text = text_of(path);
    let is_plain = |c: char| c.is_alphanumeric() || c == MAIN_SEPARATOR || "/:._-+".contains(c);
    match shlex::try_quote(&text) {
        Ok(quoted) if !text.chars().all(is_plain) => quoted.into_owned(),
        _ => text,
    }
}

/// The path from the root of the file system.
fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// The title of a page: the last part of a path.
pub fn title(path: &Path) -> String {
    let path = absolute(path);
    path.file_name()
        .map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
