//! The pixels of a photograph, and their validity. The other parts of a data set.

use std::fmt;

use organza_core::error::argument;
use organza_core::{Camera, Image, Result};

/// An image of 8-bit red, green and blue as sRGB values.
///
/// Undistorting may leave pixels outside of the photograph. These are not valid: training and comparisons must ignore
/// them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Photograph {
    width: u32,
    height: u32,
    /// Colors, row by row.
    pixels: Vec<[u8; 3]>,
    /// Validity, row by row; `None` if all pixels are valid.
    valid: Option<Vec<bool>>,
    /// Alpha, row by row; `None` if all pixels are opaque.
    alpha: Option<Vec<u8>>,
}

impl Photograph {
    /// A photograph of `[width, height]` pixels, row by row. `valid` has a value for each pixel; without it, all are
    /// valid.
    ///
    /// # Errors
    /// [`Error::Argument`](organza_core::Error::Argument) if the lengths do not match the size.
    pub fn new(
        [width, height]: [u32; 2],
        pixels: Vec<[u8; 3]>,
        valid: Option<Vec<bool>>,
    ) -> Result<Self> {
        let count = u64::from(width) * u64::from(height);
        let lengths = [Some(pixels.len()), valid.as_ref().map(Vec::len)];
        if let Some(length) = lengths.into_iter().flatten().find(|&len| len as u64 != count) {
            return argument(format!(
                "a photograph of {width} x {height} has {count} pixels, not {length}"
            ));
        }
        let valid = valid.filter(|valid| valid.contains(&false));
        Ok(Self { width, height, pixels, valid, alpha: None })
    }

    /// Adds the alpha of every pixel, row by row, from 0 to 255. The pixels must already contain the background.
    ///
    /// # Errors
    /// [`Error::Argument`](organza_core::Error::Argument) if the length does not match the size.
    pub fn with_alpha(mut self, alpha: Vec<u8>) -> Result<Self> {
        let count = self.pixels.len();
        if alpha.len() != count {
            return argument(format!(
                "a photograph of {count} pixels has {} of alpha",
                alpha.len()
            ));
        }
        self.alpha = alpha.iter().any(|&alpha| alpha < 255).then_some(alpha);
        Ok(self)
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Red, green and blue of every pixel, row by row. Invalid pixels are black.
    pub fn pixels(&self) -> &[[u8; 3]] {
        &self.pixels
    }

    /// Whether each pixel is valid, row by row; `None` if all are.
    pub fn valid(&self) -> Option<&[bool]> {
        self.valid.as_deref()
    }

    /// Whether every pixel is valid.
    pub fn all_valid(&self) -> bool {
        self.valid.is_none()
    }

    /// Whether no pixel is valid.
    pub fn is_hidden(&self) -> bool {
        self.valid().is_some_and(|valid| !valid.contains(&true))
    }

    /// Whether the pixel in column `x` and row `y` is valid.
    ///
    /// # Panics
    /// If the pixel is outside the photograph.
    pub fn is_valid(&self, x: u32, y: u32) -> bool {
        let index = self.index(x, y);
        self.valid.as_ref().is_none_or(|valid| valid[index])
    }

    /// Red, green and blue of the pixel in column `x` and row `y`, from 0 to 1.
    ///
    /// # Panics
    /// If the pixel is outside the photograph.
    pub fn color(&self, x: u32, y: u32) -> [f32; 3] {
        self.pixels[self.index(x, y)].map(|value| f32::from(value) / 255.0)
    }

    /// Alpha in the photograph's file of the pixel in column `x` and row `y`, from 0 to 1.
    ///
    /// # Panics
    /// If the pixel is outside the photograph.
    pub fn alpha(&self, x: u32, y: u32) -> f32 {
        let index = self.index(x, y);
        self.alpha.as_ref().map_or(1.0, |alpha| f32::from(alpha[index]) / 255.0)
    }

    fn index(&self, x: u32, y: u32) -> usize {
        assert!(x < self.width && y < self.height, "pixel {x},{y} is outside the photograph");
        y as usize * self.width as usize + x as usize
    }
}

/// A rendered image, in which all pixels are valid.
impl From<&Image> for Photograph {
    fn from(image: &Image) -> Self {
        let [width, height] = image.size();
        Self { width, height, pixels: image.pixels().to_vec(), valid: None, alpha: None }
    }
}

/// The format of a data set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DatasetKind {
    /// nerfstudio's `transforms.json`.
    Nerfstudio,
    /// `transforms_train.json` and `transforms_test.json`, like NeRF's synthetic scenes.
    Blender,
    /// A sparse model of COLMAP.
    Colmap,
    /// Frames that the caller made.
    #[default]
    Generated,
}

impl fmt::Display for DatasetKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Nerfstudio => "nerfstudio",
            Self::Blender => "Blender",
            Self::Colmap => "COLMAP",
            Self::Generated => "generated",
        })
    }
}

/// A photograph and its camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Path of the photograph, as the data set writes it.
    pub name: String,
    /// The pinhole camera of `image`: undistorted, and of its size.
    pub camera: Camera,
    /// The photograph, undistorted and downscaled.
    pub image: Photograph,
}

/// A point from which training may start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Position in world units, finite in f32.
    pub position: [f64; 3],
    /// Red, green and blue as sRGB values, if the data set has them.
    pub color: Option<[u8; 3]>,
}
