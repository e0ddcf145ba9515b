//! Other ways to look at a scene: from one place, as a plan for a browser, pixel by pixel, and what Gaussians contribute.

pub mod contribution;
pub mod eye;
pub mod frame;
pub mod leakage;
pub mod members;
pub mod pixel;
