//! What COLMAP found, for those who judge it.

use std::path::{Path, PathBuf};

use super::{largest, numbered, read};
use organza_core::camera::Camera;
use organza_core::error::Result;

/// A sparse model of COLMAP, as it stands.
#[derive(Clone, Debug)]
pub struct SparseModel {
    /// The model's folder.
    pub folder: PathBuf,
    /// The images that have a pose, sorted by name. A camera's `file_path` is the name.
    pub cameras: Vec<Camera>,
    /// Number of points.
    pub points: usize,
    /// Mean number of images that see a point; 0 without points.
    pub mean_track: f64,
    /// Mean distance, in pixels, between where images see a point and where they should; 0 if unknown.
    pub mean_error: f64,
}

impl SparseModel {
    /// The model with the most images in the numbered folders that COLMAP's mapper has written; `None` if there is none.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::error::Error::Invalid) if a file of the model is damaged.
    pub fn largest(folder: &Path) -> Result<Option<Self>> {
        let Some(model) = largest(numbered(folder)) else { return Ok(None) };
        let (cameras, ..) = read(&model)?;
        let points = model.supported_points()?;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
        let tracks: Vec<_> = points.iter().map(|(.., support)| support.images as f64).collect();
        let errors = points.iter().map(|(.., support)| support.error);
        let errors: Vec<_> = errors.filter(|error| *error >= 0.0).collect();
        Ok(Some(Self {
            folder: model.folder,
            cameras: cameras.into_iter().map(|(camera, _)| camera).collect(),
            points: points.len(),
            mean_track: mean(&tracks),
            mean_error: mean(&errors),
        }))
    }
}
