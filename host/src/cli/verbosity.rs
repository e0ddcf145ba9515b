//! How much the program says on stderr.

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

/// What is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Warnings and errors.
    Quiet,
    /// And what a command does and has done.
    Normal,
    /// And details.
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
