//! Channels beside color: other values of each pair, composited by Eq. 12.

use glam::{Mat3, Vec3};
use organza_shaders::channels::{PairChannelsKernel, PairChannelsParams};
use organza_shaders::composite::SUM_PLANES;

use super::composite::{Composite, TileContext, add_weighted, weighted_sum};
use muslin_device::{Buffer, Result};
use organza_core::Channel;
use organza_core::scene::Placement;

/// The sums that a channel is computed from.
#[derive(Clone, Copy, PartialEq)]
enum Source {
    Color,
    Measure,
    Normals,
}

fn source(channel: Channel) -> Source {
    match channel {
        Channel::Alpha => Source::Color,
        Channel::Depth | Channel::Visibility => Source::Measure,
        Channel::Normal => Source::Normals,
    }
}

/// A pixel of less weight shows no Gaussian. A GPU may take numbers below 1.2e-38 for 0, so means with such weights would
/// depend on the device.
const MIN_WEIGHT: f32 = 1e-30;

/// One tile's channel `[planes, S, S]` from its sums `[4, S, S]`, in the units and axes of the world.
fn resolve(channel: Channel, sum: &[f32], area: usize, placement: &Placement) -> Vec<f32> {
    let weight = &sum[3 * area..];
    // NaN is covered: it shows the pixels of an overflowing network.
    let is_empty = |weight: f32| weight < MIN_WEIGHT;
    let covered = |value: f32, weight: f32| if is_empty(weight) { 0.0 } else { value };
    let mean = |plane: usize| {
        let sum = &sum[plane * area..][..area];
        sum.iter().zip(weight).map(|(sum, &weight)| covered(sum / weight, weight)).collect()
    };
    match channel {
        Channel::Depth => {
            let mut depths: Vec<f32> = mean(0);
            depths.iter_mut().for_each(|depth| *depth *= placement.scale as f32);
            depths
        }
        Channel::Visibility => mean(1),
        Channel::Alpha => weight.iter().map(|&weight| covered(weight, weight)).collect(),
        Channel::Normal => {
            let mut normals = sum[..3 * area].to_vec();
            let to_world = (!placement.is_identity()).then(|| placement.rotation().as_mat3());
            for at in 0..area {
                let sum = Vec3::from([0, 1, 2].map(|axis| normals[axis * area + at]));
                let sum = if is_empty(weight[at]) { Vec3::ZERO } else { sum };
                // the squares of small weights would be 0
                let normal = (sum / sum.abs().max_element()).normalize_or_zero();
                let normal = to_world.map_or(normal, |rotation| rotation * normal);
                for axis in 0..3 {
                    normals[axis * area + at] = normal[axis];
                }
            }
            normals
        }
    }
}

/// The values `[pairs, 3]` of the sources other than color: measures, and normals.
fn values(context: TileContext<'_>) -> Result<[Buffer<f32>; 2]> {
    let TileContext { scene, bins, transmittance, .. } = context;
    let device = scene.device();
    let pairs = &bins.pairs;
    let capacity = pairs.count.upper_bound();
    let zeros = |name| device.zeros(name, 3 * capacity as usize);
    let measure = zeros("depths and visibilities")?;
    let normals = zeros("normals")?;
    let gaussians = &scene.tensors.gaussians;
    let kernel = PairChannelsKernel {
        params: PairChannelsParams { pairs: capacity, gaussians: scene.gaussians },
        pair: &pairs.pair,
        camera: &pairs.camera,
        position: &gaussians.position,
        rotation: &gaussians.rotation,
        log_scale: &gaussians.log_scale,
        transmittance,
        measure: &measure,
        normals: &normals,
    };
    device.run_all(&kernel.counted(&pairs.count))?;
    Ok([measure, normals])
}

/// The same in the coordinates of the first scene, in which this one has a place.
fn moved(context: TileContext<'_>, source: Source, values: &Buffer<f32>) -> Result<Buffer<f32>> {
    let device = context.scene.device();
    let place = &context.scene.place;
    let matrix = match source {
        Source::Normals => place.rotation().as_mat3(),
        _ => Mat3::from_diagonal(Vec3::new(place.scale as f32, 1.0, 1.0)),
    };
    let mut values: Vec<Vec3> = device.read(&values.view())?;
    values.iter_mut().for_each(|value| *value = matrix * *value);
    device.upload("channels of another scene", bytemuck::cast_slice(&values))
}

/// The sums of a part's tiles that its channels need, on the device: `[tiles, 4, S, S]` each.
pub struct ChannelSums {
    sums: Vec<(Source, Buffer<u32>)>,
    placement: Placement,
}

impl ChannelSums {
    /// Of all scenes, in the coordinates of the first.
    pub fn new(
        contexts: &[TileContext<'_>],
        composite: &Composite,
        channels: &[Channel],
    ) -> Result<Self> {
        let placement = contexts[0].scene.config.placement;
        let is_needed = |wanted: &Source| channels.iter().any(|c| source(*c) == *wanted);
        let mut sums = Vec::new();
        if is_needed(&Source::Color) {
            sums.push((Source::Color, composite.sum.view()));
        }
        let others = [Source::Measure, Source::Normals];
        if !others.iter().any(is_needed) {
            return Ok(Self { sums, placement });
        }
        let values = contexts.iter().map(|context| values(*context)).collect::<Result<Vec<_>>>()?;
        for (index, source) in others.into_iter().enumerate().filter(|(_, one)| is_needed(one)) {
            let (sum, _) = weighted_sum(contexts[0], &values[0][index])?;
            for (other, values) in contexts.iter().zip(&values).skip(1) {
                add_weighted(*other, &moved(*other, source, &values[index])?, &sum)?;
            }
            sums.push((source, sum.view()));
        }
        Ok(Self { sums, placement })
    }

    /// The buffers to read for [`Self::resolve`].
    pub fn buffers(&self) -> impl Iterator<Item = Buffer<u32>> {
        self.sums.iter().map(|(_, sum)| sum.view())
    }

    /// The channels `[tiles, planes, S, S]`, of the words of [`Self::buffers`].
    pub fn resolve(&self, words: &[Vec<u32>], side: u32, channels: &[Channel]) -> Vec<Vec<f32>> {
        let area = (side * side) as usize;
        let channel = |channel: &Channel| {
            let mut sums = self.sums.iter().zip(words);
            let found = sums.find(|((found, _), _)| *found == source(*channel));
            let (_, sum) = found.expect("its source is among those needed");
            let tiles = bytemuck::cast_slice(sum).chunks_exact(SUM_PLANES as usize * area);
            tiles.flat_map(|sum| resolve(*channel, sum, area, &self.placement)).collect()
        };
        channels.iter().map(channel).collect()
    }
}
