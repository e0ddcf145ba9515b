//! COLMAP's sparse models, binary and text.

mod binary;
mod model;
mod text;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::access::Access;
use super::find;
use super::{DatasetKind, DatasetOptions, Listing, Point, invalid, is_held_out};
use model::{Image, Intrinsics};
use organza_core::error::Result;
use organza_core::input::open_regular;

/// Folders in a data set that may hold a model, by priority.
const FOLDERS: [&str; 4] = ["sparse/0", "sparse", "colmap/sparse/0", ""];

type Cameras = HashMap<u32, Intrinsics>;
/// Points by their ids.
type Points = Vec<(u64, Point)>;

/// Adds a camera. A repeated id is an error, because one of the cameras would be lost.
fn add(cameras: &mut Cameras, id: u32, camera: Intrinsics, path: &Path) -> Result<()> {
    match cameras.insert(id, camera) {
        Some(_) => invalid(path, format!("camera {id} is there twice; is the file damaged?")),
        None => Ok(()),
    }
}

/// The files of a model.
pub(super) struct Model {
    cameras: PathBuf,
    images: PathBuf,
    points: PathBuf,
    is_binary: bool,
}

/// The model of a data set. If both forms exist, the binary one is used, as in COLMAP.
pub(super) fn find(folder: &Path) -> Option<Model> {
    let model = |(folder, extension): (PathBuf, &str)| {
        let file = |stem: &str| folder.join(format!("{stem}.{extension}"));
        let cameras = file("cameras");
        let images = file("images");
        let points = file("points3D");
        cameras.is_file().then(|| Model { cameras, images, points, is_binary: extension == "bin" })
    };
    let folders = FOLDERS.iter().map(|name| folder.join(name));
    let both = |folder: PathBuf| [(folder.clone(), "bin"), (folder, "txt")];
    folders.flat_map(both).find_map(model)
}

/// Reads a model. Images are sorted by name and points by id, because COLMAP writes both in no particular order.
pub(super) fn list(
    folder: &Path,
    model: &Model,
    options: &DatasetOptions,
    access: &mut Access,
) -> Result<Listing> {
    let (cameras, mut images, mut points) = read(model)?;
    images.sort_by(|a, b| a.name.cmp(&b.name));
    points.sort_by_key(|(id, _)| *id);
    if let Some(pair) = images.windows(2).find(|pair| pair[0].name == pair[1].name) {
        let reason = format!("image `{}` is there twice; is the file damaged?", pair[0].name);
        return invalid(&model.images, reason);
    }
    let mut listing = Listing::new(DatasetKind::Colmap);
    for (position, image) in images.into_iter().enumerate() {
        let Some(intrinsics) = cameras.get(&image.camera) else {
            let name = &image.name;
            let id = image.camera;
            let file = model.cameras.display();
            let reason = format!("image `{name}` has camera {id}, which is not in {file}");
            return invalid(&model.images, reason);
        };
        let pose = model::camera(&image, intrinsics);
        let camera = match pose.and_then(|camera| camera.check().map(|()| camera)) {
            Ok(camera) => camera,
            Err(reason) => {
                return invalid(&model.images, format!("image `{}`: {reason}", image.name));
            }
        };
        let photograph = |name: &str| find::photograph(folder, name, None, options.downscale);
        let in_images = photograph(&format!("images/{}", image.name));
        match in_images.or_else(|expected| photograph(&image.name).map_err(|_| expected)) {
            Ok(found) => {
                access.check(&found.path)?;
                let held_out = is_held_out(position, options.hold_out_every);
                listing.add(found, camera, intrinsics.lens, held_out, options, access)?;
            }
            Err(expected) => listing.missing.push(expected),
        }
    }
    listing.points = points.into_iter().map(|(_, point)| point).collect();
    listing.points_file = Some(model.points.clone());
    if let Some((index, point)) = listing.points.iter().enumerate().find(|(_, p)| !is_finite(p)) {
        let position = point.position;
        let reason = format!("point {index} is at {position:?}, expected finite coordinates");
        return invalid(&model.points, reason);
    }
    Ok(listing)
}

fn read(model: &Model) -> Result<(Cameras, Vec<Image>, Points)> {
    let Model { cameras, images, points, is_binary } = model;
    let (cameras_file, length) = open_regular(cameras)?;
    let cameras = match is_binary {
        true => binary::cameras(cameras_file, length, cameras)?,
        false => text::cameras(cameras_file, cameras)?,
    };
    let (images_file, length) = open_regular(images)?;
    let images = match is_binary {
        true => binary::images(images_file, length, images)?,
        false => text::images(images_file, images)?,
    };
    // A model without points still has cameras, and training can start from other points.
    let points = match (points.exists().then(|| open_regular(points)).transpose()?, is_binary) {
        (Some((file, length)), true) => binary::points(file, length, points)?,
        (Some((file, _)), false) => text::points(file, points)?,
        (None, _) => Vec::new(),
    };
    let read = (cameras, images, points);
    if read.1.is_empty() {
        return invalid(&model.images, "the model has no images; did COLMAP finish?".to_owned());
    }
    Ok(read)
}

fn is_finite(point: &Point) -> bool {
    point.position.iter().all(|&value| (value as f32).is_finite())
}

/// Reads bytes as each file of a model, for `data::fuzz`.
pub(super) fn fuzz(bytes: &[u8], path: &Path) {
    let source = || std::io::Cursor::new(bytes);
    let length = bytes.len() as u64;
    let _ = binary::cameras(source(), length, path);
    let _ = binary::points(source(), length, path);
    let _ = text::cameras(source(), path);
    let _ = text::points(source(), path);
    let images = [binary::images(source(), length, path), text::images(source(), path)];
    let lenses = model::Lenses::from_name("PINHOLE");
    let camera = lenses.and_then(|lenses| lenses.intrinsics([64, 48], &[90.0, 90.0, 32.0, 24.0]));
    for image in images.into_iter().flatten().flatten() {
        let _ = camera.as_ref().map(|camera| model::camera(&image, camera));
    }
}

/// The lens for a model's name and parameters.
#[cfg(test)]
pub(super) fn lens_of(name: &str, values: &[f64]) -> Result<super::lens::Lens, String> {
    model::Lenses::from_name(name)?.intrinsics([64, 48], values).map(|camera| camera.lens)
}
