//! Predicts the capacity that a part needs from earlier parts, so that a GPU does not wait for its counts.

use std::collections::{HashMap, VecDeque};

use crate::stages::counts::Capacity;

/// Parts that a prediction takes into account.
const PARTS: usize = 16;
/// Extra capacity, as a fraction of the largest number that one of these parts needed.
const MARGIN: f64 = 0.125;
/// Extra capacity that does not depend on earlier parts.
const MIN_CAPACITY: f64 = 1024.0;
/// Kernels count items in 32 bits, and some of them in steps of three.
const MAX_CAPACITY: f64 = (u32::MAX / 4) as f64;

/// A kind of parts: per tile and Gaussian, they need about the same numbers of pairs, intersections and samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BatchKind {
    /// Side of a tile, in pixels.
    pub side: u32,
    /// Whether they are for gradients: an evaluation between training steps renders other tiles.
    pub is_for_gradients: bool,
    /// Length of T's steps, as a multiple of sigma.
    pub ray_steps: u32,
}

/// The capacity that recent parts of each kind needed, per tile and Gaussian.
#[derive(Debug, Default, PartialEq)]
pub struct CapacityPredictor(HashMap<BatchKind, VecDeque<[f64; 3]>>);

impl CapacityPredictor {
    /// Records what a part with these numbers of tiles and Gaussians has needed.
    pub fn observe(&mut self, kind: BatchKind, [tiles, gaussians]: [u32; 2], needed: Capacity) {
        let seen = self.0.entry(kind).or_default();
        seen.truncate(PARTS - 1);
        let Capacity { pairs, intersections, samples } = needed;
        let size = f64::from(tiles) * f64::from(gaussians);
        seen.push_front([pairs, intersections, samples].map(|number| f64::from(number) / size));
    }

    /// The capacity for a part with these numbers of tiles and Gaussians. `None` before the first part of this kind, or if a number exceeds
    /// 32 bits.
    pub fn predict(&self, kind: BatchKind, [tiles, gaussians]: [u32; 2]) -> Option<Capacity> {
        let seen = self.0.get(&kind)?;
        let size = f64::from(tiles) * f64::from(gaussians);
        let capacity = |which: usize| {
            let largest = seen.iter().map(|seen| seen[which]).reduce(f64::max)?;
            let number = largest * size * (1.0 + MARGIN) + MIN_CAPACITY;
            (number < MAX_CAPACITY).then(|| rounded_up(number as u32))
        };
        Some(Capacity { pairs: capacity(0)?, intersections: capacity(1)?, samples: capacity(2)? })
    }

    /// Multiplies all recorded numbers by a factor.
    pub fn shrink(&mut self, factor: f64) {
        let numbers = self.0.values_mut().flatten().flatten();
        numbers.for_each(|number| *number *= factor);
    }

    /// Forgets everything. Returns whether there was anything.
    pub fn forget(&mut self) -> bool {
        std::mem::take(self) != Self::default()
    }
}

/// With four significant bits. So tables mostly have the size of the last step's, and with it their memory and bind groups.
fn rounded_up(number: u32) -> u32 {
    number.next_multiple_of(1 << number.ilog2().saturating_sub(3))
}

#[cfg(test)]
mod tests {
    use super::*;

    const KIND: BatchKind = BatchKind { side: 16, is_for_gradients: true, ray_steps: 1 };

    fn needed(samples: u32) -> Capacity {
        Capacity { pairs: 10, intersections: 20, samples }
    }

    #[test]
    fn the_capacity_is_for_the_largest_of_recent_parts() {
        let mut predictor = CapacityPredictor::default();
        assert_eq!(predictor.predict(KIND, [4, 100]), None);
        predictor.observe(KIND, [4, 100], needed(80_000));
        for _ in 0..PARTS - 1 {
            predictor.observe(KIND, [4, 100], needed(8_000));
        }
        let capacity = predictor.predict(KIND, [8, 100]).expect("seen");
        // 22, 45 and 180,000, and 1024 more, with four significant bits
        assert_eq!(capacity, Capacity { pairs: 1152, intersections: 1152, samples: 196_608 });
        predictor.observe(KIND, [4, 100], needed(8_000));
        let samples = |gaussians| predictor.predict(KIND, [4, gaussians]).expect("seen").samples;
        assert_eq!(samples(100), 10_240);
        // the scene has grown
        assert_eq!(samples(200), 20_480);
        let evaluation = BatchKind { is_for_gradients: false, ..KIND };
        assert_eq!(predictor.predict(evaluation, [4, 100]), None);
    }

    #[test]
    fn counts_beyond_the_limit_are_not_predicted() {
        let mut predictor = CapacityPredictor::default();
        predictor.observe(KIND, [1, 1], needed(u32::MAX));
        assert_eq!(predictor.predict(KIND, [1, 1]), None);
    }
}
