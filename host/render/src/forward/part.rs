//! Renders one part of a batch, stage by stage.

use super::bin::Bins;
use super::channels::{ChannelSums, Seen};
use super::color::Color;
use super::composite::Composite;
use super::part_counts::{Capacity, Needed};
use super::transmittance::Transmittance;
use crate::batch::plan::PartTiles;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Device, Result};
use organza_core::camera::Camera;
use organza_core::{Channel, RenderReport};

/// Everything that the stages have written on the device.
#[derive(Debug)]
pub struct Part {
    pub bins: Bins,
    pub transmittance: Transmittance,
    pub color: Color,
    pub composite: Composite,
}

impl Part {
    /// `keep` says whether [`Part::backward`] will be called. With a `capacity`, nothing waits for the device; if it is too
    /// small, the part is empty. Without one, the host waits for the counts, and there is room for everything.
    pub fn evaluate(
        scene: &DeviceScene,
        cameras: &[Camera],
        plan: &PartTiles,
        keep: bool,
        capacity: Option<Capacity>,
    ) -> Result<Self> {
        let bins = Bins::new(scene, cameras, plan, capacity)?;
        let count_samples = |first: &_| bins.count_samples(scene.device(), first);
        let transmittance = Transmittance::evaluate(scene, &bins.pairs, keep, count_samples)?;
        let color = Color::evaluate(scene, &bins.pairs, keep)?;
        let composite = Composite::new(
            scene,
            scene.config.background,
            plan.side,
            &bins,
            &transmittance.transmittance,
            &color.color,
        )?;
        Ok(Self { bins, transmittance, color, composite })
    }

    /// Reads buffers, and the capacity that the part needed. Waits once.
    pub fn read(
        &self,
        device: &Device,
        mut buffers: Vec<Buffer<u32>>,
    ) -> Result<(Vec<Vec<u32>>, Needed)> {
        let Some(tally) = &self.bins.part_counts else {
            let needed = Needed::Capacity(Capacity {
                pairs: self.bins.pairs.count.upper_bound(),
                members: self.bins.members.upper_bound(),
                samples: self.transmittance.samples.upper_bound(),
            });
            return Ok((device.read_all(&buffers)?, needed));
        };
        buffers.push(tally.counts().view());
        let mut values = device.read_all(&buffers)?;
        let counts = values.pop().expect("pushed above");
        Ok((values, Needed::from_counts(&counts)))
    }
}

/// The result of rendering a part.
#[derive(Debug)]
pub struct RenderedPart {
    /// `[tiles, 3, S, S]`
    pub pixels: Vec<f32>,
    /// `[tiles, planes, S, S]` of each channel that was asked for, in their order.
    pub channels: Vec<Vec<f32>>,
    pub report: RenderReport,
}

/// Renders a part, and finds the capacity that it needed. `keep` and `capacity` are as for [`Part::evaluate`].
pub fn render(
    scene: &DeviceScene,
    cameras: &[Camera],
    plan: &PartTiles,
    channels: &[Channel],
    keep: bool,
    capacity: Option<Capacity>,
) -> Result<((Part, RenderedPart), Needed)> {
    let part = Part::evaluate(scene, cameras, plan, keep, capacity)?;
    let transmittance = &part.transmittance.transmittance;
    let seen = Seen { bins: &part.bins, transmittance, composite: &part.composite };
    let read = |buffers| part.read(scene.device(), buffers);
    let (mut rendered, degenerate, needed) = read_tiles(scene, plan, channels, seen, read)?;
    rendered.report = report_of_part(degenerate, needed);
    Ok(((part, rendered), needed))
}

/// The report of a part, from the capacity that it needed.
pub fn report_of_part(degenerate: u32, needed: Needed) -> RenderReport {
    let mut report =
        RenderReport { parts: 1, degenerate: u64::from(degenerate), ..RenderReport::default() };
    if let Needed::Capacity(Capacity { pairs, members, samples }) = needed {
        [report.pairs, report.members, report.samples] = [pairs, members, samples].map(u64::from);
    }
    report
}

/// Reads the tiles of a part and their channels, and how many Gaussians could not be projected. The report is still empty.
pub fn read_tiles<R>(
    scene: &DeviceScene,
    plan: &PartTiles,
    channels: &[Channel],
    seen: Seen<'_>,
    read: impl FnOnce(Vec<Buffer<u32>>) -> Result<(Vec<Vec<u32>>, R)>,
) -> Result<(RenderedPart, u32, R)> {
    let mut buffers = vec![seen.composite.image.view(), seen.bins.degenerate.view()];
    let sums = ChannelSums::new(scene, plan.side, seen, channels)?;
    buffers.extend(sums.buffers());
    let (mut values, more) = read(buffers)?;
    let channels = sums.resolve(&values.split_off(2), plan.side, channels);
    let degenerate = values[1][0];
    let pixels = bytemuck::cast_vec(values.swap_remove(0));
    let report = RenderReport::default();
    Ok((RenderedPart { pixels, channels, report }, degenerate, more))
}
