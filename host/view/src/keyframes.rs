//! Keyframes as files, in the form `cameras.json` of all commands, and the path through them.

use std::path::Path;

use serde::Deserialize;
use serde_json::{Value, json};

use super::message::check;
use organza_core::camera::{Camera, CameraPath, encode, parse};
use organza_core::error::{Result, refuse};
use organza_core::scene::Placement;

/// Most keyframes in a file.
const MAX_KEYFRAMES: usize = 1000;

/// Most cameras in a path.
const MAX_FRAMES: usize = 10_000;

/// A request for a path.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PathRequest {
    keyframes: Vec<Camera>,
    #[serde(rename = "loop")]
    is_closed: bool,
    frames: usize,
}

impl PathRequest {
    /// The cameras along the path. Images have the first keyframe's size.
    pub fn cameras(&self) -> Result<Vec<Camera>> {
        let Self { keyframes, is_closed, frames } = self;
        if *frames > MAX_FRAMES || keyframes.len() > MAX_KEYFRAMES {
            return refuse(format!(
                "a path has at most {MAX_KEYFRAMES} keyframes and {MAX_FRAMES} cameras"
            ));
        }
        keyframes.iter().try_for_each(check)?;
        let Some(first) = keyframes.first() else { return refuse("a path has keyframes") };
        let size = [first.width, first.height];
        let keyframes: Vec<_> = keyframes.iter().map(|camera| camera.with_size(size)).collect();
        Ok(CameraPath::through(&keyframes, *is_closed)?.cameras(*frames))
    }
}

/// Cameras in the page's form.
pub fn listed(cameras: &[Camera]) -> Vec<u8> {
    json!({ "cameras": cameras }).to_string().into_bytes()
}

/// Writes keyframes as a file, in the world where a scene lies.
pub fn write(keyframes: &[Camera], placement: &Placement) -> Result<Vec<u8>> {
    keyframes.iter().try_for_each(check)?;
    encode(&keyframes.iter().map(|keyframe| placement.world_camera(keyframe)).collect::<Vec<_>>())
}

/// Reads the keyframes of a file: cameras of the world, in any form of a `transforms.json`.
pub fn read(file: &Value, placement: &Placement) -> Result<Vec<u8>> {
    let cameras: Vec<Camera> = parse::cameras(file, Path::new("the file"))?;
    if cameras.len() > MAX_KEYFRAMES {
        let number = cameras.len();
        return refuse(format!(
            "the file has {number} cameras, more than {MAX_KEYFRAMES} keyframes"
        ));
    }
    let own: Vec<_> = cameras.iter().map(|camera| placement.own_camera(camera)).collect();
    Ok(listed(&own))
}
