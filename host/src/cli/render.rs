//! `organza render`: whole images.

use std::fmt::Debug;
use std::path::{Path, PathBuf};

use organza::image::{ChannelFormat, ChannelImage};
use organza::tile::MAX_TILE_SIDE;
use organza::{Channel, Image, Result};
use serde::Serialize;

use super::channels::{ChannelArgs, FormatArgs};
use super::console::{Console, print_json};
use super::device::{DeviceArgs, SceneArgs};
use super::inputs::{Cameras, DataArgs, SceneSource, Shown};
use super::output::{self, Folder, KeptImages, name, refuse_others};
use super::picture::{Picture, Pictures, sizes, warn_not_finite};
use super::summary::{Cost, Summary, count, grouped};
use super::views::{ViewList, ViewTask, names, warn_distorted};
use super::{refuse, text_of};

const EXAMPLES: &str = "\
Examples:
  organza render scene.safetensors transforms.json -o images
  organza render scene.safetensors transforms.json -o images --views 0-3,8 --tile-size 128
  organza render scene.safetensors transforms.json -o images --channels depth,normal --format exr
  organza render run -o images                             the views that the run was trained on
  organza render run -o images --split held-out            those that it did not see
  organza render scene.safetensors data/fox -o images --split all --downscale 2
  organza render room.safetensors mug.safetensors@mug.json transforms.json -o images    two scenes (docs/scenes.md)
  organza render scene.safetensors transforms.json -o images --task 0/4    the first of four machines
  organza render scene.safetensors transforms.json -o images --missing     what is not there yet

A data set's cameras are used as in training: undistorted and downscaled. With a run's folder, its settings say \
which frames are held out. `--views` counts the frames that `--split` chooses.

If each camera names a photograph of its own, files are named after these; otherwise after the \
view's index. The tile size does not change the image.

A folder with files that are no images of these cameras is refused, unless you pass `--overwrite`. Nothing is removed.

`--task I/N` renders the views I, I + N, I + 2N and so on, counted in the list of views. Several machines may write to \
one folder at the same time. With `--missing`, images that are there stay as they are, and the others are rendered: after \
a task has failed, or was killed. Images of another scene, or of other cameras or options, are refused.

A channel is written beside the image, as NAME.depth.png. Every channel is 0 where no Gaussian \
covers a pixel. In a PNG, depth is in thousandths of a world unit unless `--depth-scale` says \
otherwise, alpha and visibility go from 0 to 1, and each part of a normal from -1 to 1. In an EXR \
file, the values are as they are.";

/// Render whole views as PNG images
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run; or a TOML file that lists several
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
    /// Render every Nth view, starting with the Ith: I/N, such as 0/4. `slurm` takes both from a Slurm array
    #[arg(long, value_name = "I/N")]
    task: Option<ViewTask>,
    /// Render only images that do not exist yet
    #[arg(long)]
    missing: bool,
    /// Write to a folder with other files. They stay; images of the same names are replaced
    #[arg(long)]
    overwrite: bool,
    /// Side of the tiles that an image is cut into, in pixels
    #[arg(long, value_name = "S", default_value_t = 64)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_TILE_SIDE)))]
    tile_size: u32,
    /// Print JSON: the images, and the cost of rendering (docs/json.md)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    channels: ChannelArgs,
    #[command(flatten)]
    format: FormatArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

