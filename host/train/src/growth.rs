//! How the number of Gaussians changes: some are split, transparent ones taken away.
//!
//! The Gaussians may be dealt to ranks. Every rank gets two numbers of each Gaussian of the scene, and finds the same
//! [plan](GrowthPlan). Then the rows of the Gaussians go to the ranks that have their children: blocks are cut anew.

use glam::{Quat, Vec3};

use super::checkpoint::Checkpoint;
use super::config::GrowthConfig;
use organza_core::error::Result;
use organza_core::ranks::Ranks;
use organza_core::scene::{Gaussians, Scene, logit, range_of};

/// Distance of a split Gaussian's halves from it, in standard deviations, along its longest axis;
const SPLIT_OFFSET: f32 = 0.6;
/// are so much shorter there;
const SPLIT_SCALE: f32 = 0.65;
/// and so much less opaque: together they have its weight at its center, and 0.98 of its sum.
const SPLIT_OPACITY: f32 = 0.75;

/// The fates of the Gaussians.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Grown {
    /// Split in two.
    pub split: u32,
    /// Taken away.
    pub pruned: u32,
}

/// Where a Gaussian of the new scene comes from.
#[derive(Clone, Copy, Debug)]
struct Child {
    parent: usize,
    /// On which side of its parent a half lies, 1 or -1; none is the parent itself.
    side: Option<f32>,
}

/// The fate of each Gaussian. It follows from few numbers of each.
#[derive(Debug)]
struct GrowthPlan {
    /// `[N]`: how many each becomes, 0 to 2.
    counts: Vec<u32>,
    grown: Grown,
}

/// How much a Gaussian is in need of a split: how strong a gradient its center felt, on average over the views that saw it.
fn strength([sum, views, ..]: [f32; 4]) -> f32 {
    if views > 0.0 { sum / views } else { 0.0 }
}

impl GrowthPlan {
    /// Of the opacities' logits `[N]` and the [strengths](strength) `[N]`: those whose center feels the strongest gradient
    /// become two.
    fn new(config: &GrowthConfig, opacity: &[f32], strength: &[f32]) -> Self {
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
        Self { counts, grown: Grown { split: by_strength.len() as u32, pruned } }
    }

    /// Gaussians of the new scene.
    fn len(&self) -> usize {
        self.counts.iter().map(|&count| count as usize).sum()
    }

    /// The new scene's Gaussians in their order, which is that of their parents.
    fn children(&self) -> impl Iterator<Item = Child> {
        let of_parent = |(parent, &count): (usize, &u32)| {
            let sides: &[_] = match count {
                0 => &[],
                1 => &[None],
                _ => &[Some(1.0), Some(-1.0)],
            };
            sides.iter().map(move |&side| Child { parent, side })
        };
        self.counts.iter().enumerate().flat_map(of_parent)
    }
}

