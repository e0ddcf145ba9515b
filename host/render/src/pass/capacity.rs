//! The capacity that a part needs, judging by others: a GPU then does not wait for its counts.

use std::collections::VecDeque;

use crate::stages::counts::Capacity;

/// Batches that a prediction takes into account.
const BATCHES: usize = 16;
/// Extra capacity, as a fraction of the largest number that one of them needed.
const MARGIN: f64 = 0.125;
/// Extra capacity that does not depend on the batches.
const LEAST: f64 = 1024.0;
/// Kernels count items in 32 bits, and some of them in steps of three.
const MOST: f64 = (u32::MAX / 4) as f64;

/// The room that recent batches needed, per tile.
#[derive(Debug, Default, PartialEq)]
pub struct CapacityPredictor {
    /// The scene's Gaussians and the tiles' side: other kinds of batches need other capacities.
    kind: [u32; 2],
    seen: VecDeque<[f64; 3]>,
}

impl CapacityPredictor {
    /// Records what a batch of `tiles` tiles has needed.
    pub fn observe(&mut self, kind: [u32; 2], tiles: usize, needed: Capacity) {
        if kind != self.kind {
            (self.kind, self.seen) = (kind, VecDeque::new());
        }
        self.seen.truncate(BATCHES - 1);
        let Capacity { pairs, members, samples } = needed;
        self.seen
            .push_front([pairs, members, samples].map(|number| f64::from(number) / tiles as f64));
    }

    /// The capacity for a batch of `tiles` tiles; `None` before the first batch of this kind, or if it exceeds 32 bits.
    pub fn predict(&self, kind: [u32; 2], tiles: usize) -> Option<Capacity> {
        if kind != self.kind {
            return None;
        }
        let most = |which: usize| self.seen.iter().map(|seen| seen[which]).reduce(f64::max);
        let capacity = |which| {
            let number = most(which)? * tiles as f64 * (1.0 + MARGIN) + LEAST;
            (number < MOST).then(|| rounded_up(number as u32))
        };
        Some(Capacity { pairs: capacity(0)?, members: capacity(1)?, samples: capacity(2)? })
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

    const KIND: [u32; 2] = [100, 16];

    fn needed(samples: u32) -> Capacity {
        Capacity { pairs: 10, members: 20, samples }
    }

    #[test]
    fn room_is_for_the_most_that_was_seen_lately() {
        let mut predictor = CapacityPredictor::default();
        assert_eq!(predictor.predict(KIND, 4), None);
        predictor.observe(KIND, 4, needed(80_000));
        for _ in 0..BATCHES - 1 {
            predictor.observe(KIND, 4, needed(8_000));
        }
        let capacity = predictor.predict(KIND, 8).expect("seen");
        // 22, 45 and 180,000, and 1024 more, with four significant bits
        assert_eq!(capacity, Capacity { pairs: 1152, members: 1152, samples: 196_608 });
        predictor.observe(KIND, 4, needed(8_000));
        assert_eq!(predictor.predict(KIND, 4).expect("seen").samples, 10_240);
        // another scene
        assert_eq!(predictor.predict([101, 16], 4), None);
        predictor.observe([101, 16], 4, needed(800));
        assert_eq!(predictor.predict([101, 16], 4).expect("seen").samples, 2048);
        assert_eq!(predictor.predict(KIND, 4), None);
    }

    #[test]
    fn counts_beyond_the_limit_are_not_predicted() {
        let mut predictor = CapacityPredictor::default();
        predictor.observe(KIND, 1, needed(u32::MAX));
        assert_eq!(predictor.predict(KIND, 1), None);
    }
}
