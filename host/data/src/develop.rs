//! Turns a photograph's file into a frame for training: decodes it, composites it over the background, undistorts and
//! downscales it. One photograph at a time.

use std::path::{Path, PathBuf};

use super::fingerprint::Digest;
use super::lens::{Lens, Projection, Undistortion};
use super::{Alpha, DatasetOptions, Frame, Photograph, decode, masks};
use organza_core::error::invalid;
use organza_core::image::to_8_bit;
use organza_core::input::read_file;
use organza_core::memory;
use organza_core::{Camera, Result};

/// An existing photograph, with its camera and lens.
#[derive(Clone)]
pub(super) struct Shot {
    /// Path of the photograph, as the data set writes it.
    pub name: String,
    /// Path of the file that was found.
    pub path: PathBuf,
    /// Path of its mask, if it has one.
    pub mask: Option<PathBuf>,
    /// The camera of the whole photograph, or of the view that is cut from it.
    pub camera: Camera,
    /// The camera's pose in the world, as the files give it.
    pub pose: [[f64; 4]; 4],
    /// Distortion of the camera's image.
    pub lens: Lens,
    /// Factor by which to downscale.
    pub factor: u32,
    /// Whether the frame is held out from training.
    pub held_out: bool,
    /// The digest that the file must have, if a run was trained on it.
    pub trained: Option<Digest>,
}

impl Shot {
    /// Width and height of the photograph's file.
    fn size(&self) -> [u32; 2] {
        self.lens.cut.map_or([self.camera.width, self.camera.height], |cut| cut.size)
    }

    /// How many photographs like this one may be decoded at once in `budget` bytes: at least one.
    ///
    /// # Errors
    /// [`organza_core::Error::ReadFile`]; [`organza_core::error::DeviceError::OutOfMemory`] if it alone takes more.
    pub fn at_once(&self, budget: u64) -> Result<u64> {
        decode::at_once(&self.path, self.mask.as_deref(), self.size(), budget)
    }

    /// Reads the photograph.
    ///
    /// # Errors
    /// [`organza_core::Error::ReadFile`]; [`organza_core::Error::Invalid`] if the photograph or its mask cannot be decoded or has
    /// another size than the camera, or if the lens leaves no pixel.
    pub fn develop(&self, options: &DatasetOptions) -> Result<Developed> {
        let [width, height] = self.size();
        let camera = self.smaller_camera()?;
        let bytes = read_file(&self.path, u64::MAX, "a photograph")?;
        let mask = self.mask.as_ref().map(|path| self.read_mask(path)).transpose()?;
        let digest = Digest::new(&bytes, mask.as_ref().map(|mask| &*mask.file));
        if self.trained.as_ref().is_some_and(|trained| *trained != digest) {
            let reason = "the photograph or its mask has changed since the run was trained; put it back, or name the data set \
                          to take it as it is now";
            return invalid(&self.path, reason.to_owned());
        }
        let decoded = decode::decode(&bytes, [width, height], &self.path, decode::PHOTOGRAPH)?;
        let alpha_hides = options.alpha == Alpha::Mask && decoded.has_alpha();
        let is_masked = mask.as_ref().is_some_and(|mask| mask.used.contains(&false));
        let is_used = |x: u32, y: u32, alpha: f32| {
            let is_hidden = |mask: &Mask| !mask.used[(y * width + x) as usize];
            !(alpha_hides && alpha < 0.5 || mask.as_ref().is_some_and(is_hidden))
        };
        let background = options.background.color();
        let over = |[red, green, blue, alpha]: [f32; 4]| {
            let over = |color: f32, behind: f32| color * alpha + behind * (1.0 - alpha);
            let [r, g, b] = background;
            [over(red, r), over(green, g), over(blue, b), alpha]
        };
        let is_off = decoded.size() != [width, height];
        let texel = |x, y| {
            if is_off && (x >= decoded.size()[0] || y >= decoded.size()[1]) {
                return None;
            }
            let color = decoded.rgba(x, y);
            is_used(x, y, color[3]).then(|| {
                if alpha_hides { [color[0], color[1], color[2], 1.0] } else { over(color) }
            })
        };
        let is_whole = self.lens.is_pinhole() && mask.is_none() && !alpha_hides && !is_off;
        // copy it, if resampling would not change it
        let copied = (is_whole && self.factor == 1).then(|| decoded.colors()).flatten();
        let image = match copied {
            Some(colors) => Photograph::new([width, height], colors, None)?,
            None => self.resample(is_whole, texel)?,
        };
        let may_be_hidden = mask.is_some() || alpha_hides || self.lens.cut.is_some();
        if !may_be_hidden && image.is_hidden() {
            let reason = "the lens's coefficients leave no pixel of the photograph; check them";
            return invalid(&self.path, reason);
        }
        let frame = Frame { name: self.name.clone(), camera, image };
        Ok(Developed { frame, digest, is_masked, is_off })
    }

