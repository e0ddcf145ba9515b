//! Stages B1 and B2: the segments of all pairs, their samples as one flat list, and the products.

use glam::Vec4;
use muslin::lane_vec4::LaneVec4;
use organza_shaders::limits::MAX_SAMPLES;
use organza_shaders::segment::{SEGMENT_VECTORS, SegmentKernel, SegmentParams, contracted_place};
use organza_shaders::steps::{StepCountKernel, StepFillKernel, StepsParams};
use organza_shaders::transmittance::{
    SegmentProductKernel, SegmentProductParams, TransmittanceHeadKernel, TransmittanceInputsKernel,
    TransmittanceInputsParams,
};
use organza_shaders::transmittance_backward::{
    ExtraBackwardKernel, ExtraBackwardParams, GradientCountKernel, GradientCountParams,
    SegmentProductBackwardKernel, SegmentProductBackwardParams, TransmittanceHeadBackwardKernel,
};
use organza_shaders::unit_cube::Split;

use super::field::Inputs;
use super::field::backward::{ChunkScratch, FieldBackward};
use super::field::samples::{Blocks, Chunks};
use super::pairs::{PairVectors, Pairs};
use super::scan::exclusive_scan;
use super::tiles::TileBins;
use crate::gradient::SceneGradient;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Count, Device, Error, Result};
use organza_core::Camera;

/// The segments of all pairs (Eq. 4-8).
#[derive(Debug)]
pub struct Segments {
    /// `[pairs, 4]`
    vectors: Buffer<Vec4>,
    /// `[pairs + 1]`: the index of each segment's first sample, and the number of all samples.
    pub first_sample: Buffer<u32>,
    /// `[pairs, words]`: with an occupancy grid, which steps are samples.
    bits: Buffer<u32>,
    /// `[samples]`: with an occupancy grid, which step of its segment a sample is.
    step: Buffer<f32>,
}

/// Transmittance of every pair.
#[derive(Debug)]
pub struct Transmittance {
    /// `[pairs]`
    pub transmittance: Buffer<f32>,
    pub segments: Segments,
    /// Samples of all segments.
    pub samples: Count,
    /// Exponent of the products: the length of T's steps in multiples of sigma.
    pub power: f32,
    /// Midpoints, and the network's input.
    blocks: Blocks,
}

impl Transmittance {
    /// Evaluates T for segments of `samples` samples in all. With `keep`, the inputs of [`Transmittance::backward`] stay in
    /// memory, as far as they fit.
    pub fn evaluate(
        scene: &DeviceScene,
        pairs: &Pairs,
        segments: Segments,
        samples: Count,
        keep: bool,
    ) -> Result<Self> {
        let capacity = pairs.count.upper_bound() as usize;
        let transmittance = scene.device().unwritten("transmittance", capacity)?;
        Self::evaluate_into(transmittance, false, scene, pairs, segments, samples, keep)
    }

    /// Like [`Self::evaluate`], into a buffer. With `onto`, multiplies the values that are there.
    fn evaluate_into(
        transmittance: Buffer<f32>,
        onto: bool,
        scene: &DeviceScene,
        pairs: &Pairs,
        segments: Segments,
        samples: Count,
        keep: bool,
    ) -> Result<Self> {
        let device = scene.device();
        let segments = segments.list(scene, pairs, &samples)?;
        let first_sample = &segments.first_sample;
        // where not all samples get a gradient, the ones that do are encoded again
        let keep = keep && scene.roulette.gradients == 0.0;
        let blocks = blocks(scene, pairs, &segments, samples.clone(), keep, keep)?;
        let log_rho = log_rho(scene, pairs, &segments, &blocks)?;
        let pairs_capacity = pairs.count.upper_bound();
        let power = scene.ray_steps as f32;
        let kernel = SegmentProductKernel {
            params: SegmentProductParams { pairs: pairs_capacity, power, onto: onto.into() },
            first_sample,
            log_rho: &log_rho,
            transmittance: &transmittance,
        };
        device.run_all(&kernel.counted(&pairs.count))?;
        Ok(Self { transmittance, segments, samples, power, blocks })
    }

