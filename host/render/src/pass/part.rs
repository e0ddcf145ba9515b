//! One part of a batch: all stages from Gaussians to pixels, and back to the gradients of all tensors.

use std::ops::Range;
use std::sync::OnceLock;

use glam::Vec4;

use super::ranks::Rows;
use crate::stages::channels::ChannelSums;
use crate::stages::color::Color;
use crate::stages::composite::{Composite, Seen};
use crate::stages::cut::PartTiles;
use crate::stages::distortion::Distortion;
use crate::stages::pairs::PairVectors;
use crate::stages::project::{pose_backward, project_backward};
use crate::stages::tiles::Bins;
use crate::stages::transmittance::Transmittance;
use crate::{Capacity, DeviceScene, SceneGradient};
use muslin_device::{Buffer, Device};
use organza_core::{Camera, Channel, RenderReport, Result};

/// Everything that the stages have written on the device.
#[derive(Debug)]
pub struct Part {
    pub bins: Bins,
    pub transmittance: Transmittance,
    pub color: Color,
    pub composite: Composite,
    /// Once it has been read.
    needed: OnceLock<Capacity>,
}

/// The derivative of a loss by a part's pixels.
#[derive(Debug)]
pub struct TileGradient {
    /// dL/dY `[tiles, 3, S, S]`.
    pub grad_tiles: Buffer<f32>,
    /// The term of the loss beside the image.
    pub distortion: Option<Distortion>,
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
        let seen = Seen {
            scene,
            side: plan.side,
            bins: &bins,
            transmittance: &transmittance.transmittance,
        };
        let composite = Composite::new(seen, scene.config.background, &color.color)?;
        Ok(Self { bins, transmittance, color, composite, needed: OnceLock::new() })
    }

    /// Of tiles of this side.
    pub fn seen<'a>(&'a self, scene: &'a DeviceScene, side: u32) -> Seen<'a> {
        Seen { scene, side, bins: &self.bins, transmittance: &self.transmittance.transmittance }
    }

    /// Reads buffers, and the capacity that the part needed: nothing if that was more than it had. Waits once, or not
    /// at all if both are known.
    pub fn read(
        &self,
        device: &Device,
        mut buffers: Vec<Buffer<u32>>,
    ) -> Result<Option<(Vec<Vec<u32>>, Capacity)>> {
        let Some(counts) = &self.bins.part_counts else {
            let needed = Capacity {
                pairs: self.bins.pairs.count.upper_bound(),
                members: self.bins.members.upper_bound(),
                samples: self.transmittance.samples.upper_bound(),
            };
            return Ok(Some((device.read_all(&buffers)?, needed)));
        };
        if buffers.is_empty()
            && let Some(needed) = self.needed.get()
        {
            return Ok(Some((Vec::new(), *needed)));
        }
        buffers.push(counts.counts().view());
        let mut values = device.read_all(&buffers)?;
        let counts = values.pop().expect("pushed above");
        Ok(Capacity::needed(&counts).map(|needed| (values, *self.needed.get_or_init(|| needed))))
    }

    /// The first stages of the way back: `[pairs, 3]`, see [`splat_backward`](organza_shaders::splat).
    pub fn pair_gradient(
        &self,
        scene: &DeviceScene,
        side: u32,
        of_tiles: &TileGradient,
    ) -> Result<Buffer<Vec4>> {
        let TileGradient { grad_tiles, distortion } = of_tiles;
        Ok(self.composite.backward(self.seen(scene, side), grad_tiles, distortion.as_ref())?)
    }

    /// The other stages, of a part whose hash grids share their scale with no other.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let device = scene.device();
        self.raise_bounds(device, pair_gradient, gradient)?;
        let pairs = &self.bins.pairs.count;
        let samples = &self.transmittance.samples;
        if pairs.upper_bound() > 0 {
            gradient.color.table.set_scale(device, &scene.color, pairs)?;
        }
        if gradient.has_transmittance && samples.upper_bound() > 0 {
            gradient.transmittance.table.set_scale(device, &scene.transmittance, samples)?;
        }
        self.add_pairs(scene, pair_gradient, gradient, None, false)?;
        gradient.finish(device)
    }

    /// Raises the bounds of both hash grids' sums.
    pub fn raise_bounds(
        &self,
        device: &Device,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let pairs = &self.bins.pairs.count;
        if pairs.upper_bound() == 0 {
            return Ok(());
        }
        gradient.color.table.raise_bound(device, pair_gradient, None, pairs)?;
        let transmittance = &self.transmittance;
        if gradient.has_transmittance && transmittance.samples.upper_bound() > 0 {
            let values = Some((&transmittance.transmittance, transmittance.power));
            gradient.transmittance.table.raise_bound(device, pair_gradient, values, pairs)?;
        }
        Ok(())
    }

    /// The other stages, after the scale of the hash grids' sums is set. With `rows`, takes the Gaussians' gradients in
    /// each camera. The last camera of a part may continue in the next one.
    pub fn add_pairs(
        &self,
        scene: &DeviceScene,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
        rows: Option<&mut Rows<'_>>,
        continues: bool,
    ) -> Result<()> {
        let vectors = self.backward_fields(scene, pair_gradient, gradient)?;
        let add = |cameras: Range<u32>| {
            self.add_gaussians(scene, pair_gradient, &vectors, cameras, gradient)
        };
        let cameras = self.bins.cameras.len() as u32;
        let Some(rows) = rows else { return add(0..cameras) };
        for camera in 0..cameras {
            add(camera..camera + 1)?;
            if camera + 1 < cameras || !continues {
                rows.take()?;
            }
        }
        Ok(())
    }

    /// The stages of the fields and of the poses: adds the gradients of the fields to their sums, those of the poses,
    /// and returns those of the pairs' vectors.
    fn backward_fields(
        &self,
        scene: &DeviceScene,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<FieldVectors> {
        let bins = &self.bins;
        if let Some(poses) = &gradient.poses {
            pose_backward(scene, bins, pair_gradient, poses)?;
        }
        let color = self.color.backward(scene, bins, pair_gradient, gradient)?;
        let transmittance = match gradient.has_transmittance {
            true => self.transmittance.backward(scene, bins, pair_gradient, gradient)?,
            false => None,
        };
        Ok(FieldVectors { color, transmittance })
    }

    /// Adds the gradients of the Gaussians in some cameras, and their statistics.
    fn add_gaussians(
        &self,
        scene: &DeviceScene,
        pair_gradient: &Buffer<Vec4>,
        vectors: &FieldVectors,
        cameras: Range<u32>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let bins = &self.bins;
        project_backward(scene, bins, pair_gradient, gradient, &cameras)?;
        let tensors = &gradient.tensors().gaussians;
        let fields =
            [(&vectors.color, &tensors.material), (&vectors.transmittance, &tensors.extra)];
        fields.into_iter().try_for_each(|(found, tensor)| match found {
            Some(found) => found.sum(scene, &bins.pair_mask, &cameras, &tensor.buffer),
            None => Ok(()),
        })?;
        Ok(())
    }
}

