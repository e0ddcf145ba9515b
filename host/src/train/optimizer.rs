//! Adam for every tensor of a scene: which rate, which gradient, which flags.

use organza_shaders::adam::{AdamKernel, AdamParams};

use super::config::{OptimizerConfig, Rate};
use crate::error::Result;
use crate::render::{DeviceScene, SceneGradient};
use organza_device::{Buffer, Device};

/// Both moments of every parameter, and the flag of groups that are never sparse.
#[derive(Debug)]
pub struct Optimizer {
    /// m, as a scene.
    pub first: DeviceScene,
    /// v, as a scene.
    pub second: DeviceScene,
    always: Buffer<u32>,
}

/// One tensor's buffers, all as plain numbers.
struct Group<'a> {
    rate: f64,
    value: Buffer<f32>,
    first_moment: Buffer<f32>,
    second_moment: Buffer<f32>,
    gradient: Buffer<f32>,
    first_gradient: usize,
    /// Flags of blocks; every block moves where there are none.
    touched: Option<&'a Buffer<u32>>,
}

impl Optimizer {
    /// From the moments of an earlier run, or zeros.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn new(device: &Device, first: DeviceScene, second: DeviceScene) -> Result<Self> {
        Ok(Self { first, second, always: device.upload("touched", &[1])? })
    }

    /// Moves every parameter, and clears the gradient.  `step` counts from 0; `extent` is half the scene box's longest
    /// side.
    ///
    /// # Errors
    /// As [`Device::dispatch`].
    pub fn step(
        &self,
        device: &Device,
        scene: &DeviceScene,
        gradient: &SceneGradient,
        config: &OptimizerConfig,
        [step, steps]: [u32; 2],
        learn_transmittance: bool,
    ) -> Result<()> {
        let t = f64::from(step) + 1.0;
        let correction1 = 1.0 / (1.0 - config.beta1.powf(t));
        let correction2 = (1.0 / (1.0 - config.beta2.powf(t))).sqrt();
        let at = |rate: Rate| rate.at(step, steps);
        for group in self.groups(scene, gradient, config, &at, learn_transmittance) {
            let values = group.value.len() as u32;
            let kernel = AdamKernel {
                params: AdamParams {
                    values,
                    first_gradient: group.first_gradient as u32,
                    sparse: u32::from(group.touched.is_some()),
                    rate: (group.rate * correction1) as f32,
                    decay1: config.beta1 as f32,
                    decay2: config.beta2 as f32,
                    correction2: correction2 as f32,
                    epsilon: config.epsilon as f32,
                },
                touched: group.touched.unwrap_or(&self.always),
                gradient: &group.gradient,
                first_moment: &group.first_moment,
                second_moment: &group.second_moment,
                value: &group.value,
            };
            device.run(&kernel, values, 1)?;
        }
        Ok(())
    }

    fn groups<'a>(
        &self,
        scene: &DeviceScene,
        gradient: &'a SceneGradient,
        config: &OptimizerConfig,
        at: &dyn Fn(Rate) -> f64,
        learn_transmittance: bool,
    ) -> Vec<Group<'a>> {
        let parameters = [scene, &self.first, &self.second].map(DeviceScene::parameters);
        let [values, first, second] = parameters;
        let rate = |name: Parameter| match name {
            Parameter::Position => at(config.position) * scene.extent(),
            Parameter::Rotation => at(config.rotation),
            Parameter::LogScale => at(config.log_scale),
            Parameter::Opacity => at(config.opacity),
            Parameter::Material => at(config.material),
            Parameter::Extra => at(config.extra),
            Parameter::ColorGrid | Parameter::TransmittanceGrid => at(config.grids),
            Parameter::ColorNetwork | Parameter::TransmittanceNetwork => at(config.networks),
        };
        let is_learned = |name: Parameter| {
            learn_transmittance
                || !matches!(name, Parameter::TransmittanceGrid | Parameter::TransmittanceNetwork)
        };
        values
            .into_iter()
            .zip(first)
            .zip(second)
            .filter(|(((name, _), _), _)| is_learned(*name))
            .map(|(((name, value), (_, first_moment)), (_, second_moment))| {
                let (gradient, first_gradient, touched) = gradient.of(name, scene.len());
                let rate = rate(name);
                Group {
                    rate,
                    value,
                    first_moment,
                    second_moment,
                    gradient,
                    first_gradient,
                    touched,
                }
            })
            .collect()
    }
}

pub use crate::render::Parameter;
