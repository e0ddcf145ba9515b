//! How the number of Gaussians changes: some are split, transparent ones taken away.

use glam::{Quat, Vec3};

use super::config::DensificationConfig;
use organza_core::scene::{Gaussians, along_a_curve, logit};

/// Distance of the halves of a split Gaussian from its center, in standard deviations along its longest axis.
const SPLIT_OFFSET: f32 = 0.6;
/// Length of a half along this axis, relative to the Gaussian's.
const SPLIT_SCALE: f32 = 0.65;
/// Opacity of a half, relative to the Gaussian's. Together, the halves have its weight at its center, and 0.98 of its sum.
const SPLIT_OPACITY: f32 = 0.75;

/// The Gaussians of a training, and what belongs to each.
#[derive(Clone, Debug)]
pub struct Population {
    pub gaussians: Gaussians,
    /// Adam's m and v.
    pub moments: [Gaussians; 2],
    /// `[N]`: see [`SceneGradient::statistics`](organza_render::SceneGradient::statistics).
    pub statistics: Vec<[f32; 4]>,
}

/// How many Gaussians were split and pruned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DensificationStats {
    /// Split in two.
    pub split: u32,
    /// Taken away.
    pub pruned: u32,
}

/// Where a Gaussian of the new scene comes from.
#[derive(Clone, Copy, Debug)]
struct Child {
    parent: usize,
    /// On which side of its parent a half lies, 1 or -1. `None` is the parent itself.
    side: Option<f32>,
}

/// What happens to each Gaussian.
#[derive(Debug)]
struct Densification {
    /// `[N]`: how many each becomes, 0 to 2.
    counts: Vec<u32>,
    densified: DensificationStats,
}

/// How much a Gaussian needs a split: the mean |dL/dmean2d| over the cameras that have shown it.
fn strength([sum, views, ..]: [f32; 4]) -> f32 {
    if views > 0.0 { sum / views } else { 0.0 }
}

impl Densification {
    /// Decides by the opacities' logits `[N]` and the [strengths](strength) `[N]`: transparent Gaussians go, and the ones with the largest
    /// strengths become two.
    fn new(config: &DensificationConfig, opacity: &[f32], strength: &[f32]) -> Self {
        let is_kept = |&i: &usize| sigmoid(opacity[i]) >= config.min_opacity;
        let mut kept: Vec<_> = (0..opacity.len()).filter(is_kept).collect();
        if kept.is_empty() {
            // nothing is left to grow from
            kept = (0..opacity.len()).collect();
        }
        let mut counts = vec![0; opacity.len()];
        kept.iter().for_each(|&i| counts[i] = 1);
        let pruned = (opacity.len() - kept.len()) as u32;
        let room = room(config, kept.len());
        let mut by_strength = kept;
        by_strength.sort_by(|&a, &b| strength[b].total_cmp(&strength[a]).then(a.cmp(&b)));
        by_strength.truncate(room);
        by_strength.retain(|&i| strength[i] > 0.0);
        by_strength.iter().for_each(|&i| counts[i] = 2);
        Self { counts, densified: DensificationStats { split: by_strength.len() as u32, pruned } }
    }

    /// The new scene's Gaussians, where their parents lie along a curve: what is near in space is near in memory.
    fn children(&self, positions: &[[f32; 3]]) -> impl Iterator<Item = Child> {
        let of_parent = |parent: usize| {
            let sides: &[_] = match self.counts[parent] {
                0 => &[],
                1 => &[None],
                _ => &[Some(1.0), Some(-1.0)],
            };
            sides.iter().map(move |&side| Child { parent, side })
        };
        along_a_curve(positions).into_iter().flat_map(of_parent)
    }
}

/// Puts children in the place of their parents; `moments` are Adam's.
fn apply(children: &[Child], gaussians: &mut Gaussians, moments: &mut [Gaussians; 2]) {
    let parents: Vec<_> = children.iter().map(|child| child.parent).collect();
    let is_new: Vec<_> = children.iter().map(|child| child.side.is_some()).collect();
    for moment in moments {
        *moment = moment.select(&parents);
        clear(moment, &is_new);
    }
    *gaussians = gaussians.select(&parents);
    for (i, child) in children.iter().enumerate() {
        if let Some(side) = child.side {
            halve(gaussians, i, side);
        }
    }
}

fn sigmoid(x: f32) -> f32 {
    1.0 / (1.0 + (-x).exp())
}

/// How many Gaussians may be added to `kept` others.
fn room(config: &DensificationConfig, kept: usize) -> usize {
    let wanted = (kept as f64 * config.rate).ceil() as usize;
    wanted.min((config.max_gaussians as usize).saturating_sub(kept))
}

