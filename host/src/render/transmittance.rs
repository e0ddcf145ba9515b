//! B1 and B2: the segments of all pairs, their samples as one flat list, and the products.

use glam::Vec4;
use organza_kernels::limits::MAX_SAMPLES;
use organza_kernels::segment::{SEGMENT_VECTORS, SegmentKernel, SegmentParams};
use organza_kernels::transmittance::{
    SegmentProductKernel, SegmentProductParams, TransmittanceHeadKernel, TransmittanceHeadParams,
    TransmittanceInputsKernel, TransmittanceInputsParams,
};
use organza_kernels::transmittance_backward::{
    ExtraBackwardKernel, ExtraBackwardParams, SegmentProductBackwardKernel,
    SegmentProductBackwardParams, TransmittanceHeadBackwardKernel, TransmittanceHeadBackwardParams,
};

use super::DeviceScene;
use super::bin::{Bins, Pairs};
use super::field::{Rows, Scratch};
use super::field_backward::BackwardScratch;
use super::gradient::SceneGradient;
use super::pair::sum_pairs;
use super::scan::exclusive_scan;
use crate::backend::{Buffer, Device};
use crate::error::{Error, Result};

/// Transmittance of every pair.
#[derive(Debug)]
pub struct Transmittance {
    /// `[pairs]`
    pub transmittance: Buffer<f32>,
    /// `[pairs + 1]`
    pub first_sample: Buffer<u32>,
    /// Samples of all segments.
    pub samples: u32,
    /// `[pairs, 4]`
    segment: Buffer<Vec4>,
}

impl Transmittance {
    pub fn evaluate(device: &Device, scene: &DeviceScene, pairs: &Pairs) -> Result<Self> {
        check_samples(scene, pairs)?;
        let segment = device.zeros("segments", pairs.count as usize * SEGMENT_VECTORS as usize)?;
        let count = device.zeros("sample counts", pairs.count as usize)?;
        let kernel = SegmentKernel {
            params: SegmentParams {
                pairs: pairs.count,
                gaussians: scene.gaussians,
                step: scene.config.step as f32,
            },
            pair: &pairs.pair,
            camera: &pairs.camera,
            scene_box: &scene.scene_box,
            position: &scene.position,
            segment: &segment,
            count: &count,
        };
        device.run(&kernel, pairs.count, 1)?;
        let first_sample = exclusive_scan(device, &count, pairs.count)?;
        let samples = device.read_range(&first_sample, pairs.count as usize, 1)?[0];

        let log_rho = log_rho(device, scene, pairs, &segment, &first_sample, samples)?;
        let transmittance = device.zeros("transmittance", pairs.count as usize)?;
        let kernel = SegmentProductKernel {
            params: SegmentProductParams { pairs: pairs.count },
            first_sample: &first_sample,
            log_rho: &log_rho,
            transmittance: &transmittance,
        };
        device.run(&kernel, pairs.count, 1)?;
        Ok(Self { transmittance, first_sample, samples, segment })
    }
}

/// Samples are numbered in 32 bits.
fn check_samples(scene: &DeviceScene, pairs: &Pairs) -> Result<()> {
    let longest = (3f64.sqrt() / scene.config.step).ceil().min(f64::from(MAX_SAMPLES));
    let most = f64::from(pairs.count) * longest;
    if most > f64::from(u32::MAX) {
        let what = format!("the samples of {} segments with up to {longest} each", pairs.count);
        return Err(Error::OutOfMemory { needed: most as u64 * 4, available: None, what });
    }
    Ok(())
}

/// The logarithm of Eq. 11's factor for every sample, chunk by chunk.
fn log_rho(
    device: &Device,
    scene: &DeviceScene,
    pairs: &Pairs,
    segment: &Buffer<Vec4>,
    first_sample: &Buffer<u32>,
    samples: u32,
) -> Result<Buffer<f32>> {
    let (config, field) = (&scene.config, &scene.transmittance);
    let log_rho = device.zeros("log rho", samples as usize)?;
    let scratch = Scratch::new(device, field, config.transmittance_inputs(), samples)?;
    let head = field.head();
    for (first, samples) in scratch.chunks(samples) {
        inputs(device, scene, pairs, segment, first_sample, [first, samples], scratch.rows())?;
        field.encode(device, scratch.rows(), samples, 0)?;
        let kernel = TransmittanceHeadKernel {
            params: TransmittanceHeadParams {
                samples,
                first_sample: first,
                stride: scratch.stride,
                inputs: head.inputs,
                weight: head.weight,
                bias: head.bias,
            },
            parameters: &field.parameters,
            point: &scratch.point,
            input: field.hidden(device, &scratch, samples)?,
            log_rho: &log_rho,
        };
        device.run(&kernel, samples, 1)?;
    }
    Ok(log_rho)
}

