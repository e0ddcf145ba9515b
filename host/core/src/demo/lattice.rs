//! Surfaces as lattices of flat Gaussians.
//!
//! A Gaussian takes the shape of its cell. For tangents `a` and `b` along the cell's sides, its covariance is `k^2 (a
//! a^T + b b^T)`, and small along the normal. The sum of a lattice of such Gaussians ripples by at most `2 exp(-2
//! pi^2 k^2)`, however the surface stretches and shears. Its height is the peak opacity times `2 pi k^2`. So a
//! surface is closed and even at every image size.

use std::f32::consts::TAU;

use glam::{Mat3, Quat, Vec3};

use super::shape::{Material, logit};
use crate::scene::Gaussians;

/// k: standard deviation of a Gaussian in units of its cell. It ripples by 0.04 percent.
const SPREAD: f32 = 0.66;
/// Gaussians with less coverage are left out: they would not change an 8-bit image.
const MIN_COVERAGE: f32 = 0.006;
/// Step of the central differences that give the tangents, in units of the surface's parameters.
const DIFFERENCE: f32 = 2e-3;

/// A cell of a surface's lattice.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// The cell's center, in parameters of the surface.
    pub u: f32,
    pub v: f32,
    /// The cell's center in space.
    pub position: Vec3,
    /// The cell's sides.
    pub along_u: Vec3,
    pub along_v: Vec3,
}

impl Cell {
    /// The unit normal, or zero for a cell without area.
    pub fn normal(&self) -> Vec3 {
        self.along_u.cross(self.along_v).normalize_or_zero()
    }

    pub fn area(&self) -> f32 {
        self.along_u.cross(self.along_v).length()
    }
}

/// The cells of a surface over the unit square.
pub fn cells(
    [columns, rows]: [usize; 2],
    surface: impl Fn(f32, f32) -> Vec3,
) -> impl Iterator<Item = Cell> {
    (0..columns * rows).map(move |index| {
        let u = ((index / rows) as f32 + 0.5) / columns as f32;
        let v = ((index % rows) as f32 + 0.5) / rows as f32;
        let change_u = surface(u + DIFFERENCE, v) - surface(u - DIFFERENCE, v);
        let change_v = surface(u, v + DIFFERENCE) - surface(u, v - DIFFERENCE);
        Cell {
            u,
            v,
            position: surface(u, v),
            along_u: change_u / (2.0 * DIFFERENCE * columns as f32),
            along_v: change_v / (2.0 * DIFFERENCE * rows as f32),
        }
    })
}

/// Thickness, coverage and material of a Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Standard deviation along the normal.
    pub thickness: f32,
    /// Height of the lattice's sum: the alpha of the surface if nothing is in front.
    pub coverage: f32,
    pub material: Material,
}

/// Gaussians under construction.
#[derive(Debug, Default)]
pub struct Splats(Gaussians);

impl Splats {
    /// Adds a Gaussian for a cell, unless the cell has no area or the Gaussian's coverage is too small.
    pub fn push(&mut self, cell: &Cell, look: &Look) {
        let normal = cell.normal();
        if normal == Vec3::ZERO || look.coverage < MIN_COVERAGE {
            return;
        }
        let ([first, second], deviation) = principal_axes(cell, normal);
        let rotation = Quat::from_mat3(&Mat3::from_cols(first, second, normal));
        let scale = deviation.map(|deviation| (SPREAD * deviation).max(1e-4).ln());
        self.0.position.push(cell.position.to_array());
        self.0.rotation.push([rotation.w, rotation.x, rotation.y, rotation.z]);
        self.0.log_scale.push([scale[0], scale[1], look.thickness.ln()]);
        self.0.opacity.push(logit(look.coverage / (TAU * SPREAD * SPREAD)));
        self.0.material.extend(look.material.values());
        self.0.extra.extend(look.material.kind.extra());
    }
}

impl From<Splats> for Gaussians {
    fn from(splats: Splats) -> Self {
        splats.0
    }
}

/// Eigenvectors of `a a^T + b b^T` in the tangent plane, and the square roots of their eigenvalues.
fn principal_axes(cell: &Cell, normal: Vec3) -> ([Vec3; 2], [f32; 2]) {
    let a = cell.along_u;
    let b = cell.along_v;
    let x = a.normalize();
    let y = normal.cross(x);
    let xx = a.dot(x) * a.dot(x) + b.dot(x) * b.dot(x);
    let xy = a.dot(x) * a.dot(y) + b.dot(x) * b.dot(y);
    let yy = a.dot(y) * a.dot(y) + b.dot(y) * b.dot(y);
    let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
    let first = x * cos + y * sin;
    let mean = 0.5 * (xx + yy);
    let half_difference = 0.5 * (xx - yy);
    let root = half_difference.hypot(xy);
    ([first, normal.cross(first)], [mean + root, (mean - root).max(0.0)].map(f32::sqrt))
}
