//! From a photograph's file to the frame that is trained on: decoded, put in front of the
//! background, undistorted and downscaled, one photograph at a time.

use std::path::PathBuf;

use super::budget::Budget;
use super::fingerprint::Digest;
use super::lens::{Lens, Undistortion};
use super::{DatasetOptions, Frame, Photograph, decode, invalid};
use crate::camera::Camera;
use crate::error::Result;
use crate::image::to_8_bit;
use organza_device::memory;

/// A photograph that is there, and how it was taken.
pub(super) struct Shot {
    /// The photograph's path as the data set writes it.
    pub name: String,
    /// Where it was found.
    pub path: PathBuf,
    /// The camera of the whole photograph.
    pub camera: Camera,
    /// What its lens does to the camera's image.
    pub lens: Lens,
    /// Whether the frame is kept from training.
    pub held_out: bool,
}

impl Shot {
    /// Reads the photograph; the digest is that of its file.
    ///
    /// # Errors
    /// [`crate::Error::ReadFile`]; [`crate::Error::Invalid`] for a photograph that cannot be
    /// decoded, is not of the camera's size, or of which no pixel remains;
    /// [`crate::error::DeviceError::OutOfMemory`] for one that does not fit into the budget.
    pub fn develop(&self, options: &DatasetOptions, budget: &Budget) -> Result<(Frame, Digest)> {
        let Camera { width, height, .. } = self.camera;
        let factor = options.downscale;
        if width.min(height) < factor {
            let reason = format!("a downscale of {factor} leaves nothing of {width} x {height}");
            return invalid(&self.path, format!("{reason} pixels; use a smaller one"));
        }
        let (bytes, _share) = decode::read(&self.path, [width, height], budget)?;
        let digest = Digest::of(&bytes);
        let decoded = decode::decode(&bytes, [width, height], &self.path)?;
        let over = |[red, green, blue, alpha]: [f32; 4]| {
            let color = [red, green, blue];
            std::array::from_fn(|i| color[i] * alpha + options.background[i] * (1.0 - alpha))
        };
        let image = self.resample(factor, |x, y| over(decoded.rgba(x, y)))?;
        if image.valid().is_some_and(|valid| !valid.contains(&true)) {
            let reason = "the lens's coefficients leave no pixel of the photograph; check them";
            return invalid(&self.path, reason.to_owned());
        }
        let camera = Camera { distorted: false, ..smaller(&self.camera, factor) };
        Ok((Frame { name: self.name.clone(), camera, image }, digest))
    }

    /// The undistorted, smaller photograph; `texel` is the color of a column and a row of the
    /// original.
    fn resample(&self, factor: u32, texel: impl Fn(u32, u32) -> [f32; 3]) -> Result<Photograph> {
        let Camera { width, height, .. } = smaller(&self.camera, factor);
        let count = width as usize * height as usize;
        let mut pixels = memory::zeros::<[u8; 3]>(count, "a photograph")?;
        let undistortion =
            (!self.lens.is_pinhole()).then(|| Undistortion::new(&self.camera, &self.lens));
        let mut valid = match undistortion {
            Some(_) => memory::zeros(count, "a photograph's mask")?,
            None => Vec::new(),
        };
        let size = [self.camera.width, self.camera.height];
        let sample = |x: u32, y: u32| match &undistortion {
            None => Some(texel(x, y)),
            Some(way) => {
                let source = way.source([f64::from(x) + 0.5, f64::from(y) + 0.5])?;
                Some(bilinear(source, size, &texel))
            }
        };
        for (index, pixel) in pixels.iter_mut().enumerate() {
            let (column, row) = (index as u32 % width, index as u32 / width);
            if let Some(color) = mean([column * factor, row * factor], factor, sample) {
                *pixel = color.map(to_8_bit);
                if let Some(valid) = valid.get_mut(index) {
                    *valid = true;
                }
            }
        }
        Photograph::new([width, height], pixels, undistortion.map(|_| valid))
    }
}

/// The camera of an image of which squares of `factor` by `factor` pixels became one. Places are
/// measured from the image's corner, so everything shrinks alike.
fn smaller(camera: &Camera, factor: u32) -> Camera {
    let scale = f64::from(factor);
    Camera {
        fl_x: camera.fl_x / scale,
        fl_y: camera.fl_y / scale,
        cx: camera.cx / scale,
        cy: camera.cy / scale,
        width: camera.width / factor,
        height: camera.height / factor,
        ..camera.clone()
    }
}

/// The mean of a square of samples; none where one of them is missing.
fn mean(
    [left, top]: [u32; 2],
    factor: u32,
    sample: impl Fn(u32, u32) -> Option<[f32; 3]>,
) -> Option<[f32; 3]> {
    let mut sum = [0.0; 3];
    for y in top..top + factor {
        for x in left..left + factor {
            let color = sample(x, y)?;
            sum.iter_mut().zip(color).for_each(|(sum, value)| *sum += value);
        }
    }
    Some(sum.map(|sum| sum / (factor as f32 * factor as f32)))
}

/// The color between the centers of pixels. Up to half a pixel around them, that of the border.
fn bilinear(place: [f64; 2], size: [u32; 2], texel: &impl Fn(u32, u32) -> [f32; 3]) -> [f32; 3] {
    let [(x, x_next, x_part), (y, y_next, y_part)] = [0, 1].map(|axis| {
        let last = size[axis] - 1;
        let place = (place[axis] - 0.5).clamp(0.0, f64::from(last));
        let first = place as u32;
        (first, (first + 1).min(last), (place - f64::from(first)) as f32)
    });
    let mix = |a: [f32; 3], b: [f32; 3], part: f32| -> [f32; 3] {
        std::array::from_fn(|i| a[i] + part * (b[i] - a[i]))
    };
    let upper = mix(texel(x, y), texel(x_next, y), x_part);
    let lower = mix(texel(x, y_next), texel(x_next, y_next), x_part);
    mix(upper, lower, y_part)
}
