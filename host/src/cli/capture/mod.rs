//! `organza capture`: from a video or photographs to a data set, with ffmpeg and COLMAP.

mod colmap;
mod frames;
mod judge;
mod programs;
mod source;

use std::borrow::Borrow;
use std::fs;
use std::path::{Path, PathBuf};

use organza::data::LLFF;
use organza::{Error, Result};
use organza_core::write_inside;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::console::Console;
use super::inputs::FileKind;
use super::output::{Folder, make_empty, refuse_run};
use super::signals::Signals;
use super::{quoted, refuse};
use colmap::Colmap;
use judge::Judgment;
use programs::Programs;
use source::Source;

const FRAMES: u32 = 150;
const SIDE: u32 = 1920;

/// Make a data set from a video or from photographs: sharp frames by ffmpeg, poses by COLMAP
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("../help/capture.txt"))]
pub struct Args {
    /// A video, a folder of photographs, or photographs: JPEG or PNG
    #[arg(required = true, value_name = "VIDEO|PHOTOS")]
    inputs: Vec<PathBuf>,
    /// The folder of the data set
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Number of frames to take from a video
    #[arg(long, value_name = "N", default_value_t = FRAMES)]
    #[arg(value_parser = clap::value_parser!(u32).range(3..=2000))]
    frames: u32,
    /// The longest side of an image, in pixels: larger ones become smaller
    #[arg(long, value_name = "S", default_value_t = SIDE)]
    #[arg(value_parser = clap::value_parser!(u32).range(64..=16_384))]
    side: u32,
    /// The images that each image is compared with. By default, few images are compared with all others, and many with
    /// their neighbors. If poses are then missing, up to 200 are compared with all others after all
    #[arg(long)]
    matcher: Option<Matcher>,
    /// COLMAP's model of the lens. By default, SIMPLE_RADIAL for up to 50 images or images of several sizes, else OPENCV
    #[arg(long, value_name = "MODEL")]
    #[arg(value_parser = ["SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV"])]
    camera_model: Option<String>,
}

/// Up to this many images, all pairs are compared in an hour or so: photographs, which may be in any order, and frames
/// whose poses are missing after a comparison with neighbors.
const SOME: usize = 200;

/// The images that an image is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Matcher {
    /// Its neighbors, in the order of the video or of names
    Sequential,
    /// All others: this takes longer, and helps where the camera came back to a place
    Exhaustive,
}

/// The file that says that a data set is whole.
const DONE: &str = "capture.json";
/// Folder of unfinished steps.
const WORK: &str = ".organza-capture";
/// File in it that says what its steps are made from.
const KEY: &str = "key";

/// The source of a data set.
#[derive(Debug, Serialize, Deserialize)]
struct Done {
    /// SHA-256 of the inputs' content and of the options.
    key: String,
    /// What COLMAP found.
    #[serde(flatten)]
    judgment: Judgment,
}

/// Where a step finds its inputs, and puts its result.
struct CaptureJob<'a> {
    args: &'a Args,
    work: PathBuf,
    programs: Programs<'a>,
    console: Console,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let judgment = capture(args, Signals::listen, console)?;
    let output = named(&args.output);
    let beside = |ending: &str| quoted(format!("{output}{ending}").as_ref());
    console.note(&match judgment.is_trainable() {
        true => format!("next: organza train {} -o {}", beside(""), beside("-run")),
        false => format!(
            "these poses are not worth training\n\
             next: mend the capture as the warnings say, with organza capture IMAGES -o {}",
            beside("-2")
        ),
    });
    Ok(())
}

/// Whether a path has a video, or photographs that are no data set: what is captured before it can be trained.
pub fn is_source(path: &Path) -> bool {
    match path.is_dir() {
        true => {
            let is_known = FileKind::from_path(path).is_some() || path.join(LLFF).exists();
            !is_known && source::has_photographs(path)
        }
        false => organza::data::is_video(path),
    }
}

/// Makes a data set that a run then trains on. Poses that are not worth it are an error.
pub fn for_training(
    input: &Path,
    output: &Path,
    signals: &Signals,
    console: Console,
) -> Result<()> {
    let args = Args {
        inputs: vec![input.to_owned()],
        output: output.to_owned(),
        frames: FRAMES,
        side: SIDE,
        matcher: None,
        camera_model: None,
    };
    let judgment = capture(&args, || Ok(signals), console)?;
    if judgment.is_trainable() {
        return Ok(());
    }
    refuse(format!(
        "these poses are not worth training: mend the capture as the warnings say, and train it to another folder. \
         `organza train {} -o NEW` trains all the same",
        quoted(output)
    ))
}

