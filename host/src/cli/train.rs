//! `organza train`: from photographs to a scene.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use organza::data::{Dataset, DatasetOptions};
use organza::train::{self, CHECKPOINT, CONFIG, Event, Outcome, REPORT, Session, TrainConfig};
use organza::{Error, Renderer, Result};

use super::console::{Console, Progress};
use super::device::DeviceArgs;
use super::output::Folder;
use super::refuse;
use super::summary::count;

const EXAMPLES: &str = "\
Examples:
  organza train -o run                                 the built-in scene, no files needed
  organza train data/fox -o run --steps 3000
  organza train --resume run                           continues after Ctrl-C, to the same bits
  organza train data/fox -o other --config run/config.toml --seed 1
  organza eval run

RUN gets config.toml (all settings; --config reads them back), metrics.jsonl (the log), \
checkpoint.safetensors (a scene that every other command accepts) and report.html.";

/// Train a scene on photographs with poses, or on the built-in scene
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The data set: a folder of nerfstudio, Blender or COLMAP, or a transforms.json
    /// [default: the built-in scene]
    data: Option<PathBuf>,
    /// The folder for the run; created if it does not exist
    #[arg(short, long, value_name = "RUN", required_unless_present = "resume")]
    output: Option<PathBuf>,
    /// Continue a run that was stopped, with its own settings
    #[arg(long, value_name = "RUN", conflicts_with_all = ["output", "data", "config", "steps", "seed",
        "tiles_per_step", "tile_size", "downscale", "max_gaussians", "hold_out_every"])]
    resume: Option<PathBuf>,
    /// A settings file, TOML, such as a run's config.toml; options override it
    #[arg(long, value_name = "TOML")]
    config: Option<PathBuf>,
    /// Number of training steps
    #[arg(long, value_name = "N")]
    steps: Option<u32>,
    /// Tiles per step
    #[arg(long, value_name = "K")]
    tiles_per_step: Option<u32>,
    /// Side of a tile, in pixels
    #[arg(long, value_name = "S")]
    tile_size: Option<u32>,
    /// Largest number of Gaussians, also at the start
    #[arg(long, value_name = "N")]
    max_gaussians: Option<u32>,
    /// Shrink photographs by this factor
    #[arg(long, value_name = "N")]
    downscale: Option<u32>,
    /// Hold out every Nth frame, starting with the first; 0 holds out none
    #[arg(long, value_name = "N")]
    hold_out_every: Option<usize>,
    /// Seed of all random choices
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Finish after this many seconds of training, as after the last step
    #[arg(long, value_name = "SECONDS")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..))]
    time_limit: Option<u32>,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args) -> Result<()> {
    let console = args.device.console();
    let (folder, config) = prepare(args)?;
    // until there is something in it
    let _made = Folder::make(&folder)?;
    let renderer = args.device.open()?;
    let dataset = load(&config, &renderer, console)?;
    let background = match config.data.path {
        Some(_) => config.data.background.map(f64::from),
        None => train::built_in::background(),
    };
    let stop = stop_on_signals()?;
    let session = Session {
        renderer: &renderer,
        config: &config,
        dataset: &dataset,
        background,
        folder: &folder,
        time_limit: args.time_limit.map(f64::from),
        stop: &stop,
    };
    let bar = console.progress(u64::from(config.run.steps), "steps");
    bar.say("training");
    let outcome = session.run(args.resume.is_some(), &mut |event| show(event, &bar, console))?;
    drop(bar);
    console.note(&match outcome {
        Outcome::Stopped => {
            format!("saved; `organza train --resume {}` continues from here", folder.display())
        }
        Outcome::Finished | Outcome::TimeLimit => {
            format!(
                "wrote {} and {}",
                folder.join(CHECKPOINT).display(),
                folder.join(REPORT).display()
            )
        }
    });
    Ok(())
}

/// The run's folder and its settings.
fn prepare(args: &Args) -> Result<(PathBuf, TrainConfig)> {
    if let Some(folder) = &args.resume {
        let path = folder.join(CONFIG);
        if !path.exists() {
            let reason = format!(
                "the folder has no {CONFIG}, so it is not a training run's; name the folder that \
                 `organza train -o` wrote to"
            );
            return Err(Error::Invalid { origin: folder.clone(), reason });
        }
        return Ok((folder.clone(), TrainConfig::load(path)?));
    }
    let folder = args.output.clone().expect("clap requires it");
    let config = settings(args)?;
    for name in [CONFIG, CHECKPOINT] {
        if folder.join(name).exists() {
            let reason = format!(
                "the folder already holds a run ({name}); continue it with `--resume`, or name \
                 another folder"
            );
            return Err(Error::Invalid { origin: folder, reason });
        }
    }
    Ok((folder, config))
}

