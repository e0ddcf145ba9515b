//! Unit tests of the kernels' functions. They stand apart, because a crate that holds tests is compiled twice, and these kernels
//! take a minute and a half.

mod dense_backward;
mod dense_weight_backward;
mod hash_grid_backward;
mod segment;
mod steps;
mod transmittance_backward;
mod unit_cube;
