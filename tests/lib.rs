//! Parts that the tests share: the reference's cases, devices and comparisons.

#[path = "support/cases.rs"]
pub mod cases;
#[path = "support/compare.rs"]
pub mod compare;
#[path = "support/devices.rs"]
pub mod devices;
#[path = "support/spirv.rs"]
pub mod spirv;
