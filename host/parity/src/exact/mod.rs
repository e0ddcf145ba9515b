//! The equations in f64, one file per stage. [`Parity::exact`](muslin_check::Parity::exact) of each case calls them, and so do the
//! tests of whole scenes.
//!
//! They are written from docs/pipeline.md, over plain numbers. They share no code and no constant with the kernels.

pub mod adam;
pub mod channels;
pub mod composite;
pub mod dense;
pub mod hash_grid;
pub mod hash_grid_scale;
pub mod loss;
pub mod numeric;
pub mod occupancy;
pub mod project;
pub mod resolve;
pub mod segment;
pub mod slope;
pub mod spherical_harmonics;
pub mod ssim;
pub mod tile;
pub mod transmittance;
pub mod unit_cube;

/// The set bits of words, from the lowest on.
pub(super) fn bits(words: &[u32]) -> impl Iterator<Item = usize> {
    (0..32 * words.len()).filter(|&bit| words[bit / 32] >> (bit % 32) & 1 == 1)
}
