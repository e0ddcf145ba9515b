//! B1 and B2: the segments of all pairs, their samples as one flat list, and the products.

use glam::Vec4;
use organza_kernels::limits::MAX_SAMPLES;
use organza_kernels::segment::{SegmentKernel, SegmentParams};
use organza_kernels::transmittance::{
    SegmentProductKernel, SegmentProductParams, TransmittanceHeadKernel, TransmittanceHeadParams,
    TransmittanceInputsKernel, TransmittanceInputsParams,
};

use super::DeviceScene;
use super::bin::Pairs;
use super::field::Scratch;
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
}

impl Transmittance {
    pub fn evaluate(device: &Device, scene: &DeviceScene, pairs: &Pairs) -> Result<Self> {
        check_samples(scene, pairs)?;
        let segment = device.zeros("segments", pairs.count as usize * 2)?;
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
        Ok(Self { transmittance, first_sample, samples })
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
        let inputs = TransmittanceInputsKernel {
            params: TransmittanceInputsParams {
                samples,
                first_sample: first,
                stride: scratch.stride,
                pairs: pairs.count,
                gaussians: scene.gaussians,
                extra: config.extra,
                extra_row: config.transmittance_grid.width() as u32,
            },
            pair: &pairs.pair,
            first_sample,
            segment,
            extra: &scene.extra,
            point: &scratch.point,
            input: &scratch.input,
        };
        device.run(&inputs, samples, 1)?;
        field.encode(device, &scratch, samples, 0)?;
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
