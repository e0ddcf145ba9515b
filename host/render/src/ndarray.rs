//! Tiles, tensors of scenes and gradients as arrays of [`ndarray`], and back. This needs the feature `ndarray`.
//!
//! ```
//! use ndarray::Axis;
//! use organza_core::{Tile, TileBatch, demo};
//! use muslin_device::DeviceOptions;
//! use organza_render::{Renderer, open_device};
//!
//! let renderer = Renderer::new(open_device(&DeviceOptions::cpu(None))?);
//! let mut scene = demo::scene();
//! // moves every Gaussian by 0.1 along x
//! let mut position = scene.array_mut("gaussians.position").expect("a tensor of every scene");
//! position.index_axis_mut(Axis(1), 0).map_inplace(|x| *x += 0.1);
//!
//! let scene = renderer.upload(&scene)?;
//! let cameras = demo::turntable(1, 32);
//! let batch = TileBatch { side: 8, tiles: vec![Tile { camera: 0, origin: [12, 12] }] };
//! let tiles = renderer.render(&scene, &cameras, &batch)?;
//! let y = tiles.array(); // [K, 3, S, S]
//! assert_eq!(y.dim(), (1, 3, 8, 8));
//!
//! // the loss is half the mean of squares, so dL/dY is Y / n
//! let grad_tiles = &y / y.len() as f32;
//! let gradient = renderer.gradient_of_array(&scene, &cameras, &batch, grad_tiles.view())?;
//! let opacity = gradient.array("gaussians.opacity").expect("a tensor of every scene");
//! assert_eq!(opacity.shape(), [scene.len()]);
//! # Ok::<(), organza_core::Error>(())
//! ```

use ::ndarray::ArrayView4;

use crate::{DeviceScene, LossGradient, Renderer};
use organza_core::{Camera, Error, Gradient, Result, TileBatch};

impl Renderer {
    /// Like [`Renderer::gradient`], but `grad_tiles [K, 3, S, S]`, dL/dY, is an array.
    ///
    /// # Errors
    /// The same errors as [`Renderer::gradient`]; [`Error::Argument`] if the array has another shape than the batch.
    pub fn gradient_of_array(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_tiles: ArrayView4<'_, f32>,
    ) -> Result<Gradient> {
        if grad_tiles.shape() != batch.output_shape() {
            let found = grad_tiles.shape();
            let expected = batch.output_shape();
            let reason = format!("the gradient is {found:?}, but the batch is {expected:?}");
            return Err(Error::Argument { reason });
        }
        self.gradient(scene, cameras, batch, &values(grad_tiles))
    }
}

impl LossGradient {
    /// A loss, with `grad_tiles [K, 3, S, S]`, dL/dY, in an array.
    #[must_use]
    pub fn from_array(loss: f64, grad_tiles: ArrayView4<'_, f32>) -> Self {
        Self { loss, grad_tiles: values(grad_tiles) }
    }
}

/// The values, row-major, for any memory layout.
fn values(array: ArrayView4<'_, f32>) -> Vec<f32> {
    array.iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use ::ndarray::Array4;

    use super::*;

    #[test]
    fn gradients_may_have_any_memory_order() {
        let gradient = Array4::from_shape_fn((1, 3, 2, 2), |(_, channel, row, column)| {
            (100 * channel + 10 * row + column) as f32
        });
        let expected =
            vec![0.0, 1.0, 10.0, 11.0, 100.0, 101.0, 110.0, 111.0, 200.0, 201.0, 210.0, 211.0];
        // as another program may have it: columns first
        let turned = gradient.permuted_axes([0, 1, 3, 2]).as_standard_layout().into_owned();
        let turned = turned.permuted_axes([0, 1, 3, 2]);
        assert!(!turned.is_standard_layout());
        assert_eq!(LossGradient::from_array(1.0, turned.view()).grad_tiles, expected);
    }
}