/// Puts children in the place of their parents; `moments` are Adam's.
fn apply(children: &[Child], gaussians: &mut Gaussians, moments: [&mut Gaussians; 2]) {
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

/// How many may be added to `kept`.
fn room(config: &GrowthConfig, kept: usize) -> usize {
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
    // a scale that overflows, or a rotation of no length, leads nowhere
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

/// Changes the scene of all ranks, to the same bits for any number of them.
pub fn grow(config: &GrowthConfig, shard: &mut Checkpoint, ranks: &dyn Ranks) -> Result<Grown> {
    let plan = growth_plan(config, shard, ranks)?;
    let Moves { wanted, children, parents } = Moves::new(&plan, shard, ranks);
    let scene_config = shard.scene.config.clone();
    let rows = wanted.iter().map(|indices| encode(shard, indices)).collect();
    drop(wanted);
    // not twice in memory
    let [first, second] = &mut shard.moments;
    for scene in [&mut shard.scene, first, second] {
        scene.gaussians = Gaussians::default();
    }
    let received = ranks.exchange(rows)?;
    let [mut gaussians, mut first, mut second] =
        decode(&received, || Gaussians::zeros(&scene_config, parents))?;
    drop(received);
    apply(&children, &mut gaussians, [&mut first, &mut second]);
    shard.range = range_of(plan.len(), ranks.rank(), ranks.size());
    shard.gaussians = plan.len();
    shard.scene.gaussians = gaussians;
    let [of_first, of_second] = &mut shard.moments;
    (of_first.gaussians, of_second.gaussians) = (first, second);
    shard.statistics = vec![[0.0; 4]; shard.range.len()];
    Ok(plan.grown)
}

/// The plan of the whole scene.
fn growth_plan(config: &GrowthConfig, shard: &Checkpoint, ranks: &dyn Ranks) -> Result<GrowthPlan> {
    let opacity = &shard.scene.gaussians.opacity;
    let strengths = shard.statistics.iter().copied().map(strength);
    let mine: Vec<f32> = opacity.iter().copied().chain(strengths).collect();
    let mut opacity = Vec::with_capacity(shard.gaussians);
    let mut strength = Vec::with_capacity(shard.gaussians);
    for bytes in ranks.gather(bytemuck::cast_slice(&mine).to_vec())? {
        let values: Vec<f32> = bytemuck::pod_collect_to_vec(&bytes);
        let (first, second) = values.split_at(values.len() / 2);
        opacity.extend_from_slice(first);
        strength.extend_from_slice(second);
    }
    Ok(GrowthPlan::new(config, &opacity, &strength))
}

/// Which rows go where.
struct Moves {
    /// For each rank, the Gaussians of this shard that it has children of.
    wanted: Vec<Vec<usize>>,
    /// The children of this rank. Their parents are counted among those that have children here.
    children: Vec<Child>,
    /// How many these are.
    parents: usize,
}

impl Moves {
    fn new(plan: &GrowthPlan, shard: &Checkpoint, ranks: &dyn Ranks) -> Self {
        let rank = ranks.rank();
        let size = ranks.size();
        let len = plan.len();
        let mut moves = Self { wanted: vec![Vec::new(); size], children: Vec::new(), parents: 0 };
        let mut owner = 0;
        let mut last = None;
        for (index, child) in plan.children().enumerate() {
            while index >= range_of(len, owner, size).end {
                owner += 1;
            }
            if shard.range.contains(&child.parent) {
                let wanted = &mut moves.wanted[owner];
                let place = child.parent - shard.range.start;
                if wanted.last() != Some(&place) {
                    wanted.push(place);
                }
            }
            if owner == rank {
                // parents ascend, and so do the ranks that send them
                moves.parents += usize::from(last != Some(child.parent));
                last = Some(child.parent);
                moves.children.push(Child { parent: moves.parents - 1, ..child });
            }
        }
        moves
    }
}

/// Rows of a shard's Gaussians and of both moments, tensor after tensor.
fn encode(shard: &Checkpoint, indices: &[usize]) -> Vec<u8> {
    let ([first, second], len) = (&shard.moments, shard.range.len().max(1));
    let scenes: [&Scene; 3] = [&shard.scene, first, second];
    let tensors = || scenes.into_iter().flat_map(|scene| scene.gaussians.tensors().into_vec());
    let width: usize = tensors().map(|values| values.len() / len).sum();
    let mut bytes = Vec::with_capacity(indices.len() * width * size_of::<f32>());
    for values in tensors() {
        let width = values.len() / len;
        for index in indices {
            bytes.extend_from_slice(bytemuck::cast_slice(&values[index * width..][..width]));
        }
    }
    bytes
}

/// The rows of all messages, one after the other; `zeros` makes room for all.
fn decode(messages: &[Vec<u8>], zeros: impl Fn() -> Result<Gaussians>) -> Result<[Gaussians; 3]> {
    let mut all = [zeros()?, zeros()?, zeros()?];
    let len = all[0].len().max(1);
    let widths = all[0].tensors().map(|values| values.len() / len);
    let width: usize = widths.into_vec().iter().sum();
    let mut rest = all.each_mut().map(Gaussians::tensors_mut);
    for message in messages {
        let values: Vec<f32> = bytemuck::pod_collect_to_vec(message);
        let rows = values.len() / (3 * width).max(1);
        let mut values = &values[..];
        for targets in &mut rest {
            *targets = std::mem::take(targets).zip(widths).map(|(target, width)| {
                let (now, after) = target.split_at_mut(rows * width);
                let (found, others) = values.split_at(now.len());
                now.copy_from_slice(found);
                values = others;
                after
            });
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::config::TrainConfig;
    use organza_core::ranks::ThreadRanks;
    use organza_core::scene::GAUSSIANS_PER_BLOCK;

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

    fn config() -> GrowthConfig {
        GrowthConfig { rate: 0.3, max_gaussians: 10, ..GrowthConfig::default() }
    }

    fn grown(
        config: &GrowthConfig,
        scene: Scene,
        statistics: [[f32; 4]; 4],
    ) -> (Checkpoint, Grown) {
        let mut checkpoint = Checkpoint::begin(scene.clone(), &TrainConfig::default()).unwrap();
        checkpoint.moments = [scene.clone(), scene];
        checkpoint.statistics = statistics.to_vec();
        let counts = grow(config, &mut checkpoint, &ThreadRanks::alone()).unwrap();
        checkpoint.scene.validate().unwrap();
        (checkpoint, counts)
    }

    #[test]
    fn the_strongest_are_split_and_transparent_ones_go() {
        let statistics =
            [[1.0, 2.0, 5.0, 0.0], [9.0, 1.0, 5.0, 0.0], [1.0, 1.0, 5.0, 0.0], [0.0; 4]];
        let (Checkpoint { scene, moments: [moments, second], .. }, counts) =
            grown(&config(), scene(), statistics);
        assert_eq!(moments.gaussians, second.gaussians);
        assert_eq!(counts, Grown { split: 1, pruned: 1 });
        // 0, both halves of 2, 3
        assert_eq!(scene.gaussians.len(), 4);
        let [a, b] = [1, 2].map(|i| Vec3::from(scene.gaussians.position[i]));
        assert!((a + b).abs_diff_eq(2.0 * Vec3::new(2.0, 0.0, 1.0), 1e-5));
        // along the longest axis, the second, 0.6 standard deviations each
        assert!(((a - b).length() - 1.2 * (-0.2_f32).exp()).abs() < 1e-5);
        assert!((scene.gaussians.log_scale[1][1] - (-0.2 + 0.65_f32.ln())).abs() < 1e-6);
        assert!((sigmoid(scene.gaussians.opacity[1]) - 0.375).abs() < 1e-6);
        assert_eq!(moments.gaussians.position[1], [0.0; 3]);
        assert_eq!(moments.gaussians.position[3], [3.0, 0.0, 1.0]);
    }

    /// In f32 the sigmoid of a logit below -104 is 0.
    #[test]
    fn gaussians_that_have_all_vanished_stay_as_they_are() {
        let mut scene = scene();
        scene.gaussians.opacity.fill(-200.0);
        scene.gaussians.log_scale[0] = [100.0; 3];
        scene.gaussians.rotation[1] = [0.0; 4];
        let config = GrowthConfig { min_opacity: 0.0, rate: 1.0, ..config() };
        let (checkpoint, _) = grown(&config, scene, [[1.0, 1.0, 5.0, 0.0]; 4]);
        assert!(checkpoint.scene.gaussians.opacity.iter().all(|&opacity| opacity == -200.0));
    }

    #[test]
    fn growth_stops_at_its_limit() {
        let config = GrowthConfig { max_gaussians: 4, ..config() };
        assert_eq!((room(&config, 4), room(&config, 3), room(&config, 9)), (0, 1, 0));
    }

    /// Some more than one block of random Gaussians and moments. Many of the first are to be taken away, and the last have the
    /// strongest gradients: most rows have another place afterwards.
    fn state() -> Checkpoint {
        let mut random = Pcg64::seed_from_u64(3);
        let scene = Scene::zeros(organza_core::demo::config(), GAUSSIANS_PER_BLOCK + 300).unwrap();
        let mut state = Checkpoint::begin(scene, &TrainConfig::default()).unwrap();
        let Checkpoint { scene, moments: [first, second], statistics, .. } = &mut state;
        for scene in [scene, first, second] {
            for values in scene.gaussians.tensors_mut().into_vec() {
                values.iter_mut().for_each(|value| *value = random.random_range(-1.0..1.0));
            }
        }
        for (index, statistics) in statistics.iter_mut().enumerate() {
            *statistics = [index as f32 * random.random::<f32>(), 3.0, 5.0, 0.0];
        }
        let opacity = &mut state.scene.gaussians.opacity;
        opacity[..GAUSSIANS_PER_BLOCK / 2].iter_mut().for_each(|logit| *logit *= 20.0);
        state
    }

    /// Any number of ranks grows the same Gaussians as one rank with the whole scene.
    #[test]
    fn ranks_grow_the_whole_scene_alike() {
        let begun = state();
        let config = GrowthConfig { rate: 0.3, max_gaussians: u32::MAX, ..GrowthConfig::default() };
        let mut whole = begun.clone();
        let counts = grow(&config, &mut whole, &ThreadRanks::alone()).expect("it grows");
        assert!(counts.pruned > 1000 && counts.split > 3000, "{counts:?}");
        // the first of three has nothing
        for size in [2, 3] {
            ThreadRanks::run(size, |ranks| {
                let rank = ranks.rank();
                let mut shard = begun.shard(rank, size);
                let found = grow(&config, &mut shard, &ranks).expect("it grows");
                let expected = whole.shard(rank, size);
                assert!(shard == expected, "rank {rank} of {size}");
                assert_eq!(found, counts);
            });
        }
    }
}