/// The views to render.
fn chosen(args: &Args, cameras: &Cameras) -> Result<Vec<usize>> {
    let views = match &args.views {
        Some(chosen) => chosen.resolve(cameras.list.len(), &cameras.origin)?,
        None => (0..cameras.list.len()).collect(),
    };
    Ok(args.task.map_or(views.clone(), |task| task.select(views)))
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let shown = Shown::find(&args.scene, &args.cameras)?;
    let source = &shown.source;
    let usage = "organza render SCENE CAMERAS -o DIR";
    let cameras = &Cameras::load(source, shown.cameras.as_deref(), &args.data, usage, console)?;
    let views = &chosen(args, cameras)?;
    let list = &cameras.list[..];
    warn_distorted(console, list, views);
    let channels = args.channels.list();
    let format = args.format.format();
    for &view in views {
        Image::check_memory(list[view].width, list[view].height)?;
        ChannelImage::check_memory(&channels, list[view].width, list[view].height)?;
    }
    let scene = source.load(console)?;
    let mut folder = Folder::make(&args.output)?;
    // tasks write different images to one folder
    folder.lock(args.task.is_some())?;
    let beside = |channel: &Channel| format!("{}.{}", channel.name(), format.extension());
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

    let renderer = &args.device.open(console)?;
    let scene = &shown.upload(&scene, &args.scene_args, renderer, console)?;
    let pictures =
        Pictures { renderer, scene, cameras: list, tile_size: args.tile_size, stop: None };
    let is_wanted = |files: &[PathBuf]| !args.missing || !files.iter().all(|file| file.exists());
    let todo: Vec<_> = (0..views.len()).filter(|&place| is_wanted(&files[place])).collect();
    if todo.len() < views.len() {
        let there = views.len() - todo.len();
        let all = count(views.len() as u64, "view");
        console.note(&format!("{there} of {all} are there from an earlier call"));
    }
    let rendered: Vec<_> = todo.iter().map(|&place| (views[place], &files[place])).collect();
    let how = (list, args.scene_args.options(), format, shown.others()?);
    let images = names(list).iter().map(|name| folder.join(&format!("{name}.png"))).collect();
    let replaced: Vec<_> = rendered.iter().map(|(_, files)| &files[0]).collect();
    let made_of = (source.file(), &how as &dyn Debug);
    let kept = KeptImages::check(&folder, images, made_of, &replaced, args.missing)?;
    let output = (&channels[..], format);
    let cost = write_all(&pictures, &rendered, output, console)?;
    kept.write()?;
    let names: Vec<_> = rendered.iter().flat_map(|(_, files)| *files).collect();
    console.note(&wrote(&names, &args.output));
    if args.json {
        let image = |(&view, files): (&usize, &Vec<PathBuf>)| {
            Picture::new(view, &files[0], &list[view]).with_channels(&channels, &files[1..])
        };
        let images = views.iter().zip(&files).map(image).collect();
        let folder = text_of(&args.output);
        let rendered = rendered.len();
        return print_json(&RenderOutput { folder, images, rendered, cost });
    }
    Ok(())
}

/// Names the written images, or the first and the last of many.
fn wrote(names: &[&PathBuf], output: &Path) -> String {
    match names {
        [] => "nothing to render".to_owned(),
        [only] => format!("wrote {}", only.display()),
        [first, .., last] => format!(
            "wrote {} to {}: {} to {}",
            count(names.len() as u64, "image"),
            output.display(),
            name(first),
            name(last)
        ),
    }
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct RenderOutput {
    folder: String,
    images: Vec<Picture>,
    /// Number of views that this call rendered. Earlier calls rendered the others.
    rendered: usize,
    #[serde(flatten)]
    cost: Cost,
}

fn write_all(
    pictures: &Pictures<'_>,
    todo: &[(usize, &Vec<PathBuf>)],
    (channels, format): (&[Channel], ChannelFormat),
    console: Console,
) -> Result<Cost> {
    let mut summary = Summary::start();
    let views: Vec<_> = todo.iter().map(|(view, _)| *view).collect();
    let mut not_finite = 0;
    let mut not_finite_channels = 0;
    let mut clipped = 0;
    {
        let progress = console.progress("rendering", pictures.tiles(&views), "tiles");
        for &(view, paths) in todo {
            progress.say(&format!("rendering {}", name(&paths[0])));
            let (image, beside) =
                pictures.render_channels(view, channels, &mut summary, &progress)?;
            image.save_png(&paths[0])?;
            not_finite += image.not_finite();
            for (image, path) in beside.iter().zip(&paths[1..]) {
                image.save(path, format)?;
                clipped += image.clipped(format);
                not_finite_channels += image.not_finite();
            }
        }
    }
    if !views.is_empty() {
        let number = count(views.len() as u64, "image");
        let size = sizes(pictures.cameras, &views);
        summary.say(&format!("{number} of {size}"), console);
    }
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
            "deeper than a PNG holds: {clipped} pixels; use a smaller `--depth-scale`, or \
             `--format exr`"
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
        output::refuse_replacing(&path, &[scene.file(), &cameras.origin], output::same)?;
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
