//! Adam for every tensor of a scene.

use organza_shaders::adam::{AdamKernel, AdamParams};

use super::config::OptimizerConfig;
use crate::error::Result;
use crate::render::{DeviceScene, SceneGradient, pack, unpack, upload};
use crate::scene::{Scene, Tensors};
use organza_device::{Buffer, Device};

/// Both moments of every parameter, and the flag of tensors that are never sparse.
#[derive(Debug)]
pub struct Optimizer {
    /// m and v.
    moments: [Tensors<Buffer<f32>>; 2],
    always: Buffer<u32>,
}

impl Optimizer {
    /// From the moments of an earlier run, or zeros.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn new(device: &Device, [first, second]: &[Scene; 2]) -> Result<Self> {
        let moments = [upload(device, pack(first))?, upload(device, pack(second))?];
        Ok(Self { moments, always: device.upload("touched", &[1])? })
    }

    /// The moments as they are now, as scenes.
    ///
    /// # Errors
    /// As [`Device::read`].
    pub fn moments(&self, device: &Device, scene: &DeviceScene) -> Result<[Scene; 2]> {
        let read = |moment: &Tensors<Buffer<f32>>| {
            unpack(scene.config(), scene.len(), moment.as_ref(), |buffer, values| {
                device.read_into(buffer, 0, values)
            })
        };
        let [first, second] = &self.moments;
        Ok([read(first)?, read(second)?])
    }

    /// Moves every parameter, and clears the gradient.  `step` counts from 0; `share` is the part of the run that is
    /// done.
    ///
    /// # Errors
    /// As [`Device::dispatch`].
    pub fn step(
        &self,
        device: &Device,
        scene: &DeviceScene,
        gradient: &SceneGradient,
        config: &OptimizerConfig,
        (step, share): (u32, f64),
    ) -> Result<()> {
        let t = f64::from(step) + 1.0;
        let correction1 = 1.0 / (1.0 - config.beta1.powf(t));
        let correction2 = (1.0 / (1.0 - config.beta2.powf(t))).sqrt();
        let mut rates = config.rates().map(|_, rate| rate.at(share));
        rates.gaussians.position *= scene.extent();
        let [first, second] = self.moments.each_ref().map(Tensors::as_ref);
        let tensors = scene.tensors().as_ref().zip(gradient.tensors().as_ref());
        tensors.zip(rates).zip(first.zip(second)).try_map(|_, ((tensor, rate), moments)| {
            let ((value, gradient), (first_moment, second_moment)) = (tensor, moments);
            let values = value.len() as u32;
            let kernel = AdamKernel {
                params: AdamParams {
                    values,
                    first_gradient: gradient.range.start as u32,
                    sparse: u32::from(gradient.touched.is_some()),
                    rate: (rate * correction1) as f32,
                    decay1: config.beta1 as f32,
                    decay2: config.beta2 as f32,
                    correction2: correction2 as f32,
                    epsilon: config.epsilon as f32,
                },
                touched: gradient.touched.as_ref().unwrap_or(&self.always),
                gradient: &gradient.buffer,
                first_moment,
                second_moment,
                value,
            };
            device.run(&kernel, values, 1)
        })?;
        Ok(())
    }
}
