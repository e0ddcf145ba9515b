//! The part of the world that a scene was trained for.

use std::collections::BTreeMap;

use super::Placement;
use crate::Camera;

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
    /// How training has moved the cameras of its photographs, by their names, as for [`Camera::moved`].
    pub motions: BTreeMap<String, [f64; 6]>,
}

impl Ground {
    /// A camera in the scene's coordinates, where training has moved it.
    #[must_use]
    pub fn moved(&self, camera: Camera) -> Camera {
        let motion = camera.file_path.as_ref().and_then(|name| self.motions.get(name));
        if let Some(motion) = motion { camera.moved(*motion) } else { camera }
    }

    /// How much an image of the scene counts where it shows this place of the world: 1 on the ground, one half at its sides, and nearly
    /// nothing elsewhere.
    #[must_use]
    pub fn weight(&self, place: [f64; 3]) -> f64 {
        (0.5 + self.inside(place) / self.border).clamp(LEAST, 1.0)
    }

    /// How far inside of the sides a place of the world lies, in the units of `placement`; negative outside.
    #[must_use]
    pub fn inside(&self, place: [f64; 3]) -> f64 {
        let place = self.placement.own(place);
        self.inward()
            .map(|(axis, side, sign)| sign * (place[axis] - side))
            .fold(f64::INFINITY, f64::min)
    }

    /// Whether a ray comes to a place whose [weight](Self::weight) is more than nearly nothing. Other rays tell nothing of the ground, so
    /// the scene does not count there. Both are in the coordinates of `placement`.
    #[must_use]
    pub fn is_met(&self, eye: [f64; 3], ray: [f64; 3]) -> bool {
        let [mut first, mut last] = [0.0, f64::INFINITY];
        for (axis, side, sign) in self.inward() {
            let inside = sign * (eye[axis] - side) + 0.5 * self.border;
            let gain = sign * ray[axis];
            if gain > 0.0 {
                first = f64::max(first, -inside / gain);
            } else if gain < 0.0 {
                last = f64::min(last, -inside / gain);
            } else if inside < 0.0 {
                return false;
            }
        }
        first <= last
    }

    /// The closed sides: axis, place, and 1 if the ground lies above, -1 if it lies below.
    fn inward(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let ends = self.sides.into_iter().zip([1.0, -1.0]);
        ends.flat_map(|(end, sign)| [0, 1].map(|axis| Some((axis, end[axis]?, sign)))).flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_fade_into_each_other() {
        let placement = Placement { offset: [10.0, 0.0, 0.0], ..Placement::default() };
        let ground = |sides| Ground { placement, sides, border: 2.0, motions: BTreeMap::new() };
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

    /// Against places along rays.
    #[test]
    fn rays_that_come_over_the_ground_meet_it() {
        let placement = Placement { offset: [1.0, -2.0, 0.0], scale: 2.0, ..Placement::default() };
        let sides = [[Some(0.0); 2], [None; 2]];
        let all = Ground { placement, sides, border: 0.4, motions: BTreeMap::new() };
        let mut met = [0; 2];
        for sides in [
            [[Some(0.0), None], [None; 2]],
            [[Some(0.0), Some(-1.0)], [None; 2]],
            [[Some(0.0), Some(-1.0)], [Some(1.5), Some(0.5)]],
        ] {
            let ground = Ground { sides, ..all.clone() };
            for at in 0..400 {
                let turn = f64::from(at) * 0.7;
                let eye = [6.0 * (0.31 * turn).sin(), 6.0 * (0.17 * turn).cos(), 1.0];
                let ray = [turn.cos(), turn.sin(), (0.1 * turn).sin()];
                let along = |t: f64| placement.world([0, 1, 2].map(|i| eye[i] + t * ray[i]));
                let near = (0..20_000).map(|t| 0.005 * f64::from(t));
                let far = (0..300).map(|t| 100.0 * 1.05_f64.powi(t));
                let mut weights = near.chain(far).map(|t| ground.weight(along(t)));
                let expected = weights.any(|weight| weight > LEAST);
                assert_eq!(ground.is_met(eye, ray), expected, "{sides:?}, {at}");
                met[usize::from(expected)] += 1;
            }
        }
        assert!(met.iter().all(|count| *count > 100), "{met:?}");
        // straight down, on both sides of a side
        let down = [0.0, 0.0, -1.0];
        assert!(all.is_met([-0.1, 6.0, 5.0], down) && !all.is_met([-0.3, 6.0, 5.0], down));
    }
}
