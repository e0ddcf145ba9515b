//! Gaussians for viewers that sort (Kerbl et al., 3D Gaussian Splatting, 2023). Each has an opacity and a color as
//! spherical harmonics. Only the Gaussians in front hide it.
//!
//! A scene also becomes a [`Mesh`].
//!
//! Use it through the crate [`organza`](https://crates.io/crates/organza), whose module `splats` also makes scenes of
//! such Gaussians.

mod distill;
mod files;
mod first;
mod fitted;
mod harmonics;
mod kept;
mod mesh;
mod placed;
mod sorted;
mod sorted_backward;
mod views;

pub use distill::{Distilled, Fit, distill, psnr};
pub use files::{Format, MeshFormat, SplatFile, base_color, load, read_from, save, save_mesh};
pub use fitted::PHOTOGRAPHS;
pub use mesh::Mesh;
pub use placed::save_scene;
pub use sorted::render;
pub use views::{Views, bounds};

use bytemuck::{Pod, Zeroable};
use harmonics::HARMONICS;

/// One Gaussian, in world space, or in a scene's own. The fit can change every value.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Splat {
    /// Center, in world units.
    pub position: [f32; 3],
    /// Quaternion w x y z, of any length but 0.
    pub rotation: [f32; 4],
    /// Natural logarithms of the standard deviations along the rotated axes, in world units.
    pub log_scale: [f32; 3],
    /// Logit of the opacity.
    pub opacity: f32,
    /// Red, green and blue of each harmonic. The color is 0.5 plus the sum of these times the harmonics of the
    /// direction from the eye to the center, and at least 0.
    pub color: [[f32; 3]; HARMONICS],
}

/// Number of values of a [`Splat`].
const VALUES: usize = size_of::<Splat>() / size_of::<f32>();
