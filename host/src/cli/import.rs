//! `organza import`: makes a scene from another program's Gaussians.

use std::path::{Path, PathBuf};

use organza::Result;
use organza::data::{Background, DatasetOptions, Poses};
use organza::splats::{self, Fit, Import, PHOTOGRAPHS, SplatFile, Views};

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, SceneSource};
use super::output::check_scene_file;
use super::summary::count;

/// Make a scene from a file of 3D Gaussian Splatting: .ply, .spz, .sog, .glb or .splat
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/import.txt"))]
pub struct Args {
    /// The Gaussians: a .ply, .spz, .sog, .glb or .splat file
    file: PathBuf,
    /// The views to train on: nerfstudio's transforms.json, or a data set. A few photographs show whether the Gaussians
    /// fit [default: views from all around the Gaussians]
    cameras: Option<PathBuf>,
    /// The scene's file, safetensors
    #[arg(short, long, value_name = "SCENE")]
    output: PathBuf,
    /// Steps of training
    #[arg(long, value_name = "N", default_value_t = Import::default().steps)]
    #[arg(value_parser = clap::value_parser!(u32).range(Import::STEPS))]
    steps: u32,
    /// The longest side of an image to train on, in pixels
    #[arg(long, value_name = "S", default_value_t = Import::default().side)]
    #[arg(value_parser = clap::value_parser!(u32).range(Fit::SIDES))]
    side: u32,
    /// Color behind the scene: a name such as white, or red, green and blue from 0 to 1 such as 1,1,1 [default: black]
    #[arg(long, value_name = "COLOR")]
    background: Option<Background>,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let source = SceneSource::foreign(&args.file);
    check_scene_file(&args.output, [source.named()].into_iter().chain(args.cameras.as_deref()))?;
    let mut file = console.during("reading the Gaussians", || splats::load(source.file()))?;
    let name = args.file.display();
    console.note(&format!("{} in {name}", count(file.splats.len() as u64, "Gaussian")));
    let named = args.cameras.as_deref();
    let background = args.background.unwrap_or(Background::Auto).color();
    let views = if named.is_some() || args.data.is_given() {
        let cameras = Cameras::load(&source, named, &args.data, console)?;
        let settings = args.data.settings(&source, named)?;
        let background = Background::Color(background);
        let options = DatasetOptions { background, ..settings.options() };
        file = fitted(file, &cameras.origin, &options)?;
        Views::from_cameras(cameras.list)
    } else {
        file.views()?
    };
    // before the minutes of training
    let notes = std::mem::take(&mut file.notes);
    notes.iter().for_each(|note| console.warn(&format!("{name}: {note}")));
    let renderer = args.device.open(console)?;
    let options = Import { steps: args.steps, side: args.side, background };
    let imported = {
        let progress = console.progress("training", args.steps as usize, "steps");
        let mut progress = |step| {
            progress.set(step);
            Ok(())
        };
        splats::import(&renderer, file, &views, options, &mut progress)?
    };
    imported.scene.save(&args.output)?;
    imported.notes.iter().for_each(|note| console.warn(note));
    if let Some(psnr) = imported.psnr {
        console.note(&format!(
            "in {} that training has not seen, the scene is {psnr:.2} dB from the file's own images",
            count(views.held_out.len() as u64, "view")
        ));
    }
    console.note(&format!("wrote {}", args.output.display()));
    Ok(())
}

/// The file in the axes in which photographs show its Gaussians, if there are any: cameras may have none.
fn fitted(file: SplatFile, cameras: &Path, options: &DatasetOptions) -> Result<SplatFile> {
    let Ok(poses) = Poses::load(cameras, options) else { return Ok(file) };
    let all = poses.cameras()?.len();
    let some = (0..all).step_by(all.div_ceil(PHOTOGRAPHS).max(1));
    let frames: Vec<_> = some.filter_map(|index| poses.photograph(index).ok().flatten()).collect();
    let frames: Vec<_> = frames.iter().collect();
    Ok(file.fitted(&frames, &poses.dataset.placement))
}
