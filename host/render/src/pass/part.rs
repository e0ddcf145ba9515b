//! One part of a batch: all stages from Gaussians to pixels, and back to the gradients of all tensors.

use std::ops::Range;

use glam::Vec4;

use crate::gradient::SceneGradient;
use crate::gradient::ranks::Rows;
use crate::scene::device_scene::DeviceScene;
use crate::stages::color::Color;
use crate::stages::composite::{Composite, OtherScene, PairGradients, TileContext};
use crate::stages::counts::{Capacity, PartCounts};
use crate::stages::cut::PartTiles;
use crate::stages::project::{pose_backward, project, project_backward};
use crate::stages::tiles::TileBins;
use crate::stages::transmittance::{Segments, Transmittance};
use muslin_device::Buffer;
use organza_core::{Camera, Result};

/// Everything that the stages have written on the device.
#[derive(Debug)]
pub struct Part {
    pub bins: TileBins,
    pub transmittance: Transmittance,
    pub color: Color,
    pub composite: Composite,
    /// What the scenes that are [shown with](DeviceScene::put) this one add.
    pub beside: Vec<OtherScene>,
    /// The room that the part's tables have. It is exactly what the part needs, if the host has waited for the counts.
    pub capacity: Capacity,
}

/// The stages before the composite, and the room that their tables have.
fn stages(
    scene: &DeviceScene,
    cameras: &[&Camera],
    part_tiles: &PartTiles,
    keep: bool,
    counts: Option<PartCounts>,
) -> Result<(TileBins, Transmittance, Color, Capacity)> {
    let device = scene.device();
    let projection = project(device, scene, cameras, &part_tiles.windows())?;
    let bins = TileBins::new(scene, part_tiles, projection, counts)?;
    let segments = Segments::new(scene, &bins.pairs)?;
    let samples = bins.count_samples(device, 0, &segments.first_sample)?;
    let transmittance = Transmittance::evaluate(scene, &bins.pairs, segments, samples, keep)?;
    let others_samples = transmittance.attenuate(scene, cameras, &bins.pairs, &bins)?;
    let color = Color::evaluate(scene, &bins.pairs, keep)?;
    let capacity = Capacity {
        pairs: bins.pairs.count.upper_bound(),
        intersections: bins.intersections.upper_bound(),
        samples: transmittance.samples.upper_bound().saturating_add(others_samples),
    };
    Ok((bins, transmittance, color, capacity))
}

impl Part {
    /// Runs the stages from Gaussians to pixels. With `keep`, networks' inputs stay in memory for [`Part::backward`], as far as they fit:
    /// see [`Blocks::new`](crate::stages::field::samples::Blocks::new). With `counts`, nothing waits for the device; if their capacity is
    /// too small, the part is empty. Without, the host waits for the counts, and there is room for everything.
    pub fn evaluate(
        scene: &DeviceScene,
        cameras: &[Camera],
        part_tiles: &PartTiles,
        keep: bool,
        counts: Option<PartCounts>,
    ) -> Result<Self> {
        let device = scene.device();
        device.run_in_pool(|| {
            let used: Vec<_> =
                part_tiles.cameras().into_iter().map(|index| &cameras[index]).collect();
            let (bins, transmittance, color, mut capacity) =
                stages(scene, &used, part_tiles, keep, counts)?;
            let mut beside = Vec::new();
            let scenes = scene.all().count();
            for (index, other) in scene.all().enumerate().skip(1) {
                let counts = bins.part_counts.as_ref().map(|counts| counts.after(index * scenes));
                let (bins, own, color, needed) = stages(other, &used, part_tiles, false, counts)?;
                capacity = capacity.plus(needed);
                let transmittance = own.transmittance;
                beside.push(OtherScene { bins, transmittance, color: color.color });
            }
            let own = &transmittance.transmittance;
            let context =
                TileContext { scene, bins: &bins, transmittance: own, color: &color.color };
            let composite = Composite::new(&context.all(&beside), scene.config.background)?;
            Ok(Self { bins, transmittance, color, composite, beside, capacity })
        })
    }

    pub fn context<'a>(&'a self, scene: &'a DeviceScene) -> TileContext<'a> {
        let transmittance = &self.transmittance.transmittance;
        TileContext { scene, bins: &self.bins, transmittance, color: &self.color.color }
    }

    /// Raises the bounds of both hash grids' sums, given `d_splats [pairs, 3]`.
    pub fn raise_bounds(
        &self,
        scene: &DeviceScene,
        d_splats: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let device = scene.device();
        let pairs = &self.bins.pairs.count;
        if pairs.upper_bound() == 0 {
            return Ok(());
        }
        gradient.color.table.raise_bound(device, d_splats, None, pairs)?;
        let transmittance = &self.transmittance;
        if gradient.has_transmittance && transmittance.samples.upper_bound() > 0 {
            let Transmittance { transmittance, power, .. } = transmittance;
            let values = Some((transmittance, *power, scene.roulette.gradients));
            gradient.transmittance.table.raise_bound(device, d_splats, values, pairs)?;
        }
        Ok(())
    }

    /// Adds the gradients of all tensors, given those of the pairs, after the scale of the hash grids' sums is set. With
    /// `rows`, takes the Gaussians' gradients view batch by view batch. `continues`: the last view batch continues in the next part.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        PairGradients { splat: d_splats, slope }: &PairGradients,
        gradient: &SceneGradient,
        rows: Option<&mut Rows<'_>>,
        continues: bool,
    ) -> Result<()> {
        let TileBins { pairs, pair_mask, cameras, .. } = &self.bins;
        if let Some(poses) = &gradient.poses {
            pose_backward(scene, pairs, pair_mask, cameras, d_splats, poses)?;
        }
        let tensors = &gradient.tensors().gaussians;
        let color = self.color.backward(scene, &self.bins, d_splats, gradient)?;
        let extra = match gradient.has_transmittance {
            true => self.transmittance.backward(scene, &self.bins, d_splats, gradient)?,
            false => None,
        };
        let vectors = [(color, &tensors.material), (extra, &tensors.extra)];
        let vectors = vectors.iter().map(|(found, tensor)| (found.as_ref(), *tensor));
        let vectors: Vec<_> = vectors.chain([(slope.as_ref(), &tensors.slope)]).collect();
        let add = |cameras: Range<u32>| -> Result<()> {
            project_backward(scene, pairs, pair_mask, d_splats, gradient, &cameras)?;
            for (found, tensor) in &vectors {
                if let Some(found) = found {
                    found.sum(scene, pair_mask, &cameras, &tensor.buffer)?;
                }
            }
            Ok(())
        };
        let end = cameras.len() as u32;
        let Some(rows) = rows else { return add(0..end) };
        for camera in 0..end {
            add(camera..camera + 1)?;
            if camera + 1 < end || !continues {
                rows.take()?;
            }
        }
        Ok(())
    }
}
