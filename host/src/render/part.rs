//! Renders one part of a batch, stage by stage.

use super::bin::Bins;
use super::color::Color;
use super::composite::Composite;
use super::plan::Plan;
use super::transmittance::Transmittance;
use super::{DeviceScene, RenderReport};
use crate::backend::Device;
use crate::camera::Camera;
use crate::error::Result;

/// Everything that the stages leave on the device.
#[derive(Debug)]
pub struct Part {
    pub bins: Bins,
    pub transmittance: Transmittance,
    pub color: Color,
    pub composite: Composite,
}

impl Part {
    /// `keep` says whether [`Part::backward`] will be called.
    pub fn evaluate(
        device: &Device,
        scene: &DeviceScene,
        cameras: &[Camera],
        plan: &Plan,
        keep: bool,
    ) -> Result<Self> {
        let bins = Bins::new(device, scene, cameras, plan)?;
        let transmittance = Transmittance::evaluate(device, scene, &bins.pairs, keep)?;
        let color = Color::evaluate(device, scene, &bins.pairs, keep)?;
        let composite = Composite::new(
            device,
            scene,
            plan.side,
            &bins,
            &transmittance.transmittance,
            &color.color,
        )?;
        Ok(Self { bins, transmittance, color, composite })
    }

    pub fn report(&self, device: &Device) -> Result<RenderReport> {
        Ok(RenderReport {
            parts: 1,
            pairs: u64::from(self.bins.pairs.count),
            members: u64::from(self.bins.members()),
            samples: u64::from(self.transmittance.samples),
            degenerate: u64::from(device.read(&self.bins.degenerate)?[0]),
        })
    }
}

/// The pixels of a part, `[tiles, 3, S, S]`, and what it took.
pub fn render(
    device: &Device,
    scene: &DeviceScene,
    cameras: &[Camera],
    plan: &Plan,
) -> Result<(Vec<f32>, RenderReport)> {
    let part = Part::evaluate(device, scene, cameras, plan, false)?;
    Ok((device.read(&part.composite.image)?, part.report(device)?))
}
