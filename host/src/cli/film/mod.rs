//! `organza film`: a moving camera.

mod film_path;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use organza::film::{FilmKind, Frames};
use organza::{Camera, DeviceScene, Image, Renderer, Result};
use serde::Serialize;

use super::console::{Console, Progress, print_json};
use super::device::{DeviceArgs, SceneArgs};
use super::inputs::{DataArgs, Shown};
use super::output::{self, Folder, continue_film, remove_frames};
use super::picture::{Pictures, warn_not_finite};
use super::signals::Signals;
use super::summary::{Cost, Summary, count};
use super::{refuse, text_of};
use film_path::{Inputs, PathArgs, described};

const EXAMPLES: &str = "\
Examples:
  organza film run -o film.mp4                                      on an arc or a ring, where the run's cameras stood
  organza film run -o film.mp4 --between --views 0,10,20,30 --loop  through cameras of its data set
  organza film scene.safetensors keys.json -o film.mp4              through keyframes of your own
  organza film run -o small.mp4 --size 1280x720
  organza film run -o frames --frames 600                           a folder of PNG images
  organza film scene.safetensors -o film.png --orbit --distance 4 --elevation 20

An MP4 is encoded by ffmpeg, which must be installed. An animated PNG (.png) needs nothing, loses nothing, plays in \
every browser, and is larger.

Between cameras, position, rotation and field of view change smoothly, at an even pace. A film of another shape than the \
images still shows all that a camera sees.

Ctrl-C stops. Finished frames are kept in FILE.frames, or in the folder, and the same command continues from there, even \
if the program was killed. A folder with other files, or with frames of another film, is refused without `--overwrite`. A \
file that is already there under the film's name is replaced when the film is complete, not \
before. A film's frames are the images that `organza render` writes of the same cameras.";

/// Make a film: where a run's cameras stood, around a scene, or along a path through cameras
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run; or a TOML file that lists several
    scene: PathBuf,
    /// More scenes at their places, each as SCENE@PLACE.json; and cameras to move through, or whose scene to turn around:
    /// nerfstudio's transforms.json, or a data set
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
    /// Replace the frames of another film, and write to a folder with other files, which stay
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
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let shown = Shown::find(&args.scene, &args.cameras)?;
    let source = &shown.source;
    let kind = FilmKind::from_path(&args.output)?;
    let scenes = shown.load(console)?;
    let inputs =
        Inputs { source, scene: &scenes[0], named: shown.cameras.as_deref(), data: &args.data };
    let path = args.path.frames(&inputs, args.frames as usize, kind == FilmKind::Mp4, console)?;
    let size @ [width, height] = [path.frames[0].width, path.frames[0].height];
    kind.check(size)?;
    Image::check_memory(width, height)?;
    if kind != FilmKind::Frames {
        let origin = path.cameras.iter().map(|cameras| cameras.origin.as_path());
        let inputs: Vec<_> = origin.chain([source.named(), source.file()]).collect();
        output::check_file(&args.output, &inputs)?;
        if path.cameras.as_ref().is_some_and(|cameras| cameras.is_photograph(&args.output)) {
            let path = args.output.display();
            return refuse(format!("{path} would replace a photograph; choose another name"));
        }
    }

    let renderer = args.device.open(console)?;
    let scene = shown.upload(&scenes, &args.scene_args, &renderer)?;
    let film = Film { renderer: &renderer, scene: &scene, cameras: &path.frames };
    let made = film.make(args, kind, &shown, console)?;
    if args.json { print_json(&made) } else { Ok(()) }
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Made {
    film: String,
    frames: usize,
    fps: u32,
    width: u32,
    height: u32,
    /// Number of frames that this call rendered. Earlier calls rendered the others.
    rendered: usize,
    #[serde(flatten)]
    cost: Cost,
}

/// A film to be rendered.
struct Film<'a> {
    renderer: &'a Renderer,
    scene: &'a DeviceScene,
    cameras: &'a [Camera],
}