/// Makes the data set, unless it is there, and says what was found. `signals` are needed only to make it.
fn capture<S: Borrow<Signals>>(
    args: &Args,
    signals: impl FnOnce() -> Result<S>,
    console: Console,
) -> Result<Judgment> {
    let mut source = Source::find(&args.inputs, console)?;
    source.number(args.matcher, console);
    refuse_run(&args.output)?;
    let is_video = matches!(source, Source::Video(_));
    let mut needed = vec![programs::COLMAP];
    if is_video {
        needed.insert(0, programs::FFMPEG);
    }
    let versions = programs::find(&needed)?;
    let mut folder = Folder::make(&args.output)?;
    folder.lock()?;
    let key = key(&source, args)?;
    let output = named(&args.output);
    if let Some(Done { judgment, .. }) = done(&folder, &key)? {
        console.note(&format!("{output} is there from an earlier call"));
        judgment.print(&output, console);
        return Ok(judgment);
    }
    let work = begin(&folder, &key)?;
    console.note(&format!("with {versions}"));
    if let Some(copies) = source.copies() {
        console.warn(&copies);
    }
    let signals = signals()?;
    let signals = signals.borrow();
    signals.keeps_results();
    let programs = Programs::new(&work, signals.stop(), console);
    let job = CaptureJob { args, work, programs, console };
    let images = job.images(&source).inspect_err(|_| {
        // Without images there is nothing to keep. A file that stays does no harm.
        let _ = fs::remove_dir_all(&job.work);
    })?;
    let judgment = Colmap::new(&job, is_video, &images)?.run(&images)?;
    let done = Done { key, judgment };
    job.publish(&folder, &done)?;
    done.judgment.print(&output, console);
    Ok(done.judgment)
}

/// A folder as messages name it, without a slash at the end.
fn named(folder: &Path) -> String {
    folder.components().as_path().display().to_string()
}

/// Identifies inputs and options.
fn key(source: &Source<'_>, args: &Args) -> Result<String> {
    let Args { frames, side, matcher, camera_model, .. } = args;
    let options = format!("{frames} {side} {matcher:?} {camera_model:?}");
    Ok(format!("{:x}", Sha256::digest(source.content()? + &options)))
}

/// The data set in a folder, if it is whole and made from the same inputs. Another one is an error.
fn done(folder: &Folder, key: &str) -> Result<Option<Done>> {
    let found = fs::read(folder.file(DONE)?).ok();
    match found.and_then(|text| serde_json::from_slice::<Done>(&text).ok()) {
        Some(done) if done.key == key => Ok(Some(done)),
        Some(_) => refuse(format!(
            "{} holds a data set of other inputs or options; choose another folder",
            folder.path().display()
        )),
        None => Ok(None),
    }
}

/// The folder of unfinished steps. Steps of other inputs are an error: they may have taken hours.
fn begin(folder: &Folder, key: &str) -> Result<PathBuf> {
    let work = folder.join(WORK);
    if fs::symlink_metadata(&work).is_ok_and(|found| !found.is_dir()) {
        return refuse(format!("{} is not a folder; remove it", work.display()));
    }
    match fs::read_to_string(work.join(KEY)) {
        Ok(found) if found == key => return Ok(work),
        Ok(_) => {
            return refuse(format!(
                "{} holds an unfinished capture of other images or options. Continue it with the command that began it, choose \
                 another folder, or remove {}",
                folder.path().display(),
                work.display()
            ));
        }
        Err(_) => {}
    }
    for name in ["images", "sparse"] {
        if folder.join(name).exists() {
            return refuse(format!(
                "{} has a folder `{name}` already; choose another folder",
                folder.path().display()
            ));
        }
    }
    make_empty(&work)?;
    write_inside(work.join(KEY), |writer| writer.write_all(key.as_bytes()))?;
    Ok(work)
}

impl CaptureJob<'_> {
    /// A folder of the work.
    fn path(&self, name: &str) -> PathBuf {
        self.work.join(name)
    }

    /// Runs a step that fills a folder, unless it is done. So a folder under its own name is always whole.
    fn step(&self, name: &str, fill: impl FnOnce(&Path) -> Result<()>) -> Result<()> {
        let path = self.path(name);
        if path.exists() {
            return Ok(());
        }
        let unfinished = self.path(&format!("{name}.part"));
        make_empty(&unfinished)?;
        fill(&unfinished)?;
        fs::rename(&unfinished, &path).map_err(|source| Error::write(&path, source))
    }

    /// Moves the undistorted images and their cameras to their places, and removes the unfinished steps.
    fn publish(&self, folder: &Folder, done: &Done) -> Result<()> {
        let undistorted = self.path(colmap::UNDISTORTED);
        let sparse = folder.join("sparse");
        fs::create_dir_all(&sparse).map_err(|source| Error::write(&sparse, source))?;
        for (from, to) in [("images", folder.join("images")), ("sparse", sparse.join("0"))] {
            let from = undistorted.join(from);
            if from.exists() {
                fs::rename(&from, &to).map_err(|source| Error::write(&to, source))?;
            }
        }
        write_inside(folder.file(DONE)?, |writer| {
            serde_json::to_writer_pretty(&mut *writer, done)?;
            writer.write_all(b"\n")
        })?;
        // A file that stays does no harm.
        let _ = fs::remove_dir_all(&self.work);
        Ok(())
    }
}
