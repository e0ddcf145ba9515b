//! The weights of Eq. 12: opacities and transmittances, and the sum over a camera's tiles.

use glam::Vec4;
use organza::Device;
use organza::parity::inputs::Random;
use organza_shaders::splat::{SplatBackwardKernel, SplatBackwardParams};

use super::numeric::{central, everywhere, hold};

/// Two cameras of three and two tiles, Gaussians of three words.
struct Inputs {
    pair: Vec<u32>,
    tile_mask: Vec<u32>,
    first_member: Vec<u32>,
    opacity: Vec<f32>,
    transmittance: Vec<f32>,
    member_gradient: Vec<Vec4>,
}

const GAUSSIANS: u32 = 71;
const WORDS: u32 = 3;
const FIRST_TILE: [u32; 3] = [0, 3, 5];

impl Inputs {
    fn new() -> Self {
        let mut random = Random::new(3);
        let mut tile_mask: Vec<_> = (0..5 * WORDS).map(|_| random.bits() & random.bits()).collect();
        // all bits, none, and none behind the last Gaussian
        (tile_mask[0], tile_mask[4]) = (u32::MAX, 0);
        tile_mask.iter_mut().skip(2).step_by(3).for_each(|bits| *bits &= (1 << 7) - 1);
        let mut first_member = Vec::new();
        let mut members = 0;
        for bits in &tile_mask {
            first_member.push(members);
            members += bits.count_ones();
        }
        let has = |tile: u32, gaussian: u32| {
            tile_mask[(tile * WORDS + gaussian / 32) as usize] >> (gaussian % 32) & 1 == 1
        };
        let pair: Vec<_> = (0..2 * GAUSSIANS)
            .filter(|slot| {
                let camera = (slot / GAUSSIANS) as usize;
                (FIRST_TILE[camera]..FIRST_TILE[camera + 1]).any(|tile| has(tile, slot % GAUSSIANS))
            })
            .collect();
        let mut opacity = random.values(GAUSSIANS as usize, -6.0, 6.0);
        (opacity[0], opacity[1]) = (30.0, -30.0);
        let mut transmittance = random.values(pair.len(), 0.0, 1.0);
        (transmittance[2], transmittance[3]) = (0.0, 1.0);
        let numbers = random.values(12 * members as usize, -1.0, 1.0);
        let member_gradient = numbers.chunks(4).map(Vec4::from_slice).collect();
        Self { pair, tile_mask, first_member, opacity, transmittance, member_gradient }
    }

    fn run(&self, device: &Device) -> Vec<f32> {
        let pairs = self.pair.len() as u32;
        let found = device.zeros::<Vec4>("pair gradient", 3 * self.pair.len()).unwrap();
        let kernel = SplatBackwardKernel {
            params: SplatBackwardParams { pairs, gaussians: GAUSSIANS, words: WORDS },
            pair: &device.upload("pairs", &self.pair).unwrap(),
            first_tile: &device.upload("first tiles", &FIRST_TILE).unwrap(),
            tile_mask: &device.upload("masks", &self.tile_mask).unwrap(),
            first_member: &device.upload("first members", &self.first_member).unwrap(),
            opacity: &device.upload("opacity", &self.opacity).unwrap(),
            transmittance: &device.upload("transmittance", &self.transmittance).unwrap(),
            member_gradient: &device.upload("gradient", &self.member_gradient).unwrap(),
            pair_gradient: &found,
        };
        device.run(&kernel, pairs, 1).unwrap();
        device.read(&found).unwrap().iter().flat_map(Vec4::to_array).collect()
    }

    /// The gradients of a pair's members: walks through all bits in order.
    fn members(&self, slot: u32) -> [f64; 12] {
        let (mut next, mut sum) = (0, [0.0; 12]);
        for tile in 0..5 {
            let camera = u32::from(tile >= FIRST_TILE[1]);
            for bit in 0..32 * WORDS {
                let word = self.tile_mask[(tile * WORDS + bit / 32) as usize];
                if word >> (bit % 32) & 1 == 1 {
                    if camera * GAUSSIANS + bit == slot {
                        let vectors = &self.member_gradient[3 * next..3 * next + 3];
                        let numbers = vectors.iter().flat_map(Vec4::to_array);
                        sum.iter_mut().zip(numbers).for_each(|(sum, x)| *sum += f64::from(x));
                    }
                    next += 1;
                }
            }
        }
        sum
    }

    fn expected(&self) -> Vec<f64> {
        let one = |(index, &slot): (usize, &u32)| {
            let sum = self.members(slot);
            let opacity = f64::from(self.opacity[(slot % GAUSSIANS) as usize]);
            let transmittance = f64::from(self.transmittance[index]);
            let d =
                central(&[opacity, transmittance], 1e-5, |x| sum[2] * x[1] / (1.0 + (-x[0]).exp()));
            let mut expected = sum;
            (expected[2], expected[3]) = (d[0], d[1]);
            expected
        };
        self.pair.iter().enumerate().flat_map(one).collect()
    }
}

#[test]
fn splat_backward() {
    let inputs = Inputs::new();
    let expected = inputs.expected();
    for (name, device) in everywhere() {
        let found = inputs.run(&device);
        for (what, part) in [("mean2d", 0..2), ("opacity", 2..3), ("T", 3..4), ("rest", 4..12)] {
            let of = |index: &usize| part.contains(&(index % 12));
            let some: Vec<_> = (0..found.len()).filter(of).map(|index| found[index]).collect();
            let exact: Vec<_> = (0..found.len()).filter(of).map(|index| expected[index]).collect();
            hold(&format!("{name}: {what}"), &some, &exact);
        }
    }
}
