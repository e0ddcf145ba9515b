//! How the number of Gaussians changes: some are split or copied, transparent ones taken away.

use glam::{Quat, Vec3};
use rand::RngExt;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

use super::config::{GrowthConfig, GrowthMethod};
use crate::scene::{Gaussians, Scene, logit};

/// A split Gaussian's halves lie so many standard deviations from it, along its longest axis;
const SPLIT_OFFSET: f32 = 0.6;
/// are so much shorter there;
const SPLIT_SCALE: f32 = 0.65;
/// and so much less opaque: together they have its weight at its center, and 0.98 of its sum.
const SPLIT_OPACITY: f32 = 0.75;
/// Where a copy lies, in standard deviations: copies at one place would stay together forever.
const COPY_OFFSET: f32 = 0.3;

/// What became of the Gaussians.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Grown {
    /// Split in two.
    pub split: u32,
    /// Copied.
    pub cloned: u32,
    /// Taken away.
    pub pruned: u32,
}

/// Where a Gaussian of the new scene comes from.
#[derive(Clone, Copy, Debug)]
pub struct Child {
    pub parent: usize,
    /// What becomes of the parent; none keeps all.
    change: Option<Change>,
}

impl Child {
    /// The same, where its parent has another index.
    pub fn with_parent(self, parent: usize) -> Self {
        Self { parent, ..self }
    }
}

#[derive(Clone, Copy, Debug)]
enum Change {
    /// One of two halves along the longest axis: on this side, 1 or -1.
    Half(f32),
    /// One of so many copies, and its offset in standard deviations along each axis.
    Copy(u32, Vec3),
}

/// What becomes of each Gaussian. It follows from few numbers of each, so that ranks that hold shares of a scene can find
/// the same plan.
#[derive(Debug)]
pub struct Plan {
    method: GrowthMethod,
    /// `[N]`: how many each becomes.
    counts: Vec<u32>,
    /// For the places of copies.
    random: Pcg64,
    pub grown: Grown,
}

/// How much a Gaussian is in need of a split: how strong a gradient its center felt, on average over the views that saw it.
pub fn strength([sum, views, ..]: [f32; 4]) -> f32 {
    if views > 0.0 { sum / views } else { 0.0 }
}

impl Plan {
    /// Of the opacities' logits `[N]` and the [strengths](strength) `[N]`.
    pub fn new(
        config: &GrowthConfig,
        opacity: &[f32],
        strength: &[f32],
        mut random: Pcg64,
    ) -> Self {
        let method = config.method;
        let (counts, grown) = match method {
            GrowthMethod::None => (vec![1; opacity.len()], Grown::default()),
            GrowthMethod::Split => split(config, opacity, strength),
            GrowthMethod::Relocate => relocate(config, opacity, &mut random),
        };
        Self { method, counts, random, grown }
    }

    /// Gaussians of the new scene.
    pub fn len(&self) -> usize {
        self.counts.iter().map(|&count| count as usize).sum()
    }

    /// The new scene's Gaussians in their order, which is that of their parents.
    pub fn children(&self) -> impl Iterator<Item = Child> {
        let mut random = self.random.clone();
        let of_parent = move |(parent, &count): (usize, &u32)| {
            let change = |copy: u32| match self.method {
                GrowthMethod::Relocate => {
                    let offset = std::array::from_fn(|_| StandardNormal.sample(&mut random));
                    let offset = Vec3::from_array(offset) * COPY_OFFSET;
                    Change::Copy(count, if copy == 0 { Vec3::ZERO } else { offset })
                }
                _ => Change::Half(if copy == 0 { 1.0 } else { -1.0 }),
            };
            let changes: Vec<_> = (0..count).map(change).collect();
            let child = move |change| Child { parent, change: (count > 1).then_some(change) };
            changes.into_iter().map(child)
        };
        self.counts.iter().enumerate().flat_map(of_parent)
    }
}

/// Changes a scene and both of Adam's moments; `statistics [N]` is that of the steps since the last time.
pub fn grow(
    config: &GrowthConfig,
    scene: &mut Scene,
    [first, second]: [&mut Scene; 2],
    statistics: &[[f32; 4]],
    random: Pcg64,
) -> Grown {
    let strength: Vec<_> = statistics.iter().copied().map(strength).collect();
    let plan = Plan::new(config, &scene.gaussians.opacity, &strength, random);
    let children: Vec<_> = plan.children().collect();
    let moments = [&mut first.gaussians, &mut second.gaussians];
    apply(&children, &mut scene.gaussians, moments);
    plan.grown
}

