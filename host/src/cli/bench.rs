//! `organza bench`: how long a batch takes.

use std::path::PathBuf;

use organza::bench::{BenchOptions, Benchmark, KernelShare, measure, passes};
use organza::{Camera, Result, Scene, TileBatch};

use super::console::{print, print_json};
use super::device::DeviceArgs;
use super::summary::{count, grouped};
use super::table::Table;
use super::tiles::with_origin;

const EXAMPLES: &str = "\
Examples:
  organza bench scene.safetensors cameras.json tiles.json
  organza bench scene.safetensors cameras.json tiles.json --backend cpu --threads 1 --json
  organza bench scene.safetensors cameras.json tiles.json --forward --repeat 20

Times are medians over the passes, after one that warms up. Forward ends with the tiles on the host. Forward and \
backward is one pass, for the derivative of the tiles' sum (dLoss/dY = 1 everywhere), and ends with the gradients of \
all tensors on the device. A kernel's share is that of the kernels' time. On the CPU kernels are timed in the same \
passes; on a GPU in passes of their own, where each dispatch is waited for: with the way to the device and back in \
every dispatch, they add up to more than a whole pass. Peak memory is the process's, reading the scene included; not \
a GPU's.";

/// Measure how long a batch takes, forward and backward, and which kernels take it
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors
    scene: PathBuf,
    /// The cameras, nerfstudio's transforms.json
    cameras: PathBuf,
    /// The tiles, JSON
    tiles: PathBuf,
    /// Passes to take the median of
    #[arg(long, value_name = "N", default_value_t = 5)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=100_000))]
    repeat: u32,
    /// Measure forward alone
    #[arg(long)]
    forward: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args) -> Result<()> {
    let console = args.device.console();
    let batch = TileBatch::load(&args.tiles)?;
    let cameras = Camera::load_all(&args.cameras)?;
    batch.validate(&cameras).map_err(|error| with_origin(error, &args.tiles))?;
    let scene = console.during("reading the scene", || Scene::load(&args.scene))?;
    let renderer = args.device.open()?;
    // the host's copy is not kept: it is not part of what rendering takes
    let scene = renderer.upload(&{ scene })?;
    let options = BenchOptions { repeat: args.repeat as usize, backward: !args.forward };
    let benchmark = {
        let progress = console.progress(passes(renderer.device(), options) as u64, "passes");
        progress.say("measuring");
        measure(&renderer, &scene, &cameras, &batch, options, &mut || progress.advance(1))?
    };
    if args.json { print_json(&benchmark) } else { print(&text(&benchmark)) }
}

/// What was measured in lines, and the kernels as a table.
fn text(benchmark: &Benchmark) -> String {
    let batch = [
        count(benchmark.gaussians as u64, "Gaussian"),
        format!("{0} of {1} x {1}", count(benchmark.tiles as u64, "tile"), benchmark.side),
        count(benchmark.parts as u64, "part"),
        count(benchmark.pairs, "pair"),
        count(benchmark.members, "member"),
        count(benchmark.samples, "sample"),
    ];
    let mut text = format!("{}\n{}\n\n", benchmark.device, batch.join(", "));
    let mut whole = Table::new(1, ["median", "seconds", "peak memory"]);
    let memory = |bytes: Option<u64>| {
        bytes.map_or("-".to_owned(), |bytes| format!("{} MiB", grouped(bytes >> 20)))
    };
    let mut row = |name: &str, seconds: f64, bytes| {
        whole.row([name.to_owned(), self::seconds(seconds), memory(bytes)]);
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

fn table(kernels: &[KernelShare]) -> Table {
    let mut table = Table::new(1, ["kernel", "dispatches", "seconds", "share"]);
    for kernel in kernels {
        table.row([
            kernel.name.to_owned(),
            grouped(kernel.dispatches),
            seconds(kernel.seconds),
            format!("{:.1}%", 100.0 * kernel.share),
        ]);
    }
    table
}

/// Down to a microsecond.
fn seconds(seconds: f64) -> String {
    format!("{seconds:.6}")
}