/// What does not come from the hash grid, for a chunk of samples: its first one, and how many there are.
fn inputs(
    device: &Device,
    scene: &DeviceScene,
    pairs: &Pairs,
    segment: &Buffer<Vec4>,
    first_sample: &Buffer<u32>,
    [first, samples]: [u32; 2],
    rows: Rows<'_>,
) -> Result<()> {
    let config = &scene.config;
    let kernel = TransmittanceInputsKernel {
        params: TransmittanceInputsParams {
            samples,
            first_sample: first,
            stride: rows.stride,
            pairs: pairs.count,
            gaussians: scene.gaussians,
            extra: config.extra,
            extra_row: config.transmittance_grid.width() as u32,
        },
        pair: &pairs.pair,
        first_sample,
        segment,
        extra: &scene.extra,
        point: rows.point,
        input: rows.input,
    };
    device.run(&kernel, samples, 1)
}

impl Transmittance {
    /// Adds the gradients of the transmittance field and of the extra vectors, of `pair_gradient [pairs, 3]` (see
    /// [`splat_backward`](organza_kernels::splat)).
    pub fn backward(
        &self,
        device: &Device,
        scene: &DeviceScene,
        bins: &Bins,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        if self.samples == 0 {
            return Ok(());
        }
        let (pairs, field, extra) = (&bins.pairs, &scene.transmittance, scene.config.extra);
        let scratch = BackwardScratch::new(device, field, self.samples)?;
        let log_rho_gradient = device.zeros("gradient of log rho", scratch.stride as usize)?;
        let pair_extra =
            device.zeros("gradient of the pairs' extra vectors", (pairs.count * extra) as usize)?;
        // which pairs a chunk has samples of
        let first_samples = device.read(&self.first_sample)?;
        let table = &gradient.transmittance.table;
        let transmittance = Some(&self.transmittance);
        table.set_scale(device, field, pair_gradient, transmittance, pairs.count, self.samples)?;
        for (first, samples) in scratch.chunks(self.samples) {
            let (segment, first_sample) = (&self.segment, &self.first_sample);
            let rows = scratch.rows();
            inputs(device, scene, pairs, segment, first_sample, [first, samples], rows)?;
            field.activate(device, &scratch, samples, 0)?;

            let first_pair = first_samples.partition_point(|&begin| begin <= first) as u32 - 1;
            let end_pair = first_samples.partition_point(|&begin| begin < first + samples) as u32;
            let chunk = Chunk { first, samples, first_pair, pairs: end_pair - first_pair };
            self.head_backward(device, scene, &scratch, chunk, pair_gradient, &log_rho_gradient)?;
            field.backward(device, &scratch, samples, 0, &gradient.transmittance)?;
            self.extra_backward(device, scene, &scratch, chunk, &pair_extra)?;
        }
        table.finish(device)?;
        sum_pairs(device, scene, &bins.pair_mask, extra, &pair_extra, &gradient.extra)
    }

    /// The gradient of the network's output for a chunk of samples.
    fn head_backward(
        &self,
        device: &Device,
        scene: &DeviceScene,
        scratch: &BackwardScratch,
        chunk: Chunk,
        pair_gradient: &Buffer<Vec4>,
        log_rho_gradient: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = SegmentProductBackwardKernel {
            params: SegmentProductBackwardParams {
                pairs: chunk.pairs,
                first_pair: chunk.first_pair,
                samples: chunk.samples,
                first_sample: chunk.first,
            },
            first_sample: &self.first_sample,
            transmittance: &self.transmittance,
            pair_gradient,
            log_rho_gradient,
        };
        device.run(&kernel, chunk.pairs, 1)?;
        let field = &scene.transmittance;
        let head = field.head();
        let kernel = TransmittanceHeadBackwardKernel {
            params: TransmittanceHeadBackwardParams {
                samples: chunk.samples,
                stride: scratch.stride,
                inputs: head.inputs,
                weight: head.weight,
                bias: head.bias,
            },
            parameters: &field.parameters,
            point: scratch.rows().point,
            input: scratch.last_hidden(),
            log_rho_gradient,
            logit_gradient: &scratch.logit_gradient,
        };
        device.run(&kernel, chunk.samples, 1)
    }

    /// Adds the gradients of the pairs' extra vectors that come from a chunk of samples.
    fn extra_backward(
        &self,
        device: &Device,
        scene: &DeviceScene,
        scratch: &BackwardScratch,
        chunk: Chunk,
        pair_extra: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = ExtraBackwardKernel {
            params: ExtraBackwardParams {
                pairs: chunk.pairs,
                first_pair: chunk.first_pair,
                samples: chunk.samples,
                first_sample: chunk.first,
                stride: scratch.stride,
                extra: scene.config.extra,
                extra_row: scene.config.transmittance_grid.width() as u32,
            },
            first_sample: &self.first_sample,
            input_gradient: &scratch.input_gradient,
            pair_extra,
        };
        device.run(&kernel, chunk.pairs, scene.config.extra)
    }
}

/// A chunk of samples, and the pairs that have some of them.
#[derive(Clone, Copy, Debug)]
struct Chunk {
    first: u32,
    samples: u32,
    first_pair: u32,
    pairs: u32,
}
