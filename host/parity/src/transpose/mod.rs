//! Holds backward kernels to their forward kernels, whatever the equations: `<J v, u> = <v, J^T u>`, where both have the inputs of
//! the backward kernel's case. [`table`] has a row for each of them.
//!
//! Four forward kernels take all that they differentiate through lanes: [`lanes`] has their slopes in f64, and holds them to 1e-6.
//! The others read vectors, or share a number among all pixels: [`networks`], [`splats`] and [`images`] have their slopes by differences of the kernel itself.
//!
//! Some kernels of gradients have no row:
//!
//! - `distortion_backward` has no forward kernel: nobody needs the distortion itself.
//! - `hash_grid_gradient` and `binned_gradient` turn sums of integers into floats, and `adam` takes a step: none is a derivative.
//! - `hash_grid_peak`, `hash_grid_norm` and `hash_grid_scale` find a bound.

mod images;
mod lanes;
mod networks;
mod splats;
mod table;
