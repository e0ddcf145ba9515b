//! `organza demo`: the built-in scene, as something to look at and to try.

use std::fs;
use std::path::{Path, PathBuf};

use organza::data::encode_jpeg;
use organza::image::TILE_SIDE;
use organza::still_life;
use organza::{Camera, Error, Renderer, Result, Scene, Tile, TileBatch, demo};
use organza_core::write_atomic;
use serde::Serialize;

use super::console::{Console, print_json};
use super::device::DeviceArgs;
use super::output::{Folder, make_empty};
use super::picture::{Picture, Pictures, warn_not_finite};
use super::summary::{Cost, Summary, count};
use super::views::names;
use super::{quoted, refuse, text_of};

/// Default number of views, and of pixels of their sides.
const VIEWS: u16 = 24;
const SIDE: u32 = 384;

/// Render the built-in scene from all sides; needs no files
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/demo.txt"))]
pub struct Args {
    /// Write photographs of a still life instead, made by a ray tracer, with the flaws of photographs that are taken by
    /// hand. They are in the public domain (CC0 1.0)
    #[arg(long)]
    photographs: bool,
    /// The folder for the images, the scene and the cameras; created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Number of views, all around the scene [default: 24, or 40 photographs]
    #[arg(long, value_name = "N")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=1000))]
    views: Option<u16>,
    /// Width and height of the images, in pixels; of photographs, the width [default: 384, or 640]
    #[arg(long, value_name = "S")]
    #[arg(value_parser = clap::value_parser!(u32).range(8..=4096))]
    size: Option<u32>,
    /// Print JSON: the files, and the cost of rendering (docs/json.md)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    if args.photographs {
        return write_photographs(args, console);
    }
    let mut folder = Folder::make(&args.output)?;
    folder.lock()?;
    let cameras =
        demo::turntable(usize::from(args.views.unwrap_or(VIEWS)), args.size.unwrap_or(SIDE));
    refuse_foreign(&folder, &cameras, &args.output)?;
    let scene = console.during("building the scene", demo::scene);
    let renderer = args.device.open(console)?;
    for name in FILES {
        folder.file(name)?;
    }
    let [scene_file, cameras_file, tiles_file] = FILES.map(|name| folder.join(name));
    scene.save(&scene_file)?;
    Camera::save_all(&cameras_file, &cameras)?;
    center_tiles(&cameras).save(&tiles_file)?;
    let (images, cost) = render(&renderer, &scene, &cameras, &folder, console)?;
    console.note(&next_steps(&args.output, &cameras));
    if args.json {
        let folder = text_of(&args.output);
        let [scene, cameras, tiles] =
            [scene_file, cameras_file, tiles_file].map(|file| text_of(&file));
        return print_json(&Made { folder, scene, cameras, tiles, images, cost });
    }
    Ok(())
}

/// The files besides the views.
const FILES: [&str; 3] = ["scene.safetensors", "cameras.json", "tiles.json"];

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Made {
    folder: String,
    scene: String,
    cameras: String,
    tiles: String,
    images: Vec<Picture>,
    #[serde(flatten)]
    cost: Cost,
}

/// Refuses a folder that holds other files with the names of ours.
fn refuse_foreign(folder: &Folder, cameras: &[Camera], path: &Path) -> Result<()> {
    let views = names(cameras).into_iter().map(|name| format!("{name}.png"));
    let mut files = FILES.map(str::to_owned).into_iter().chain(views);
    let Some(name) = files.find(|name| folder.join(name).exists()) else { return Ok(()) };
    // A file that was written and read again has the same values: f32 are exact in a file.
    match Scene::load(folder.join("scene.safetensors")) {
        Ok(found) if found == demo::scene() => Ok(()),
        _ => refuse(format!(
            "{} holds a {name} that the demo did not write; choose another folder",
            path.display()
        )),
    }
}

fn render(
    renderer: &Renderer,
    scene: &Scene,
    cameras: &[Camera],
    folder: &Folder,
    console: Console,
) -> Result<(Vec<Picture>, Cost)> {
    let scene = renderer.upload(scene)?;
    let scene = &scene;
    let pictures = Pictures { renderer, scene, cameras, stop: None };
    let views: Vec<_> = (0..cameras.len()).collect();
    let names = names(cameras);
    let mut summary = Summary::start();
    let mut images = Vec::new();
    let mut not_finite = 0;
    {
        let progress = console.progress("rendering", pictures.tiles(&views), "tiles");
        for view in views {
            progress.say(&format!("rendering {}", names[view]));
            let (image, _) = pictures.render_channels(view, &[], &mut summary, &progress)?;
            let file = folder.file(&format!("{}.png", names[view]))?;
            image.save_png(&file)?;
            images.push(Picture::new(view, &file, &cameras[view]));
            not_finite += image.not_finite();
        }
    }
    let size = cameras[0].width;
    let number = count(cameras.len() as u64, "image");
    summary.say(&format!("{number} of {size} x {size}"), console);
    warn_not_finite(console, not_finite);
    Ok((images, summary.cost(renderer, not_finite)))
}