    /// Multiplies by T of the scenes that are [shown with](DeviceScene::put) this one. Returns the number of samples in their fields.
    /// `pairs` are the pairs of `bins`, or some of them.
    pub fn attenuate(
        &self,
        scene: &DeviceScene,
        cameras: &[&Camera],
        pairs: &Pairs,
        bins: &TileBins,
    ) -> Result<u32> {
        let mut samples = 0_u32;
        for (index, field) in scene.fields.iter().enumerate() {
            let pairs = pairs.with_cameras(field.cameras(cameras)?);
            let segments = Segments::new(field, &pairs)?;
            let first_sample = &segments.first_sample;
            let count = bins.count_samples(field.device(), 1 + index, first_sample)?;
            samples = samples.saturating_add(count.upper_bound());
            let product = self.transmittance.view();
            Self::evaluate_into(product, true, field, &pairs, segments, count, false)?;
        }
        Ok(samples)
    }
}

/// The part of a pair's ray in the unit cube, and the light that its samples let through.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray {
    /// Points in the unit cube, from the Gaussian to the eye. A straight ray has two, s and s + w of Eq. 7. A
    /// [contracted](organza_core::scene::Contraction) one has the start of every step, and the end.
    pub places: Vec<[f32; 3]>,
    /// The logarithm of each sample's rho, Eq. 11.
    pub log_rho: Vec<f32>,
}

impl Transmittance {
    /// The rays of all pairs; evaluates the samples once more.
    pub fn rays(&self, scene: &DeviceScene, pairs: &Pairs) -> Result<Vec<Ray>> {
        let device = scene.device();
        let log_rho = log_rho(scene, pairs, &self.segments, &self.blocks)?;
        let segment = device.read(&self.segments.vectors)?;
        let first = device.read(&self.segments.first_sample)?;
        let log_rho = device.read(&log_rho)?;
        let steps = device.read(&self.segments.step)?;
        let is_contracted = !scene.config.contraction.is_none();
        let ray = |(pair, vectors): (usize, &[Vec4; SEGMENT_VECTORS as usize])| {
            let [start, w, start_rest, w_rest] = *vectors;
            let lanes = vectors.map(LaneVec4::splat);
            let samples = first[pair] as usize..first[pair + 1] as usize;
            let mut of_steps = vec![0.0; w_rest.w as usize];
            for (rank, sample) in samples.enumerate() {
                let step = if scene.config.occupancy == 0 { rank } else { steps[sample] as usize };
                of_steps[step] = log_rho[sample];
            }
            let places = if is_contracted {
                let count = of_steps.len().max(1);
                let place = |step| contracted_place(lanes, step as f32 / count as f32);
                (0..=count).map(|step| place(step).map(Split::value)).collect()
            } else {
                let begin = start + start_rest;
                let end = begin + w + w_rest;
                vec![begin.truncate().to_array(), end.truncate().to_array()]
            };
            Ray { places, log_rho: of_steps }
        };
        Ok(segment.as_chunks().0.iter().enumerate().map(ray).collect())
    }
}

