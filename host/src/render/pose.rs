//! The gradient of the cameras' poses, for the pairs of a part. [`organza_shaders::pose_backward`] has the equations.

use glam::Vec4;
use organza_shaders::pose_backward::{
    BLOCK, MAX_BLOCKS, PoseBackwardKernel, PoseBackwardParams, PoseSumKernel, PoseSumParams, VALUES,
};

use super::bin::Bins;
use super::plan::words;
use super::scene::DeviceScene;
use crate::error;
use crate::ranks::Ranks;
use organza_device::{Buffer, Device, Result};

/// Numbers of a pose: a rotation vector and a shift. [`Camera::moved`](crate::Camera::moved) says what they mean.
pub const POSE: usize = VALUES as usize;

/// Gradients of the poses of a batch's cameras; kernels add to them.
#[derive(Debug)]
pub struct PoseGradient {
    /// `[cameras, 6]`, all cameras that a batch may show.
    sum: Buffer<f32>,
}

impl PoseGradient {
    /// Zeros.
    pub fn new(device: &Device, cameras: usize) -> Result<Self> {
        Ok(Self { sum: device.zeros("gradients of poses", POSE * cameras)? })
    }

    /// The same gradients, on the same memory.
    pub fn view(&self) -> Self {
        Self { sum: self.sum.view() }
    }

    /// Numbers of all poses.
    pub fn len(&self) -> usize {
        self.sum.len()
    }

    /// Replaces the gradients `[cameras, 6]`.
    pub fn write(&self, device: &Device, values: &[f32]) -> Result<()> {
        device.write(&self.sum, 0, values)
    }

    /// Adds what `pair_gradient [pairs, 3]` makes of the poses of a part's cameras.
    pub fn add(
        &self,
        device: &Device,
        scene: &DeviceScene,
        bins: &Bins,
        pair_gradient: &Buffer<Vec4>,
    ) -> Result<()> {
        let (pairs, tensors) = (&bins.pairs, &scene.tensors.gaussians);
        let (gaussians, cameras) = (scene.gaussians, bins.cameras.len() as u32);
        let (words, blocks) = (words(gaussians), gaussians.div_ceil(BLOCK));
        let values = (cameras * blocks * VALUES) as usize;
        let partial = device.unwritten("gradients of poses, by blocks of pairs", values)?;
        let kernel = PoseBackwardKernel {
            params: PoseBackwardParams { gaussians, words, blocks, blur: scene.config.blur as f32 },
            camera: &pairs.camera,
            position: &tensors.position,
            rotation: &tensors.rotation,
            log_scale: &tensors.log_scale,
            first_pair: &bins.pair_mask.first,
            pair: &pairs.pair,
            pair_gradient,
            partial: &partial,
        };
        device.run(&kernel, blocks, cameras)?;
        let index = device.upload("cameras of a part", &bins.cameras)?;
        for first in (0..blocks).step_by(MAX_BLOCKS as usize) {
            let end = blocks.min(first + MAX_BLOCKS);
            let kernel = PoseSumKernel {
                params: PoseSumParams { cameras, blocks, first, end },
                index: &index,
                partial: &partial,
                gradient: &self.sum,
            };
            device.run(&kernel, cameras * VALUES, 1)?;
        }
        Ok(())
    }

    /// Adds what all ranks have of some cameras. What one rank alone has keeps its bits.
    pub fn add_ranks(
        &self,
        device: &Device,
        cameras: &[usize],
        ranks: &dyn Ranks,
    ) -> error::Result<()> {
        let mut all = self.read(device)?;
        let mine: Vec<_> = cameras.iter().map(|&camera| std::mem::take(&mut all[camera])).collect();
        for bytes in ranks.gather(bytemuck::cast_slice(&mine).to_vec())? {
            let found: Vec<[f32; POSE]> = bytemuck::pod_collect_to_vec(&bytes);
            for (&camera, found) in cameras.iter().zip(&found) {
                all[camera].iter_mut().zip(found).for_each(|(sum, value)| *sum += value);
            }
        }
        Ok(self.write(device, all.as_flattened())?)
    }

    /// The gradients, by camera; waits for the device.
    pub fn read(&self, device: &Device) -> Result<Vec<[f32; POSE]>> {
        Ok(device.read(&self.sum)?.as_chunks().0.to_vec())
    }

    /// Zeros, as in the beginning.
    pub fn clear(&self, device: &Device) {
        device.clear(&self.sum);
    }
}
