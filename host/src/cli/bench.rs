//! `organza bench`: measures a batch.

use std::path::PathBuf;

use muslin_check::bench::{self, table};
use organza::bench::{BenchOptions, Benchmark, measure, passes};
use organza::camera::Orbit;
use organza::image::TILE_SIDE;
use organza::{Camera, Result, Scene, TileBatch, demo};

use super::console::{Console, print, print_json};
use super::demo::built_in;
use super::device::SceneArgs;
use super::inputs::{Cameras, DataArgs, SceneSource};
use super::summary::{Table, count, grouped};
use super::tiles::load_batch;
use super::{image_size, refuse, usage};

/// Measure a batch, forward and backward, and each kernel's part of it
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/bench.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run [default: what `organza demo` writes]
    #[arg(required_if_eq("frame", "true"))]
    scene: Option<PathBuf>,
    /// The cameras: nerfstudio's transforms.json, or a data set
    cameras: Option<PathBuf>,
    /// The tiles, JSON
    tiles: Option<PathBuf>,
    /// Number of passes; times are their medians
    #[arg(long, value_name = "N", default_value_t = 5)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=100_000))]
    repeat: u32,
    /// Measure only the forward pass
    #[arg(long)]
    forward: bool,
    /// Measure an image instead of tiles: of the first camera, or of an orbit around the scene
    #[arg(long, conflicts_with = "tiles")]
    frame: bool,
    /// Size of the image, in pixels
    #[arg(long, value_name = "WxH", value_parser = image_size, default_value = "1920x1080", requires = "frame")]
    size: [u32; 2],
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

/// The batch to render.
struct Workload {
    scene: Scene,
    cameras: Vec<Camera>,
    batch: TileBatch,
}

impl Args {
    fn workload(&self, console: Console) -> Result<Workload> {
        let Some(scene) = &self.scene else {
            let (cameras, batch) = built_in();
            return Ok(Workload { scene: demo::scene(), cameras, batch });
        };
        let source = SceneSource::find(scene)?;
        if self.frame {
            return self.frame(source, console);
        }
        let (Some(cameras), Some(tiles)) = (&self.cameras, &self.tiles) else {
            return refuse(format!(
                "the arguments CAMERAS and TILES are required: `{}`; an image needs `--frame`",
                usage()
            ));
        };
        let batch = load_batch(tiles)?;
        let cameras = Cameras::load(&source, Some(cameras), &self.data, console)?.list;
        batch.validate(&cameras).map_err(|error| error.in_file(tiles))?;
        Ok(Workload { scene: source.load(console)?, cameras, batch })
    }

    /// One image.
    fn frame(&self, source: SceneSource, console: Console) -> Result<Workload> {
        let scene = source.load(console)?;
        let camera = if self.cameras.is_some() || source.settings()?.is_some() {
            let cameras = Cameras::load(&source, self.cameras.as_deref(), &self.data, console)?;
            cameras.list[0].with_size(self.size)
        } else {
            Orbit::from_box(scene.visible_box(), self.size).cameras(1)?.remove(0)
        };
        let [width, height] = self.size;
        let batch = TileBatch::cover(0, width, height, TILE_SIDE)?;
        Ok(Workload { scene, cameras: vec![camera], batch })
    }

    fn measure(&self, workload: Workload, console: Console) -> Result<Benchmark> {
        let Workload { scene, cameras, batch } = workload;
        let renderer = self.scene_args.device.open(console)?;
        // the host's copy is dropped: rendering does not need it
        let scene = renderer.upload_with(&{ scene }, self.scene_args.options())?;
        let backward = !self.forward && !self.frame;
        let options = BenchOptions { repeat: self.repeat as usize, backward, frame: self.frame };
        let progress = console.progress("measuring", passes(renderer.device(), options), "passes");
        measure(&renderer, &scene, &cameras, &batch, options, &mut || progress.advance(1))
    }
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    if args.scene_args.half_grids && !args.forward && !args.frame {
        return refuse("`--half-grids` has no gradients; add `--forward`");
    }
    let benchmark = args.measure(args.workload(console)?, console)?;
    if args.json { print_json(&benchmark) } else { print(&text(&benchmark)) }
}

/// The measurements in lines, and the kernels as a table.
fn text(benchmark: &Benchmark) -> String {
    let report = &benchmark.report;
    let batch = [
        count(benchmark.gaussians as u64, "Gaussian"),
        format!("{0} of {1} x {1}", count(benchmark.tiles as u64, "tile"), benchmark.side),
        count(report.parts as u64, "part"),
        count(report.pairs, "pair"),
        count(report.intersections, "intersection"),
        count(report.samples, "sample"),
    ];
    let mut text = format!("{}\n{}\n\n", benchmark.device, batch.join(", "));
    let mut whole = Table::new(1, ["median", "seconds", "peak memory"]);
    let mut row = |name: &str, seconds: f64, bytes| {
        whole.row([name.to_owned(), bench::seconds(seconds), memory(bytes)]);
    };
    row("forward", benchmark.forward_s, benchmark.forward_peak_memory_bytes);
    if let Some(seconds) = benchmark.forward_backward_s {
        row("forward and backward", seconds, benchmark.peak_memory_bytes);
    }
    text += &whole.to_string();
    text += &format!("\nforward\n{}", table(&benchmark.forward_kernels));
    if benchmark.forward_backward_s.is_some() {
        text += &format!("\nforward and backward\n{}", table(&benchmark.kernels));
    }
    text
}

/// Bytes as MiB; a dash for `None`.
fn memory(bytes: Option<u64>) -> String {
    bytes.map_or("-".to_owned(), |bytes| format!("{} MiB", grouped(bytes >> 20)))
}
