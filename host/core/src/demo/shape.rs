//! The common parts of the built-in scene's pieces: their sizes, and how a Gaussian of each kind looks.

use glam::Vec3;

/// Half the side of the scene's box, which is a cube around the origin.
pub const HALF_BOX: f32 = 1.2;
/// Radius of the pearl.
pub const PEARL: f32 = 0.42;
/// Height of the floor. Only its shadows are visible.
pub const FLOOR: f32 = -0.78;
/// Warm paper.
pub const BACKGROUND: [f64; 3] = [0.965, 0.955, 0.94];

/// Signed distance from the pearl, negative inside.
pub fn pearl_distance(position: Vec3) -> f32 {
    position.length() - PEARL
}

/// Smooth step: 0 below 0, 1 above 1, `x^2 (3 - 2x)` between.
pub fn smoothstep(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Values of a material: three logits, the normal, whether it is cloth, whether it is the pearl.
pub const MATERIAL: usize = 8;

/// The kind of surface that a Gaussian belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceKind {
    Cloth,
    Pearl,
    Floor,
}

/// The appearance of a Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    pub color: Vec3,
    pub normal: Vec3,
    pub kind: SurfaceKind,
}

impl Material {
    /// The Gaussian's material vector.
    pub fn values(&self) -> [f32; MATERIAL] {
        let [r, g, b] = self.color.to_array().map(logit);
        let Vec3 { x, y, z } = self.normal;
        let is = |kind| f32::from(u8::from(self.kind == kind));
        [r, g, b, x, y, z, is(SurfaceKind::Cloth), is(SurfaceKind::Pearl)]
    }
}

/// The inverse of the sigmoid; probabilities are clamped away from 0 and 1.
pub fn logit(probability: f32) -> f32 {
    crate::scene::logit(probability.clamp(0.003, 0.997))
}
