//! Reads nerfstudio's `transforms.json`, and Blender's pair of such files.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::access::Access;
use super::find::{self, Found};
use super::lens::Lens;
use super::panorama::is_panorama;
use super::{
    DatasetKind, DatasetOptions, Listing, colmap_points, decode, invalid, is_held_out, ply,
};
use organza_core::camera::parse::{PANORAMA, PERSPECTIVE_MODELS, PINHOLE_MODELS, Source, frames};
use organza_core::camera::{Camera, camera_error};
use organza_core::error::Result;
use organza_core::input::{kind, read_json};

/// Name of the file that marks a nerfstudio data set.
pub(super) const NERFSTUDIO: &str = "transforms.json";
/// Name of the file that marks a Blender data set.
pub(super) const BLENDER_TRAIN: &str = "transforms_train.json";
const BLENDER_TEST: &str = "transforms_test.json";
/// Camera model of nerfstudio's fisheyes, for which instant-ngp writes `is_fisheye`.
const FISHEYE: &str = "OPENCV_FISHEYE";

/// Functions that find and measure a data set's photographs.
pub(super) struct Photographs {
    /// Finds a photograph: see [`find::photograph`].
    pub find: fn(&Path, &str, Option<&str>, u32) -> Result<Found, PathBuf>,
    /// Width and height of a photograph in pixels.
    pub size: fn(&Path) -> Result<[u32; 2]>,
}

const ON_DISK: Photographs = Photographs { find: find::photograph, size: decode::size };

/// Reads nerfstudio's file at `path`.
pub(super) fn nerfstudio(
    path: &Path,
    options: &DatasetOptions,
    access: &mut Access,
) -> Result<Listing> {
    let mut listing = Listing { kind: DatasetKind::Nerfstudio, ..Listing::default() };
    let file = read_json(path)?;
    let held_out = |position| is_held_out(position, options.hold_out_every);
    add_frames(&file, path, &mut listing, held_out, options, access, &ON_DISK)?;
    add_points(&file, path, &mut listing, access)?;
    Ok(listing)
}

/// Adds the points to start from: those of the file's point cloud, or else those of a COLMAP model.
fn add_points(file: &Value, path: &Path, listing: &mut Listing, access: &mut Access) -> Result<()> {
    match file.get("ply_file_path") {
        None | Some(Value::Null) => {}
        Some(Value::String(points)) => {
            let points = find::named(folder(path), points);
            access.check(&points)?;
            listing.points = ply::read(&points)?;
            listing.points_file = Some(points);
            return Ok(());
        }
        Some(other) => {
            let reason = format!("`ply_file_path` is {}, expected a path", kind(other));
            return invalid(path, reason);
        }
    }
    match colmap_points::points(folder(path), listing) {
        Ok(None) => {}
        Ok(Some((points, file))) => {
            listing.points = points;
            listing.points_file = Some(file);
        }
        Err(reason) => listing.notes.push(reason),
    }
    if listing.points.is_empty() {
        let reason = format!("{} does not name it as `ply_file_path`", path.display());
        listing.notes.extend(find::unused_clouds(folder(path), &reason));
    }
    Ok(())
}

/// Reads Blender's files; `train` is the first of them.
pub(super) fn blender(
    train: &Path,
    options: &DatasetOptions,
    access: &mut Access,
) -> Result<Listing> {
    let mut listing = Listing { kind: DatasetKind::Blender, ..Listing::default() };
    let test = train.with_file_name(BLENDER_TEST);
    let has_test = test.exists();
    let held_out = |position| !has_test && is_held_out(position, options.hold_out_every);
    let file = read_json(train)?;
    add_frames(&file, train, &mut listing, held_out, options, access, &ON_DISK)?;
    add_points(&file, train, &mut listing, access)?;
    if has_test {
        add_frames(&read_json(&test)?, &test, &mut listing, |_| true, options, access, &ON_DISK)?;
    }
    Ok(listing)
}

