//! Requests of the page.

use serde::{Deserialize, Serialize};

use organza_core::error::refuse;
use organza_core::{Camera, Result};

/// Largest side of an image, in pixels.
pub const MAX_SIDE: u32 = 4096;

/// The content of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    Color,
    /// The mean of T, weighted.
    Visibility,
    /// S, the sum of weights in Eq. 12.
    Weight,
    Depth,
    Normal,
    /// Number of Gaussians in the pixel's sum.
    Gaussians,
    /// The difference from the photograph.
    Error,
}

/// The quality of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Quality {
    /// The camera moves: a small image with long steps, quickly.
    Moving,
    /// Every pixel, with long steps.
    Still,
    /// The same image as `organza render`.
    Exact,
}

/// A request for an image.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FrameRequest {
    /// Random number of the page.
    pub client: u64,
    /// Number of the request on the page: a higher one is newer.
    pub sequence: u64,
    pub camera: Camera,
    pub mode: Mode,
    pub quality: Quality,
    /// Replaces the scene's background.
    #[serde(default)]
    pub background: Option<[f64; 3]>,
    /// View in the data set whose photograph is compared.
    #[serde(default)]
    pub view: Option<usize>,
}

/// A request to explain a pixel.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PixelRequest {
    pub camera: Camera,
    /// Column and row of the pixel.
    pub pixel: [i32; 2],
}

/// Checks a camera, and its image's size.
pub fn check(camera: &Camera) -> Result<()> {
    camera.validate(0)?;
    if camera.width.max(camera.height) > MAX_SIDE {
        let width = camera.width;
        let height = camera.height;
        return refuse(format!(
            "an image of {width} x {height} pixels is too large to view: {MAX_SIDE} a side are allowed"
        ));
    }
    Ok(())
}

impl FrameRequest {
    /// Checks the background, and then the camera.
    pub fn check(&self) -> Result<()> {
        let is_color = |color: [f64; 3]| color.iter().all(|value| (0.0..=1.0).contains(value));
        if !self.background.is_none_or(is_color) {
            return refuse("a background has red, green and blue of 0 to 1");
        }
        check(&self.camera)
    }
}
