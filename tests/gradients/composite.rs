//! Eq. 12: a tile's sums, of its members' splats.

use glam::Vec4;
use organza::Device;
use organza::parity::composite::extent;
use organza::parity::inputs::Random;
use organza_shaders::composite_backward::{
    CompositeBackwardKernel, CompositeBackwardParams, band_rows,
};
use organza_shaders::tile::Tile;

use super::numeric::{central, everywhere, hold};

/// Tiles and members: at the origin, without members, over the border, far away.
struct Inputs {
    side: u32,
    origins: [[i32; 2]; 4],
    tile_first: Vec<u32>,
    member: Vec<u32>,
    splat: Vec<[Vec4; 3]>,
    gradient: Vec<f32>,
}

impl Inputs {
    fn new(side: u32) -> Self {
        let mut random = Random::new(u64::from(side));
        let origins = [[0, 0], [50, 0], [-9, 5], [4000, -30]];
        let per_tile = [9, 0, 7, 8];
        let mut splat = Vec::new();
        let mut tile_first = vec![0];
        for (origin, count) in origins.into_iter().zip(per_tile) {
            splat.extend((0..count).map(|index| {
                // wide ones, usual ones, needles, some smaller than a pixel, one beside the tile
                let size = [side as f32, 6.0, 2.0, 0.4, 12.0, 5.0, 3.0][index % 7];
                let slant = if index == 4 { 0.999 } else { random.between(-0.8, 0.8) };
                let [xx, yy] = [0, 1].map(|_| (random.between(0.5, 1.5) / size).powi(2));
                let conic = [xx, slant * (xx * yy).sqrt(), yy];
                let [width, height] = extent(conic);
                let place = |axis: usize, random: &mut Random| {
                    let beside = if index == 6 { -50.0 } else { 0.0 };
                    origin[axis] as f32 + random.between(-2.0, side as f32 + 2.0) + beside
                };
                let (x, y) = (place(0, &mut random), place(1, &mut random));
                [
                    Vec4::new(x, y, random.between(0.05, 1.0), width),
                    Vec4::new(conic[0], conic[1], conic[2], height),
                    Vec4::from_slice(&random.values(4, 0.0, 1.0)),
                ]
            }));
            tile_first.push(splat.len() as u32);
        }
        // splats lie in another order than members
        let splats = splat.len() as u32;
        let member: Vec<_> = (0..splats).map(|index| (index * 5 + 3) % splats).collect();
        let mut shuffled = splat.clone();
        member.iter().zip(&splat).for_each(|(&to, &splat)| shuffled[to as usize] = splat);
        let values = origins.len() * 4 * (side * side) as usize;
        let gradient = random.values(values, -1.0, 1.0);
        Self { side, origins, tile_first, member, splat: shuffled, gradient }
    }

    /// Runs the kernel over bands of `rows` rows.
    fn run(&self, device: &Device, rows: u32) -> Vec<Vec4> {
        let tile = |origin| Tile { camera: 0, origin, output: 0 };
        let tiles: Vec<_> = self.origins.iter().flat_map(|&origin| tile(origin).pack()).collect();
        let members = self.member.len() as u32;
        let found = device.zeros("member gradient", 3 * self.member.len()).unwrap();
        for first_row in (0..self.side).step_by(rows as usize) {
            let params = CompositeBackwardParams {
                members,
                tiles: self.origins.len() as u32,
                side: self.side,
                first_row,
                rows: rows.min(self.side - first_row),
            };
            let kernel = CompositeBackwardKernel {
                params,
                tile: &device.upload("tiles", &tiles).unwrap(),
                tile_first: &device.upload("first members", &self.tile_first).unwrap(),
                member: &device.upload("members", &self.member).unwrap(),
                splat: &device.upload("splats", self.splat.as_flattened()).unwrap(),
                sum_gradient: &device.upload("sum gradient", &self.gradient).unwrap(),
                member_gradient: &found,
            };
            device.run(&kernel, members, 1).unwrap();
        }
        device.read(&found).unwrap()
    }

