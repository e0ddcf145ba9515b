//! Parts of a data set.

use std::fmt;

use super::Photograph;
use organza_core::camera::Camera;

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
