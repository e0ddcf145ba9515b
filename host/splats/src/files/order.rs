//! The order of Gaussians in files that compress neighbors together.

use super::{Splat, ends, level};

/// Bits of a coordinate in a place on the curve.
const BITS: u32 = 10;
const MOST: u32 = (1 << BITS) - 1;

/// Indices of the Gaussians along a Morton curve through the box of their centers: what is near in space is near in the
/// file.
pub fn along_a_curve(splats: &[Splat]) -> Vec<usize> {
    let ranges = [0, 1, 2].map(|axis| ends(splats.iter().map(|splat| splat.position[axis])));
    let key = |splat: &Splat| -> u32 {
        let cells = [0, 1, 2].map(|axis| level(splat.position[axis], ranges[axis], MOST));
        (0..3 * BITS).map(|bit| (cells[bit as usize % 3] >> (bit / 3) & 1) << bit).sum()
    };
    let mut order: Vec<_> = (0..splats.len()).collect();
    order.sort_by_cached_key(|&index| key(&splats[index]));
    order
}

#[cfg(test)]
mod tests {
    use super::super::tests::splats;
    use super::*;

    #[test]
    fn octants_follow_one_another() {
        let mut splats = splats();
        splats.truncate(8);
        for (index, splat) in splats.iter_mut().enumerate() {
            // the octants in the reverse of the curve's order: x has the lowest bit
            let octant = 7 - index;
            splat.position = [0, 1, 2].map(|axis| (octant >> axis & 1) as f32);
        }
        assert_eq!(along_a_curve(&splats), [7, 6, 5, 4, 3, 2, 1, 0]);
    }
}
