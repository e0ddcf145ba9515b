//! `organza tiles`: a batch of tiles as one tensor.

use std::path::{Path, PathBuf};

use organza::scene::{TensorRef, write_tensors};
use organza::{Camera, Error, Result, Scene, TileBatch, memory};

use super::device::DeviceArgs;
use super::output;
use super::summary::{Summary, count, grouped};
use super::views::warn_distorted;

const EXAMPLES: &str = "\
Examples:
  organza tiles scene.safetensors cameras.json tiles.json -o rendered.safetensors
  organza tiles scene.safetensors cameras.json tiles.json -o rendered.safetensors --backend cpu

TILES holds {\"side\": 64, \"tiles\": [{\"camera\": 0, \"origin\": [128, 96]}, ...]}: a tile's \
origin is the column and the row of its upper left pixel. OUT holds `tiles`, F32 [K, 3, S, S]: \
tile, RGB, row, column.";

/// Render a batch of tiles, of any views, into one tensor
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors
    scene: PathBuf,
    /// The cameras, nerfstudio's transforms.json
    cameras: PathBuf,
    /// The tiles, JSON
    tiles: PathBuf,
    /// Where to write the tensor, safetensors
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args) -> Result<()> {
    let console = args.device.console();
    output::check_file(&args.output, &[&args.scene, &args.cameras, &args.tiles])?;
    // The large file comes last: most mistakes are in the small ones.
    let batch = TileBatch::load(&args.tiles)?;
    let cameras = Camera::load_all(&args.cameras)?;
    batch.validate(&cameras).map_err(|error| with_origin(error, &args.tiles))?;
    let mut views: Vec<_> = batch.tiles.iter().map(|tile| tile.camera).collect();
    views.sort_unstable();
    views.dedup();
    warn_distorted(console, &cameras, &views);
    memory::check(
        4 * batch.output_shape().iter().map(|&n| n as u64).product::<u64>(),
        "the output",
    )?;
    let scene = console.during("reading the scene", || Scene::load(&args.scene))?;

    let renderer = args.device.open()?;
    let scene = renderer.upload(&scene)?;
    let mut summary = Summary::start();
    let tiles = {
        let progress = console.progress(batch.tiles.len() as u64, "tiles");
        progress.say("rendering");
        let mut advance = |tiles| progress.advance(tiles);
        renderer.render_with_progress(&scene, &cameras, &batch, &mut advance)?
    };
    summary.add(&tiles.report);
    let (number, side) = (count(tiles.count as u64, "tile"), tiles.side);
    console.note(&summary.line(&format!("{number} of {side} x {side}")));
    let not_finite = tiles.data.iter().filter(|value| !value.is_finite()).count();
    if not_finite > 0 {
        let (found, all) = (grouped(not_finite as u64), count(tiles.data.len() as u64, "value"));
        console.warn(&format!("{found} of {all} are NaN or infinite: are the networks sane?"));
    }

    let shape = batch.output_shape();
    let tensor = TensorRef { name: "tiles", shape: &shape, data: &tiles.data };
    write_tensors(&args.output, &[tensor], &[])?;
    console.note(&format!("wrote {}: tiles {shape:?}", args.output.display()));
    Ok(())
}

/// Names the file of a tile that was found wrong only beside the cameras.
fn with_origin(error: Error, path: &Path) -> Error {
    match error {
        Error::Tile { tile, reason, .. } => Error::Tile { origin: path.to_owned(), tile, reason },
        other => other,
    }
}
