//! Adam for every tensor of a scene.

use organza_shaders::adam::{AdamKernel, AdamParams};

use super::config::{EPSILON, OptimizerConfig};
use crate::error::Result;
use crate::render::{
    DeviceScene, DeviceShare, SceneGradient, ShareGradient, TensorGradient, in_slices, pack,
    read_slices, unpack, upload,
};
use crate::scene::{GaussianTensors, Gaussians, Scene, Tensors};
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
        now: (u32, f64),
    ) -> Result<()> {
        let adam = Adam::new(device, config, &self.always, now, scene.extent());
        let [first, second] = self.moments.each_ref().map(Tensors::as_ref);
        let tensors = scene.tensors().as_ref().zip(gradient.tensors().as_ref());
        let all = tensors.zip(adam.rates).zip(first.zip(second));
        all.try_map(|_, ((tensor, rate), moments)| adam.step(tensor, rate, moments))?;
        Ok(())
    }
}

/// Adam for a share of a scene: the fields' moments, and those of each slice's Gaussians.
#[derive(Debug)]
pub struct ShareOptimizer {
    fields: Optimizer,
    slices: Vec<[GaussianTensors<Buffer<f32>>; 2]>,
}

impl ShareOptimizer {
    /// From the moments of a share's tensors.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn new(device: &Device, moments: &[Scene; 2]) -> Result<Self> {
        let fields = |moment: &Scene| -> Result<Scene> {
            let mut fields = Scene::zeros(moment.config.clone(), 1)?;
            fields.color.clone_from(&moment.color);
            fields.transmittance.clone_from(&moment.transmittance);
            Ok(fields)
        };
        let [first, second] = moments;
        let fields = Optimizer::new(device, &[fields(first)?, fields(second)?])?;
        let mut optimizer = Self { fields, slices: Vec::new() };
        optimizer.replace_slices(device, moments)?;
        Ok(optimizer)
    }

    /// The moments of the Gaussians are these from now on.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn replace_slices(&mut self, device: &Device, [first, second]: &[Scene; 2]) -> Result<()> {
        // not both at once
        self.slices.clear();
        for (first, second) in in_slices(&first.gaussians).zip(in_slices(&second.gaussians)) {
            let upload = |moment: &Gaussians| {
                moment.tensors().try_map(|name, values| device.upload(name, values))
            };
            self.slices.push([upload(&first)?, upload(&second)?]);
        }
        Ok(())
    }

    /// The moments as they are now.
    ///
    /// # Errors
    /// As [`Device::read`].
    pub fn moments(&self, device: &Device, share: &DeviceShare) -> Result<[Scene; 2]> {
        let mut moments = self.fields.moments(device, share.fields())?;
        for (place, moment) in moments.iter_mut().enumerate() {
            moment.gaussians = Gaussians::zeros(share.config(), share.len())?;
            let slices = self.slices.iter().map(|moments| moments[place].as_ref());
            read_slices(device, slices, &mut moment.gaussians)?;
        }
        Ok(moments)
    }

    /// As [`Optimizer::step`].
    ///
    /// # Errors
    /// As [`Optimizer::step`].
    pub fn step(
        &self,
        device: &Device,
        share: &DeviceShare,
        gradient: &ShareGradient,
        config: &OptimizerConfig,
        now: (u32, f64),
    ) -> Result<()> {
        let fields = share.fields();
        self.fields.step(device, fields, &gradient.fields, config, now)?;
        let adam = Adam::new(device, config, &self.fields.always, now, fields.extent());
        let slices = share.slices().iter().zip(&gradient.slices).zip(&self.slices);
        for ((slice, gradient), [first, second]) in slices {
            let gradient = gradient.tensors().gaussians.as_ref();
            let tensors = slice.tensors().gaussians.as_ref().zip(gradient);
            let all = tensors.zip(adam.rates.gaussians).zip(first.as_ref().zip(second.as_ref()));
            all.try_map(|_, ((tensor, rate), moments)| adam.step(tensor, rate, moments))?;
        }
        Ok(())
    }
}

/// One step of Adam.
struct Adam<'a> {
    device: &'a Device,
    config: &'a OptimizerConfig,
    always: &'a Buffer<u32>,
    /// The rate of each tensor, and what weight decay leaves of its values.
    rates: Tensors<(f64, f64)>,
    correction1: f64,
    correction2: f64,
}

impl<'a> Adam<'a> {
    fn new(
        device: &'a Device,
        config: &'a OptimizerConfig,
        always: &'a Buffer<u32>,
        (step, share): (u32, f64),
        extent: f64,
    ) -> Self {
        let t = f64::from(step) + 1.0;
        let correction1 = 1.0 / (1.0 - config.beta1.powf(t));
        let correction2 = (1.0 / (1.0 - config.beta2.powf(t))).sqrt();
        let mut rates = config.rates().map(|_, rate| (config.rate_at(rate, share), 1.0));
        rates.gaussians.position.0 *= extent;
        let (rate, kept) = &mut rates.transmittance.grid;
        *kept -= *rate * config.transmittance_decay;
        Self { device, config, always, rates, correction1, correction2 }
    }

    fn step(
        &self,
        (value, gradient): (&Buffer<f32>, &TensorGradient),
        (rate, kept): (f64, f64),
        (first_moment, second_moment): (&Buffer<f32>, &Buffer<f32>),
    ) -> organza_device::Result<()> {
        let values = value.len() as u32;
        let kernel = AdamKernel {
            params: AdamParams {
                values,
                first_gradient: gradient.range.start as u32,
                sparse: u32::from(gradient.touched.is_some()),
                rate: (rate * self.correction1) as f32,
                decay1: self.config.beta1 as f32,
                decay2: self.config.beta2 as f32,
                correction2: self.correction2 as f32,
                epsilon: EPSILON as f32,
                kept: kept as f32,
            },
            touched: gradient.touched.as_ref().unwrap_or(self.always),
            gradient: &gradient.buffer,
            first_moment,
            second_moment,
            value,
        };
        self.device.run(&kernel, values, 1)
    }
}
