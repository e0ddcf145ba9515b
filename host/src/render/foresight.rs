//! How much room the next batch will need, by what those before it have needed.

use std::collections::VecDeque;

use super::tally::Room;

/// Batches that are looked back at.
const BATCHES: usize = 16;
/// Room beyond the most that any of them needed, as a share of it.
const MARGIN: f64 = 0.125;
/// Room that there is in any case.
const LEAST: f64 = 1024.0;
/// Kernels number what there is in 32 bits, some of it three at a time.
const MOST: f64 = (u32::MAX / 4) as f64;

/// What batches have needed, for each of their tiles.
#[derive(Debug, Default, PartialEq)]
pub struct Foresight {
    /// Gaussians of the scene and the tiles' side: others need something else.
    kind: [u32; 2],
    seen: VecDeque<[f64; 3]>,
}

impl Foresight {
    /// A batch of `tiles` tiles has needed this.
    pub fn saw(&mut self, kind: [u32; 2], tiles: usize, needed: Room) {
        if kind != self.kind {
            (self.kind, self.seen) = (kind, VecDeque::new());
        }
        self.seen.truncate(BATCHES - 1);
        let Room { pairs, members, samples } = needed;
        self.seen
            .push_front([pairs, members, samples].map(|number| f64::from(number) / tiles as f64));
    }

    /// What a batch of `tiles` tiles will need; none where nobody can tell.
    pub fn room(&self, kind: [u32; 2], tiles: usize) -> Option<Room> {
        if kind != self.kind {
            return None;
        }
        let most = |which: usize| self.seen.iter().map(|seen| seen[which]).reduce(f64::max);
        let room = |which| {
            let number = most(which)? * tiles as f64 * (1.0 + MARGIN) + LEAST;
            (number < MOST).then_some(number as u32)
        };
        Some(Room { pairs: room(0)?, members: room(1)?, samples: room(2)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KIND: [u32; 2] = [100, 16];

    fn needed(samples: u32) -> Room {
        Room { pairs: 10, members: 20, samples }
    }

    #[test]
    fn room_is_for_the_most_that_was_seen_lately() {
        let mut foresight = Foresight::default();
        assert_eq!(foresight.room(KIND, 4), None);
        foresight.saw(KIND, 4, needed(80_000));
        for _ in 0..BATCHES - 1 {
            foresight.saw(KIND, 4, needed(8_000));
        }
        let room = foresight.room(KIND, 8).expect("seen");
        assert_eq!(room, Room { pairs: 22 + 1024, members: 45 + 1024, samples: 180_000 + 1024 });
        foresight.saw(KIND, 4, needed(8_000));
        assert_eq!(foresight.room(KIND, 4).expect("seen").samples, 9_000 + 1024);
        // another scene
        assert_eq!(foresight.room([101, 16], 4), None);
        foresight.saw([101, 16], 4, needed(800));
        assert_eq!(foresight.room([101, 16], 4).expect("seen").samples, 900 + 1024);
        assert_eq!(foresight.room(KIND, 4), None);
    }

    #[test]
    fn what_cannot_be_numbered_is_not_foreseen() {
        let mut foresight = Foresight::default();
        foresight.saw(KIND, 1, needed(u32::MAX));
        assert_eq!(foresight.room(KIND, 1), None);
    }
}
