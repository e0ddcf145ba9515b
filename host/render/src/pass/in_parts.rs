//! Gradients of batches, part by part.

use std::sync::atomic::Ordering;

use super::part::Part;
use super::renderer::Renderer;
use crate::scene::device_scene::DeviceScene;
use crate::stages::counts::Capacity;
use crate::stages::cut::{PartTiles, values_of_tiles};
use crate::stages::gradient::SceneGradient;
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::scene::Gradient;
use organza_core::tile::TileBatch;

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
