//! A dense level of a grid as a volume: numbers at vertices, interpolated as the kernels do it.

use std::f32::consts::TAU;

use glam::{UVec3, Vec3};

use super::shape::HALF_BOX;
use crate::scene::{GridConfig, GridLevelGeometry};

/// World units per unit of the unit cube, in which the scene's box spans 0.05 to 0.95.
pub const WORLD_PER_UNIT: f32 = 2.0 * HALF_BOX / 0.9;

/// One number at each vertex, in the order of the grid's table.
#[derive(Debug)]
pub struct Volume {
    pub values: Vec<f32>,
    resolution: u32,
    /// Cells per world unit.
    density: f32,
    /// Whether a block of cells may have a vertex that is not zero. Most have none, and need no interpolation.
    filled: Vec<bool>,
}

/// Cells along a side of a block.
const BLOCK: u32 = 8;

impl Volume {
    /// Zeros at all vertices of a grid with one level.
    pub fn zeros(grid: &GridConfig) -> Self {
        let GridLevelGeometry { scale, resolution, count, hashed, .. } = grid.levels_geometry()[0];
        assert!(!hashed, "a hashed level has no vertices of its own");
        let density = scale as f32 / WORLD_PER_UNIT;
        let blocks = resolution.div_ceil(BLOCK).pow(3) as usize;
        Self { values: vec![0.0; count as usize], resolution, density, filled: vec![false; blocks] }
    }

    /// Side of a cell in world units.
    pub fn cell(&self) -> f32 {
        1.0 / self.density
    }

    /// Position of a vertex: the inverse of `position = x' * scale + 0.5`.
    fn vertex(&self, cell: UVec3) -> Vec3 {
        let [x, y, z] = cell.to_array().map(|c| (c as f32 - 0.5) / self.density);
        Vec3::new(x, y, z) - 0.5 * WORLD_PER_UNIT
    }

    fn cell_of(&self, position: Vec3) -> Vec3 {
        (position + 0.5 * WORLD_PER_UNIT) * self.density + 0.5
    }

    fn index(&self, cell: UVec3) -> usize {
        (cell.x + (cell.y + cell.z * self.resolution) * self.resolution) as usize
    }

    /// Index of a block.
    fn block(&self, block: UVec3) -> usize {
        let blocks = self.resolution.div_ceil(BLOCK);
        (block.x + (block.y + block.z * blocks) * blocks) as usize
    }

    /// Every vertex: its index and position.
    pub fn vertices(&self) -> impl Iterator<Item = (usize, Vec3)> + '_ {
        let side = self.resolution;
        (0..side * side * side).map(move |index| {
            let cell = UVec3::new(index % side, index / side % side, index / (side * side));
            (index as usize, self.vertex(cell))
        })
    }

    /// Adds a Gaussian with the given integral over space.
    pub fn add_gaussian(&mut self, position: Vec3, integral: f32, deviation: f32) {
        let center = self.cell_of(position);
        let reach = (3.0 * deviation * self.density).ceil();
        let range = |axis: usize| {
            let first = (center[axis] - reach).ceil().max(0.0) as u32;
            first..((center[axis] + reach).max(-1.0) as u32 + 1).min(self.resolution)
        };
        let weight = |axis: usize, cell: u32| {
            let distance = (cell as f32 - center[axis]) * self.cell() / deviation;
            (-0.5 * distance * distance).exp() / (TAU.sqrt() * deviation)
        };
        let [xs, ys, zs] = [0, 1, 2]
            .map(|axis| range(axis).map(|cell| (cell, weight(axis, cell))).collect::<Vec<_>>());
        for &(z, weight_z) in &zs {
            for &(y, weight_y) in &ys {
                let row = integral * weight_z * weight_y;
                for &(x, weight_x) in &xs {
                    let index = self.index(UVec3::new(x, y, z));
                    self.values[index] += row * weight_x;
                }
            }
        }
        // A vertex is a corner of the cell before it, too.
        let blocks = |weights: &[(u32, f32)]| {
            let first = weights.first().map_or(0, |(first, _)| first.saturating_sub(1) / BLOCK);
            first..weights.last().map_or(0, |(last, _)| last / BLOCK + 1)
        };
        for z in blocks(&zs) {
            for y in blocks(&ys) {
                for x in blocks(&xs) {
                    let block = self.block(UVec3::new(x, y, z));
                    self.filled[block] = true;
                }
            }
        }
    }

    /// The cell of a position, and its place in there; `None` outside of the grid.
    pub fn place(&self, position: Vec3) -> Option<(UVec3, Vec3)> {
        let place = self.cell_of(position);
        let inside =
            place.min_element() >= 0.0 && place.max_element() < (self.resolution - 1) as f32;
        let cell = place.as_uvec3();
        inside.then(|| (cell, place - cell.as_vec3()))
    }

    /// The interpolated value at a [place](Self::place) of this grid.
    pub fn sample(&self, (cell, t): (UVec3, Vec3)) -> f32 {
        if !self.filled[self.block(cell / BLOCK)] {
            return 0.0;
        }
        let side = self.resolution as usize;
        let first = self.index(cell);
        let row = |at: usize| self.values[at] + (self.values[at + 1] - self.values[at]) * t.x;
        let plane = |at: usize| row(at) + (row(at + side) - row(at)) * t.y;
        plane(first) + (plane(first + side * side) - plane(first)) * t.z
    }
}