impl Segments {
    /// Clips or contracts the ray of every pair, and counts its samples: the steps that the occupancy grid does not find empty.
    pub fn new(scene: &DeviceScene, pairs: &Pairs) -> Result<Self> {
        let device = scene.device();
        check_samples(scene, pairs)?;
        let capacity = pairs.count.upper_bound();
        let vectors = device.unwritten("segments", capacity as usize * SEGMENT_VECTORS as usize)?;
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
            segment: &vectors,
            count: &count,
        };
        device.run_all(&kernel.counted(&pairs.count))?;
        let occupancy = &scene.occupancy.table;
        // every binding needs a buffer, even if the kernel does not read it
        let mut bits = count.view();
        if scene.config.occupancy != 0 {
            let params = steps_params(scene, pairs);
            bits =
                device.unwritten("steps that are samples", (capacity * params.words) as usize)?;
            let kernel = StepCountKernel {
                params,
                segment: &vectors,
                occupancy,
                bits: &bits,
                count: &count,
            };
            device.run_all(&kernel.counted(&pairs.count))?;
        }
        let first_sample = exclusive_scan(device, &count, capacity)?;
        Ok(Self { vectors, first_sample, bits, step: occupancy.view() })
    }

    /// K of every segment: its steps, samples or not.
    pub fn steps(&self, device: &Device) -> Result<Vec<u32>> {
        let vectors = device.read(&self.vectors)?;
        Ok(vectors.chunks(SEGMENT_VECTORS as usize).map(|of| of[3].w as u32).collect())
    }

    /// Lists the steps that are samples, if there is an occupancy grid.
    fn list(self, scene: &DeviceScene, pairs: &Pairs, samples: &Count) -> Result<Self> {
        if scene.config.occupancy == 0 {
            return Ok(self);
        }
        let device = scene.device();
        let step = device.unwritten("steps of samples", samples.upper_bound() as usize)?;
        let kernel = StepFillKernel {
            params: steps_params(scene, pairs),
            bits: &self.bits,
            first_sample: &self.first_sample,
            step: &step,
        };
        device.run_all(&kernel.counted(&pairs.count))?;
        Ok(Self { step, ..self })
    }
}

fn steps_params(scene: &DeviceScene, pairs: &Pairs) -> StepsParams {
    StepsParams {
        pairs: pairs.count.upper_bound(),
        side: scene.config.occupancy,
        contracted: scene.config.contraction.for_kernels(),
        faint: scene.roulette.samples,
        words: longest(scene).div_ceil(u32::BITS),
    }
}

/// The largest number of steps of a segment: the cube's diagonal, and one more that rounding may add.
fn longest(scene: &DeviceScene) -> u32 {
    let steps = (3f64.sqrt() / scene.ray_step()).ceil() + 1.0;
    steps.min(f64::from(MAX_SAMPLES)) as u32
}

/// Memory for the samples of segments: see [`Blocks::new`].
fn blocks(
    scene: &DeviceScene,
    pairs: &Pairs,
    segments: &Segments,
    samples: Count,
    keep: bool,
    has_gradients: bool,
) -> Result<Blocks> {
    let device = scene.device();
    let end = |&pair: &u32| Ok(device.read_range(&segments.first_sample, pair as usize, 1)?[0]);
    let ends: Vec<_> = pairs.chunk_ends(has_gradients).iter().map(end).collect::<Result<_>>()?;
    Blocks::new(device, scene.config.transmittance_inputs(), samples, keep, &ends)
}

/// Samples are numbered in 32 bits.
fn check_samples(scene: &DeviceScene, pairs: &Pairs) -> Result<()> {
    let longest = longest(scene);
    let pairs = pairs.count.upper_bound();
    let max_samples = u64::from(pairs) * u64::from(longest);
    if max_samples > u32::MAX.into() {
        let what = format!("the samples of {pairs} segments with up to {longest} each");
        return Err(Error::OutOfMemory { needed: 4 * max_samples, available: None, what });
    }
    Ok(())
}

/// The logarithm of Eq. 11's factor for every sample.
fn log_rho(
    scene: &DeviceScene,
    pairs: &Pairs,
    segments: &Segments,
    blocks: &Blocks,
) -> Result<Buffer<f32>> {
    let device = scene.device();
    let field = &scene.transmittance;
    let log_rho = device.unwritten("log rho", blocks.count.upper_bound() as usize)?;
    let others = &|chunk: &Chunks<'_>| inputs(scene, pairs, segments, chunk);
    field.forward(device, Inputs { blocks, grid_row: 0, others }, |input, chunk| {
        let kernel = TransmittanceHeadKernel {
            params: field.head_params(chunk),
            parameters: &field.parameters,
            point: &chunk.point(),
            input,
            log_rho: &log_rho,
        };
        device.run_all(&kernel.counted(&chunk.count()))
    })?;
    Ok(log_rho)
}

