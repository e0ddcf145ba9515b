//! B1 and B2: the segments of all pairs, their samples as one flat list, and the products.

use std::sync::Mutex;

use glam::Vec4;
use organza_shaders::limits::MAX_SAMPLES;
use organza_shaders::segment::{SEGMENT_VECTORS, SegmentKernel, SegmentParams, contracted_place};
use organza_shaders::transmittance::{
    SegmentProductKernel, SegmentProductParams, TransmittanceHeadKernel, TransmittanceInputsKernel,
    TransmittanceInputsParams,
};
use organza_shaders::transmittance_backward::{
    ExtraBackwardKernel, ExtraBackwardParams, SegmentProductBackwardKernel,
    SegmentProductBackwardParams, TransmittanceHeadBackwardKernel,
};
use organza_shaders::unit_cube::Split;

use super::field::Scratch;
use super::field::backward::{CameraSamples, ChunkScratch, GroupScratch};
use super::field::samples::{BlockOf, Blocks, Chunk, Layout};
use super::pairs::{PairVectors, Pairs};
use super::scan::exclusive_scan;
use super::tiles::Bins;
use crate::gradient::SceneGradient;
use crate::scene::device_scene::DeviceScene;
use crate::scene::field::DeviceField;
use muslin_device::{Buffer, Count, Device, Error, Result};

/// Transmittance of every pair.
#[derive(Debug)]
pub struct Transmittance {
    /// `[pairs]`
    pub transmittance: Buffer<f32>,
    /// `[pairs + 1]`
    pub first_sample: Buffer<u32>,
    /// Samples of all segments.
    pub samples: Count,
    /// The power of the products: how many times as long as sigma the steps are.
    pub power: f32,
    /// `[pairs, 4]`
    segment: Buffer<Vec4>,
    /// Midpoints, and the network's input.
    blocks: Blocks,
}

impl Transmittance {
    /// Evaluates [`segments`], which have a number of samples. `keep` says whether [`Transmittance::backward`] will be
    /// called: its inputs are kept then, as far as they fit.
    pub fn evaluate(
        scene: &DeviceScene,
        pairs: &Pairs,
        (segment, first_sample): (Buffer<Vec4>, Buffer<u32>),
        samples: Count,
        keep: bool,
    ) -> Result<Self> {
        let device = scene.device();
        let capacity = pairs.count.upper_bound();
        let inputs = scene.config.transmittance_inputs();
        let end = |&pair: &u32| Ok(device.read_range(&first_sample, pair as usize, 1)?[0]);
        let ends: Vec<_> = pairs.chunk_ends(keep).iter().map(end).collect::<Result<_>>()?;
        let blocks = Blocks::new(device, inputs, samples.clone(), keep, &ends)?;
        let log_rho = log_rho(scene, pairs, &segment, &first_sample, &blocks)?;
        let transmittance = device.unwritten("transmittance", capacity as usize)?;
        let power = scene.ray_steps as f32;
        let kernel = SegmentProductKernel {
            params: SegmentProductParams { pairs: capacity, power },
            first_sample: &first_sample,
            log_rho: &log_rho,
            transmittance: &transmittance,
        };
        device.run(&kernel.counted(&pairs.count), capacity, 1)?;
        Ok(Self { transmittance, first_sample, samples, power, segment, blocks })
    }
}

/// The part of a pair's ray in the unit cube, and what its samples let through.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray {
    /// Places of the unit cube, evenly spaced in the samples' order, from the Gaussian to the eye. Two where the ray is straight,
    /// s and s + w of Eq. 7; if it is [contracted](organza_core::scene::Contraction), where each of its steps begins, and the end.
    pub places: Vec<[f32; 3]>,
    /// The logarithm of each sample's rho, Eq. 11.
    pub log_rho: Vec<f32>,
}