/// Puts children in the place of their parents; `moments` are Adam's.
pub fn apply(children: &[Child], gaussians: &mut Gaussians, moments: [&mut Gaussians; 2]) {
    let parents: Vec<_> = children.iter().map(|child| child.parent).collect();
    let is_new: Vec<_> = children.iter().map(|child| child.change.is_some()).collect();
    for moment in moments {
        *moment = moment.select(&parents);
        clear(moment, &is_new);
    }
    *gaussians = gaussians.select(&parents);
    for (i, child) in children.iter().enumerate() {
        if let Some(change) = child.change {
            change.apply(gaussians, i);
        }
    }
}

fn sigmoid(x: f32) -> f32 {
    1.0 / (1.0 + (-x).exp())
}

/// Whoever is as opaque as that is kept.
fn is_kept(config: &GrowthConfig, opacity: f32) -> bool {
    sigmoid(opacity) >= config.min_opacity
}

/// How many may be added to `kept`.
fn room(config: &GrowthConfig, kept: usize) -> usize {
    let wanted = (kept as f64 * config.rate).ceil() as usize;
    wanted.min((config.max_gaussians as usize).saturating_sub(kept))
}

/// How many each Gaussian becomes: those whose center feels the strongest gradient become two.
fn split(config: &GrowthConfig, opacity: &[f32], strength: &[f32]) -> (Vec<u32>, Grown) {
    let mut kept: Vec<_> = (0..opacity.len()).filter(|&i| is_kept(config, opacity[i])).collect();
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
    (counts, Grown { split: by_strength.len() as u32, cloned: 0, pruned })
}

/// How many each Gaussian becomes: transparent ones move to opaque ones, and new ones are added there; n at one place share
/// its opacity, so that the sum of Eq. 12 stays what it was.
fn relocate(config: &GrowthConfig, opacity: &[f32], random: &mut Pcg64) -> (Vec<u32>, Grown) {
    let kept: Vec<_> = (0..opacity.len()).filter(|&i| is_kept(config, opacity[i])).collect();
    let dead = opacity.len() - kept.len();
    if kept.is_empty() {
        return (vec![1; opacity.len()], Grown { split: 0, cloned: 0, pruned: dead as u32 });
    }
    let mut counts = vec![0_u32; opacity.len()];
    let mut sums = Vec::with_capacity(kept.len());
    let mut sum = 0.0_f64;
    for &i in &kept {
        counts[i] = 1;
        sum += f64::from(sigmoid(opacity[i]));
        sums.push(sum);
    }
    // where all have vanished there is nothing to choose by
    let new = if sum > 0.0 { dead + room(config, opacity.len()) } else { 0 };
    for _ in 0..new {
        let at = random.random_range(0.0..sum);
        counts[kept[sums.partition_point(|&sum| sum <= at).min(kept.len() - 1)]] += 1;
    }
    (counts, Grown { split: 0, cloned: new as u32, pruned: dead as u32 })
}