impl Film<'_> {
    fn make(&self, args: &Args, kind: FilmKind, shown: &Shown, console: Console) -> Result<Made> {
        let folder = match kind {
            FilmKind::Frames => args.output.clone(),
            FilmKind::Mp4 | FilmKind::Png => args.output.with_added_extension("frames"),
        };
        let mut folder = Folder::make(&folder)?;
        folder.lock()?;
        let how = (self.cameras, args.scene_args.options(), shown.others()?);
        continue_film(&folder, shown.source.file(), &how, args.overwrite)?;
        let file = |frame: usize| folder.file(&format!("{frame:05}.png"));
        let files = (0..self.cameras.len()).map(file).collect::<Result<Vec<_>>>()?;
        let todo: Vec<_> = (0..files.len()).filter(|&frame| !files[frame].exists()).collect();
        // before this, a signal has ended the program, and nothing was changed
        let signals = Signals::listen()?;
        signals.keeps_results();
        let cost = self.render(&files, &todo, &signals, console)?;
        let Some(cost) = cost else { return stopped(&files, &folder) };
        if kind != FilmKind::Frames {
            let progress = console.progress("encoding", files.len(), "frames");
            let kept = format!("the frames are kept in {}", folder.path().display());
            let frames = Frames {
                files: &files,
                fps: args.fps,
                scratch: folder.path(),
                progress: &|| progress.advance(1),
            };
            if let Err(error) = kind.write(&frames, &args.output) {
                drop(progress);
                console.note(&kept);
                return Err(error);
            }
            remove_frames(&mut folder, &files)?;
        }
        let described = described(self.cameras, args.fps);
        console.note(&format!("wrote {}: {described}", args.output.display()));
        let [Camera { width, height, .. }, ..] = *self.cameras else { unreachable!("a frame") };
        let frames = files.len();
        let rendered = todo.len();
        let film = text_of(&args.output);
        Ok(Made { film, frames, fps: args.fps, width, height, rendered, cost })
    }

    /// Renders frames. Returns `None` if a signal asks to stop.
    fn render(
        &self,
        files: &[PathBuf],
        todo: &[usize],
        signals: &Signals,
        console: Console,
    ) -> Result<Option<Cost>> {
        if todo.len() < files.len() {
            let there = files.len() - todo.len();
            let all = files.len();
            console.note(&format!("{there} of {all} frames are there from an earlier call"));
        }
        let mut summary = Summary::start();
        let mut not_finite = 0;
        {
            let progress = console.progress("rendering", todo.len(), "frames");
            // the bar counts frames, not tiles
            let silent = console.hidden();
            for &frame in todo {
                if signals.stop().load(Ordering::Relaxed) {
                    return Ok(None);
                }
                let stop = signals.stop();
                let saved =
                    self.frame(frame, Some(stop), &mut summary, &silent).and_then(|image| {
                        image.save_png_unless(&files[frame], stop)?;
                        Ok(image.not_finite())
                    });
                not_finite += match saved {
                    Err(_) if stop.load(Ordering::Relaxed) => return Ok(None),
                    saved => saved?,
                };
                progress.advance(1);
            }
        }
        if !todo.is_empty() {
            summary.say(&count(todo.len() as u64, "frame"), console);
        }
        warn_not_finite(console, not_finite);
        Ok(Some(summary.cost(self.renderer, not_finite)))
    }

    fn frame(
        &self,
        frame: usize,
        stop: Option<&AtomicBool>,
        summary: &mut Summary,
        progress: &Progress,
    ) -> Result<Image> {
        let Self { renderer, scene, cameras } = *self;
        let pictures = Pictures { renderer, scene, cameras, stop };
        pictures.render_channels(frame, &[], summary, progress).map(|(image, _)| image)
    }
}

/// The error after a signal.
fn stopped<T>(files: &[PathBuf], folder: &Folder) -> Result<T> {
    let there = files.iter().filter(|file| file.exists()).count() as u64;
    let all = files.len();
    let folder = folder.path().display();
    refuse(format!(
        "stopped after {} of {all}, which are kept in {folder}; the same command continues",
        count(there, "frame")
    ))
}