impl Transmittance {
    /// The rays of all pairs; evaluates the samples once more.
    pub fn rays(&self, scene: &DeviceScene, pairs: &Pairs) -> Result<Vec<Ray>> {
        let device = scene.device();
        let segment = &self.segment;
        let first = &self.first_sample;
        let log_rho = log_rho(scene, pairs, segment, first, &self.blocks)?;
        let segment = device.read(segment)?;
        let first = device.read(first)?;
        let log_rho = device.read(&log_rho)?;
        let is_contracted = !scene.config.contraction.is_none();
        let ray = |(pair, vectors): (usize, &[Vec4; SEGMENT_VECTORS as usize])| {
            let [start, w, start_rest, w_rest] = *vectors;
            let log_rho = &log_rho[first[pair] as usize..first[pair + 1] as usize];
            let places = if is_contracted {
                let count = log_rho.len().max(1);
                let place =
                    |step| contracted_place([start, w, start_rest], step as f32 / count as f32);
                (0..=count).map(|step| place(step).map(Split::value)).collect()
            } else {
                let begin = start + start_rest;
                let end = begin + w + w_rest;
                vec![begin.truncate().to_array(), end.truncate().to_array()]
            };
            Ray { places, log_rho: log_rho.to_vec() }
        };
        Ok(segment.as_chunks().0.iter().enumerate().map(ray).collect())
    }
}

/// The segments `[pairs, 4]` (Eq. 4-8), and where the samples of each begin, `[pairs + 1]`.
pub fn segments(scene: &DeviceScene, pairs: &Pairs) -> Result<(Buffer<Vec4>, Buffer<u32>)> {
    let device = scene.device();
    check_samples(scene, pairs)?;
    let capacity = pairs.count.upper_bound();
    let segment = device.unwritten("segments", capacity as usize * SEGMENT_VECTORS as usize)?;
    let count = device.zeros("sample counts", capacity as usize)?;
    let kernel = SegmentKernel {
        params: SegmentParams {
            pairs: capacity,
            gaussians: scene.gaussians,
            step: scene.ray_step() as f32,
            contracted: scene.config.contraction.for_kernels(),
        },
        pair: &pairs.pair,
        camera: &pairs.camera,
        scene_box: &scene.scene_box,
        position: &scene.tensors.gaussians.position,
        segment: &segment,
        count: &count,
    };
    device.run(&kernel.counted(&pairs.count), capacity, 1)?;
    let first_sample = exclusive_scan(device, &count, capacity)?;
    Ok((segment, first_sample))
}

/// Samples are numbered in 32 bits.
fn check_samples(scene: &DeviceScene, pairs: &Pairs) -> Result<()> {
    let longest = (3f64.sqrt() / scene.ray_step()).ceil().min(f64::from(MAX_SAMPLES));
    let pairs = pairs.count.upper_bound();
    let most = f64::from(pairs) * longest;
    if most > f64::from(u32::MAX) {
        let what = format!("the samples of {pairs} segments with up to {longest} each");
        return Err(Error::OutOfMemory { needed: most as u64 * 4, available: None, what });
    }
    Ok(())
}

/// The logarithm of Eq. 11's factor for every sample.
fn log_rho(
    scene: &DeviceScene,
    pairs: &Pairs,
    segment: &Buffer<Vec4>,
    first_sample: &Buffer<u32>,
    blocks: &Blocks,
) -> Result<Buffer<f32>> {
    let device = scene.device();
    let field = &scene.transmittance;
    let log_rho = device.unwritten("log rho", blocks.samples() as usize)?;
    let scratches = Mutex::default();
    for block in blocks.iter() {
        encode(scene, pairs, segment, first_sample, &block)?;
        let new = || Scratch::new(device, field, blocks.layout());
        device.parallel_for_with(block.chunks(), &scratches, new, |scratch, chunk| {
            let kernel = TransmittanceHeadKernel {
                params: field.head_params(&chunk),
                parameters: &field.parameters,
                point: &chunk.point,
                input: field.hidden(device, scratch, &chunk)?,
                log_rho: &log_rho,
            };
            device.run(&kernel.counted(&chunk.count), chunk.samples, 1)
        })?;
    }
    Ok(log_rho)
}