    /// Tile of a member, and its splat's center in the tile, weight, conic and color.
    fn member(&self, index: usize) -> (usize, [f64; 9]) {
        let tile = self.tile_first.iter().rposition(|&first| first as usize <= index).unwrap();
        let [placed, conic, color] = self.splat[self.member[index] as usize].map(|v| v.as_dvec4());
        let [left, top] = self.origins[tile].map(f64::from);
        let (x, y) = (placed.x - left, placed.y - top);
        let values = [x, y, placed.z, conic.x, conic.y, conic.z, color.x, color.y, color.z];
        (tile, values)
    }

    /// One member's part of the sums of its tile, times the gradient; `base` says which pixels the support reaches.
    fn loss(&self, tile: usize, base: &[f64], splat: &[f64]) -> f64 {
        let area = (self.side * self.side) as usize;
        let q = |splat: &[f64], x: f64, y: f64| {
            let (dx, dy) = (x - splat[0], y - splat[1]);
            splat[3] * dx * dx + 2.0 * splat[4] * dx * dy + splat[5] * dy * dy
        };
        let mut loss = 0.0;
        for at in 0..area {
            let (row, column) = (at / self.side as usize, at % self.side as usize);
            let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
            if q(base, x, y) <= 2.0 * 255f64.ln() {
                let alpha = splat[2] * (-0.5 * q(splat, x, y)).exp();
                let plane = |plane: usize| f64::from(self.gradient[(4 * tile + plane) * area + at]);
                let color: f64 = (0..3).map(|channel| plane(channel) * splat[6 + channel]).sum();
                loss += alpha * (color + plane(3));
            }
        }
        loss
    }

    fn expected(&self) -> Vec<f64> {
        let one = |index: usize| {
            let (tile, base) = self.member(index);
            let d = central(&base, 1e-6, |splat| self.loss(tile, &base, splat));
            [d[0], d[1], d[2], 0.0, d[3], d[4], d[5], 0.0, d[6], d[7], d[8], 0.0]
        };
        (0..self.member.len()).flat_map(one).collect()
    }
}

/// Holds each kind of derivative on its own: they are of different sizes.
fn hold_parts(what: &str, found: &[Vec4], expected: &[f64]) {
    let found: Vec<_> = found.iter().flat_map(Vec4::to_array).collect();
    for (name, range) in [("mean2d", 0..2), ("weight", 2..4), ("conic", 4..8), ("color", 8..12)] {
        let of = |index: &usize| range.contains(&(index % 12));
        let part: Vec<_> = (0..found.len()).filter(of).map(|index| found[index]).collect();
        let exact: Vec<_> = (0..found.len()).filter(of).map(|index| expected[index]).collect();
        hold(&format!("{what}: {name}"), &part, &exact);
    }
}

#[test]
fn composite_backward() {
    // rows shorter than a block of lanes, whole blocks, blocks with a rest, and more than a band
    for side in [1, 5, 16, 19, 33, 64, 260] {
        let inputs = Inputs::new(side);
        let expected = inputs.expected();
        for (name, device) in everywhere() {
            let found = inputs.run(&device, band_rows(side));
            hold_parts(&format!("{name}, side {side}"), &found, &expected);
        }
    }
}

#[test]
fn bands_add_up() {
    let inputs = Inputs::new(19);
    let expected = inputs.expected();
    for (name, device) in everywhere() {
        for rows in [1, 7] {
            let found = inputs.run(&device, rows);
            hold_parts(&format!("{name}, bands of {rows} rows"), &found, &expected);
        }
    }
}

/// Pixels are summed in one order.
#[test]
fn threads_change_no_bit() {
    let inputs = Inputs::new(33);
    let [one, more] = [1, 3].map(|threads| {
        let device = organza_tests::devices::cpu(Some(threads));
        inputs.run(&device, 33)
    });
    assert_eq!(one, more);
}
