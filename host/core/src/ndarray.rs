//! Tensors of scenes and gradients as [`ndarray`] arrays.

use ::ndarray::{ArrayViewD, ArrayViewMutD};

use crate::scene::{Gradient, Scene};

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

impl Gradient {
    /// The gradient of the tensor named `name`, as in [`Gradient::tensors`]: `gaussians.position`, for example.
    #[must_use]
    pub fn array(&self, name: &str) -> Option<ArrayViewD<'_, f32>> {
        let (spec, values) = self.tensors().into_iter().find(|(spec, _)| spec.name == name)?;
        ArrayViewD::from_shape(spec.shape, values).ok()
    }
}

#[cfg(test)]
mod tests {
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
}
