//! `organza info`: what a file holds.

mod cameras;
mod scene;
mod tensors;
mod tiles;

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

use organza::{Camera, Error, Result, Scene, TileBatch};
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::console::{print, print_json};

/// Rows of a table that could have as many as a data set has photographs.
const MOST_ROWS: usize = 24;

const EXAMPLES: &str = "\
Examples:
  organza info scene.safetensors
  organza info cameras.json
  organza info rendered.safetensors --json";

/// Describe a file: a scene, cameras, tiles, or a rendered batch
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The file; its content decides what it is
    file: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Result<()> {
    let path = args.file.as_path();
    match kind(path)? {
        Kind::Safetensors => match Scene::load(path) {
            Ok(scene) => show(args, &scene::SceneInfo::new(path, &scene)?),
            // No other program's name for its content: tensors of anyone's.
            Err(Error::WrongFormat { found, .. }) if found == "missing" => {
                show(args, &tensors::TensorFile::load(path)?)
            }
            Err(error) => Err(error),
        },
        Kind::Cameras => show(args, &cameras::CameraFile::new(path, &Camera::load_all(path)?)),
        Kind::Tiles => show(args, &tiles::TileFile::new(path, &TileBatch::load(path)?)),
    }
}

fn show(args: &Args, info: &(impl serde::Serialize + std::fmt::Display)) -> Result<()> {
    if args.json { print_json(info) } else { print(&info.to_string()) }
}

enum Kind {
    Safetensors,
    Cameras,
    Tiles,
}

/// What JSON is about, by its top-level keys.
#[derive(Deserialize)]
struct Keys {
    frames: Option<IgnoredAny>,
    side: Option<IgnoredAny>,
    tiles: Option<IgnoredAny>,
}

fn kind(path: &Path) -> Result<Kind> {
    let cannot_read = |source| Error::ReadFile { path: path.to_owned(), source };
    // What is no regular file could block or never end: a loader says so.
    if !std::fs::metadata(path).is_ok_and(|found| found.is_file()) {
        return Ok(Kind::Safetensors);
    }
    let mut start = Vec::new();
    let file = File::open(path).map_err(cannot_read)?;
    file.take(64).read_to_end(&mut start).map_err(cannot_read)?;
    let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start);
    let is_json = text.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'{');
    // The length in front of a safetensors header ends in zeros, which JSON has none of.
    let named = path.extension().is_some_and(|extension| extension == "safetensors");
    if named || start.iter().take(8).any(|&byte| byte == 0) {
        return Ok(Kind::Safetensors);
    }
    let reason = if is_json {
        let mut reader = BufReader::new(File::open(path).map_err(cannot_read)?);
        let mark = (start.len() - text.len()) as u64;
        std::io::copy(&mut reader.by_ref().take(mark), &mut std::io::sink())
            .map_err(cannot_read)?;
        match serde_json::from_reader::<_, Keys>(reader) {
            Ok(keys) if keys.tiles.is_some() || keys.side.is_some() => return Ok(Kind::Tiles),
            Ok(keys) if keys.frames.is_some() => return Ok(Kind::Cameras),
            Ok(_) => "it is JSON, but has neither the `frames` of cameras nor `side` and `tiles`",
            // The loader words it better.
            Err(_) => return Ok(Kind::Cameras),
        }
    } else {
        "it is neither safetensors nor a JSON object"
    };
    let expected = "expected a scene, cameras, tiles or a rendered batch";
    Err(Error::Invalid { origin: path.to_owned(), reason: format!("{reason}; {expected}") })
}

/// How many rows a table leaves out.
fn and_more(all: usize) -> String {
    match all.saturating_sub(MOST_ROWS) {
        0 => String::new(),
        more => format!("... and {more} more (--json has all)\n"),
    }
}

/// A file's size; a file that has gone meanwhile has none.
fn file_bytes(path: &Path) -> u64 {
    std::fs::metadata(path).map_or(0, |found| found.len())
}
