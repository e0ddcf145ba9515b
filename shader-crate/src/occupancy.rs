//! Where Gaussians are: a grid of the unit cube. Only there, a ray loses light.
//!
//! A cell's depth is the sum of its Gaussians' opacities, each integrated over the Gaussian's largest cross-section, in faces
//! of a cell. It is full from a depth of 1/2 on. Training knows T where photographs look; elsewhere, T would be whatever the
//! networks say, in empty space, too.

use glam::Vec3;

use crate::camera::read3;
use crate::hash_grid::{Corners, GridLevel, of_corners, sum};
use crate::project::{read_quaternion, rotation_columns};
use crate::unit_cube::{SceneBox, Split, contract, from_center};
use muslin::atomic;
use muslin::math::{exp, max, min, sigmoid};
use muslin::prelude::*;

/// Count of a cell that is full.
pub const FULL: u32 = 1 << 12;
/// Largest number of nodes to either side of a Gaussian's center, along an axis.
pub const MAX_HALF: u32 = 3;
/// Largest number of nodes along an axis.
const MAX_NODES: u32 = 2 * MAX_HALF + 1;
/// The outermost nodes, in standard deviations.
const REACH: f32 = 2.0;
/// 1 / sqrt(2 pi)
const NORMAL: f32 = 0.398_942_3;

/// Parameters of [`occupancy_add`].
#[params]
pub struct OccupancyParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Cells along a side of the unit cube.
    pub side: u32,
    /// Length of a cell's side in world units: the mean over the axes.
    pub cell: f32,
    /// 1 where what lies outside the scene's box is contracted.
    pub contracted: u32,
}

/// Entries along a side: a border of empty cells surrounds the cube.
#[inline(always)]
pub fn entries_of_side(side: u32) -> u32 {
    side + 2
}

/// Nodes to either side of a center, for a scale in cells.
#[inline(always)]
fn half_of(scale: f32) -> u32 {
    min(REACH * scale + 0.5, MAX_HALF as f32) as u32
}

/// `exp(-x^2 / 2)` for the squares x^2 of the nodes: 0, 4/9, 1, 16/9 and 4. An exponential would take most of the kernel's time.
#[inline(always)]
fn falloff(square: f32) -> f32 {
    if square < 0.2 {
        1.0
    } else if square < 0.7 {
        0.800_737_4
    } else if square < 1.4 {
        0.606_530_66
    } else if square < 3.0 {
        0.411_112_3
    } else {
        0.135_335_28
    }
}

/// A node along an axis: its place in standard deviations, and its part of the Gaussian, by the trapezoidal rule.
#[inline(always)]
fn node(index: u32, half: u32) -> (f32, f32) {
    if half == 0 {
        (0.0, 1.0)
    } else {
        let spacing = REACH / half as f32;
        let x = (index as f32 - half as f32) * spacing;
        (x, NORMAL * spacing * falloff(x * x))
    }
}

/// Adds each Gaussian to the cells of its nodes, in [`FULL`]ths, until they are full: `counts [entries^3]`, x fastest.
#[kernel(threads(64), over(params.gaussians), iterations = MAX_NODES * (1 + MAX_NODES * (1 + MAX_NODES)))]
pub fn occupancy_add(
    id: Invocation,
    params: &OccupancyParams,
    scene_box: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    opacity: Read<f32>,
    counts: Write<u32>,
) {
    let gaussian = id.index();
    if gaussian < params.gaussians {
        let scene_box = SceneBox::read(scene_box);
        let center = read3(position, gaussian * 3);
        let log_scale = read3(log_scale, gaussian * 3);
        let scale = Vec3::new(exp(log_scale.x), exp(log_scale.y), exp(log_scale.z));
        let [x, y, z] = rotation_columns(read_quaternion(rotation, gaussian));
        let cells = scale * (1.0 / params.cell);
        let section = max(max(cells.x * cells.y, cells.x * cells.z), cells.y * cells.z);
        // 2 pi times the section, doubled because half a face fills a cell
        let fill = 4.0 * core::f32::consts::PI * sigmoid(opacity.read(gaussian)) * section;
        let half_x = half_of(cells.x);
        let half_y = half_of(cells.y);
        let half_z = half_of(cells.z);
        let mut i = 0;
        while i <= 2 * half_x {
            let (a, part_x) = node(i, half_x);
            let plane = center + x * (a * scale.x);
            let mut j = 0;
            while j <= 2 * half_y {
                let (b, part_y) = node(j, half_y);
                let line = plane + y * (b * scale.y);
                let mut k = 0;
                while k <= 2 * half_z {
                    let (c, part_z) = node(k, half_z);
                    let count = fill * (part_x * part_y * part_z) * FULL as f32 + 0.5;
                    if count >= 1.0 {
                        let place = line + z * (c * scale.z);
                        add(params, scene_box, place, min(count, FULL as f32), counts);
                    }
                    k += 1;
                }
                j += 1;
            }
            i += 1;
        }
    }
}

/// Adds a count to the cell of a place in world space, if it lies in the cube.
#[inline(always)]
fn add(params: &OccupancyParams, scene_box: SceneBox, place: Vec3, count: f32, counts: Write<u32>) {
    let split = scene_box.split(place);
    let inside = if params.contracted != 0 {
        let center = from_center(split);
        contract([center.x, center.y, center.z])
    } else {
        split
    };
    let side = params.side as f32;
    let x = inside[0].value() * side;
    let y = inside[1].value() * side;
    let z = inside[2].value() * side;
    let lowest = min(min(x, y), z);
    let highest = max(max(x, y), z);
    // what is not a number is not inside
    if lowest >= 0.0 && highest < side {
        let entries = entries_of_side(params.side);
        let row = (z as u32 + 1) * entries + y as u32 + 1;
        let entry = row * entries + x as u32 + 1;
        let count = count as u32;
        // Most cells that Gaussians reach are full soon, and reading is cheaper than adding.
        if counts.atomic_load(entry) < FULL {
            let before = atomic::add(counts, entry, count);
            // in any order, the entry ends as min(sum, FULL); it cannot overflow
            if before + count > FULL {
                counts.atomic_min(entry, FULL);
            }
        }
    }
}

/// Parameters of [`occupancy`].
#[params]
pub struct OccupancyTableParams {
    /// Entries of the grid.
    pub entries: u32,
}

/// How full each cell is, 0 to 1, `table [entries]`; clears the counts.
#[kernel(threads(64), over(params.entries))]
pub fn occupancy(
    id: Invocation,
    params: &OccupancyTableParams,
    counts: Write<u32>,
    table: Write<f32>,
) {
    let entry = id.index();
    if entry < params.entries {
        table.write(entry, counts.read(entry) as f32 * (1.0 / FULL as f32));
        counts.write(entry, 0);
    }
}

/// How full the cells around a point of the unit cube are: trilinear between the cells' centers.
#[inline(always)]
pub fn occupied<L: Lane>(side: u32, table: Read<f32>, point: [Split<L>; 3]) -> L {
    let entries = entries_of_side(side);
    let level = GridLevel {
        scale: side as f32,
        scale_rest: 0.0,
        resolution: entries,
        first: 0,
        count: entries * entries * entries,
        hashed: 0,
    };
    let corners = Corners::new(&level, level.cell(point));
    sum(of_corners!(corners, |entry, weight| L::gather(table, entry) * weight))
}
