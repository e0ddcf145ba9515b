//! `organza export`: writes a scene as a file for 3D Gaussian Splatting viewers.

use std::path::PathBuf;

use organza::data::{Dataset, Pose};
use organza::error::format_bytes;
use organza::splats::{self, Distilled, Fit, Format, Splat, SplatComparison, Views};
use organza::train::FIT;
use organza::{DeviceScene, Renderer, Result, Scene, UploadOptions};

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, DataSet, SceneSource, Shown, Split};
use super::output::{check_file, made_of, relative_to};
use super::summary::count;
use super::{quoted, refuse};

/// Loss of PSNR by rounding that is worth a warning, in dB.
const NOTICED: f64 = 0.1;

/// Write a file for 3D Gaussian Splatting viewers such as SuperSplat: .ply, .spz, .sog, .glb or .splat
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/export.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The views to compare: nerfstudio's transforms.json, or a data set [default: the run's, or views from
    /// all around the scene]
    cameras: Option<PathBuf>,
    /// The file. Its extension chooses the format: .ply and .glb have all values; .spz and .sog round them; .splat has
    /// one color for all directions
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Steps in which a view is compared and the Gaussians are corrected; 0 only takes what the scene says of each Gaussian, in
    /// seconds, and can lose 10 decibels. A run's folder keeps the result, so that a second export takes only what its format needs
    #[arg(long, value_name = "N", default_value_t = Fit::default().steps)]
    #[arg(value_parser = clap::value_parser!(u32).range(Fit::STEPS))]
    steps: u32,
    /// Longest side of a compared view, in pixels
    #[arg(long, value_name = "S", default_value_t = Fit::default().side)]
    #[arg(value_parser = clap::value_parser!(u32).range(Fit::SIDES))]
    side: u32,
    /// Version of an .spz file; 2 is for viewers that do not open version 4, and rounds rotations more [default: 4]
    #[arg(long, value_name = "V", value_parser = ["2", "4"])]
    spz_version: Option<String>,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let format = match (Format::from_path(&args.output)?, args.spz_version.as_deref()) {
        (Format::Spz, Some("2")) => Format::Spz2,
        (format @ Format::Spz, _) | (format, None) => format,
        (_, Some(_)) => return refuse("`--spz-version` is for a file that ends in .spz"),
    };
    let shown = Shown::find(&args.scene, &[])?;
    let source = &shown.source;
    check_file(&args.output, [source.named()].into_iter().chain(args.cameras.as_deref()))?;
    let scenes = shown.load(console)?;
    let scene = &scenes[0];
    let renderer = args.device.open(console)?;
    let visible = shown.visible_box(&scenes);
    let (views, data) = load_views(args, source, visible, &renderer, console)?;
    let uploaded = shown.upload(&scenes, UploadOptions::default(), &renderer)?;
    let distilled = distill(args, source, scene, (&renderer, &uploaded), &views, console)?;
    let placement = scene.config.placement;
    let up = placement.upward(&[&views.fitted[..], &views.held_out].concat());
    let (written, offset) =
        splats::save_scene(&distilled.splats, &args.output, format, up, &placement)?;
    if let Some(left_out) = offset {
        let said = if format.stores_placement() { ", as it says itself" } else { "" };
        console.warn(&(relative_to(left_out) + said));
    }
    say_psnr(&views, &distilled, &written, args.steps, console);
    if let Some(data) = data {
        let frames: Vec<_> = data.held_out_frames().collect();
        if let Some(found) = splats::compare_splats(&renderer, &uploaded, &written, &frames)? {
            say_photographs(found, console);
        }
    }
    let bytes = std::fs::metadata(&args.output).map_or(0, |file| file.len());
    console.note(&format!(
        "wrote {} to {}, {}",
        count(written.len() as u64, "Gaussian"),
        args.output.display(),
        format_bytes(bytes)
    ));
    let is_of_cameras = offset.is_none() && placement.meters.is_none();
    if is_of_cameras || format.stores_placement() {
        let [red, green, blue] = scene.config.background;
        let file = quoted(&args.output);
        let cameras = args.cameras.iter().map(|path| format!(" {}", quoted(path)));
        let cameras = cameras.collect::<String>();
        console.note(&format!(
            "back to a scene: organza import {file}{cameras} -o NEW --background {red:.3},{green:.3},{blue:.3}"
        ));
    }
    Ok(())
}

