//! Checks that a scene's tensors agree with its configuration, and warns of probable mistakes.

use std::collections::BTreeMap;
use std::path::Path;

use super::tensor_spec::{MAX_VALUES, TensorSpec};
use super::{Scene, Tensor};
use crate::error::{Result, refuse};

impl TensorSpec {
    /// Checks the shape that the tensor has, if it is there.
    ///
    /// # Errors
    /// [`Error::Invalid`](crate::Error::Invalid).
    pub fn check_shape(&self, found: Option<&[usize]>) -> Result<()> {
        let Self { shape: expected, why, .. } = self;
        let reason = match found {
            None => format!("is missing; it should be F32 {expected:?} ({why})"),
            Some(found) if found == expected => return Ok(()),
            Some(found) => format!(
                "has shape {found:?}, expected {expected:?} ({why}); make the tensor and the config agree"
            ),
        };
        self.wrong(reason)
    }

    /// An error about this tensor.
    fn wrong<T>(&self, reason: String) -> Result<T> {
        refuse(format!("tensor `{}` {reason}", self.name))
    }

    /// Takes the tensor's values from the `tensors` of the file `origin`.
    ///
    /// # Errors
    /// The same errors as [`Self::check_shape`].
    pub fn take(&self, tensors: &mut BTreeMap<String, Tensor>, origin: &Path) -> Result<Vec<f32>> {
        let found = tensors.remove(&self.name);
        let shape = found.as_ref().map(|found| &found.shape[..]);
        self.check_shape(shape).map_err(|error| error.in_file(origin))?;
        Ok(found.unwrap_or_default().data)
    }

    /// Checks that the number of values is right and that all are finite.
    pub fn check(&self, values: &[f32]) -> Result<()> {
        if values.len() != self.values() {
            self.check_shape(Some(&[values.len()]))?;
        }
        self.check_finite(values)
    }

    /// Checks that all values are finite.
    ///
    /// # Errors
    /// [`Error::Invalid`](crate::Error::Invalid).
    pub fn check_finite(&self, values: &[f32]) -> Result<()> {
        let Some(index) = values.iter().position(|value| !value.is_finite()) else { return Ok(()) };
        let reason = format!(
            "holds {} at flat index {index}; every value must be finite (did the training diverge?)",
            values[index]
        );
        self.wrong(reason)
    }
}

impl Scene {
    /// Checks that the configuration is in range, that there are Gaussians, that every tensor has the shape that the
    /// configuration gives it, and that every value is finite.
    ///
    /// # Errors
    /// [`Error::BadConfig`](crate::Error::BadConfig); [`Error::Invalid`](crate::Error::Invalid) without Gaussians, or
    /// for a tensor.
    pub fn validate(&self) -> Result<()> {
        self.config.validate()?;
        if self.gaussians.is_empty() {
            return no_gaussians();
        }
        self.check_layers()?;
        let tensors = self.tensors();
        for (spec, data) in &tensors {
            if data.len() != spec.values() {
                spec.check_shape(Some(&[data.len()]))?;
            }
        }
        check_sizes(tensors.iter().map(|(spec, _)| spec))?;
        tensors.iter().try_for_each(|(spec, data)| spec.check_finite(data))
    }

    /// Checks the layers' widths. After that, [`Self::tensors`] is in the configuration's order.
    fn check_layers(&self) -> Result<()> {
        let networks = [&self.color.network, &self.transmittance.network];
        for (network, field) in networks.into_iter().zip(self.config.fields()) {
            // A layer that only one side has is a difference, too.
            for index in 0..network.layers.len().max(field.widths.len() - 1) {
                let layer = network.layers.get(index);
                let found = layer.map_or(Vec::new(), |layer| vec![layer.outputs, layer.inputs]);
                let pair = field.widths.get(index..index + 2);
                let expected = pair.map_or(Vec::new(), |pair| vec![pair[1], pair[0]]);
                field.weight(index, expected).check_shape(Some(&found))?;
            }
        }
        Ok(())
    }
}

