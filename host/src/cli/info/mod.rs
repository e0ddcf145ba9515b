//! `organza info`: describes a file.

mod cameras;
mod scene;
mod tensors;
mod tiles;

use std::path::{Path, PathBuf};

use organza::{Camera, Error, Result, Scene, TileBatch};

use super::console::{Console, print, print_json};
use super::inputs::{FileKind, Format, SceneSource, format};

/// Most rows of a table that could have as many rows as a data set has photographs.
const MOST_ROWS: usize = 24;

const EXAMPLES: &str = "\
Examples:
  organza info scene.safetensors
  organza info run
  organza info cameras.json
  organza info data/fox
  organza info rendered.safetensors --json";

/// Describe a scene, cameras, tiles, a rendered batch or a data set
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The file, which is recognized by its content. Or a folder: a training run's, or a data set
    file: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    if FileKind::from_path(&args.file) == Some(FileKind::DataSet) {
        return show(args, &cameras::CameraFile::from_data_set(&args.file)?);
    }
    let source = SceneSource::find(&args.file)?;
    let path = source.file();
    console.detail(&format!("reading {}", path.display()));
    match format(path)? {
        Format::Safetensors => match Scene::load(path) {
            Ok(scene) => show(args, &scene::SceneInfo::new(path, &scene)?),
            // No program has named the file's content: it has just tensors.
            Err(Error::WrongFormat { found, .. }) if found == "missing" => {
                show(args, &tensors::TensorFile::load(path)?)
            }
            Err(error) => Err(error),
        },
        Format::Cameras => show(args, &cameras::CameraFile::new(path, &Camera::load_all(path)?)),
        Format::Tiles => show(args, &tiles::TileFile::new(path, &TileBatch::load(path)?)),
    }
}

fn show(args: &Args, info: &(impl serde::Serialize + std::fmt::Display)) -> Result<()> {
    if args.json { print_json(info) } else { print(&info.to_string()) }
}

/// The number of rows that a table leaves out, as text.
fn and_more(all: usize) -> String {
    match all.saturating_sub(MOST_ROWS) {
        0 => String::new(),
        more => format!("... and {more} more (--json has all)\n"),
    }
}

/// A file's size in bytes; 0 if the file has been removed meanwhile.
fn file_bytes(path: &Path) -> u64 {
    std::fs::metadata(path).map_or(0, |found| found.len())
}
