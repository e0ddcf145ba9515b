//! Losses of rendered tiles: of the image, with exposures, beside the image, and a caller's own.

pub mod compare;
pub mod distortion;
pub mod exposure;
pub mod image;
pub mod own;
