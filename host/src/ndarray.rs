//! Tiles, tensors of scenes and gradients as arrays of [`ndarray`], and back. This needs the feature `ndarray`.
//!
//! ```
//! use ndarray::Axis;
//! use organza::{DeviceOptions, Renderer, Tile, TileBatch, demo};
//!
//! let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
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
//! let slopes = &y / y.len() as f32;
//! let gradient = renderer.gradient_of_array(&scene, &cameras, &batch, slopes.view())?;
//! let opacity = gradient.array("gaussians.opacity").expect("a tensor of every scene");
//! assert_eq!(opacity.shape(), [scene.len()]);
//! # Ok::<(), organza::Error>(())
//! ```

use ::ndarray::{Array4, ArrayView4};

use crate::camera::Camera;
use crate::error::{Error, Result};
use crate::render::{DeviceScene, LossGradient, RenderedTiles, Renderer};
use crate::scene::Gradient;
use crate::tile::TileBatch;

impl RenderedTiles {
    /// Y `[K, 3, S, S]`: tile, channel, row, column.
    ///
    /// # Panics
    /// If the number of values is not that of `count` tiles of side `side`.
    #[must_use]
    pub fn array(&self) -> ArrayView4<'_, f32> {
        let side = self.side as usize;
        let view = ArrayView4::from_shape((self.count, 3, side, side), &self.data);
        view.expect("K tiles of S x S pixels")
    }
}

impl TryFrom<Array4<f32>> for RenderedTiles {
    type Error = Error;

    /// Converts Y `[K, 3, S, S]`.
    fn try_from(array: Array4<f32>) -> Result<Self> {
        let (count, channels, height, width) = array.dim();
        let side = u32::try_from(width).ok().filter(|_| channels == 3 && height == width);
        let Some(side) = side else {
            let reason = format!("tiles are [K, 3, S, S], not {:?}", array.shape());
            return Err(Error::Argument { reason });
        };
        Ok(Self { side, count, data: values(array.view()), ..Self::default() })
    }
}

impl Renderer {
    /// Like [`Renderer::gradient`], but dLoss/dY `[K, 3, S, S]` is an array.
    ///
    /// # Errors
    /// The same errors as [`Renderer::gradient`]; [`Error::Argument`] if the array has another shape than the batch.
    pub fn gradient_of_array(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_output: ArrayView4<'_, f32>,
    ) -> Result<Gradient> {
        if grad_output.shape() != batch.output_shape() {
            let found = grad_output.shape();
            let expected = batch.output_shape();
            let reason = format!("the gradient is {found:?}, but the batch is {expected:?}");
            return Err(Error::Argument { reason });
        }
        self.gradient(scene, cameras, batch, &values(grad_output))
    }
}

impl LossGradient {
    /// A loss, with dL/dY `[K, 3, S, S]` in an array.
    #[must_use]
    pub fn from_array(loss: f64, grad_output: ArrayView4<'_, f32>) -> Self {
        Self { loss, grad_output: values(grad_output) }
    }
}

/// The values, row-major, for any memory layout.
fn values(array: ArrayView4<'_, f32>) -> Vec<f32> {
    array.iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each value encodes its own place.
    fn numbered() -> Array4<f32> {
        Array4::from_shape_fn((2, 3, 4, 4), |(tile, channel, row, column)| {
            (1000 * tile + 100 * channel + 10 * row + column) as f32
        })
    }

    #[test]
    fn tiles_come_back_whatever_their_order_in_memory() {
        let tiles = RenderedTiles::try_from(numbered()).unwrap();
        assert_eq!((tiles.side, tiles.count, tiles.array()), (4, 2, numbered().view()));
        assert_eq!(tiles.rgb(1, 3, 2), [1023.0, 1123.0, 1223.0]);
        // the layout of some other programs: columns first
        let turned = numbered().permuted_axes([0, 1, 3, 2]).as_standard_layout().into_owned();
        let turned = turned.permuted_axes([0, 1, 3, 2]);
        assert!(!turned.is_standard_layout());
        assert_eq!(RenderedTiles::try_from(turned.clone()).unwrap(), tiles);
        assert_eq!(LossGradient::from_array(1.0, turned.view()).grad_output, tiles.data);
        for shape in [(2, 4, 4, 4), (2, 3, 4, 5)] {
            let error = RenderedTiles::try_from(Array4::zeros(shape)).unwrap_err().to_string();
            assert!(error.contains("[K, 3, S, S], not [2, "), "{error}");
        }
    }
}
