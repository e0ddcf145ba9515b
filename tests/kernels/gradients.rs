//! Each backward kernel against central differences in f64 of the forward formula.

#[path = "../gradients/color.rs"]
mod color;
#[path = "../gradients/dense.rs"]
mod dense;
#[path = "../gradients/hash_grid.rs"]
mod hash_grid;
#[path = "../gradients/hash_grid_scale.rs"]
mod hash_grid_scale;
#[path = "../gradients/numeric.rs"]
mod numeric;
#[path = "../gradients/transmittance.rs"]
mod transmittance;