/// Checks that the kernels can address every tensor.
pub(super) fn check_sizes<'a>(mut specs: impl Iterator<Item = &'a TensorSpec>) -> Result<()> {
    let Some(spec) = specs.find(|spec| spec.values() >= MAX_VALUES) else { return Ok(()) };
    let reason = format!(
        "would hold {} values; the kernels address fewer than 2^31 = 2147483648: use fewer Gaussians or smaller tables",
        spec.values()
    );
    spec.wrong(reason)
}

/// The error of a scene without Gaussians.
pub(super) fn no_gaussians<T>() -> Result<T> {
    refuse("the scene holds no Gaussians; there is nothing to render")
}

/// From this resolution on, an f32 position keeps fewer than 11 bits of its fraction inside a cell.
const FINE_RESOLUTION: u32 = 8192;

/// There is no warning if fewer than one in this number of Gaussians is outside the box.
const USUAL: usize = 10;

impl Scene {
    /// One sentence, with counts, for each suspicious but valid property; empty for an ordinary scene.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.gaussian_warnings();
        for (name, grid) in [
            ("color_grid", &self.config.color_grid),
            ("transmittance_grid", &self.config.transmittance_grid),
        ] {
            let finest = grid.finest_resolution();
            if finest > FINE_RESOLUTION {
                warnings.push(format!(
                    "the finest level of {name} has resolution {finest}: above {FINE_RESOLUTION} \
                     f32 positions lose the fraction that interpolation needs"
                ));
            }
        }
        if self.config.blur == 0.0 {
            warnings.push(
                "blur is 0: Gaussians much smaller than a pixel vanish between pixel centers or \
                 are culled"
                    .to_owned(),
            );
        }
        warnings
    }

    fn gaussian_warnings(&self) -> Vec<String> {
        let gaussians = &self.gaussians;
        let [lo, hi] = self.config.aabb;
        let outside = |position: &&[f32; 3]| {
            let mut axes = position.iter().zip(lo).zip(hi);
            axes.any(|((&value, lo), hi)| !(lo..=hi).contains(&f64::from(value)))
        };
        let extents = lo.iter().zip(hi).map(|(lo, hi)| hi - lo);
        let diagonal = extents.map(|extent| extent * extent).sum::<f64>().sqrt();
        let is_contracted = !self.config.contraction.is_none();
        // cells are larger where space is contracted: a far Gaussian may be as large as its distance
        let far = |position: &[f32; 3]| {
            let axes = position.iter().zip(lo).zip(hi);
            axes.map(|((&at, lo), hi)| (f64::from(at) - (lo + hi) / 2.0).powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let huge = |(position, log_scale): &(&[f32; 3], &[f32; 3])| {
            let max = if is_contracted { diagonal.max(far(position)) } else { diagonal };
            log_scale.iter().any(|&value| f64::from(value).exp() > max)
        };
        // In f32, as in the kernels: small components may square to zero.
        let no_rotation = |rotation: &&[f32; 4]| {
            let squared: f32 = rotation.iter().map(|value| value * value).sum();
            !squared.is_normal()
        };
        let total = gaussians.len();
        // training leaves a few outside of any box
        let outside = gaussians.position.iter().filter(outside).count();
        let is_usual = is_contracted || outside * USUAL < total;
        let counts = [
            (
                if is_usual { 0 } else { outside },
                "have their center outside the scene's box, where the grids repeat the border",
            ),
            (
                gaussians.rotation.iter().filter(no_rotation).count(),
                "have a rotation of zero or overflowing norm and are culled",
            ),
            (
                gaussians.position.iter().zip(&gaussians.log_scale).filter(huge).count(),
                if is_contracted {
                    "have a scale larger than the diagonal of the scene's box and their distance from it"
                } else {
                    "have a scale larger than the diagonal of the scene's box"
                },
            ),
        ];
        let counted = counts.into_iter().filter(|(count, _)| *count > 0);
        counted.map(|(count, text)| format!("{count} of {total} Gaussians {text}")).collect()
    }
}
