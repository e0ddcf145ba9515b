//! `organza eval`: compares a scene with photographs.

use std::path::PathBuf;
use std::time::Instant;

use organza::data::{Background, Dataset, Frame};
use organza::evaluate::{Event, Score, evaluate_with};
use organza::train::config::LearnExposure;
use organza::{DeviceScene, Evaluation, Renderer, Result};

use super::console::{Console, print, print_json};
use super::device::SceneArgs;
use super::inputs::{DataArgs, DataSet, Shown, Split};
use super::picture::warn_not_finite;
use super::summary::{Table, count, score};

/// Compare a scene with photographs: PSNR and SSIM of each view
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/eval.txt"))]
#[command(mut_arg("split", |split| split.help("The frames of the data set to use [default: held-out]")))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The data set: a folder or a transforms.json [default: the run's]
    data: Option<PathBuf>,
    /// Background of photographs with an alpha channel: a name such as white, or red, green and blue
    /// from 0 to 1 such as 1,1,1 [default: the scene's background]
    #[arg(long, value_name = "COLOR")]
    background: Option<Background>,
    /// Also measure PSNR with a gain and an offset for each channel: each half of an image, left and right, is measured
    /// with the fit of the other half. A run that learned exposures always has it
    #[arg(long)]
    fit_colors: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data_args: DataArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let evaluation = args.evaluate(console)?;
    if args.json { print_json(&evaluation) } else { print(&table(&evaluation)) }
}

impl Args {
    /// Reads the scene and the photographs, and compares them.
    fn evaluate(&self, console: Console) -> Result<Evaluation> {
        let mut shown = Shown::find_images(&self.scene, &[])?;
        if self.data.is_none() {
            shown.refine()?;
        }
        let source = &shown.source;
        let split = self.data_args.split(Split::HeldOut);
        let scenes = shown.load(console)?;
        let named = self.data.as_deref();
        let mut data = DataSet::of(source, named, &self.data_args, self.background, console)?;
        data.say_doubt(split, console);
        let data = data.only(split);
        let renderer = self.scene_args.device.open(console)?;
        let dataset = data.read(&renderer, console)?;
        let frames = frames(self, &dataset, split)?;
        let scene = shown.upload(&scenes, self.scene_args.options(), &renderer)?;
        let run = source.settings()?;
        let has_exposures = run.is_some_and(|run| run.exposure.learn == LearnExposure::On);
        measure(&renderer, &scene, &frames, self.fit_colors || has_exposures, console)
    }
}

fn frames<'a>(args: &Args, dataset: &'a Dataset, split: Split) -> Result<Vec<&'a Frame>> {
    let frames: Vec<_> = match split {
        Split::Train => dataset.train_frames().collect(),
        Split::HeldOut => dataset.held_out_frames().collect(),
        Split::All => dataset.frames.iter().collect(),
    };
    if frames.is_empty() {
        return split.nothing(args.data.as_ref().unwrap_or(&args.scene));
    }
    Ok(frames)
}

/// Compares a scene with photographs, one after the other. `fitted` also measures the PSNR of fitted colors.
pub fn measure(
    renderer: &Renderer,
    scene: &DeviceScene,
    frames: &[&Frame],
    fitted: bool,
    console: Console,
) -> Result<Evaluation> {
    let start = Instant::now();
    let evaluation = {
        let progress = console.progress("measuring", 0, "tiles");
        let say = |name: &str| progress.say(&format!("measuring {name}"));
        say(&frames[0].name);
        evaluate_with(renderer, scene, frames, fitted, &mut |event| match event {
            Event::Tiles { done, total } => progress.set_of(done, total),
            Event::View { index, .. } => {
                frames.get(index + 1).into_iter().for_each(|next| say(&next.name));
            }
            _ => {}
        })?
    };
    let seconds = start.elapsed().as_secs_f64();
    console.note(&format!("measured {} in {seconds:.1} s", count(frames.len() as u64, "view")));
    warn_not_finite(console, evaluation.not_finite);
    Ok(evaluation)
}

/// A row for each view, and their mean.
fn table(evaluation: &Evaluation) -> String {
    let fitted = evaluation.mean.psnr_fitted;
    let is_shown = [true, true, true, fitted.is_some()];
    let titles = ["view", "PSNR", "SSIM", "PSNR, fitted"];
    let titles =
        titles.into_iter().zip(is_shown).filter_map(|(title, is_shown)| is_shown.then_some(title));
    let mut table = Table::new(1, titles);
    let mut row = |name: &str, view: &Score| {
        let [psnr, fitted] = [view.psnr, view.psnr_fitted].map(|value| score(value, 2));
        let ssim = score(view.ssim, 4);
        let cells = [name.to_owned(), psnr, ssim, fitted].into_iter().zip(is_shown);
        table.row(cells.filter_map(|(cell, is_shown)| is_shown.then_some(cell)));
    };
    for view in &evaluation.views {
        row(&view.name, &view.score);
    }
    row("mean", &evaluation.mean);
    table.to_string()
}
