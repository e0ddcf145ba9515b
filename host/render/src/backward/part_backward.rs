//! From the gradient of a batch's pixels to that of every tensor: the stages of [`Part`] in reverse.

use std::ops::Range;
use std::sync::atomic::Ordering;

use glam::Vec4;

use super::distortion::Distortion;
use super::gradient::SceneGradient;
use super::pose::pose_backward;
use super::project::project_backward;
use super::rows::Rows;
use crate::batch::plan::{PartTiles, PlannedTile};
use crate::batch::renderer::Renderer;
use crate::forward::pair::PairVectors;
use crate::forward::part::Part;
use crate::forward::part_counts::Capacity;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Device};
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::scene::Gradient;
use organza_core::tile::TileBatch;

impl Part {
    /// Adds the gradients of all tensors to `gradient`, of `image_gradient [tiles, 3, S, S]`, dLoss/dY of this part's
    /// tiles.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        side: u32,
        image_gradient: &Buffer<f32>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let device = scene.device();
        let pair_gradient = self.pair_gradient(scene, side, image_gradient)?;
        self.raise_bounds(device, &pair_gradient, gradient)?;
        let pairs = &self.bins.pairs.count;
        let samples = &self.transmittance.samples;
        if pairs.upper_bound() > 0 {
            gradient.color.table.set_scale(device, &scene.color, pairs)?;
        }
        if gradient.has_transmittance && samples.upper_bound() > 0 {
            gradient.transmittance.table.set_scale(device, &scene.transmittance, samples)?;
        }
        self.add_pairs(scene, &pair_gradient, gradient, None, false)?;
        gradient.finish(device)
    }

    /// The first stages: `[pairs, 3]`, see [`splat_backward`](organza_shaders::splat).
    pub fn pair_gradient(
        &self,
        scene: &DeviceScene,
        side: u32,
        image_gradient: &Buffer<f32>,
    ) -> Result<Buffer<Vec4>> {
        let transmittance = &self.transmittance.transmittance;
        Ok(self.composite.backward(scene, side, &self.bins, transmittance, image_gradient)?)
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

    /// The other stages, after the scale of the hash grids' sums is set. With the `rows` of a block, takes what each
    /// camera has of the Gaussians. The last camera of a part may continue in the next one.
    pub fn add_pairs(
        &self,
        scene: &DeviceScene,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
        rows: Option<(&mut Rows<'_>, usize)>,
        continues: bool,
    ) -> Result<()> {
        let vectors = self.backward_fields(scene, pair_gradient, gradient)?;
        let add = |cameras: Range<u32>| {
            self.add_gaussians(scene, pair_gradient, &vectors, cameras, gradient)
        };
        let cameras = self.bins.cameras.len() as u32;
        let Some((rows, block)) = rows else { return add(0..cameras) };
        for camera in 0..cameras {
            add(camera..camera + 1)?;
            if camera + 1 < cameras || !continues {
                rows.take(block)?;
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

    /// Adds what some cameras have of the Gaussians, and of their statistics.
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

/// The part of a batch's values `[K, len]` that belongs to a part's tiles, in their order.
pub(crate) fn values_of_tiles(values: &[f32], tiles: &[PlannedTile], len: usize) -> Vec<f32> {
    tiles.iter().flat_map(|tile| &values[tile.place * len..][..len]).copied().collect()
}

/// The ground truth of tiles: K tiles of S x S pixels.
#[derive(Clone, Copy, Debug)]
pub struct LossTarget<'a> {
    /// `[K, 3, S, S]`: the photographs; 0 where there is no pixel.
    pub image: &'a [f32],
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: &'a [f32],
    /// How many of `valid` are 1.
    pub valid_pixels: f64,
    /// w, the weight of `1 - SSIM` in the settings.
    pub ssim_weight: f32,
    /// The weight of the [distortion](organza_shaders::distortion). A loss of your own has none.
    pub distortion_weight: f32,
    /// `[K, 3, 2]`: a gain and an offset for each channel, which the rendered tiles get before they are compared.
    /// Without them they are compared as they are. A loss of your own never has them.
    pub exposure: Option<&'a [f32]>,
}

impl LossTarget<'_> {
    /// The terms of the loss beside the image, of a part with this mask `[K, S, S]`.
    pub(crate) fn distortion(&self, valid: &Buffer<f32>) -> Option<Distortion> {
        let scale = f64::from(self.distortion_weight) / self.valid_pixels.max(1.0);
        (scale > 0.0).then(|| Distortion { valid: valid.view(), scale: scale as f32 })
    }
}

impl Renderer {
    /// dLoss/dtensor for every tensor of a scene, given `grad_output [K, 3, S, S]`, dLoss/dY.
    ///
    /// The networks see positions and directions as constants: position, rotation and scale have the gradient of the
    /// projection alone. [`Renderer::record`] gives the tiles, too.
    ///
    /// ```
    /// use organza_core::{Tile, TileBatch, demo};
    /// use muslin_device::DeviceOptions;
    /// use organza_render::{Renderer, open_device};
    ///
    /// let renderer = Renderer::new(open_device(&DeviceOptions::cpu(None))?);
    /// let scene = renderer.upload(&demo::scene())?;
    /// let cameras = demo::turntable(1, 32);
    /// let batch = TileBatch { side: 8, tiles: vec![Tile { camera: 0, origin: [12, 12] }] };
    ///
    /// // the loss is the sum of all values, so dL/dY is 1 everywhere
    /// let ones = vec![1.0; batch.output_shape().iter().product()];
    /// let gradient = renderer.gradient(&scene, &cameras, &batch, &ones)?;
    /// assert_eq!(gradient.gaussians().position.len(), scene.len());
    /// assert!(gradient.tensor("gaussians.opacity").is_some_and(|g| g.iter().any(|&g| g != 0.0)));
    /// # Ok::<(), organza_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`](crate::Recording::backward).
    pub fn gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_output: &[f32],
    ) -> Result<Gradient> {
        self.record(scene, cameras, batch)?.backward(grad_output)
    }

    /// Does `work` with the parts of a batch; where one does not fit, all over again with smaller ones: what parts have
    /// added before would count twice.
    pub(crate) fn in_parts<R>(
        &self,
        scene: &DeviceScene,
        batch: &TileBatch,
        mut work: impl FnMut(&[PartTiles]) -> Result<R>,
    ) -> Result<R> {
        let mut plans = self.plans(scene, batch)?;
        loop {
            match work(&plans) {
                Err(error) if error.is_out_of_memory() && plans.len() < batch.tiles.len() => {
                    let before = plans.len();
                    // the next batch will not fit, either
                    while plans.len() == before {
                        let half = self.part_bytes.load(Ordering::Relaxed) / 2;
                        self.part_bytes.store(half, Ordering::Relaxed);
                        plans = self.plans(scene, batch)?;
                    }
                }
                Err(error) if error.is_out_of_memory() && self.forget() => {}
                result => return result,
            }
        }
    }

    /// Adds dLoss/dtensor of `grad_output [K, 3, S, S]` to `gradient`, and waits for it.
    ///
    /// # Errors
    /// The same errors as [`Renderer::gradient`].
    pub fn add_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_output: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        let plans = self.plans(scene, batch)?;
        self.add_parts(scene, cameras, &plans, grad_output, gradient)?;
        gradient.check(self.device())
    }

    pub(crate) fn add_parts(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        plans: &[PartTiles],
        grad_output: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        let device = self.device();
        let add = |plan: &PartTiles, capacity: Option<Capacity>| {
            let part = Part::evaluate(scene, cameras, plan, true, capacity)?;
            let pixels =
                values_of_tiles(grad_output, &plan.tiles, 3 * (plan.side * plan.side) as usize);
            let pixels = device.upload("gradient of the tiles", &pixels)?;
            part.backward(scene, plan.side, &pixels, gradient)?;
            Ok(part.read(device, Vec::new())?)
        };
        device.run_in_pool(|| {
            plans.iter().try_for_each(|plan| {
                self.with_predicted_capacity(scene, plan, |capacity| add(plan, capacity)).map(drop)
            })
        })
    }
}
