//! Keyframes as files: `cameras.json` as every other command reads it.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::message::{Lens, checked, refuse};
use crate::camera::{Camera, CameraPath, file_of, parse};
use crate::error::Result;

/// Keyframes that are read from a file.
const MAX_KEYFRAMES: usize = 1000;

/// Cameras of a path.
const MAX_FRAMES: usize = 10_000;

#[derive(Serialize)]
struct Cameras {
    cameras: Vec<Lens>,
}

/// A path that the page asks for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PathRequest {
    keyframes: Vec<Lens>,
    #[serde(rename = "loop")]
    is_closed: bool,
    frames: usize,
}

/// The cameras along a path through keyframes.
pub fn path(request: &[u8]) -> Result<Vec<u8>> {
    let PathRequest { keyframes, is_closed, frames } = match serde_json::from_slice(request) {
        Ok(request) => request,
        Err(error) => return refuse(format!("a path has keyframes: {error}")),
    };
    if frames > MAX_FRAMES || keyframes.len() > MAX_KEYFRAMES {
        return refuse(format!(
            "a path has at most {MAX_KEYFRAMES} keyframes and {MAX_FRAMES} cameras"
        ));
    }
    let keyframes = keyframes.iter().map(checked).collect::<Result<Vec<_>>>()?;
    listed(&CameraPath::through(&keyframes, is_closed)?.cameras(frames))
}

fn listed(cameras: &[Camera]) -> Result<Vec<u8>> {
    let cameras = Cameras { cameras: cameras.iter().map(Lens::from).collect() };
    serde_json::to_vec(&cameras).or_else(|error| refuse(error.to_string()))
}

/// The file of some keyframes.
pub fn write(keyframes: &[u8]) -> Result<Vec<u8>> {
    let lenses: Vec<Lens> = match serde_json::from_slice(keyframes) {
        Ok(lenses) => lenses,
        Err(error) => return refuse(format!("keyframes are a list of cameras: {error}")),
    };
    let cameras = lenses.iter().map(checked).collect::<Result<Vec<_>>>()?;
    file_of(&cameras)
}

/// The keyframes of a file: cameras in any form that a `transforms.json` has.
pub fn read(file: &[u8]) -> Result<Vec<u8>> {
    let value: Value = match serde_json::from_slice(file) {
        Ok(value) => value,
        Err(error) => return refuse(format!("the file is not JSON: {error}")),
    };
    let cameras: Vec<Camera> = parse::cameras(&value, Path::new("the file"))?;
    if cameras.len() > MAX_KEYFRAMES {
        let number = cameras.len();
        return refuse(format!(
            "the file has {number} cameras, more than {MAX_KEYFRAMES} keyframes"
        ));
    }
    listed(&cameras)
}