/// The network's input, for a block of samples.
fn encode(
    scene: &DeviceScene,
    pairs: &Pairs,
    segment: &Buffer<Vec4>,
    first_sample: &Buffer<u32>,
    block: &BlockOf<'_>,
) -> Result<()> {
    scene.device().parallel_for(block.chunks(), |chunk| {
        inputs(scene, pairs, segment, first_sample, &chunk)
    })?;
    scene.transmittance.encode(scene.device(), block, 0)
}

/// The inputs that do not come from the hash grid, for a chunk of samples.
fn inputs(
    scene: &DeviceScene,
    pairs: &Pairs,
    segment: &Buffer<Vec4>,
    first_sample: &Buffer<u32>,
    chunk: &Chunk,
) -> Result<()> {
    let config = &scene.config;
    let kernel = TransmittanceInputsKernel {
        params: TransmittanceInputsParams {
            samples: chunk.samples,
            first_sample: chunk.first,
            stride: chunk.stride,
            pairs: pairs.count.upper_bound(),
            gaussians: scene.gaussians,
            extra: config.extra,
            extra_row: config.transmittance_grid.width() as u32,
            contracted: config.contraction.for_kernels(),
            occupancy: config.occupancy,
        },
        pair: &pairs.pair,
        first_sample,
        segment,
        extra: &scene.tensors.gaussians.extra,
        occupancy: &scene.occupancy.table,
        point: &chunk.point,
        input: &chunk.input,
    };
    scene.device().run(&kernel.counted(&chunk.count, &pairs.count), chunk.samples, 1)
}

impl Transmittance {
    /// Adds the gradients of the transmittance field to their sums, of `pair_gradient [pairs, 3]` (see
    /// [`splat_backward`](organza_shaders::splat)); returns those of the pairs' extra vectors, unless there are no samples.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        bins: &Bins,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<Option<PairVectors>> {
        let device = scene.device();
        if self.samples.upper_bound() == 0 {
            return Ok(None);
        }
        let pairs = &bins.pairs;
        let field = &scene.transmittance;
        let extra = scene.config.extra;
        let layout = self.blocks.layout();
        let samples = CameraSamples::new(scene, bins, Some(&self.first_sample));
        let group_scratch = GroupScratch::new(device, field, &self.blocks, samples)?;
        let of_field = &gradient.transmittance;
        let scratches = Mutex::default();
        let capacity = pairs.count.upper_bound();
        let pair_extra =
            device.zeros("gradient of the pairs' extra vectors", (capacity * extra) as usize)?;
        let owners = AllOwners::new(device, bins, &self.first_sample)?;
        for block in self.blocks.iter() {
            if !block.is_kept {
                encode(scene, pairs, &self.segment, &self.first_sample, &block)?;
            }
            for group in block.groups() {
                let new = || TransmittanceScratch::new(device, field, layout);
                device.parallel_for_with(group.chunks(), &scratches, new, |scratch, chunk| {
                    field.activate(device, &scratch.network, &chunk)?;
                    let owners = owners.owners_of_chunk(&chunk);
                    self.head_backward(scene, scratch, &chunk, &owners, pair_gradient)?;
                    field.backward(device, &group_scratch, &scratch.network, &chunk, 0, of_field)
                })?;
                // in their order: a pair may have samples of two
                for chunk in group.chunks() {
                    let owners = owners.owners_of_chunk(&chunk);
                    let inputs = group_scratch.input_gradient(field, &chunk);
                    self.extra_backward(scene, &inputs, &chunk, &owners, &pair_extra)?;
                }
                field.grid_backward(device, &group_scratch, &group, 0, of_field)?;
            }
        }
        Ok(Some(PairVectors { values: pair_extra, width: extra }))
    }

    /// The gradient of the network's output for a chunk of samples.
    fn head_backward(
        &self,
        scene: &DeviceScene,
        scratch: &TransmittanceScratch,
        chunk: &Chunk,
        owners: &Owners,
        pair_gradient: &Buffer<Vec4>,
    ) -> Result<()> {
        let device = scene.device();
        let log_rho_gradient = &scratch.log_rho_gradient;
        let kernel = SegmentProductBackwardKernel {
            params: SegmentProductBackwardParams {
                pairs: owners.pairs.upper_bound(),
                first_pair: owners.first,
                samples: chunk.samples,
                first_sample: chunk.first,
                power: self.power,
            },
            first_sample: &self.first_sample,
            transmittance: &self.transmittance,
            pair_gradient,
            log_rho_gradient,
        };
        device.run(&kernel.counted(&owners.pairs, &chunk.count), owners.pairs.upper_bound(), 1)?;
        let field = &scene.transmittance;
        let kernel = TransmittanceHeadBackwardKernel {
            params: field.head_params(chunk),
            parameters: &field.parameters,
            point: &chunk.point,
            input: scratch.network.last_hidden(chunk),
            log_rho_gradient,
            logit_gradient: &scratch.network.logit_gradient,
        };
        device.run(&kernel.counted(&chunk.count), chunk.samples, 1)
    }

    /// Adds the gradients of the pairs' extra vectors that come from a chunk of samples.
    fn extra_backward(
        &self,
        scene: &DeviceScene,
        input_gradient: &Buffer<f32>,
        chunk: &Chunk,
        owners: &Owners,
        pair_extra: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = ExtraBackwardKernel {
            params: ExtraBackwardParams {
                pairs: owners.pairs.upper_bound(),
                first_pair: owners.first,
                samples: chunk.samples,
                first_sample: chunk.first,
                stride: chunk.stride,
                extra: scene.config.extra,
                extra_row: scene.config.transmittance_grid.width() as u32,
            },
            first_sample: &self.first_sample,
            input_gradient,
            pair_extra,
        };
        scene.device().run(
            &kernel.counted(&owners.pairs, &chunk.count),
            owners.pairs.upper_bound(),
            scene.config.extra,
        )
    }
}

