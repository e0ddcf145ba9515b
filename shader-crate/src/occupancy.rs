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
fn falloff<L: Lane>(square: L) -> L {
    let number = L::splat;
    let value = number(0.135_335_28);
    let value = L::select(square.less(number(3.0)), number(0.411_112_3), value);
    let value = L::select(square.less(number(1.4)), number(0.606_530_66), value);
    let value = L::select(square.less(number(0.7)), number(0.800_737_4), value);
    L::select(square.less(number(0.2)), number(1.0), value)
}

/// A node along an axis: its place in standard deviations, and its part of the Gaussian, by the trapezoidal rule.
#[inline(always)]
fn node<L: Lane>(index: L, half: u32) -> (L, L) {
    if half == 0 {
        (L::splat(0.0), L::splat(1.0))
    } else {
        let spacing = REACH / half as f32;
        let x = (index - L::splat(half as f32)) * L::splat(spacing);
        (x, L::splat(NORMAL * spacing) * falloff(x * x))
    }
}

/// Adds each Gaussian to the cells of its nodes, in [`FULL`]ths, until they are full: `counts [entries^3]`, x fastest.
///
/// On a CPU, the lanes are neighboring nodes of a Gaussian.
#[kernel(threads(64), over(params.gaussians), iterations = 2 * MAX_NODES * MAX_NODES * MAX_NODES, lanes)]
pub fn occupancy_add<L: Lane>(
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
        let rows = 2 * half_y + 1;
        let columns = 2 * half_z + 1;
        let nodes = (2 * half_x + 1) * rows * columns;
        let mut first = 0;
        while first < nodes {
            let index = L::splat(first as f32) + L::ramp();
            let row = quotient(index, columns);
            let plane = quotient(row, rows);
            let (a, part_x) = node(plane, half_x);
            let (b, part_y) = node(row - plane * L::splat(rows as f32), half_y);
            let (c, part_z) = node(index - row * L::splat(columns as f32), half_z);
            let part = part_x * part_y * part_z;
            let count = L::splat(fill) * part * L::splat(FULL as f32) + L::splat(0.5);
            let a = a * L::splat(scale.x);
            let b = b * L::splat(scale.y);
            let c = c * L::splat(scale.z);
            let place = |center: f32, x: f32, y: f32, z: f32| {
                L::splat(center) + L::splat(x) * a + L::splat(y) * b + L::splat(z) * c
            };
            let place = [
                place(center.x, x.x, y.x, z.x),
                place(center.y, x.y, y.y, z.y),
                place(center.z, x.z, y.z, z.z),
            ];
            add(params, scene_box, place, count, nodes - first, counts);
            first += L::WIDTH;
        }
    }
}

/// The quotient of two integers, of which the first is small: no place is so near to an integer that rounding decides.
#[inline(always)]
fn quotient<L: Lane>(index: L, divisor: u32) -> L {
    ((index + L::splat(0.5)) * L::splat(1.0 / divisor as f32)).truncate()
}

/// Adds counts to the cells of places in world space, if they lie in the cube; of the first lanes, as many as there are `nodes`.
#[loops]
#[inline(always)]
fn add<L: Lane>(
    params: &OccupancyParams,
    scene_box: SceneBox,
    place: [L; 3],
    count: L,
    nodes: u32,
    counts: Write<u32>,
) {
    let zero = L::splat(0.0);
    let split = scene_box.split(place);
    let inside = if params.contracted != 0 { contract(from_center(split)) } else { split };
    let side = L::splat(params.side as f32);
    let x = inside[0].value() * side;
    let y = inside[1].value() * side;
    let z = inside[2].value() * side;
    let lowest = x.min(y).min(z);
    let highest = x.max(y).max(z);
    // what is not a number is not inside
    let is_inside = L::both(zero.less_equal(lowest), highest.less(side));
    let is_added = L::both(is_inside, L::splat(1.0).less_equal(count));
    let number = <L::Index as LaneIndex>::splat;
    let cell = |x: L| L::select(is_added, x, zero).index().wrapping_add(number(1));
    let entries = number(entries_of_side(params.side));
    let row = cell(z).wrapping_mul(entries).wrapping_add(cell(y));
    let entry = row.wrapping_mul(entries).wrapping_add(cell(x));
    let count = L::select(is_added, count.min(L::splat(FULL as f32)), zero).index();
    let mut lane = 0;
    while lane < L::WIDTH && lane < nodes {
        let entry = entry.lane(lane);
        let count = count.lane(lane);
        // Most cells that Gaussians reach are full soon, and reading is cheaper than adding.
        if count > 0 && counts.atomic_load(entry) < FULL {
            let before = atomic::add(counts, entry, count);
            // in any order, the entry ends as min(sum, FULL); it cannot overflow
            if before + count > FULL {
                counts.atomic_min(entry, FULL);
            }
        }
        lane += 1;
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
    if !L::GATHERS_TWO {
        return sum(of_corners!(corners, |entry, weight| L::gather(table, entry) * weight));
    }
    // neighbors along x are neighbors in memory: no corner lies behind the border
    let [ll, _, ul, _, lu, _, uu, _] = corners.entry;
    let [a, b] = L::gather_two(table, ll);
    let [c, d] = L::gather_two(table, ul);
    let [e, f] = L::gather_two(table, lu);
    let [g, h] = L::gather_two(table, uu);
    let [wa, wb, wc, wd, we, wf, wg, wh] = corners.weight;
    sum([a * wa, b * wb, c * wc, d * wd, e * we, f * wf, g * wg, h * wh])
}
