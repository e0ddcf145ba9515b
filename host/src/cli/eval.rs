//! `organza eval`: how close a scene comes to photographs.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use clap::ValueEnum;
use organza::data::{Dataset, DatasetOptions, Frame};
use organza::evaluate::{Event, Score, evaluate, tiles};
use organza::train::config::DataConfig;
use organza::train::{self, CHECKPOINT, CONFIG};
use organza::{DeviceScene, Error, Evaluation, Renderer, Result, Scene};

use super::console::{Console, print, print_json};
use super::device::{DeviceArgs, SceneArgs};
use super::picture::warn_not_finite;
use super::summary::count;
use super::table::Table;
use super::train::warn_of_files;

const EXAMPLES: &str = "\
Examples:
  organza eval run
  organza eval run --split train
  organza eval scene.safetensors data/lego --background 1,1,1 --json
  organza eval run data/garden --downscale 4

A run's folder says what the run was trained on, the built-in scene included, and which frames were held out. \
Arguments and options override this.

PSNR is in decibels. SSIM uses windows of 11 x 11 pixels with Gaussian weights (sigma 1.5). Pixels that have no \
color after undistortion do not count. In JSON, a value is null if no pixel or no window counts. The PSNR of equal \
images is infinite, and null too.";

/// Compare a scene with photographs: PSNR and SSIM of each view
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The data set: a folder or a transforms.json [default: what the run was trained on]
    data: Option<PathBuf>,
    /// Which frames to compare
    #[arg(long, value_enum, default_value_t)]
    split: Split,
    /// Hold out every Nth frame, starting with the first [default: as in the run, or 8]
    #[arg(long, value_name = "N")]
    #[arg(value_parser = clap::value_parser!(u32).range(2..))]
    hold_out_every: Option<u32>,
    /// Shrink photographs by this factor [default: as in the run, or 1]
    #[arg(long, value_name = "N")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1024))]
    downscale: Option<u32>,
    /// Background of photographs with an alpha channel, three values from 0 to 1 [default: the scene's
    /// background]
    #[arg(long, value_name = "R,G,B")]
    background: Option<Color>,
    /// Read what the data set names outside its own folder, by a path or a link
    #[arg(long)]
    allow_outside: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    scene_args: SceneArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
enum Split {
    /// The frames that training does not see
    #[default]
    HeldOut,
    /// The frames that training sees
    Train,
    /// All frames
    All,
}

/// Red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Color([f32; 3]);

impl FromStr for Color {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let values: Option<Vec<f32>> =
            text.split(',').map(|part| part.trim().parse().ok()).collect();
        values
            .and_then(|values| values.try_into().ok())
            .filter(|color: &[f32; 3]| color.iter().all(|value| (0.0..=1.0).contains(value)))
            .map(Self)
            .ok_or_else(|| "expected three numbers from 0 to 1, such as 1,1,1".to_owned())
    }
}

pub fn run(args: &Args) -> Result<()> {
    let console = args.device.console();
    let scene = scene_file(&args.scene)?;
    let data = data(args)?;
    let scene = console.during("reading the scene", || Scene::load(&scene))?;
    let renderer = args.device.open()?;
    let dataset = load(args, &data, &renderer, &scene, console)?;
    let frames = frames(args, &dataset)?;
    let scene = args.scene_args.upload(&renderer, &scene)?;
    let evaluation = measure(&renderer, &scene, &frames, console)?;
    if args.json { print_json(&evaluation) } else { print(&table(&evaluation)) }
}

/// The photographs: what is asked for, and what a run's folder says about the rest.
fn data(args: &Args) -> Result<DataConfig> {
    let is_run = args.scene.join(CONFIG).exists();
    let mut data =
        if is_run { train::settings_of(&args.scene)?.data } else { DataConfig::default() };
    data.allow_outside |= args.allow_outside;
    if args.data.is_none() && !is_run {
        let reason = "a scene file does not say what it was trained on, only a training run's folder does; name the \
                      data set: `organza eval SCENE DATA`";
        return Err(Error::Invalid { origin: args.scene.clone(), reason: reason.to_owned() });
    }
    data.path = args.data.clone().or(data.path);
    data.downscale = args.downscale.unwrap_or(data.downscale);
    data.hold_out_every = args.hold_out_every.map_or(data.hold_out_every, |every| every as usize);
    if args.split == Split::All {
        // where all are measured, it does not matter to whom a frame belongs
        data.hold_out_every = 0;
    }
    Ok(data)
}

