//! nerfstudio's `transforms.json`, and Blender's pair of them.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::develop::Shot;
use super::lens::Lens;
use super::reach::Reach;
use super::{DatasetKind, Listing, decode, invalid, is_held_out, ply};
use crate::camera::parse::{PERSPECTIVE_MODELS, PINHOLE_MODELS, Source, frames};
use crate::camera::{Camera, camera_error};
use crate::error::Result;
use crate::input::{kind, read_json};

/// The file by which Blender's data sets are known.
pub(super) const BLENDER_TRAIN: &str = "transforms_train.json";
const BLENDER_TEST: &str = "transforms_test.json";
/// What a frame's `file_path` may lack.
const EXTENSIONS: [&str; 4] = ["", ".png", ".jpg", ".jpeg"];

/// How a data set's photographs are found and measured.
pub(super) struct Photographs {
    /// The one that a frame names, in a folder, or else where it should have been.
    pub find: fn(&Path, &str) -> Result<PathBuf, PathBuf>,
    /// Its width and height in pixels.
    pub size: fn(&Path) -> Result<[u32; 2]>,
}

const ON_DISK: Photographs = Photographs { find, size: decode::size };

/// What nerfstudio's file at `path` holds.
pub(super) fn nerfstudio(path: &Path, hold_out_every: usize, reach: &mut Reach) -> Result<Listing> {
    let mut listing =
        Listing { kind: DatasetKind::Nerfstudio, shots: vec![], missing: vec![], points: vec![] };
    let file = read_json(path)?;
    let held_out = |position| is_held_out(position, hold_out_every);
    add_frames(&file, path, &mut listing, held_out, reach, &ON_DISK)?;
    listing.points = match file.get("ply_file_path") {
        None | Some(Value::Null) => Vec::new(),
        Some(Value::String(points)) => {
            let points = folder(path).join(points);
            reach.check(&points)?;
            ply::read(&points)?
        }
        Some(other) => {
            let reason = format!("`ply_file_path` is {}, expected a path", kind(other));
            return invalid(path, reason);
        }
    };
    Ok(listing)
}

/// What Blender's files hold; `train` is the first of them.
pub(super) fn blender(train: &Path, hold_out_every: usize, reach: &mut Reach) -> Result<Listing> {
    let mut listing =
        Listing { kind: DatasetKind::Blender, shots: vec![], missing: vec![], points: vec![] };
    let test = train.with_file_name(BLENDER_TEST);
    let has_test = test.exists();
    let held_out = |position| !has_test && is_held_out(position, hold_out_every);
    add_frames(&read_json(train)?, train, &mut listing, held_out, reach, &ON_DISK)?;
    if has_test {
        add_frames(&read_json(&test)?, &test, &mut listing, |_| true, reach, &ON_DISK)?;
    }
    Ok(listing)
}

/// Adds the frames of a file at `path` to a listing; `held_out` decides by the position in the file.
pub(super) fn add_frames(
    file: &Value,
    path: &Path,
    listing: &mut Listing,
    held_out: impl Fn(usize) -> bool,
    reach: &mut Reach,
    photographs: &Photographs,
) -> Result<()> {
    for (index, frame) in frames(file, path)?.iter().enumerate() {
        let name = name(frame).map_err(|reason| camera_error(path, index, reason))?;
        let photograph = match (photographs.find)(folder(path), name) {
            Ok(photograph) => photograph,
            Err(expected) => {
                listing.missing.push(expected);
                continue;
            }
        };
        reach.check(&photograph)?;
        let mut source = Source { file, frame, size: None };
        // Blender's files leave it to the photographs how large they are.
        if source.get("w").is_none() || source.get("h").is_none() {
            source.size = Some((photographs.size)(&photograph)?);
        }
        let camera = source.valid_camera(index, path)?;
        let lens = lens(&source).map_err(|reason| camera_error(path, index, reason))?;
        let camera = Camera { file_path: Some(name.to_owned()), ..camera };
        let held_out = held_out(index);
        listing.shots.push(Shot {
            name: name.to_owned(),
            path: photograph,
            camera,
            lens,
            held_out,
        });
    }
    Ok(())
}

fn name(frame: &Value) -> Result<&str, String> {
    match frame.get("file_path") {
        Some(Value::String(name)) if !name.is_empty() => Ok(name),
        Some(Value::String(_)) => Err("`file_path` is empty, expected a photograph's path".into()),
        Some(other) => Err(format!("`file_path` is {}, expected a path", kind(other))),
        None => Err("`file_path` is missing; a frame names its photograph with it".into()),
    }
}

/// The photograph that a frame names, or else where it should have been.
fn find(folder: &Path, name: &str) -> Result<PathBuf, PathBuf> {
    // Files written on Windows have its separator.
    let names = [name.to_owned(), name.replace('\\', "/")];
    let with_extension =
        |name: &String| EXTENSIONS.map(|extension| folder.join(format!("{name}{extension}")));
    let candidates = names.iter().flat_map(with_extension);
    let found = candidates.into_iter().find(|path| path.exists() && !path.is_dir());
    found.ok_or_else(|| folder.join(name))
}

/// What a frame says about its lens.
fn lens(source: &Source<'_>) -> Result<Lens, String> {
    let refuse = |what: String| {
        Err(format!(
            "{what}; the models that are read are {}: undistort the photographs first, and \
             describe them as PINHOLE",
            PERSPECTIVE_MODELS.join(", ")
        ))
    };
    let is_pinhole = match source.get("camera_model") {
        None => false,
        Some(Value::String(model)) if PINHOLE_MODELS.contains(&model.as_str()) => true,
        Some(Value::String(model)) if PERSPECTIVE_MODELS.contains(&model.as_str()) => false,
        Some(Value::String(model)) => {
            return refuse(format!("the camera model {model} is not supported"));
        }
        Some(other) => return Err(format!("`camera_model` is {}, expected a name", kind(other))),
    };
    if source.get("is_fisheye").and_then(Value::as_bool) == Some(true) {
        return refuse("`is_fisheye` is true, and fisheyes are not supported".to_owned());
    }
    if is_pinhole {
        return Ok(Lens::default());
    }
    let value = |key| Ok::<f64, String>(source.number(key)?.unwrap_or_default());
    let k4 = value("k4")?;
    if k4 != 0.0 {
        return refuse(format!("`k4` is {k4}, expected 0: a fourth radial term is not supported"));
    }
    Ok(Lens {
        radial: [value("k1")?, value("k2")?, value("k3")?],
        tangential: [value("p1")?, value("p2")?],
    })
}

fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}
