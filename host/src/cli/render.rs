//! `organza render`: whole images.

use std::path::{Path, PathBuf};

use organza::image::ChannelImage;
use organza::{Channel, Image, Result};
use serde::Serialize;

use super::channels::{ChannelArgs, LevelArgs};
use super::console::{Console, print_json};
use super::device::SceneArgs;
use super::inputs::{Cameras, DataArgs, SceneSource, Shown};
use super::output::{self, Folder, name, refuse_others};
use super::picture::{Picture, Pictures, sizes, warn_not_finite};
use super::summary::{Cost, Summary, count, grouped};
use super::views::{ViewList, names, warn_distorted};
use super::{refuse, text_of};

/// Render whole views as PNG images
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/render.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// More scenes at their places, each as SCENE@PLACE.json; and the cameras: nerfstudio's transforms.json, or a data set
    /// [default: the run's]
    cameras: Vec<PathBuf>,
    /// The folder for the images; created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// The views to render, such as 0,8 or 0-3 [default: all]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    views: Option<ViewList>,
    /// Write to a folder with other files. They stay; images of the same names are replaced
    #[arg(long)]
    overwrite: bool,
    /// Print JSON: the images, and the cost of rendering (docs/json.md)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    channels: ChannelArgs,
    #[command(flatten)]
    levels: LevelArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let mut shown = Shown::find_images(&args.scene, &args.cameras)?;
    if shown.cameras.is_none() {
        shown.refine()?;
    }
    let source = &shown.source;
    let cameras = &Cameras::load(source, shown.cameras.as_deref(), &args.data, console)?;
    let views = &match &args.views {
        Some(chosen) => chosen.resolve(cameras.list.len(), &cameras.origin)?,
        None => (0..cameras.list.len()).collect(),
    };
    let list = &cameras.list[..];
    warn_distorted(console, list, views);
    let channels = args.channels.list();
    for &view in views {
        Image::check_memory(list[view].width, list[view].height)?;
        ChannelImage::check_memory(&channels, list[view].width, list[view].height)?;
    }
    let scenes = shown.load(console)?;
    let mut folder = Folder::make(&args.output)?;
    folder.lock()?;
    let beside = |channel: &Channel| format!("{}.png", channel.name());
    let endings: Vec<_> =
        std::iter::once("png".to_owned()).chain(channels.iter().map(beside)).collect();
    let files = files(&folder, source, cameras, views, &endings)?;
    if !args.overwrite {
        let names = names(&cameras.all);
        let is_image = |file: &str| {
            let of = |name: &String| file.strip_prefix(name.as_str());
            names.iter().filter_map(of).any(|rest| rest.starts_with('.'))
        };
        refuse_others(&folder, is_image)?;
    }

    let renderer = &args.scene_args.device.open(console)?;
    let scene = &shown.upload(&scenes, args.scene_args.options(), renderer)?;
    let pictures = Pictures { renderer, scene, cameras: list, stop: None };
    let output = (&channels[..], args.levels.depth_scale);
    let cost = write_all(&pictures, views, &files, output, console)?;
    let names: Vec<_> = files.iter().flatten().collect();
    console.note(&wrote(&names, &args.output));
    if args.json {
        let image = |(&view, files): (&usize, &Vec<PathBuf>)| {
            Picture::new(view, &files[0], &list[view]).with_channels(&channels, &files[1..])
        };
        let images = views.iter().zip(&files).map(image).collect();
        return print_json(&RenderOutput { folder: text_of(&args.output), images, cost });
    }
    Ok(())
}

/// Names the written images, or the first and the last of many.
fn wrote(names: &[&PathBuf], output: &Path) -> String {
    match names {
        [first, .., last] => format!(
            "wrote {} to {}: {} to {}",
            count(names.len() as u64, "image"),
            output.display(),
            name(first),
            name(last)
        ),
        names => format!("wrote {}", names[0].display()),
    }
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct RenderOutput {
    folder: String,
    images: Vec<Picture>,
    #[serde(flatten)]
    cost: Cost,
}

fn write_all(
    pictures: &Pictures<'_>,
    views: &[usize],
    files: &[Vec<PathBuf>],
    (channels, depth_scale): (&[Channel], f32),
    console: Console,
) -> Result<Cost> {
    let mut summary = Summary::start();
    let mut not_finite = 0;
    let mut not_finite_channels = 0;
    let mut clipped = 0;
    {
        let progress = console.progress("rendering", pictures.tiles(views), "tiles");
        for (&view, paths) in views.iter().zip(files) {
            progress.say(&format!("rendering {}", name(&paths[0])));
            let (image, beside) =
                pictures.render_channels(view, channels, &mut summary, &progress)?;
            image.save_png(&paths[0])?;
            not_finite += image.not_finite();
            for (image, path) in beside.iter().zip(&paths[1..]) {
                image.save(path, depth_scale)?;
                clipped += image.clipped(depth_scale);
                not_finite_channels += image.not_finite();
            }
        }
    }
    let number = count(views.len() as u64, "image");
    let size = sizes(pictures.cameras, views);
    summary.say(&format!("{number} of {size}"), console);
    warn_not_finite(console, not_finite);
    if not_finite_channels > 0 {
        let values = grouped(not_finite_channels);
        console.warn(&format!(
            "NaN or infinite values in channels: {values}; check the Gaussians' positions and the networks' weights"
        ));
    }
    if clipped > 0 {
        let clipped = grouped(clipped);
        console.warn(&format!(
            "deeper than a PNG holds: {clipped} pixels; use a smaller `--depth-scale`"
        ));
    }
    Ok(summary.cost(pictures.renderer, not_finite))
}

/// The files to write for each view, one per extension. None may be an input of the scene.
fn files(
    folder: &Folder,
    scene: &SceneSource,
    cameras: &Cameras,
    views: &[usize],
    endings: &[String],
) -> Result<Vec<Vec<PathBuf>>> {
    let names = names(&cameras.list);
    let path = |view: usize, ending: &str| {
        let path = folder.file(&format!("{}.{ending}", names[view]))?;
        output::refuse_replacing(&path, [scene.file(), &cameras.origin], output::same)?;
        organza_core::check_writable(&path)?;
        if cameras.is_photograph(&path) {
            let path = path.display();
            let origin = cameras.origin.display();
            return refuse(format!(
                "{path} would replace a photograph of {origin}; choose another folder"
            ));
        }
        Ok(path)
    };
    let paths = |&view: &usize| endings.iter().map(|ending| path(view, ending)).collect();
    views.iter().map(paths).collect()
}