/// Makes row `i`, a copy of its parent, the half on this side of it along the longest axis.
fn halve(gaussians: &mut Gaussians, i: usize, side: f32) {
    let scales = gaussians.log_scale[i];
    let axis = (0..3).max_by(|&a, &b| scales[a].total_cmp(&scales[b])).unwrap_or_default();
    let mut offset = Vec3::ZERO;
    offset[axis] = side * SPLIT_OFFSET * Vec3::from(scales).exp()[axis];
    let [w, x, y, z] = gaussians.rotation[i];
    let offset = Quat::from_xyzw(x, y, z, w).normalize() * offset;
    let position = Vec3::from(gaussians.position[i]) + offset;
    // a scale that overflows, or a rotation without a length, gives no position
    if position.is_finite() {
        gaussians.position[i] = position.to_array();
    }
    gaussians.log_scale[i][axis] += SPLIT_SCALE.ln();
    let logit = logit(sigmoid(gaussians.opacity[i]) * SPLIT_OPACITY);
    // an opacity that has become 0 has no logit: the old one stays
    if logit.is_finite() {
        gaussians.opacity[i] = logit;
    }
}

/// Clears the rows of moments of Gaussians that are new.
fn clear(gaussians: &mut Gaussians, is_new: &[bool]) {
    for values in gaussians.tensors_mut().into_vec() {
        let width = values.len() / is_new.len().max(1);
        for (row, _) in values.chunks_mut(width.max(1)).zip(is_new).filter(|(_, is_new)| **is_new) {
            row.fill(0.0);
        }
    }
}

/// Splits and removes Gaussians.
pub fn densify(config: &DensificationConfig, population: &mut Population) -> DensificationStats {
    let Population { gaussians, moments, statistics } = population;
    let strengths: Vec<_> = statistics.iter().copied().map(strength).collect();
    let densification = Densification::new(config, &gaussians.opacity, &strengths);
    let children: Vec<_> = densification.children(&gaussians.position).collect();
    apply(&children, gaussians, moments);
    *statistics = vec![[0.0; 4]; children.len()];
    densification.densified
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::scene::Scene;

    fn scene() -> Scene {
        let config = organza_core::demo::config();
        let mut scene = Scene::zeros(config, 4).unwrap();
        let gaussians = &mut scene.gaussians;
        gaussians.rotation.fill([0.3, -0.2, 0.9, 0.1]);
        for i in 0..4 {
            gaussians.position[i] = [i as f32, 0.0, 1.0];
            gaussians.log_scale[i] = [-1.0, -0.2, -2.0];
        }
        gaussians.opacity = vec![1.0, -9.0, 0.0, -1.0];
        gaussians.material.iter_mut().zip(0..).for_each(|(value, i)| *value = i as f32);
        scene
    }

    fn config() -> DensificationConfig {
        DensificationConfig { rate: 0.3, max_gaussians: 10, ..DensificationConfig::default() }
    }

    fn densified(
        config: &DensificationConfig,
        scene: Scene,
        statistics: [[f32; 4]; 4],
    ) -> (Population, DensificationStats) {
        let gaussians = scene.gaussians.clone();
        let moments = [gaussians.clone(), gaussians.clone()];
        let mut population = Population { gaussians, moments, statistics: statistics.to_vec() };
        let counts = densify(config, &mut population);
        let gaussians = population.gaussians.clone();
        Scene { gaussians, ..scene }.validate().unwrap();
        (population, counts)
    }

    #[test]
    fn the_strongest_are_split_and_transparent_ones_go() {
        let statistics =
            [[1.0, 2.0, 5.0, 0.0], [9.0, 1.0, 5.0, 0.0], [1.0, 1.0, 5.0, 0.0], [0.0; 4]];
        let (Population { gaussians, moments: [moments, second], .. }, counts) =
            densified(&config(), scene(), statistics);
        assert_eq!(moments, second);
        assert_eq!(counts, DensificationStats { split: 1, pruned: 1 });
        // 0, both halves of 2, 3
        assert_eq!(gaussians.len(), 4);
        let [a, b] = [1, 2].map(|i| Vec3::from(gaussians.position[i]));
        assert!((a + b).abs_diff_eq(2.0 * Vec3::new(2.0, 0.0, 1.0), 1e-5));
        // along the longest axis, the second, 0.6 standard deviations each
        assert!(((a - b).length() - 1.2 * (-0.2_f32).exp()).abs() < 1e-5);
        assert!((gaussians.log_scale[1][1] - (-0.2 + 0.65_f32.ln())).abs() < 1e-6);
        assert!((sigmoid(gaussians.opacity[1]) - 0.375).abs() < 1e-6);
        assert_eq!(moments.position[1], [0.0; 3]);
        assert_eq!(moments.position[3], [3.0, 0.0, 1.0]);
    }

    /// In f32 the sigmoid of a logit below -104 is 0.
    #[test]
    fn gaussians_that_have_all_vanished_stay_as_they_are() {
        let mut scene = scene();
        scene.gaussians.opacity.fill(-200.0);
        scene.gaussians.log_scale[0] = [100.0; 3];
        scene.gaussians.rotation[1] = [0.0; 4];
        let config = DensificationConfig { min_opacity: 0.0, rate: 1.0, ..config() };
        let (population, _) = densified(&config, scene, [[1.0, 1.0, 5.0, 0.0]; 4]);
        assert!(population.gaussians.opacity.iter().all(|&opacity| opacity == -200.0));
    }

    #[test]
    fn densification_stops_at_its_limit() {
        let config = DensificationConfig { max_gaussians: 4, ..config() };
        assert_eq!((room(&config, 4), room(&config, 3), room(&config, 9)), (0, 1, 0));
    }
}
