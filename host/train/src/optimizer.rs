//! Adam for every tensor of a scene.

use organza_shaders::adam::{AdamKernel, AdamParams};

use super::config::{EPSILON, OptimizerConfig};
use muslin_device::{Buffer, Device};
use organza_core::error::Result;
use organza_core::scene::{GaussianTensors, Gaussians, Scene, Tensors};
use organza_render::{
    DeviceScene, SceneGradient, TensorGradient, pack, replace_gaussians, unpack, upload,
};

/// Both moments of every parameter.
#[derive(Debug)]
pub struct Optimizer {
    /// m and v.
    moments: [Tensors<Buffer<f32>>; 2],
    /// `[1]`: the flag of tensors that are never sparse.
    always: Buffer<u32>,
}

impl Optimizer {
    /// Uploads moments, of an earlier run or zeros.
    pub fn new(device: &Device, [first, second]: &[Scene; 2]) -> Result<Self> {
        let moments = [upload(device, pack(first))?, upload(device, pack(second))?];
        Ok(Self { moments, always: device.upload("touched", &[1])? })
    }

    /// Replaces the moments of the Gaussians.
    pub fn replace_gaussians(&mut self, device: &Device, moments: &[Gaussians; 2]) -> Result<()> {
        for (own, moment) in self.moments.iter_mut().zip(moments) {
            replace_gaussians(device, own, moment)?;
        }
        Ok(())
    }

    /// The moments of the Gaussians, m and v.
    pub fn of_gaussians(&self) -> [&GaussianTensors<Buffer<f32>>; 2] {
        self.moments.each_ref().map(|moment| &moment.gaussians)
    }

    /// The moments as they are now, as scenes.
    pub fn moments(&self, device: &Device, scene: &DeviceScene) -> Result<[Scene; 2]> {
        let read = |moment: &Tensors<Buffer<f32>>| {
            unpack(scene.config(), scene.len(), moment.as_ref(), |buffer, values| {
                device.read_into(buffer, 0, values)
            })
        };
        let [first, second] = &self.moments;
        Ok([read(first)?, read(second)?])
    }

    /// Moves every parameter that has a gradient, and clears the gradient. `step` counts from 0; `fraction` is the part of the run that is
    /// done.
    pub fn step(
        &self,
        device: &Device,
        scene: &DeviceScene,
        gradient: &SceneGradient,
        config: &OptimizerConfig,
        (step, fraction): (u32, f64),
    ) -> Result<()> {
        let adam = self.adam(device, config, gradient);
        let updates = updates(config, gradient.has_transmittance, (step, fraction), scene.extent());
        let [first, second] = self.moments.each_ref().map(Tensors::as_ref);
        let tensors = scene.tensors().as_ref().zip(gradient.tensors().as_ref());
        let all = tensors.zip(updates).zip(first.zip(second));
        all.try_map(|_, ((tensor, update), moments)| adam.step(tensor, update, moments))?;
        Ok(())
    }

    /// One step of Adam, for other tensors than the scene's, too.
    pub fn adam<'a>(
        &'a self,
        device: &'a Device,
        config: &'a OptimizerConfig,
        gradient: &'a SceneGradient,
    ) -> Adam<'a> {
        Adam { device, config, gradient, always: &self.always }
    }
}

/// One step of Adam.
pub struct Adam<'a> {
    pub device: &'a Device,
    config: &'a OptimizerConfig,
    pub gradient: &'a SceneGradient,
    always: &'a Buffer<u32>,
}

/// The numbers that differ between the updates of tensors.
#[derive(Clone, Copy)]
pub struct Update {
    /// Learning rate, corrected for the first moment's start at zero.
    rate: f64,
    /// The same for the root of the second moment.
    correction2: f64,
    /// Factor of weight decay on the values.
    kept: f64,
}

impl Update {
    /// `updates` is the number of the tensor's updates before this one.
    pub fn new(config: &OptimizerConfig, rate: f64, updates: u32) -> Self {
        let t = f64::from(updates) + 1.0;
        let correction1 = 1.0 / (1.0 - config.beta1.powf(t));
        let correction2 = (1.0 / (1.0 - config.beta2.powf(t))).sqrt();
        Self { rate: rate * correction1, correction2, kept: 1.0 }
    }
}

/// The update of each tensor of a scene; `None` for T's if they stay as they are.
fn updates(
    config: &OptimizerConfig,
    has_transmittance: bool,
    (step, fraction): (u32, f64),
    extent: f64,
) -> Tensors<Option<Update>> {
    let mut rates = config.rates().map(|_, rate| config.rate_at(rate, fraction));
    rates.gaussians.position *= extent;
    let kept = 1.0 - rates.transmittance.grid * config.transmittance_decay;
    let mut updates = rates.map(|_, rate| Some(Update::new(config, rate, step)));
    let of_transmittance = |rate| {
        let updates = step / config.transmittance_every;
        has_transmittance.then(|| Update::new(config, rate, updates))
    };
    updates.gaussians.extra = of_transmittance(rates.gaussians.extra);
    updates.transmittance.network = of_transmittance(rates.transmittance.network);
    updates.transmittance.grid =
        of_transmittance(rates.transmittance.grid).map(|update| Update { kept, ..update });
    updates
}

impl Adam<'_> {
    /// Moves a tensor, and clears its gradient. Nothing happens without an update.
    pub fn step(
        &self,
        (value, gradient): (&Buffer<f32>, &TensorGradient),
        update: Option<Update>,
        (first_moment, second_moment): (&Buffer<f32>, &Buffer<f32>),
    ) -> muslin_device::Result<()> {
        let Some(Update { rate, correction2, kept }) = update else { return Ok(()) };
        let values = value.len() as u32;
        let kernel = AdamKernel {
            params: AdamParams {
                values,
                first_gradient: gradient.range.start as u32,
                sparse: u32::from(gradient.touched.is_some()),
                rate: rate as f32,
                decay1: self.config.beta1 as f32,
                decay2: self.config.beta2 as f32,
                correction2: correction2 as f32,
                epsilon: EPSILON as f32,
                kept: kept as f32,
            },
            touched: gradient.touched.as_ref().unwrap_or(self.always),
            gradient: &gradient.buffer,
            first_moment,
            second_moment,
            value,
        };
        self.device.run_all(&kernel.counted(&self.gradient.unless_failed(values)))
    }
}
