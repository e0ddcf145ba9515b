//! Parts of a scene: what lies in a region, and what hangs together.

use std::collections::HashMap;

use crate::scene::Gaussians;

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
        /// Its center.
        center: [f32; 3],
        /// Its radius.
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

/// Four times the median of the Gaussians' longest axes, as standard deviations: a surface of such Gaussians has no gaps of
/// this size. 0 without Gaussians.
#[must_use]
pub fn spacing(gaussians: &Gaussians) -> f32 {
    let longest = |scale: &[f32; 3]| scale.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let mut longest: Vec<_> = gaussians.log_scale.iter().map(longest).collect();
    let middle = longest.len() / 2;
    if longest.is_empty() {
        return 0.0;
    }
    let (_, median, _) = longest.select_nth_unstable_by(middle, f32::total_cmp);
    4.0 * median.exp()
}

/// Which places belong to the largest cluster. Space is cut into cubes of this side. Places hang together if their cubes are
/// the same or touch, also at a corner. Of clusters with as many places, the one with the first place is taken.
#[must_use]
pub fn largest_cluster(places: &[[f32; 3]], side: f32) -> Vec<bool> {
    // casts of large numbers saturate
    let cube = |place: &[f32; 3]| place.map(|x| (f64::from(x) / f64::from(side)).floor() as i64);
    let mut cubes: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    places.iter().enumerate().for_each(|(i, place)| cubes.entry(cube(place)).or_default().push(i));
    let mut largest = Vec::new();
    for place in places {
        let mut cluster = Vec::new();
        let mut open = vec![cube(place)];
        while let Some(at) = open.pop() {
            let Some(found) = cubes.remove(&at) else { continue };
            cluster.extend(found);
            for step in 0..27 {
                let steps = [step % 3, step / 3 % 3, step / 9];
                open.push(std::array::from_fn(|i| at[i].saturating_add(steps[i] - 1)));
            }
        }
        if cluster.len() > largest.len() {
            largest = cluster;
        }
    }
    let mut is_in_largest = vec![false; places.len()];
    largest.into_iter().for_each(|i| is_in_largest[i] = true);
    is_in_largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo;

    #[test]
    fn regions_contain_their_surface_and_nothing_beyond() {
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

    #[test]
    fn the_largest_cluster_is_found_across_corners_and_beside_a_gap() {
        // in cubes of 1: a diagonal of three, a pair two cubes away, and one alone below zero
        let diagonal = [[0.5; 3], [1.5; 3], [2.5; 3]];
        let others = [[4.5, 0.5, 0.5], [4.9, 0.5, 0.5], [-1.5; 3]];
        let mut places = [&others[..], &diagonal].concat();
        assert_eq!(largest_cluster(&places, 1.0), [false, false, false, true, true, true]);
        // larger cubes bridge the gap
        assert_eq!(largest_cluster(&places, 2.0), [true; 6]);
        places.truncate(2);
        places.extend([[1e38; 3], [1e38; 3]]);
        assert_eq!(largest_cluster(&places, 1e-3), [false, false, true, true]);
        // of two clusters of two, the first
        assert_eq!(largest_cluster(&places, 1.0), [true, true, false, false]);
        assert!(largest_cluster(&[], 1.0).is_empty());
    }

    #[test]
    fn the_spacing_follows_the_median_of_the_longest_axes() {
        let mut gaussians = Gaussians::zeros(&demo::config(), 3).unwrap();
        assert_eq!(spacing(&Gaussians::default()), 0.0);
        let scales: [[f32; 3]; 3] = [[0.1, 0.3, 0.2], [9.0, 1.0, 1.0], [0.01, 0.01, 0.02]];
        gaussians.log_scale = scales.map(|scale| scale.map(f32::ln)).to_vec();
        assert!((spacing(&gaussians) - 1.2).abs() < 1e-5);
    }
}