impl Change {
    fn apply(self, gaussians: &mut Gaussians, i: usize) {
        let (mut offset, mut part, mut shorter) = (Vec3::ZERO, SPLIT_OPACITY, None);
        match self {
            Self::Half(side) => {
                let scales = gaussians.log_scale[i];
                let axis =
                    (0..3).max_by(|&a, &b| scales[a].total_cmp(&scales[b])).unwrap_or_default();
                offset[axis] = side * SPLIT_OFFSET;
                shorter = Some(axis);
            }
            Self::Copy(count, place) => (offset, part) = (place, 1.0 / count as f32),
        }
        let [w, x, y, z] = gaussians.rotation[i];
        let scale = Vec3::from(gaussians.log_scale[i]).exp();
        let offset = Quat::from_xyzw(x, y, z, w).normalize() * (offset * scale);
        let position = Vec3::from(gaussians.position[i]) + offset;
        // a scale that overflows, or a rotation of no length, leads nowhere
        if position.is_finite() {
            gaussians.position[i] = position.to_array();
        }
        if let Some(axis) = shorter {
            gaussians.log_scale[i][axis] += SPLIT_SCALE.ln();
        }
        let logit = logit(sigmoid(gaussians.opacity[i]) * part);
        // what has vanished has no logit; it stays what it was
        if logit.is_finite() {
            gaussians.opacity[i] = logit;
        }
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

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;

    fn scene() -> Scene {
        let config = crate::demo::config();
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

    fn config(method: GrowthMethod) -> GrowthConfig {
        GrowthConfig { method, rate: 0.3, max_gaussians: 10, ..GrowthConfig::default() }
    }

    fn grown(method: GrowthMethod) -> (Scene, Scene, Grown) {
        let (mut grown_scene, mut first, mut second) = (scene(), scene(), scene());
        let statistics =
            [[1.0, 2.0, 5.0, 0.0], [9.0, 1.0, 5.0, 0.0], [1.0, 1.0, 5.0, 0.0], [0.0; 4]];
        let random = Pcg64::seed_from_u64(5);
        let moments = [&mut first, &mut second];
        let counts = grow(&config(method), &mut grown_scene, moments, &statistics, random);
        assert_eq!(first.gaussians, second.gaussians);
        (grown_scene, first, counts)
    }

    #[test]
    fn the_strongest_are_split_and_transparent_ones_go() {
        let (scene, moments, counts) = grown(GrowthMethod::Split);
        assert_eq!(counts, Grown { split: 1, cloned: 0, pruned: 1 });
        // 0, both halves of 2, 3
        assert_eq!(scene.gaussians.len(), 4);
        scene.validate().unwrap();
        let [a, b] = [1, 2].map(|i| Vec3::from(scene.gaussians.position[i]));
        assert!((a + b).abs_diff_eq(2.0 * Vec3::new(2.0, 0.0, 1.0), 1e-5));
        // along the longest axis, the second, 0.6 standard deviations each
        assert!(((a - b).length() - 1.2 * (-0.2_f32).exp()).abs() < 1e-5);
        assert!((scene.gaussians.log_scale[1][1] - (-0.2 + 0.65_f32.ln())).abs() < 1e-6);
        assert!((sigmoid(scene.gaussians.opacity[1]) - 0.375).abs() < 1e-6);
        assert_eq!(moments.gaussians.position[1], [0.0; 3]);
        assert_eq!(moments.gaussians.position[3], [3.0, 0.0, 1.0]);
    }

    #[test]
    fn copies_share_the_opacity_of_their_original() {
        let (scene, _, counts) = grown(GrowthMethod::Relocate);
        assert_eq!(counts, Grown { split: 0, cloned: 3, pruned: 1 });
        assert_eq!(scene.gaussians.len(), 6);
        let weight = |i: usize| sigmoid(scene.gaussians.opacity[i]);
        let all: f32 = (0..6).map(weight).sum();
        let before: f32 = [1.0, 0.0, -1.0].map(sigmoid).iter().sum();
        assert!((all - before).abs() < 1e-5, "{all} {before}");
    }

    /// In f32 the sigmoid of a logit below -104 is 0.
    #[test]
    fn gaussians_that_have_all_vanished_stay_as_they_are() {
        for method in [GrowthMethod::Relocate, GrowthMethod::Split] {
            let (mut grown_scene, mut first, mut second) = (scene(), scene(), scene());
            grown_scene.gaussians.opacity.fill(-200.0);
            grown_scene.gaussians.log_scale[0] = [100.0; 3];
            grown_scene.gaussians.rotation[1] = [0.0; 4];
            let config = GrowthConfig { min_opacity: 0.0, rate: 1.0, ..config(method) };
            let moments = [&mut first, &mut second];
            let statistics = [[1.0, 1.0, 5.0, 0.0]; 4];
            let random = Pcg64::seed_from_u64(5);
            grow(&config, &mut grown_scene, moments, &statistics, random);
            grown_scene.validate().unwrap();
            assert!(grown_scene.gaussians.opacity.iter().all(|&opacity| opacity == -200.0));
        }
    }

    #[test]
    fn nothing_grows_past_its_limit() {
        let config = GrowthConfig { max_gaussians: 4, ..config(GrowthMethod::Split) };
        assert_eq!((room(&config, 4), room(&config, 3), room(&config, 9)), (0, 1, 0));
    }
}