/// Gradients of the pairs' material and extra vectors; nothing of a field without samples.
#[derive(Debug)]
struct FieldVectors {
    color: Option<PairVectors>,
    transmittance: Option<PairVectors>,
}

/// The tiles of a part that were read.
#[derive(Debug)]
pub struct ReadTiles {
    /// `[tiles, 3, S, S]`
    pub pixels: Vec<f32>,
    /// `[tiles, planes, S, S]` of each channel that was asked for, in their order.
    pub channels: Vec<Vec<f32>>,
    pub report: RenderReport,
}

impl ReadTiles {
    /// Reads the tiles of a part and their channels with `read`, which is [`Part::read`].
    pub fn new(
        seen: Seen<'_>,
        composite: &Composite,
        channels: &[Channel],
        read: impl FnOnce(Vec<Buffer<u32>>) -> Result<Option<(Vec<Vec<u32>>, Capacity)>>,
    ) -> Result<Option<(Self, Capacity)>> {
        let mut buffers = vec![composite.image.view(), seen.bins.degenerate.view()];
        let sums = ChannelSums::new(seen, composite, channels)?;
        buffers.extend(sums.buffers());
        let Some((mut values, needed)) = read(buffers)? else { return Ok(None) };
        let channels = sums.resolve(&values.split_off(2), seen.side, channels);
        let report = report_of_part(values[1][0], needed);
        let pixels = bytemuck::cast_vec(values.swap_remove(0));
        Ok(Some((Self { pixels, channels, report }, needed)))
    }
}

/// The report of a part, from the capacity that it needed.
pub fn report_of_part(degenerate: u32, needed: Capacity) -> RenderReport {
    let [pairs, members, samples, degenerate] =
        [needed.pairs, needed.members, needed.samples, degenerate].map(u64::from);
    RenderReport { parts: 1, pairs, members, samples, degenerate }
}