/// Adds the frames of a file at `path` to a listing. `held_out` decides by the position in the file.
pub(super) fn add_frames(
    file: &Value,
    path: &Path,
    listing: &mut Listing,
    held_out: impl Fn(usize) -> bool,
    options: &DatasetOptions,
    access: &mut Access,
    photographs: &Photographs,
) -> Result<()> {
    for (index, frame) in frames(file, path)?.iter().enumerate() {
        let name = name(frame).map_err(|reason| camera_error(path, index, reason))?;
        let mask = mask(frame).map_err(|reason| camera_error(path, index, reason))?;
        let mut source = Source { file, frame, size: None };
        let has_size = source.get("w").is_some() && source.get("h").is_some();
        // A smaller photograph has a camera only if the file gives the size of the whole one.
        let downscale = if has_size { options.downscale } else { 1 };
        let found = match (photographs.find)(folder(path), name, mask, downscale) {
            Ok(found) => found,
            Err(expected) => {
                listing.missing.push(expected);
                continue;
            }
        };
        access.check(&found.path)?;
        // Blender's files give no image size, so it is read from the photographs.
        if !has_size {
            source.size = Some((photographs.size)(&found.path)?);
        }
        let camera = source.valid_camera(index, path)?;
        let lens = lens(&source).map_err(|reason| camera_error(path, index, reason))?;
        let Camera { width, height, .. } = camera;
        if lens.panorama && !is_panorama([width, height]) {
            let reason = format!(
                "has {width} x {height} pixels, but a panorama of 360 degrees is twice as wide as high"
            );
            return Err(camera_error(path, index, reason));
        }
        let camera = Camera { file_path: Some(name.to_owned()), ..camera };
        listing.add(found, camera, lens, held_out(index), options, access)?;
    }
    Ok(())
}

/// The path of a frame's mask.
fn mask(frame: &Value) -> Result<Option<&str>, String> {
    match frame.get("mask_path") {
        None | Some(Value::Null) => Ok(None),
        Some(Value::String(mask)) if !mask.is_empty() => Ok(Some(mask)),
        Some(other) => Err(format!("`mask_path` is {}, expected a path", kind(other))),
    }
}

fn name(frame: &Value) -> Result<&str, String> {
    match frame.get("file_path") {
        Some(Value::String(name)) if !name.is_empty() => Ok(name),
        Some(Value::String(_)) => Err("`file_path` is empty, expected a photograph's path".into()),
        Some(other) => Err(format!("`file_path` is {}, expected a path", kind(other))),
        None => Err("`file_path` is missing; a frame names its photograph with it".into()),
    }
}

/// The lens of a frame.
fn lens(source: &Source<'_>) -> Result<Lens, String> {
    let is_fisheye = source.get("is_fisheye").and_then(Value::as_bool) == Some(true);
    let fisheye = match source.get("camera_model") {
        None => is_fisheye,
        Some(Value::String(model)) if PINHOLE_MODELS.contains(&model.as_str()) => {
            return Ok(Lens::default());
        }
        Some(Value::String(model)) if PERSPECTIVE_MODELS.contains(&model.as_str()) => is_fisheye,
        Some(Value::String(model)) if model == FISHEYE => true,
        Some(Value::String(model)) if model == PANORAMA => {
            return Ok(Lens { panorama: true, ..Lens::default() });
        }
        Some(Value::String(model)) => {
            return Err(format!(
                "the camera model {model} is not supported; the models that are read are {}, \
                 {FISHEYE} and {PANORAMA}: undistort the photographs first, and describe them as PINHOLE",
                PERSPECTIVE_MODELS.join(", ")
            ));
        }
        Some(other) => return Err(format!("`camera_model` is {}, expected a name", kind(other))),
    };
    let value = |key| Ok::<f64, String>(source.number(key)?.unwrap_or_default());
    let k3 = value("k3")?;
    let k4 = value("k4")?;
    let k5 = value("k5")?;
    let k6 = value("k6")?;
    // In OpenCV's model, k4 is a part of a denominator. In nerfstudio's other models, it is one more radial term.
    let is_full = source.get("camera_model").and_then(Value::as_str) == Some("FULL_OPENCV");
    let (k4, denominator) = if is_full { (0.0, [k4, k5, k6]) } else { (k4, [0.0; 3]) };
    let tangential = if fisheye { [0.0; 2] } else { [value("p1")?, value("p2")?] };
    let radial = [value("k1")?, value("k2")?, k3, k4];
    Ok(Lens { fisheye, radial, denominator, tangential, ..Lens::default() })
}

fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// The lens of a file, for frames without their own.
#[cfg(test)]
pub(super) fn lens_of(file: &Value) -> Result<Lens, String> {
    lens(&Source { file, frame: &Value::Null, size: None })
}
