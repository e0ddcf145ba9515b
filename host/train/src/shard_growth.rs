//! Growth. The Gaussians may be dealt to ranks.
//!
//! Every rank gets two numbers of each Gaussian of the scene, and finds the same [plan](GrowthPlan). Then the rows of the Gaussians
//! go to the ranks that have their children: blocks are cut anew.

use super::checkpoint::Checkpoint;
use super::config::GrowthConfig;
use super::growth::{Child, Grown, GrowthPlan, apply, strength};
use organza_core::error::Result;
use organza_core::ranks::Ranks;
use organza_core::scene::{Gaussians, Scene, range_of};

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
                moves.children.push(child.with_parent(moves.parents - 1));
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

    /// Any number of ranks makes what growth makes of the whole scene.
    #[test]
    fn ranks_grow_what_the_whole_scene_grows() {
        let begun = state();
        let config = GrowthConfig { rate: 0.3, max_gaussians: u32::MAX, ..GrowthConfig::default() };
        let mut whole = begun.clone();
        let counts = grow(&config, &mut whole, &ThreadRanks::alone()).expect("it grows");
        assert!(counts.pruned > 1000 && counts.split > 3000, "{counts:?}");
        // the first of three has nothing
        for size in [2, 3] {
            std::thread::scope(|scope| {
                for ranks in ThreadRanks::new(size) {
                    let begun = &begun;
                    let whole = &whole;
                    let config = &config;
                    scope.spawn(move || {
                        let rank = ranks.rank();
                        let mut shard = begun.shard(rank, size);
                        let found = grow(config, &mut shard, &ranks).expect("it grows");
                        let expected = whole.shard(rank, size);
                        assert!(shard == expected, "rank {rank} of {size}");
                        assert_eq!(found, counts);
                    });
                }
            });
        }
    }
}
