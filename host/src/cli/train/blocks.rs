//! `organza train BLOCKS`: the blocks of a split, one after the other.

use std::fs;
use std::path::{Path, PathBuf};

use organza::data::block::BLOCK;
use organza::data::{self, Block};
use organza::error::{self, invalid};
use organza::train::{self, CONFIG};
use organza::{Error, Result};

use super::{Args, Prepared};
use crate::cli::console::{Console, print_json};
use crate::cli::signals::Signals;
use crate::cli::summary::count;
use crate::cli::{absolute, quoted, refuse};

/// The blocks in the folder of a split; `None` for every other folder.
pub fn of_split(folder: &Path) -> Result<Option<Vec<(PathBuf, Block)>>> {
    if data::kind_of(folder).is_some() { Ok(None) } else { Block::all_in(folder) }
}

/// Trains each block in a folder of its own. What is finished is left as it is, what was interrupted goes on, and what fails does not
/// stop the others.
pub fn train(args: &Args, blocks: &[(PathBuf, Block)], console: Console) -> Result<()> {
    let runs = args.output.as_deref().expect("clap requires it");
    let all = blocks.len();
    let folders =
        blocks.iter().map(|(data, block)| (data, runs.join(Block::name(block.index)), block));
    let folders: Vec<_> = folders.collect();
    folders.iter().try_for_each(|(data, folder, block)| check(folder, data, block))?;
    let signals = Signals::listen()?;
    let mut ended = Vec::new();
    let mut failed = Vec::new();
    for (data, folder, block) in folders {
        let name = Block::name(block.index);
        if folder.join(BLOCK).exists() {
            console.note(&format!("{name} is finished already"));
            continue;
        }
        console.note(&format!("{name}, of {}", count(all as u64, "block")));
        let group = args.ranks.start()?;
        if group.as_ref().is_some_and(|group| group.is_mpi) {
            let one = quoted(data);
            return refuse(format!(
                "`--ranks mpi` trains one block at a time: name its folder, such as {one}"
            ));
        }
        let run =
            prepare(args, data, folder).and_then(|run| run.train(args, group, &signals, console));
        match run {
            Ok(run) if run.outcome == super::STOPPED => {
                console.note("stopped; the same command continues with this block");
                ended.push(run);
                break;
            }
            Ok(run) => ended.push(run),
            Err(error) => {
                console.warn(&format!("{name} failed: {}", error::chain(&error)));
                failed.push(name);
            }
        }
    }
    if !failed.is_empty() {
        let failed_of = failed.len();
        let names = failed.join(", ");
        return refuse(format!(
            "{failed_of} of {all} blocks failed: {names}. The others are trained; the same command tries these again"
        ));
    }
    if args.json { print_json(&ended) } else { Ok(()) }
}

/// Refuses a folder with a run of something else.
fn check(folder: &Path, data: &Path, block: &Block) -> Result<()> {
    let is_same = if folder.join(BLOCK).exists() {
        Block::load(folder)?.split == block.split
    } else if folder.join(CONFIG).exists() {
        let path = train::settings_of(folder)?.data.path;
        let real = |path: &Path| fs::canonicalize(path).map_err(|source| Error::read(path, source));
        path.as_deref().map(real).transpose()? == Some(real(data)?)
    } else {
        true
    };
    match is_same {
        true => Ok(()),
        false => invalid(
            folder,
            format!(
                "this is a run of another split than {}: name another folder with `-o`",
                data.display()
            ),
        ),
    }
}

/// The run of a block: a new one with the settings of the command, or one that goes on with its own.
fn prepare(args: &Args, data: &Path, folder: PathBuf) -> Result<Prepared> {
    if folder.join(CONFIG).exists() {
        let mut config = train::settings_of(&folder)?;
        config.data.path = config.data.path.map(|path| absolute(&path));
        return Ok(Prepared { folder, config, resume: true, shrinks: false });
    }
    let (config, shrinks) = args.settings.settings(Some(data))?;
    Ok(Prepared { folder, config, resume: false, shrinks })
}