/// Memory of the backward pass of a chunk of samples.
#[derive(Debug)]
struct TransmittanceScratch {
    network: ChunkScratch,
    /// `[samples]`
    log_rho_gradient: Buffer<f32>,
}

impl TransmittanceScratch {
    fn new(device: &Device, field: &DeviceField, layout: Layout) -> Result<Self> {
        let network = ChunkScratch::new(device, field, layout)?;
        let log_rho_gradient = device.unwritten("gradient of log rho", layout.chunk as usize)?;
        Ok(Self { network, log_rho_gradient })
    }
}

/// Which pairs have samples in which chunk.
enum AllOwners {
    /// Where each pair's samples begin.
    Known(Vec<u32>),
    /// Any of them may: kernels find out.
    OnDevice(Count),
}

/// The pairs that have samples in a chunk, and maybe others.
#[derive(Debug)]
struct Owners {
    first: u32,
    pairs: Count,
}

impl AllOwners {
    /// `first_sample [pairs + 1]`
    fn new(device: &Device, bins: &Bins, first_sample: &Buffer<u32>) -> Result<Self> {
        Ok(match &bins.part_counts {
            None => Self::Known(device.read(first_sample)?),
            Some(_) => Self::OnDevice(bins.pairs.count.clone()),
        })
    }

    fn owners_of_chunk(&self, chunk: &Chunk) -> Owners {
        match self {
            Self::Known(first) => {
                let begin = first.partition_point(|&begin| begin <= chunk.first) as u32 - 1;
                let end = chunk.first + chunk.samples;
                let end = first.partition_point(|&begin| begin < end) as u32;
                Owners { first: begin, pairs: Count::known(end - begin) }
            }
            Self::OnDevice(pairs) => Owners { first: 0, pairs: pairs.clone() },
        }
    }
}
