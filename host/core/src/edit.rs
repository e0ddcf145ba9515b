//! Regions of a scene, to crop it by.

/// A region of the scene's space. Its surface belongs to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Region {
    /// A box along the axes.
    Box {
        /// The corner with the smallest coordinates.
        low: [f32; 3],
        /// The corner with the largest coordinates.
        high: [f32; 3],
    },
    /// A ball.
    Sphere {
        /// Center of the ball.
        center: [f32; 3],
        /// Radius of the ball.
        radius: f32,
    },
}

impl Region {
    /// Whether a place lies in the region.
    #[must_use]
    pub fn contains(&self, place: [f32; 3]) -> bool {
        match *self {
            Self::Box { low, high } => (0..3).all(|i| (low[i]..=high[i]).contains(&place[i])),
            Self::Sphere { center, radius } => {
                let square = |i: usize| f64::from(place[i] - center[i]).powi(2);
                (0..3).map(square).sum::<f64>() <= f64::from(radius).powi(2)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_end_at_their_surface() {
        let cube = Region::Box { low: [0.0, 1.0, 2.0], high: [1.0, 2.0, 3.0] };
        let ball = Region::Sphere { center: [1.0, 0.0, 0.0], radius: 2.0 };
        for (place, in_cube, in_ball) in [
            ([0.0, 1.0, 2.0], true, false),
            ([1.0, 2.0, 3.0], true, false),
            ([0.5, 1.5, 3.001], false, false),
            ([3.0, 0.0, 0.0], false, true),
            ([1.0, 1.5, 1.5], false, false),
            ([1.0, 1.4, 1.4], false, true),
            ([-1.001, 0.0, 0.0], false, false),
        ] {
            assert_eq!(
                (cube.contains(place), ball.contains(place)),
                (in_cube, in_ball),
                "{place:?}"
            );
        }
    }
}
