//! Tiles, tensors of scenes and gradients as [`ndarray`] arrays.

use ::ndarray::{Array4, ArrayView4, ArrayViewD, ArrayViewMutD};

use crate::{Error, RenderedTiles, Result, Scene};

impl Scene {
    /// The tensor named `name`, as in [`Scene::tensors`]: `gaussians.position`, for example.
    #[must_use]
    pub fn array(&self, name: &str) -> Option<ArrayViewD<'_, f32>> {
        let (spec, values) = self.tensors().into_iter().find(|(spec, _)| spec.name == name)?;
        ArrayViewD::from_shape(spec.shape, values).ok()
    }

    /// Like [`Scene::array`], but mutable. `assign` copies another array of the same shape.
    #[must_use]
    pub fn array_mut(&mut self, name: &str) -> Option<ArrayViewMutD<'_, f32>> {
        let (spec, values) = self.tensors_mut().into_iter().find(|(spec, _)| spec.name == name)?;
        ArrayViewMutD::from_shape(spec.shape, values).ok()
    }
}

impl RenderedTiles {
    /// Y `[K, 3, S, S]`: tile, channel, row, column.
    ///
    /// # Panics
    /// Where the number of values is not that of `count` tiles of side `side`.
    #[must_use]
    pub fn array(&self) -> ArrayView4<'_, f32> {
        let side = self.side as usize;
        let view = ArrayView4::from_shape((self.count, 3, side, side), &self.data);
        view.expect("K tiles of S x S pixels")
    }
}

impl TryFrom<Array4<f32>> for RenderedTiles {
    type Error = Error;

    /// From Y `[K, 3, S, S]`.
    fn try_from(array: Array4<f32>) -> Result<Self> {
        let (count, channels, height, width) = array.dim();
        let side = u32::try_from(width).ok().filter(|_| channels == 3 && height == width);
        let Some(side) = side else {
            let reason = format!("tiles are [K, 3, S, S], not {:?}", array.shape());
            return Err(Error::Argument { reason });
        };
        Ok(Self { side, count, data: array.iter().copied().collect(), ..Self::default() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tensors_have_the_shapes_and_values_of_a_scene() {
        let mut scene = crate::demo::scene();
        let names: Vec<_> = scene.tensors().into_iter().map(|(spec, _)| spec).collect();
        for spec in names {
            assert_eq!(scene.array(&spec.name).expect("it is there").shape(), spec.shape);
        }
        let row = scene.gaussians.position[7];
        let position = scene.array("gaussians.position").unwrap();
        assert_eq!([0, 1, 2].map(|column| position[[7, column]]), row);
        scene.array_mut("gaussians.position").unwrap()[[7, 2]] = 5.0;
        assert_eq!(scene.gaussians.position[7], [row[0], row[1], 5.0]);
        assert!(scene.array("gaussians.color").is_none());
    }

    /// The value of each place says where it is.
    fn numbered() -> Array4<f32> {
        Array4::from_shape_fn((2, 3, 4, 4), |(tile, channel, row, column)| {
            (1000 * tile + 100 * channel + 10 * row + column) as f32
        })
    }

    #[test]
    fn arrays_of_any_memory_order_become_tiles() {
        let tiles = RenderedTiles::try_from(numbered()).unwrap();
        assert_eq!((tiles.side, tiles.count, tiles.array()), (4, 2, numbered().view()));
        assert_eq!(tiles.rgb(1, 3, 2), [1023.0, 1123.0, 1223.0]);
        // as another program may have it: columns first
        let turned = numbered().permuted_axes([0, 1, 3, 2]).as_standard_layout().into_owned();
        let turned = turned.permuted_axes([0, 1, 3, 2]);
        assert!(!turned.is_standard_layout());
        assert_eq!(RenderedTiles::try_from(turned.clone()).unwrap(), tiles);
        for shape in [(2, 4, 4, 4), (2, 3, 4, 5)] {
            let error = RenderedTiles::try_from(Array4::zeros(shape)).unwrap_err().to_string();
            assert!(error.contains("[K, 3, S, S], not [2, "), "{error}");
        }
    }
}