    /// The camera of the undistorted and downscaled photograph.
    ///
    /// # Errors
    /// [`organza_core::Error::Invalid`] if no pixel is left.
    pub fn smaller_camera(&self) -> Result<Camera> {
        let Camera { width, height, .. } = self.camera;
        if width.min(height) < self.factor {
            let reason =
                format!("a downscale of {} leaves nothing of {width} x {height}", self.factor);
            return invalid(&self.path, format!("{reason} pixels; use a smaller one"));
        }
        Ok(Camera { distorted: false, ..self.camera.smaller(self.factor) })
    }

    fn read_mask(&self, path: &Path) -> Result<Mask> {
        let size = self.size();
        let file = read_file(path, u64::MAX, "a mask")?;
        let decoded = decode::decode(&file, size, path, decode::MASK)?;
        let count = size[0] as usize * size[1] as usize;
        let mut used = memory::zeros::<bool>(count, "a photograph's mask")?;
        let across = decoded.size()[0] as usize;
        let rows = used.chunks_mut(size[0] as usize).enumerate();
        let all: Vec<_> = masks::used(&decoded, path).collect();
        for (y, row) in rows.take(decoded.size()[1] as usize) {
            row.iter_mut().zip(&all[y * across..][..across]).for_each(|(used, is)| *used = *is);
        }
        Ok(Mask { file, used })
    }

    /// The undistorted and downscaled photograph. `texel` is the color and alpha at a column and row of the original,
    /// or `None` if a mask hides it. `is_whole` says that no pixel can be missing.
    fn resample(
        &self,
        is_whole: bool,
        texel: impl Fn(u32, u32) -> Option<[f32; 4]>,
    ) -> Result<Photograph> {
        let factor = self.factor;
        let Camera { width, height, .. } = self.camera.smaller(factor);
        let count = width as usize * height as usize;
        let mut pixels = memory::zeros::<[u8; 3]>(count, "a photograph")?;
        let mut alpha = memory::zeros::<u8>(count, "a photograph's alpha")?;
        let undistortion =
            (!self.lens.is_pinhole()).then(|| Undistortion::new(&self.camera, &self.lens));
        let mut valid = match is_whole {
            false => memory::zeros(count, "a photograph's mask")?,
            true => Vec::new(),
        };
        let [across, down] = self.size();
        let sample = |x: u32, y: u32| {
            let Some(undistortion) = &undistortion else { return texel(x, y) };
            let [x, y] = undistortion.source([f64::from(x) + 0.5, f64::from(y) + 0.5])?;
            if self.lens.projection == Projection::Panorama {
                // The last column is beside the first, so each is there once more, at the other end.
                let around = |x: u32, y: u32| texel((x + across - 1) % across, y);
                return bilinear([x + 1.0, y], [across + 2, down], &around);
            }
            bilinear([x, y], [across, down], &texel)
        };
        for (index, pixel) in pixels.iter_mut().enumerate() {
            let column = index as u32 % width;
            let row = index as u32 / width;
            if let Some(color) = mean([column * factor, row * factor], factor, sample) {
                let [red, green, blue, opaque] = color.map(to_8_bit);
                *pixel = [red, green, blue];
                alpha[index] = opaque;
                if let Some(valid) = valid.get_mut(index) {
                    *valid = true;
                }
            }
        }
        // missing pixels are unknown, not transparent
        for (alpha, _) in alpha.iter_mut().zip(&valid).filter(|(_, valid)| !**valid) {
            *alpha = 255;
        }
        Photograph::new([width, height], pixels, (!is_whole).then_some(valid))?.with_alpha(alpha)
    }
}