fn settings(args: &Args) -> Result<TrainConfig> {
    let mut config = match &args.config {
        Some(path) => TrainConfig::load(path)?,
        None if args.data.is_none() => TrainConfig::built_in(),
        None => TrainConfig::default(),
    };
    fn set<T: Clone>(target: &mut T, value: &Option<T>) {
        if let Some(value) = value {
            *target = value.clone();
        }
    }
    if let Some(data) = &args.data {
        // a run is resumed from anywhere
        let path = std::path::absolute(data).unwrap_or_else(|_| data.clone());
        config.data.path = Some(path);
    }
    set(&mut config.run.steps, &args.steps);
    set(&mut config.run.tiles_per_step, &args.tiles_per_step);
    set(&mut config.run.tile_size, &args.tile_size);
    set(&mut config.growth.max_gaussians, &args.max_gaussians);
    if let Some(most) = args.max_gaussians {
        config.start.gaussians = config.start.gaussians.min(most);
    }
    set(&mut config.data.downscale, &args.downscale);
    set(&mut config.data.hold_out_every, &args.hold_out_every);
    set(&mut config.run.seed, &args.seed);
    // options are held to what files are held to
    TrainConfig::parse(&config.to_toml(), Path::new(""))
}

fn load(config: &TrainConfig, renderer: &Renderer, console: Console) -> Result<Dataset> {
    let data = &config.data;
    let Some(path) = &data.path else {
        let bar = console.progress(u64::from(data.built_in_views), "views");
        bar.say("rendering the built-in scene");
        let (views, side) = (data.built_in_views, data.built_in_side);
        return train::built_in::dataset(renderer, views, side, data.hold_out_every, &|done, _| {
            bar.set(done);
        });
    };
    let options = DatasetOptions {
        downscale: data.downscale,
        hold_out_every: data.hold_out_every,
        background: data.background,
    };
    let bar = console.progress(0, "photographs");
    bar.say("reading");
    let dataset = Dataset::load(path, &options, &|done, all| bar.set_of(done, all))?;
    drop(bar);
    for missing in &dataset.missing {
        console.warn(&format!("missing, so left out: {}", missing.display()));
    }
    let (all, held_out) = (dataset.frames.len() as u64, dataset.held_out.len());
    console.note(&format!("{} ({}), {held_out} held out", count(all, "photograph"), dataset.kind));
    Ok(dataset)
}

/// A flag that Ctrl-C and SIGTERM set; the second time they end the program at once.
fn stop_on_signals() -> Result<Arc<AtomicBool>> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = stop.clone();
    let handler = move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(super::FAILURE));
        }
    };
    match ctrlc::set_handler(handler) {
        Ok(()) => Ok(stop),
        Err(error) => refuse(format!("cannot handle signals: {error}")),
    }
}

fn show(event: Event<'_>, bar: &Progress, console: Console) {
    match event {
        Event::Begin(0) => {}
        Event::Begin(step) => {
            bar.set(step as usize);
            bar.restart_clock();
            console.note(&format!("continuing after step {step}"));
        }
        Event::Step { step, seconds, report, scene } => {
            let speed = f64::from(step) * report.tiles as f64 / seconds.max(1e-9);
            bar.set(step as usize);
            bar.say(&format!(
                "loss {:.4}, PSNR {:.1} dB, {speed:.0} tiles/s, {} Gaussians",
                report.loss,
                report.psnr,
                scene.len()
            ));
        }
        Event::Evaluating => bar.say("measuring the held-out views"),
        Event::Evaluated(evaluation) => {
            let decibels =
                |value: Option<f64>| value.map_or("no".to_owned(), |v| format!("{v:.2}"));
            let (psnr, ssim) = (evaluation.mean.psnr, evaluation.mean.ssim);
            let ssim = ssim.map_or("no".to_owned(), |value| format!("{value:.4}"));
            let views = count(evaluation.views.len() as u64, "held-out view");
            bar.note(console, &format!("{views}: PSNR {} dB, SSIM {ssim}", decibels(psnr)));
        }
    }
}
