//! Parts of a scene: the Gaussians in a region, and the largest cluster.

use std::collections::{BTreeMap, HashMap};
use std::f32::consts::LN_2;

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

/// Places of Gaussians in grids of several sides.
#[derive(Debug, Default)]
struct Grids {
    /// The cubes that hold places, by the logarithm of their side to the base 2. Casts of large numbers saturate.
    cubes: BTreeMap<i32, HashMap<[i64; 3], usize>>,
    /// For each cube, another cube of its cluster; the cube itself at the end of the chain.
    joined: Vec<usize>,
}

impl Grids {
    fn cube(place: [f32; 3], level: i32) -> [i64; 3] {
        let side = f64::from(level).exp2();
        place.map(|x| (f64::from(x) / side).floor() as i64)
    }

    /// The number of the cube that holds a place.
    fn insert(&mut self, place: [f32; 3], level: i32) -> usize {
        let new = self.joined.len();
        let at = Self::cube(place, level);
        let number = *self.cubes.entry(level).or_default().entry(at).or_insert(new);
        if number == new {
            self.joined.push(new);
        }
        number
    }

    /// The number that all cubes of a cluster share.
    fn cluster(&mut self, mut number: usize) -> usize {
        while self.joined[number] != number {
            self.joined[number] = self.joined[self.joined[number]];
            number = self.joined[number];
        }
        number
    }

    /// Joins cube `number`, which holds a place, with all cubes of a level that touch the place's cube in this level.
    fn join(&mut self, number: usize, place: [f32; 3], level: i32) {
        let at = Self::cube(place, level);
        for step in 0..27 {
            let steps = [step % 3, step / 3 % 3, step / 9];
            let beside = std::array::from_fn(|i| at[i].saturating_add(steps[i] - 1));
            let Some(&other) = self.cubes[&level].get(&beside) else { continue };
            let ends = [number, other].map(|number| self.cluster(number));
            let [first, last] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            self.joined[last] = first;
        }
    }
}

/// Which Gaussians belong to the largest cluster, the one with the most of them.
///
/// A Gaussian lies in a cube of a grid. The cube's side is `reach` times the Gaussian's longest axis (one standard
/// deviation), rounded up to a power of 2. Two Gaussians are connected if their cubes are the same or touch, even at a
/// corner; the smaller cube counts as one of the larger side. Among clusters of equal size, the one with the first Gaussian
/// is taken.
#[must_use]
pub fn largest_cluster(gaussians: &Gaussians, reach: f32) -> Vec<bool> {
    let longest = |scale: &[f32; 3]| scale.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let level = |scale| f64::from(longest(scale) / LN_2 + reach.log2()).ceil() as i32;
    // a side beyond this is as good as everywhere or nowhere
    let levels = gaussians.log_scale.iter().map(|scale| level(scale).clamp(-200, 200));
    let placed: Vec<_> = gaussians.position.iter().copied().zip(levels).collect();
    let mut grids = Grids::default();
    let numbers: Vec<_> = placed.iter().map(|&(at, level)| grids.insert(at, level)).collect();
    let levels: Vec<_> = grids.cubes.keys().copied().collect();
    let mut is_joined = vec![false; grids.joined.len()];
    for (&(place, own), &number) in placed.iter().zip(&numbers) {
        // another Gaussian of the same cube has done it
        if std::mem::replace(&mut is_joined[number], true) {
            continue;
        }
        levels.iter().filter(|&&level| level >= own).for_each(|&l| grids.join(number, place, l));
    }
    let clusters: Vec<_> = numbers.into_iter().map(|number| grids.cluster(number)).collect();
    let mut sizes = vec![0_usize; grids.joined.len()];
    clusters.iter().for_each(|&cluster| sizes[cluster] += 1);
    // among equal clusters, `max_by_key` takes the last
    let largest = (0..sizes.len()).rev().max_by_key(|&cluster| sizes[cluster]);
    clusters.iter().map(|&cluster| Some(cluster) == largest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo;

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

    /// Gaussians at places, each with the length of its longest axis.
    fn gaussians(places: &[([f32; 3], f32)]) -> Gaussians {
        let mut gaussians = Gaussians::zeros(&demo::config(), places.len()).unwrap();
        for (i, (place, longest)) in places.iter().enumerate() {
            gaussians.position[i] = *place;
            gaussians.log_scale[i] = [-9.0, longest.ln(), -7.0];
        }
        gaussians
    }

    #[test]
    fn the_largest_cluster_is_found_across_corners_and_beside_a_gap() {
        // in cubes of 1: a diagonal of three, a pair two cubes away, and one alone below zero
        let places = [[4.5, 0.5, 0.5], [4.9, 0.5, 0.5], [-1.5; 3], [0.5; 3], [1.5; 3], [2.5; 3]];
        let small = |places: &[[f32; 3]]| {
            gaussians(&places.iter().map(|&place| (place, 0.2)).collect::<Vec<_>>())
        };
        let all = small(&places);
        assert_eq!(largest_cluster(&all, 4.9), [false, false, false, true, true, true]);
        // larger cubes bridge the gap
        assert_eq!(largest_cluster(&all, 9.8), [true; 6]);
        // of two clusters of two, the first
        let pairs = small(&[places[0], places[1], [1e38; 3], [1e38; 3]]);
        assert_eq!(largest_cluster(&pairs, 4.9), [true, true, false, false]);
        assert_eq!(largest_cluster(&pairs, 1e-3), [false, false, true, true]);
        assert!(largest_cluster(&Gaussians::default(), 1.0).is_empty());
    }

    #[test]
    fn a_large_gaussian_reaches_farther_than_a_small_one() {
        // cubes of 8 and of 1: the small ones are 6.5 away from the large one, and one is beyond its neighbors
        let near = [([1.0; 3], 7.9), ([7.5, 1.0, 1.0], 0.9), ([9.5, 1.0, 1.0], 0.9)];
        let far = ([16.5, 1.0, 1.0], 0.9);
        let mut all = near.to_vec();
        all.insert(1, far);
        assert_eq!(largest_cluster(&gaussians(&all), 1.0), [true, false, true, true]);
        // among themselves, the small ones do not touch
        assert_eq!(largest_cluster(&gaussians(&all[1..]), 1.0), [true, false, false]);
    }
}
