//! Losses of rendered tiles: of the image with exposures, and a caller's own.

pub mod compare;
pub mod exposure;
pub mod image;
pub mod own;
