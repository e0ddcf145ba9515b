//! Options for the amount of output on stderr.

/// Options of every command.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Verbosity {
    /// Print only warnings and errors
    #[arg(short, long, global = true, display_order = 1000)]
    quiet: bool,
    /// Also print details: files, sizes, settings and times
    #[arg(short, long, global = true, display_order = 1001, conflicts_with = "quiet")]
    verbose: bool,
}

/// The amount of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Only warnings and errors.
    Quiet,
    /// Also what a command does and has done.
    Normal,
    /// Also details.
    Verbose,
}

impl Verbosity {
    pub fn level(self) -> Level {
        match (self.quiet, self.verbose) {
            (true, _) => Level::Quiet,
            (_, true) => Level::Verbose,
            _ => Level::Normal,
        }
    }
}
