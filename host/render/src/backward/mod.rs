//! From the gradient of the pixels back to the gradients of all tensors, and the losses that begin it.

pub mod binned;
pub mod compare;
pub mod distortion;
pub mod exposure;
pub mod field_backward;
pub mod field_sums;
pub mod gradient;
pub mod hash_grid;
pub mod loss;
pub mod own_loss;
pub mod part_backward;
pub mod pose;
pub mod project;
pub mod recording_backward;
pub mod rows;
pub mod step;