/// The cameras and the tiles of the built-in scene, unless the user asks for others.
pub fn built_in() -> (Vec<Camera>, TileBatch) {
    let cameras = demo::turntable(VIEWS.into(), SIDE);
    let tiles = center_tiles(&cameras);
    (cameras, tiles)
}

/// A tile in the center of each of the first views.
fn center_tiles(cameras: &[Camera]) -> TileBatch {
    let origin = |camera: &Camera| {
        [camera.width, camera.height].map(|size| (size as i32 - TILE_SIDE as i32) / 2)
    };
    let tile = |(camera, of): (usize, &Camera)| Tile { camera, origin: origin(of) };
    TileBatch { side: TILE_SIDE, tiles: cameras.iter().enumerate().take(8).map(tile).collect() }
}

fn next_steps(path: &Path, cameras: &[Camera]) -> String {
    let [scene, cameras_file, tiles] = FILES.map(|name| quoted(&path.join(name)));
    let center = cameras[0].width / 2;
    let images = quoted(&path.join("views"));
    let rendered = quoted(&path.join("rendered.safetensors"));
    format!(
        "wrote {}, the scene, its cameras and tiles to {}\n\
         look at them, then try\n  \
         organza info {scene}\n  \
         organza explain {scene} {cameras_file} --view 0 --pixel {center},{center}\n  \
         organza render {scene} {cameras_file} -o {images} --views 0\n  \
         organza tiles {scene} {cameras_file} {tiles} -o {rendered}",
        count(cameras.len() as u64, "view"),
        path.display(),
    )
}

/// Default number of photographs, and of pixels of their width.
const PHOTOGRAPHS: u16 = 40;
const WIDTH: u32 = 640;
/// Quality of JPEG files, out of 100: as phones write them.
const QUALITY: u8 = 92;
const CAMERAS: &str = "transforms.json";
const IMAGES: &str = "images";

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Taken {
    folder: String,
    cameras: String,
    images: Vec<Picture>,
}

/// Writes photographs of a still life, with their true cameras.
fn write_photographs(args: &Args, console: Console) -> Result<()> {
    let mut folder = Folder::make(&args.output)?;
    folder.lock()?;
    let path = args.output.display();
    if let Some(name) = [IMAGES, CAMERAS].into_iter().find(|name| folder.join(name).exists()) {
        return refuse(format!("{path} has {name} already; choose another folder"));
    }
    let width = args.size.unwrap_or(WIDTH);
    let size = [width, width * 3 / 4];
    let mut cameras = still_life::cameras(args.views.unwrap_or(PHOTOGRAPHS).into(), size)?;
    let images = folder.join(IMAGES);
    let unfinished = folder.join("images.part");
    make_empty(&unfinished)?;
    let mut pictures = Vec::new();
    {
        let progress = console.progress("ray tracing", cameras.len(), "photographs");
        for (index, camera) in cameras.iter_mut().enumerate() {
            let name = format!("{index:05}.jpg");
            let photograph = still_life::photograph(camera, index)?;
            let bytes = encode_jpeg(size, photograph.pixels().as_flattened(), QUALITY)?;
            write_atomic(unfinished.join(&name), |writer| writer.write_all(&bytes))?;
            pictures.push(Picture::new(index, &images.join(&name), camera));
            camera.file_path = Some(format!("{IMAGES}/{name}"));
            progress.advance(1);
        }
    }
    fs::rename(&unfinished, &images).map_err(|source| Error::write(&images, source))?;
    Camera::save_all(folder.join(CAMERAS), &cameras)?;
    let number = count(cameras.len() as u64, "photograph");
    console.note(&format!(
        "wrote {number} of {} x {} to {path}. They are in the public domain (CC0 1.0)\n\
         next: organza capture {} -o DATA, which finds out where the camera stood\n  \
         or: organza train {} -o RUN, with the true cameras",
        size[0],
        size[1],
        quoted(&images),
        quoted(&args.output),
    ));
    if args.json {
        let cameras = text_of(&folder.join(CAMERAS));
        return print_json(&Taken { folder: text_of(&args.output), cameras, images: pictures });
    }
    Ok(())
}
