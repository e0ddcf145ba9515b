//! `organza tiles`: renders a batch of tiles into one tensor.

use std::path::{Path, PathBuf};

use muslin_device::memory;
use organza::error::invalid;
use organza::scene::{TensorSpec, read_tensors, write_tensors};
use organza::{Camera, RenderedTiles, Renderer, Result, TileBatch};
use serde::Serialize;

use super::channels::ChannelArgs;
use super::console::{Console, print_json};
use super::device::SceneArgs;
use super::inputs::{Cameras, DataArgs, FileKind, SceneSource, told_apart};
use super::summary::{Cost, Summary, count, grouped};
use super::views::warn_distorted;
use super::{output, refuse, text_of};

/// Render a batch of tiles, of any views, into one tensor
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/tiles.txt"), allow_missing_positional = true)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The cameras: nerfstudio's transforms.json, or a data set [default: the run's]
    cameras: Option<PathBuf>,
    /// The tiles, JSON
    tiles: PathBuf,
    /// Where to write the tensor, safetensors
    #[arg(short, long, value_name = "OUT", required_unless_present = "grad")]
    output: Option<PathBuf>,
    /// The gradient of a loss with respect to the rendered tiles: `grad_tiles` in a safetensors file
    #[arg(long, value_name = "G", requires = "grad")]
    grad_tiles: Option<PathBuf>,
    /// Where to write the gradient of the loss with respect to every tensor of the scene, safetensors
    #[arg(long, value_name = "GRAD", requires = "grad_tiles", conflicts_with = "half_grids")]
    grad: Option<PathBuf>,
    /// Print JSON: the files, and the cost of rendering (docs/json.md)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    channels: ChannelArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

impl Args {
    /// Reads everything but the scene.
    fn read(
        &self,
        source: &SceneSource,
        console: Console,
    ) -> Result<(TileBatch, Vec<Camera>, Option<Vec<f32>>)> {
        let mut inputs = vec![source.named(), &self.tiles];
        inputs.extend(self.cameras.as_deref());
        inputs.extend(self.grad_tiles.as_deref());
        for output in self.output.iter().chain(&self.grad) {
            output::check_file(output, inputs.iter().copied())?;
        }
        if self.output.is_some() && self.output == self.grad {
            return refuse("`--output` and `--grad` name the same file");
        }
        let channels = self.channels.list();
        if self.output.is_none() && !channels.is_empty() {
            return refuse("`--channels` are written to the output; name one with `-o OUT`");
        }
        // The large file is read last: most mistakes are in the small ones.
        let batch = load_batch(&self.tiles)?;
        let cameras = Cameras::load(source, self.cameras.as_deref(), &self.data, console)?.list;
        batch.validate(&cameras).map_err(|error| error.in_file(&self.tiles))?;
        let mut views: Vec<_> = batch.tiles.iter().map(|tile| tile.camera).collect();
        views.sort_unstable();
        views.dedup();
        warn_distorted(console, &cameras, &views);
        let grad_tiles = self.grad_tiles.as_deref().map(|path| read_grad_tiles(path, &batch));
        let grad_tiles = grad_tiles.transpose()?;
        let planes = 3 + channels.iter().map(|c| c.planes()).sum::<usize>();
        let [tiles, _, side, _] = batch.output_shape().map(|n| n as u64);
        memory::check(4 * tiles * planes as u64 * side * side, "the output")?;
        Ok((batch, cameras, grad_tiles))
    }
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let source = SceneSource::find(&args.scene)?;
    let (batch, cameras, grad_tiles) = &args.read(&source, console)?;
    let output = args.output.as_deref();
    let channels = args.channels.list();
    let mut cost = None;
    let mut gradient = None;
    let scene = source.load(console)?;
    let renderer = &args.scene_args.device.open(console)?;
    let scene = &renderer.upload_with(&scene, args.scene_args.options())?;
    if let Some(output) = output {
        let mut summary = Summary::start();
        let tiles = {
            let progress = console.progress("rendering", batch.tiles.len(), "tiles");
            let mut advance = |done, total| progress.set_of(done, total);
            renderer.render_channels(scene, cameras, batch, &channels, &mut advance)?
        };
        cost = Some(write_tiles(console, &mut summary, renderer, &tiles, batch, output)?);
    }
    if let Some(values) = grad_tiles {
        let task = || renderer.gradient(scene, cameras, batch, values);
        gradient = Some(console.during("computing the gradient", task)?);
    }
    if let (Some(gradient), Some(output)) = (gradient, &args.grad) {
        gradient.save(output)?;
        console.note(&format!("wrote {}: grad.<tensor>", output.display()));
    }
    if args.json {
        let file = args.output.as_deref().map(text_of);
        let gradient = args.grad.as_deref().map(text_of);
        return print_json(&TilesOutput { file, shape: batch.output_shape(), gradient, cost });
    }
    Ok(())
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct TilesOutput {
    file: Option<String>,
    shape: [usize; 4],
    gradient: Option<String>,
    #[serde(flatten)]
    cost: Option<Cost>,
}

/// Reads `grad_tiles` from a file. It must have the batch's shape.
fn read_grad_tiles(path: &Path, batch: &TileBatch) -> Result<Vec<f32>> {
    let spec = TensorSpec {
        name: "grad_tiles".to_owned(),
        shape: batch.output_shape().to_vec(),
        why: "a value for each of `tiles`, the rendered batch",
    };
    let values = spec.take(&mut read_tensors(path)?, path)?;
    if values.iter().all(|value| value.is_finite()) {
        return Ok(values);
    }
    invalid(path, "`grad_tiles` has values that are NaN or infinite")
}

fn write_tiles(
    console: Console,
    summary: &mut Summary,
    renderer: &Renderer,
    tiles: &RenderedTiles,
    batch: &TileBatch,
    output: &Path,
) -> Result<Cost> {
    summary.add(&tiles.report);
    let number = count(tiles.count as u64, "tile");
    let side = tiles.side;
    summary.say(&format!("{number} of {side} x {side}"), console);
    let not_finite = tiles.data.iter().filter(|value| !value.is_finite()).count();
    if not_finite > 0 {
        let found = grouped(not_finite as u64);
        let all = count(tiles.data.len() as u64, "value");
        console.warn(&format!("{found} of {all} are NaN or infinite; check the networks' weights"));
    }

    let spec = |name: &str, planes| {
        let [tiles, _, rows, columns] = batch.output_shape();
        let shape = vec![tiles, planes, rows, columns];
        TensorSpec { name: name.to_owned(), shape, why: "what was rendered" }
    };
    let mut tensors = vec![(spec("tiles", 3), &tiles.data[..])];
    let channels = tiles.channels.iter();
    tensors.extend(channels.map(|(c, values)| (spec(c.name(), c.planes()), &values[..])));
    write_tensors(output, &tensors, &[])?;
    let written = tensors.iter().map(|(spec, _)| format!("{} {:?}", spec.name, spec.shape));
    let written: Vec<_> = written.collect();
    console.note(&format!("wrote {}: {}", output.display(), written.join(", ")));
    Ok(summary.cost(renderer, not_finite as u64))
}

/// Reads a file of tiles.
pub fn load_batch(path: &Path) -> Result<TileBatch> {
    TileBatch::load(path).map_err(|error| told_apart(error, path, FileKind::Tiles))
}
