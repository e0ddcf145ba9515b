//! The stages from Gaussians to pixels, one file each, and a part of a batch, which runs them all. The derivative of a stage is
//! in its file if it reads the same tables.

pub mod bin;
pub mod block;
pub mod channels;
pub mod color;
pub mod composite;
pub mod field;
pub mod mask;
pub mod pair;
pub mod part;
pub mod part_counts;
pub mod scan;
pub mod transmittance;
pub mod weighted_sum;
