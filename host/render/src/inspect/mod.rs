//! The outputs of single stages, where the weight of a pixel lies, and what Gaussians contribute.

pub mod contribution;
pub mod inspection;
pub mod leakage;
pub mod members;
