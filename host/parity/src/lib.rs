//! The test case of every kernel: one file per stage, with the names of `shader-crate`.
//!
//! A case implements [`Parity`](muslin_check::Parity): it has random inputs, inputs that break careless code, and the equation. The
//! equation is computed in [`Rounded`](muslin_check::number::Rounded): f64 numbers that carry the error that f32 arithmetic may have. So
//! it also gives the tolerance. A kernel without a case fails a test.
//!
//! `adam.rs` is a short case to begin with, and `docs/adding-a-kernel.md` writes one.

mod adam;
mod binned;
mod channels;
mod color;
mod color_backward;
mod composite;
mod composite_backward;
mod count;
mod dense;
mod dense_backward;
mod dense_weight_backward;
pub mod exact;
mod exposure;
mod hash_grid;
mod hash_grid_backward;
mod hash_grid_half;
mod hash_grid_scale;
mod loss;
mod occupancy;
mod pair;
mod pixels;
mod pose_backward;
pub mod project;
pub mod project_backward;
mod resolve;
mod scan;
pub mod segment;
mod slope;
mod splat;
mod ssim;
mod statistics;
mod steps;
mod target;
pub mod tile;
mod tile_cells;
mod transmittance;
mod transmittance_backward;

use muslin_check::Case;

/// The case of every kernel, with the kit's own: `case!` registers it.
pub fn cases() -> Vec<Case> {
    let mut cases = muslin_check::cases(env!("CARGO_PKG_NAME"));
    cases.extend(muslin_check::cases("muslin-check"));
    cases
}
