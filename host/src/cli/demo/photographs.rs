//! `organza demo --photographs`: a data set that needs no camera.

use std::fs;
use std::path::{Path, PathBuf};

use image::ExtendedColorType;
use image::codecs::jpeg::JpegEncoder;
use organza::still_life::StillLife;
use organza::{Camera, Error, Image, Result};
use organza_core::write_atomic;
use serde::Serialize;

use super::{Args, quoted};
use crate::cli::console::{Console, print_json};
use crate::cli::output::Folder;
use crate::cli::picture::Picture;
use crate::cli::refuse;
use crate::cli::summary::count;

/// Default number of photographs, and of pixels of their width.
const PHOTOGRAPHS: u16 = 40;
const WIDTH: u32 = 640;
/// Quality of JPEG files, out of 100: as phones write them.
const QUALITY: u8 = 92;
const CAMERAS: &str = "transforms.json";
const IMAGES: &str = "images";

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Taken<'a> {
    folder: &'a Path,
    cameras: PathBuf,
    images: Vec<Picture>,
}

/// Writes photographs of a still life, with their true cameras.
pub fn run(args: &Args, console: Console) -> Result<()> {
    let mut folder = Folder::make(&args.output)?;
    folder.lock(false)?;
    let path = args.output.display();
    if let Some(name) = [IMAGES, CAMERAS].into_iter().find(|name| folder.join(name).exists()) {
        return refuse(format!("{path} has {name} already; choose another folder"));
    }
    let width = args.size.unwrap_or(WIDTH);
    let size = [width, width * 3 / 4];
    let walk = StillLife::new(usize::from(args.views.unwrap_or(PHOTOGRAPHS)), size)?;
    let images = folder.join(IMAGES);
    let unfinished = folder.join("images.part");
    // A call that was stopped has left it.
    if unfinished.exists() {
        fs::remove_dir_all(&unfinished).map_err(|source| Error::write(&unfinished, source))?;
    }
    fs::create_dir(&unfinished).map_err(|source| Error::write(&unfinished, source))?;
    let mut cameras = Vec::new();
    let mut pictures = Vec::new();
    {
        let progress = console.progress(walk.cameras().len() as u64, "photographs");
        progress.say("ray tracing");
        for (index, camera) in walk.cameras().iter().enumerate() {
            let name = format!("{index:05}.jpg");
            write_jpeg(&walk.photograph(index)?, &unfinished.join(&name))?;
            pictures.push(Picture::new(index, &images.join(&name), camera));
            let file_path = Some(format!("{IMAGES}/{name}"));
            cameras.push(Camera { file_path, ..camera.clone() });
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
        let cameras = folder.join(CAMERAS);
        return print_json(&Taken { folder: &args.output, cameras, images: pictures });
    }
    Ok(())
}

fn write_jpeg(photograph: &Image, path: &Path) -> Result<()> {
    let [width, height] = photograph.size();
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, QUALITY)
        .encode(photograph.pixels().as_flattened(), width, height, ExtendedColorType::Rgb8)
        .map_err(|error| Error::write(path, std::io::Error::other(error)))?;
    write_atomic(path, |writer| writer.write_all(&bytes))
}
