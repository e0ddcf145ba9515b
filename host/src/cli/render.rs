//! `organza render`: whole images.

use std::path::{Path, PathBuf};

use organza::tile::MAX_TILE_SIDE;
use organza::{Camera, Image, Result, Scene};

use super::console::Console;
use super::device::{DeviceArgs, SceneArgs};
use super::output::{self, Folder};
use super::picture::{Pictures, sizes, warn_not_finite};
use super::refuse;
use super::summary::{Summary, count};
use super::views::{ViewList, names, photographs, warn_distorted};

const EXAMPLES: &str = "\
Examples:
  organza render scene.safetensors transforms.json -o images
  organza render scene.safetensors transforms.json -o images --views 0-3,8 --tile-size 128

If each camera names a photograph of its own, files are named after these; otherwise after the \
view's index. The tile size does not change the image.";

/// Render whole views as PNG images
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors
    scene: PathBuf,
    /// The cameras, nerfstudio's transforms.json
    cameras: PathBuf,
    /// The folder for the images; created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Which views to render, such as 0,8 or 0-3 [default: all]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    views: Option<ViewList>,
    /// Side of the tiles that an image is cut into, in pixels
    #[arg(long, value_name = "S", default_value_t = 64)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_TILE_SIDE)))]
    tile_size: u32,
    #[command(flatten)]
    scene_args: SceneArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args) -> Result<()> {
    let console = args.device.console();
    let cameras = Camera::load_all(&args.cameras)?;
    let views = match &args.views {
        Some(list) => list.resolve(cameras.len(), &args.cameras)?,
        None => (0..cameras.len()).collect(),
    };
    warn_distorted(console, &cameras, &views);
    for &view in &views {
        Image::check_memory(cameras[view].width, cameras[view].height)?;
    }
    let scene = console.during("reading the scene", || Scene::load(&args.scene))?;
    let folder = Folder::make(&args.output)?;
    let files = files(args, &folder, &cameras, &views)?;

    let renderer = args.device.open()?;
    let scene = args.scene_args.upload(&renderer, &scene)?;
    let (cameras, tile_size) = (&cameras[..], args.tile_size);
    let pictures = Pictures { renderer: &renderer, scene: &scene, cameras, tile_size };
    write_all(&pictures, &views, &files, console)?;
    console.note(&match files.as_slice() {
        [first, .., last] => format!(
            "wrote {} to {}: {} to {}",
            count(files.len() as u64, "image"),
            args.output.display(),
            name(first),
            name(last)
        ),
        _ => format!("wrote {}", files[0].display()),
    });
    Ok(())
}

fn write_all(
    pictures: &Pictures<'_>,
    views: &[usize],
    files: &[PathBuf],
    console: Console,
) -> Result<()> {
    let mut summary = Summary::start();
    let mut not_finite = 0;
    {
        let progress = console.progress(pictures.tiles(views), "tiles");
        for (&view, path) in views.iter().zip(files) {
            progress.say(&name(path));
            let image = pictures.render(view, &mut summary, &progress)?;
            image.save_png(path)?;
            not_finite += image.not_finite();
        }
    }
    let (number, size) = (count(views.len() as u64, "image"), sizes(pictures.cameras, views));
    console.note(&summary.line(&format!("{number} of {size}")));
    warn_not_finite(console, not_finite);
    Ok(())
}

/// The files to write, none of which may be what the scene was made from.
fn files(
    args: &Args,
    folder: &Folder,
    cameras: &[Camera],
    views: &[usize],
) -> Result<Vec<PathBuf>> {
    let names = names(cameras);
    let path = |&view: &usize| {
        let path = folder.join(&format!("{}.png", names[view]));
        output::check_file(&path, &[&args.scene, &args.cameras])?;
        for photograph in cameras.iter().flat_map(|camera| photographs(camera, &args.cameras)) {
            if output::is_same(&path, &photograph) {
                let path = path.display();
                return refuse(format!(
                    "{path} would replace a photograph of {}; choose another folder",
                    args.cameras.display()
                ));
            }
        }
        Ok(path)
    };
    views.iter().map(path).collect()
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
