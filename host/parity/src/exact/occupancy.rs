//! Where Gaussians are: docs/pipeline.md, "Occupancy".

use super::hash_grid::Level;
use super::numeric::Number;
use super::project::{Gaussian, unit_axes};
use super::unit_cube::{contract, unit};

/// The grid of a scene's box.
#[derive(Clone, Copy, Debug)]
pub struct OccupancyGrid {
    /// Cells along a side.
    pub side: u32,
    /// The scene's box.
    pub aabb: [[f64; 3]; 2],
    /// Whether the space outside the box is contracted.
    pub is_contracted: bool,
}

/// A part of a Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Its place in cells.
    pub place: [f64; 3],
    /// How much it fills a cell.
    pub fill: f64,
}

impl OccupancyGrid {
    /// Length of a cell's side in the world.
    pub fn cell(&self) -> f64 {
        let inside = if self.is_contracted { 0.5 } else { 0.9 };
        let [low, high] = self.aabb;
        let sides = [0, 1, 2].map(|axis| (high[axis] - low[axis]) / inside);
        (sides[0] * sides[1] * sides[2]).cbrt() / f64::from(self.side)
    }

    /// Entries along a side: a border of empty cells surrounds the cube.
    pub fn entries(&self) -> usize {
        self.side as usize + 2
    }

    /// The Gaussian's nodes.
    pub fn nodes(&self, gaussian: &Gaussian<f64>, opacity: f64) -> Vec<Node> {
        let scales = gaussian.axes();
        let cells = scales.map(|scale| scale / self.cell());
        let smallest = cells.into_iter().fold(f64::INFINITY, f64::min);
        let section = cells.iter().product::<f64>() / smallest;
        let fill = 2.0 * std::f64::consts::TAU * opacity.sigmoid() * section;
        let axes = unit_axes(gaussian.rotation);
        let nodes = cells.map(along);
        let mut all = Vec::new();
        for &(z, of_z) in &nodes[2] {
            for &(y, of_y) in &nodes[1] {
                for &(x, of_x) in &nodes[0] {
                    let offset = [x * scales[0], y * scales[1], z * scales[2]];
                    let place = [0, 1, 2].map(|row| {
                        let along = (0..3).map(|axis| axes[axis][row] * offset[axis]);
                        gaussian.position[row] + along.sum::<f64>()
                    });
                    let place = unit(place, self.aabb, self.is_contracted);
                    let place = if self.is_contracted { contract(place) } else { place };
                    let place = place.map(|x| x * f64::from(self.side));
                    all.push(Node { place, fill: fill * of_x * of_y * of_z });
                }
            }
        }
        all
    }

    /// The entry of a node, if it lies in the cube.
    pub fn entry(&self, node: &Node) -> Option<usize> {
        let side = f64::from(self.side);
        let is_inside = node.place.iter().all(|x| (0.0..side).contains(x));
        let [x, y, z] = node.place.map(|x| x as usize + 1);
        is_inside.then(|| x + self.entries() * (y + self.entries() * z))
    }

    /// How full the cells around a point of the unit cube are: the grid is a dense level with its points at the cells' centers.
    pub fn occupied(&self, table: &[f32], point: [f64; 3]) -> f64 {
        let resolution = self.entries() as u64;
        let scale = f64::from(self.side);
        let level = Level { scale, resolution, first: 0, count: resolution.pow(3) };
        level.corners(point).iter().map(|&(at, weight)| weight * f64::from(table[at])).sum()
    }
}

/// Nodes to either side of the center, for a scale in cells.
pub fn half(scale: f64) -> f64 {
    (2.0 * scale).round().min(3.0)
}

/// The nodes along an axis: places in standard deviations, and parts of the Gaussian.
fn along(scale: f64) -> Vec<(f64, f64)> {
    let half = half(scale);
    if half == 0.0 {
        return vec![(0.0, 1.0)];
    }
    let spacing = 2.0 / half;
    let node = |i: i32| {
        let x = f64::from(i) * spacing;
        (x, spacing / std::f64::consts::TAU.sqrt() * (-0.5 * x * x).exp())
    };
    (-half as i32..=half as i32).map(node).collect()
}