/// A photograph that was read.
pub(super) struct Developed {
    pub frame: Frame,
    /// Of the photograph's file and its mask.
    pub digest: Digest,
    /// Whether its mask hides something.
    pub is_masked: bool,
    /// Whether it is a pixel larger or smaller than its camera's image. What is missing is not valid.
    pub is_off: bool,
}

/// A mask's file, and whether each pixel of the photograph is used, row by row.
struct Mask {
    file: Vec<u8>,
    used: Vec<bool>,
}

/// The camera of a photograph that was already made `factor` times smaller, to `size` pixels.
///
/// # Errors
/// An explanation, if `size` differs from the expected one by more than a pixel.
pub(super) fn prepared(camera: &Camera, factor: u32, size: [u32; 2]) -> Result<Camera, String> {
    let whole = [camera.width, camera.height];
    let is_near = |axis: usize| {
        (f64::from(size[axis]) - f64::from(whole[axis]) / f64::from(factor)).abs() < 1.0
    };
    if !(is_near(0) && is_near(1)) {
        let [width, height] = size;
        let [w, h] = whole;
        return Err(format!(
            "the photograph is {width} x {height} pixels, but one of {w} x {h} should be {factor} times smaller; \
             make it again, or remove its folder"
        ));
    }
    let [across, down] = [0, 1].map(|axis| f64::from(size[axis]) / f64::from(whole[axis]));
    Ok(Camera {
        fl_x: camera.fl_x * across,
        fl_y: camera.fl_y * down,
        cx: camera.cx * across,
        cy: camera.cy * down,
        width: size[0],
        height: size[1],
        ..camera.clone()
    })
}

/// The mean of a square of samples; `None` if one of them is missing.
pub fn mean<const CHANNELS: usize>(
    [left, top]: [u32; 2],
    factor: u32,
    sample: impl Fn(u32, u32) -> Option<[f32; CHANNELS]>,
) -> Option<[f32; CHANNELS]> {
    let mut sum = [0.0; CHANNELS];
    for y in top..top + factor {
        for x in left..left + factor {
            let color = sample(x, y)?;
            sum.iter_mut().zip(color).for_each(|(sum, value)| *sum += value);
        }
    }
    Some(sum.map(|sum| sum / (factor as f32 * factor as f32)))
}

/// The bilinearly interpolated color at a place; `None` if one of the pixels is hidden. Up to half a pixel outside,
/// it is the color of the border.
fn bilinear(
    place: [f64; 2],
    size: [u32; 2],
    texel: &impl Fn(u32, u32) -> Option<[f32; 4]>,
) -> Option<[f32; 4]> {
    let [(x, x_next, x_part), (y, y_next, y_part)] = [0, 1].map(|axis| {
        let last = size[axis] - 1;
        let place = (place[axis] - 0.5).clamp(0.0, f64::from(last));
        let first = place as u32;
        (first, (first + 1).min(last), (place - f64::from(first)) as f32)
    });
    let upper = mix(texel(x, y)?, texel(x_next, y)?, x_part);
    let lower = mix(texel(x, y_next)?, texel(x_next, y_next)?, x_part);
    Some(mix(upper, lower, y_part))
}

/// Interpolates linearly: `a` where `part` is 0, and `b` where it is 1.
fn mix(a: [f32; 4], b: [f32; 4], part: f32) -> [f32; 4] {
    std::array::from_fn(|i| a[i] + part * (b[i] - a[i]))
}
