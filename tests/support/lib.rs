//! Parts that the tests share: the reference's cases, devices and comparisons.

pub mod cases;
pub mod compare;
pub mod devices;
