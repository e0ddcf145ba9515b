//! Other queries of a scene: views from one place, a plan for a browser, single pixels, surfaces, and the contributions of Gaussians.

pub mod contribution;
pub mod eye;
pub mod frame;
pub mod pixel;
pub mod pixel_gaussians;
pub mod surface;