/// The Gaussians that show what the scene shows: of an earlier export, or fitted now.
fn distill(
    args: &Args,
    source: &SceneSource,
    scene: &Scene,
    (renderer, uploaded): (&Renderer, &DeviceScene),
    views: &Views,
    console: Console,
) -> Result<Distilled> {
    let fit = Fit { steps: args.steps, side: args.side };
    let key = made_of(source.file(), &(views, fit, renderer.device().arithmetic()))?;
    let file = source.named().join(FIT);
    // the key knows one file
    if !source.is_whole()
        && let Some(kept) = Distilled::kept(&file, &key, renderer, scene, uploaded, views, fit)?
    {
        console.note("the fit is there from an earlier export");
        return Ok(kept);
    }
    announce(fit, console);
    let progress = console.progress("fitting", args.steps as usize, "steps");
    let mut see = |step| {
        progress.set(step);
        Ok(())
    };
    let new = splats::distill(renderer, scene, uploaded, views, fit, &mut see)?;
    // what is fitted again in a minute need not be kept
    if args.steps > 0 && !source.is_whole() && source.settings()?.is_some() {
        let _ = new.keep(&file, &key).inspect_err(|error| console.detail(&error.to_string()));
    }
    Ok(new)
}

/// Says what the fit will take, or what is lost without it.
fn announce(fit: Fit, console: Console) {
    console.note(&match fit.steps {
        0 => "`--steps 0` compares no images, and only takes what the scene says of each Gaussian: the file can lose 10 decibels"
            .to_owned(),
        steps => format!(
            "fitting the Gaussians to the scene's own images in {}; `--steps 0` only takes what the scene says of each, in \
             seconds, and can lose 10 decibels",
            count(u64::from(steps), "step")
        ),
    });
}

/// The views to compare, and the held-out photographs if there are any.
fn load_views(
    args: &Args,
    source: &SceneSource,
    visible: [[f64; 3]; 2],
    renderer: &Renderer,
    console: Console,
) -> Result<(Views, Option<Dataset>)> {
    let named = args.cameras.as_deref();
    let has_photographs = match named {
        Some(named) => args.data.names_photographs(named),
        None => args.data.is_given() || source.settings()?.is_some(),
    };
    if !has_photographs {
        let views = match named {
            Some(_) => Views::from_cameras(Cameras::load(source, named, &args.data, console)?.list),
            None => Views::around(visible)?,
        };
        return Ok((views, None));
    }
    let mut data = DataSet::of(source, named, &args.data, None, console)?;
    data.say_doubt(Split::HeldOut, console);
    let (held_out, fitted): (Vec<_>, _) =
        data.cameras()?.into_iter().partition(|pose| pose.held_out);
    let has_held_out = !held_out.is_empty();
    let (fitted, held_out) = match args.data.split(Split::All) {
        Split::All if !fitted.is_empty() => (fitted, held_out),
        Split::Train => (fitted, Vec::new()),
        _ => (held_out, Vec::new()),
    };
    let cameras = |poses: Vec<Pose>| poses.into_iter().map(|pose| pose.camera).collect::<Vec<_>>();
    let [fitted, held_out] = [fitted, held_out].map(cameras);
    // only the photographs that the file is compared with are needed
    let data = data.only(Split::HeldOut);
    let data = has_held_out.then(|| data.read(renderer, console)).transpose()?;
    Ok((Views { fitted, held_out }, data))
}

/// Reports how close the file's images are to the scene's, and what rounding in the file costs.
fn say_psnr(views: &Views, distilled: &Distilled, written: &[Splat], steps: u32, console: Console) {
    let (views, which) = match views.held_out.len() {
        0 => (views.fitted.len(), ""),
        held_out => (held_out, " that the fit has not seen"),
    };
    let psnr = distilled.psnr_of(written);
    let before = match steps {
        0 => String::new(),
        _ => {
            format!(" ({:.2} dB before {})", distilled.first_psnr, count(u64::from(steps), "step"))
        }
    };
    console.note(&format!(
        "in {}{which}, PSNR of the file against the scene's own images: {psnr:.2} dB{before}",
        count(views as u64, "view"),
    ));
    let cost = distilled.psnr - psnr;
    if cost > NOTICED {
        console.warn(&format!(
            "this format rounds or leaves out values, which costs {cost:.2} dB of {:.2} dB; a .ply keeps all values",
            distilled.psnr
        ));
    }
}

/// Reports the file's loss on photographs that training has not seen.
fn say_photographs(found: SplatComparison, console: Console) {
    let SplatComparison { photographs, scene, splats } = found;
    console.note(&format!(
        "beside {}: {splats:.2} dB, the scene itself {scene:.2} dB, so the file loses {:.2} dB",
        count(photographs as u64, "held-out view"),
        scene - splats
    ));
}