/// The inputs that do not come from the hash grid, for a chunk of samples.
fn inputs(
    scene: &DeviceScene,
    pairs: &Pairs,
    segments: &Segments,
    chunk: &Chunks<'_>,
) -> Result<()> {
    let config = &scene.config;
    let kernel = TransmittanceInputsKernel {
        params: TransmittanceInputsParams {
            samples: chunk.samples(),
            first_sample: chunk.first(),
            stride: chunk.stride(),
            pairs: pairs.count.upper_bound(),
            gaussians: scene.gaussians,
            extra: config.extra,
            extra_row: config.transmittance_grid.width() as u32,
            contracted: config.contraction.for_kernels(),
            side: config.occupancy,
            faint: scene.roulette.samples,
        },
        pair: &pairs.pair,
        first_sample: &segments.first_sample,
        segment: &segments.vectors,
        extra: &scene.tensors.gaussians.extra,
        step: &segments.step,
        occupancy: &scene.occupancy.table,
        point: &chunk.point(),
        input: &chunk.input(),
    };
    scene.device().run_all(&kernel.counted(&chunk.count(), &pairs.count))
}

impl Transmittance {
    /// Backpropagates `pair_gradient [pairs, 3]` (see [`splat_backward`](organza_shaders::splat)). Adds to the gradient sums of
    /// the transmittance field. Returns the gradient of each pair's extra vector; `None` without samples.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        bins: &TileBins,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<Option<PairVectors>> {
        if self.samples.upper_bound() == 0 {
            return Ok(None);
        }
        let extra = scene.config.extra;
        let values = (bins.pairs.count.upper_bound() * extra) as usize;
        let values = scene.device().zeros("gradient of the pairs' extra vectors", values)?;
        let pair_extra = PairVectors { values, width: extra };
        let survivors = self.survivors(scene, bins, pair_gradient)?;
        let (segments, blocks) = match &survivors {
            None => (&self.segments, &self.blocks),
            Some((segments, blocks)) => (segments, blocks),
        };
        let inputs = Inputs {
            blocks,
            grid_row: 0,
            others: &|chunk| inputs(scene, &bins.pairs, segments, chunk),
        };
        let first_sample = Some(&segments.first_sample);
        let gradient = &gradient.transmittance;
        let field = &scene.transmittance;
        let is_encoded = survivors.is_none();
        let backward =
            FieldBackward { scene, bins, field, inputs, is_encoded, first_sample, gradient };
        self.backward_samples(backward, segments, pair_gradient, &pair_extra)?;
        Ok(Some(pair_extra))
    }

    /// The samples that get a gradient, in blocks that nothing is written to yet; `None` if all get one.
    fn survivors(
        &self,
        scene: &DeviceScene,
        bins: &TileBins,
        pair_gradient: &Buffer<Vec4>,
    ) -> Result<Option<(Segments, Blocks)>> {
        if scene.roulette.gradients == 0.0 {
            return Ok(None);
        }
        let device = scene.device();
        let pairs = &bins.pairs;
        let capacity = pairs.count.upper_bound();
        let count = device.zeros("counts of gradients", capacity as usize)?;
        let kernel = GradientCountKernel {
            params: GradientCountParams {
                pairs: capacity,
                power: self.power,
                faint: scene.roulette.gradients,
            },
            segment: &self.segments.vectors,
            first_sample: &self.segments.first_sample,
            transmittance: &self.transmittance,
            pair_gradient,
            count: &count,
        };
        device.run_all(&kernel.counted(&pairs.count))?;
        let first_sample = exclusive_scan(device, &count, capacity)?;
        let samples = bins.count_gradients(device, &first_sample)?;
        let segments = Segments {
            vectors: self.segments.vectors.view(),
            first_sample,
            bits: self.segments.bits.view(),
            step: self.segments.step.view(),
        };
        let segments = segments.list(scene, pairs, &samples)?;
        let blocks = blocks(scene, pairs, &segments, samples, false, true)?;
        Ok(Some((segments, blocks)))
    }

    /// Adds the gradients of samples to their sums, and to `pair_extra`.
    fn backward_samples(
        &self,
        backward: FieldBackward<'_>,
        segments: &Segments,
        pair_gradient: &Buffer<Vec4>,
        pair_extra: &PairVectors,
    ) -> Result<()> {
        let FieldBackward { scene, bins, .. } = backward;
        let device = scene.device();
        let first_sample = &segments.first_sample;
        let owners = Owners {
            all: &bins.pairs.count,
            first: match &bins.part_counts {
                None => Some(device.read(first_sample)?),
                Some(_) => None,
            },
        };
        // a pair's samples may lie in two chunks: they are added in order
        backward.run(
            |scratch, chunk| {
                self.head_backward(scene, scratch, chunk, &owners, first_sample, pair_gradient)
            },
            |input_gradient, chunk| {
                let (first_pair, count) = owners.of_chunk(chunk);
                let pairs = count.upper_bound();
                let kernel = ExtraBackwardKernel {
                    params: ExtraBackwardParams {
                        pairs,
                        first_pair,
                        samples: chunk.samples(),
                        first_sample: chunk.first(),
                        stride: chunk.stride(),
                        extra: pair_extra.width,
                        extra_row: scene.config.transmittance_grid.width() as u32,
                    },
                    first_sample,
                    input_gradient,
                    pair_extra: &pair_extra.values,
                };
                device.run_all(&kernel.counted(&count, &chunk.count()))
            },
        )
    }

    /// The gradient of the network's output for a chunk of samples.
    fn head_backward(
        &self,
        scene: &DeviceScene,
        scratch: &ChunkScratch,
        chunk: &Chunks<'_>,
        owners: &Owners<'_>,
        first_sample: &Buffer<u32>,
        pair_gradient: &Buffer<Vec4>,
    ) -> Result<()> {
        let device = scene.device();
        let log_rho_gradient = &scratch.head_scratch;
        let (first_pair, count) = owners.of_chunk(chunk);
        let pairs = count.upper_bound();
        let kernel = SegmentProductBackwardKernel {
            params: SegmentProductBackwardParams {
                pairs,
                first_pair,
                samples: chunk.samples(),
                first_sample: chunk.first(),
                power: self.power,
                faint: scene.roulette.gradients,
            },
            first_sample,
            transmittance: &self.transmittance,
            pair_gradient,
            log_rho_gradient,
        };
        device.run_all(&kernel.counted(&count, &chunk.count()))?;
        let field = &scene.transmittance;
        let kernel = TransmittanceHeadBackwardKernel {
            params: field.head_params(chunk),
            parameters: &field.parameters,
            point: &chunk.point(),
            input: &scratch.last_hidden(chunk),
            log_rho_gradient,
            logit_gradient: &scratch.logit_gradient,
        };
        device.run_all(&kernel.counted(&chunk.count()))
    }
}

/// Which pairs have samples in which chunk.
struct Owners<'a> {
    all: &'a Count,
    /// `[pairs + 1]`: each pair's first sample, if the host knows it.
    first: Option<Vec<u32>>,
}

impl Owners<'_> {
    /// The first pair with samples in a chunk, and how many there are. All pairs, if the host does not know them.
    fn of_chunk(&self, chunk: &Chunks<'_>) -> (u32, Count) {
        let Some(first) = &self.first else { return (0, self.all.clone()) };
        let begin = first.partition_point(|&begin| begin <= chunk.first()) as u32 - 1;
        let end = chunk.first() + chunk.samples();
        let end = first.partition_point(|&begin| begin < end) as u32;
        (begin, Count::known(end - begin))
    }
}