/// The scene's file: the one that was named, or that of a run's folder.
fn scene_file(path: &Path) -> Result<PathBuf> {
    if !path.is_dir() {
        return Ok(path.to_owned());
    }
    let file = path.join(CHECKPOINT);
    if file.exists() {
        return Ok(file);
    }
    let reason = format!(
        "the folder has no {CHECKPOINT}, so it is not a training run's; name a scene file, or the \
         folder that training wrote to"
    );
    Err(Error::Invalid { origin: path.to_owned(), reason })
}

fn load(
    args: &Args,
    data: &DataConfig,
    renderer: &Renderer,
    scene: &Scene,
    console: Console,
) -> Result<Dataset> {
    let Some(path) = &data.path else {
        let (views, side, every) = (data.built_in_views, data.built_in_side, data.hold_out_every);
        let task = || train::built_in::dataset(renderer, views, side, every, &|_, _| {});
        return console.during("rendering the built-in scene", task);
    };
    let background = args.background.map_or_else(
        || scene.config.background.map(|value| value.clamp(0.0, 1.0) as f32),
        |Color(color)| color,
    );
    let (downscale, hold_out_every) = (data.downscale, data.hold_out_every);
    let (alpha, allow_outside) = (data.alpha, data.allow_outside);
    let options = DatasetOptions { downscale, hold_out_every, background, alpha, allow_outside };
    let dataset =
        console.during("reading the photographs", || Dataset::load(path, &options, &|_, _| {}))?;
    warn_of_files(console, &dataset);
    Ok(dataset)
}

fn frames<'a>(args: &Args, dataset: &'a Dataset) -> Result<Vec<&'a Frame>> {
    let chosen = |indices: &[usize]| indices.iter().map(|&index| &dataset.frames[index]).collect();
    let frames: Vec<_> = match args.split {
        Split::HeldOut => chosen(&dataset.held_out),
        Split::Train => chosen(&dataset.train),
        Split::All => dataset.frames.iter().collect(),
    };
    if frames.is_empty() {
        let reason = "no frame of the data set is held out; use others with `--split train` or `--split all`, \
                      or hold some out with `--hold-out-every`";
        let origin = args.data.as_ref().unwrap_or(&args.scene).clone();
        return Err(Error::Invalid { origin, reason: reason.to_owned() });
    }
    Ok(frames)
}

fn measure(
    renderer: &Renderer,
    scene: &DeviceScene,
    frames: &[&Frame],
    console: Console,
) -> Result<Evaluation> {
    let start = Instant::now();
    let evaluation = {
        let progress = console.progress(tiles(frames), "tiles");
        progress.say(&frames[0].name);
        evaluate(renderer, scene, frames, &mut |event| match event {
            Event::Tiles(tiles) => progress.advance(tiles),
            Event::View { index, .. } => {
                progress.say(frames.get(index + 1).map_or("", |next| &next.name));
            }
        })?
    };
    let seconds = start.elapsed().as_secs_f64();
    console.note(&format!("measured {} in {seconds:.1} s", count(frames.len() as u64, "view")));
    warn_not_finite(console, evaluation.not_finite);
    Ok(evaluation)
}

/// A row for each view, and their mean.
fn table(evaluation: &Evaluation) -> String {
    let mut table = Table::new(1, ["view", "PSNR", "SSIM"]);
    let cell = |value: Option<f64>, digits| match value {
        Some(value) => format!("{value:.digits$}"),
        None => "-".to_owned(),
    };
    let mut row = |name: &str, score: &Score| {
        table.row([name.to_owned(), cell(score.psnr, 2), cell(score.ssim, 4)]);
    };
    for view in &evaluation.views {
        row(&view.name, &view.score);
    }
    row("mean", &evaluation.mean);
    table.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_are_three_numbers() {
        assert_eq!("1, 0.5,0".parse(), Ok(Color([1.0, 0.5, 0.0])));
        for bad in ["", "1,1", "1,1,1,1", "1,1,2", "-0.1,0,0", "a,b,c", "NaN,0,0"] {
            assert!(bad.parse::<Color>().is_err(), "{bad}");
        }
    }
}
