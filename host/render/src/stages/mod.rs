//! The stages from Gaussians to pixels, one file each: a stage's derivative is in its file.

pub mod channels;
pub mod color;
pub mod composite;
pub mod counts;
pub mod cut;
pub mod field;
pub mod pairs;
pub mod project;
pub mod scan;
pub mod tiles;
pub mod transmittance;
