//! The part of the world that a scene was trained for.

use super::Placement;

/// Weight of a scene at places far from its ground: where no scene is on its ground, all of them count.
const LEAST: f64 = 1e-6;

/// A part of the ground that a scene was trained for. It shows more, but other scenes show that better.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// The coordinates of `sides`: x and y lie on the ground.
    pub placement: Placement,
    /// Lowest x and y, and highest ones. `None` is open.
    pub sides: [[Option<f64>; 2]; 2],
    /// Over this length, half of it on either side, scenes of neighboring grounds fade into each other.
    pub border: f64,
}

impl Ground {
    /// How much an image of the scene counts where it shows this place of the world: 1 on the ground, one half at its sides, and nearly
    /// nothing elsewhere.
    #[must_use]
    pub fn weight(&self, place: [f64; 3]) -> f64 {
        let place = self.placement.own(place);
        let [low, high] = self.sides;
        let beyond = |axis: usize| {
            let low = low[axis].map(|low| place[axis] - low);
            [low, high[axis].map(|high| high - place[axis])].into_iter().flatten()
        };
        let inside = (0..2).flat_map(beyond).fold(f64::INFINITY, f64::min);
        (0.5 + inside / self.border).clamp(LEAST, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_fade_into_each_other() {
        let placement = Placement { offset: [10.0, 0.0, 0.0], ..Placement::default() };
        let ground = |sides| Ground { placement, sides, border: 2.0 };
        let one = ground([[None; 2], [Some(3.0), None]]);
        let other = ground([[Some(3.0), None], [None; 2]]);
        for (x, expected) in [(0.0, 1.0), (12.0, 1.0), (12.5, 0.75), (13.0, 0.5), (13.5, 0.25)] {
            for y in [-100.0, 100.0] {
                assert!((one.weight([x, y, 5.0]) - expected).abs() < 1e-12, "{x}");
                assert!((other.weight([26.0 - x, y, 5.0]) - expected).abs() < 1e-12, "{x}");
            }
        }
        assert_eq!(one.weight([20.0, 0.0, 0.0]), LEAST);
    }
}
