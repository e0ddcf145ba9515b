//! `organza film`: a moving camera.

mod encode;
mod film_path;

use std::path::PathBuf;

use organza::{Image, Result};
use serde::Serialize;

use super::console::{Console, print_json};
use super::device::SceneArgs;
use super::inputs::{DataArgs, Shown};
use super::output::{self, Folder, refuse_others};
use super::picture::{Pictures, warn_not_finite};
use super::signals::Signals;
use super::summary::{Cost, Summary, count};
use super::{refuse, text_of};
use encode::FilmKind;
use film_path::{PathArgs, described};

/// Make a film: where a run's cameras stood, around a scene, or along a path through cameras
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("../help/film.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// More scenes at their places, each as SCENE@PLACE.json; and cameras to move through: nerfstudio's transforms.json,
    /// or a data set [default: an arc or a ring where a run's cameras stood; without a run, a turn around the scene]
    cameras: Vec<PathBuf>,
    /// The film: a name that ends in .mp4 or .png, or a folder for its frames
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Number of frames
    #[arg(long, value_name = "N", default_value_t = 180)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=99_999))]
    frames: u32,
    /// Frames a second
    #[arg(long, value_name = "F", default_value_t = 30)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=240))]
    fps: u32,
    /// Write frames to a folder with other files, which stay, and replace frames in it
    #[arg(long)]
    overwrite: bool,
    /// Print JSON: the film, and the cost of rendering (docs/json.md)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    path: PathArgs,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let shown = Shown::find_images(&args.scene, &args.cameras)?;
    let source = &shown.source;
    let kind = FilmKind::from_path(&args.output)?;
    let scenes = shown.load(console)?;
    let count_of = args.frames as usize;
    let is_mp4 = kind == FilmKind::Mp4;
    let of = (&shown, &scenes[0]);
    let (cameras, named) = args.path.frames(of, &args.data, count_of, is_mp4, console)?;
    let cameras = &cameras[..];
    let size @ [width, height] = [cameras[0].width, cameras[0].height];
    kind.check(size)?;
    Image::check_memory(width, height)?;
    // before this, a signal has ended the program, and nothing was changed
    let signals = Signals::listen()?;
    signals.keeps_results();
    if kind != FilmKind::Frames {
        let origin = named.iter().map(|named| named.origin.as_path());
        output::check_file(&args.output, origin.chain([source.named(), source.file()]))?;
        if named.as_ref().is_some_and(|named| named.is_photograph(&args.output)) {
            let path = args.output.display();
            return refuse(format!("{path} would replace a photograph; choose another name"));
        }
    }

    let folder = match kind {
        FilmKind::Frames => Some(frames_folder(args)?),
        FilmKind::Mp4 | FilmKind::Png => None,
    };
    let renderer = &args.scene_args.device.open(console)?;
    let scene = &shown.upload(&scenes, args.scene_args.options(), renderer)?;
    let pictures = Pictures { renderer, scene, cameras, stop: Some(signals.stop()) };
    let mut summary = Summary::start();
    let mut not_finite = 0;
    {
        let progress = console.progress("rendering", cameras.len(), "frames");
        // the bar counts frames, not tiles
        let silent = console.hidden();
        let frames = (0..cameras.len()).map(|frame| {
            let (image, _) = pictures.render_channels(frame, &[], &mut summary, &silent)?;
            not_finite += image.not_finite();
            progress.advance(1);
            Ok::<Image, _>(image)
        });
        match &folder {
            Some(folder) => encode::write_folder(folder, frames)?,
            None if is_mp4 => encode::write_mp4(&args.output, args.fps, frames)?,
            None => encode::write_animated_png(&args.output, size, args.fps, frames)?,
        }
    }
    summary.say(&count(cameras.len() as u64, "frame"), console);
    warn_not_finite(console, not_finite);
    let described = described(cameras, args.fps);
    console.note(&format!("wrote {}: {described}", args.output.display()));
    if args.json {
        return print_json(&Made {
            film: text_of(&args.output),
            frames: cameras.len(),
            fps: args.fps,
            width,
            height,
            cost: summary.cost(renderer, not_finite),
        });
    }
    Ok(())
}

/// The folder of a film's frames, which no other call writes to.
fn frames_folder(args: &Args) -> Result<Folder> {
    let mut folder = Folder::make(&args.output)?;
    folder.lock()?;
    if !args.overwrite {
        refuse_others(&folder, |_| false)?;
    }
    Ok(folder)
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Made {
    film: String,
    frames: usize,
    fps: u32,
    width: u32,
    height: u32,
    #[serde(flatten)]
    cost: Cost,
}
