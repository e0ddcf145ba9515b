//! Hash grids whose entries are packed as two halves.

use half::f16;
use half::slice::HalfFloatSliceExt;
use organza_kernels::hash_grid_half::MAX_HALF;

use super::field::DeviceField;
use super::{DeviceScene, Renderer};
use crate::backend::Device;
use crate::error::{Error, Result};
use crate::scene::{Field, GridConfig, Scene};

/// A table `[entries, features]` as [`hash_grid_half`](organza_kernels::hash_grid_half) reads it,
/// `[entries, ceil(features / 2)]`: each value rounded to the nearest half, or to zero below 2^-14.
///
/// # Errors
/// [`Error::Argument`] where a value is too large for a half.
pub fn pack_halves(table: &[f32], features: usize, name: &str) -> Result<Vec<u32>> {
    if let Some(value) = table.iter().find(|value| value.abs() > MAX_HALF) {
        let reason = format!(
            "`{name}` has a value of {value}: halves end at {MAX_HALF}, keep the grids as they are"
        );
        return Err(Error::Argument { reason });
    }
    let mut halves = vec![f16::ZERO; table.len()];
    halves.convert_from_f32_slice(table);
    // drivers may make zero of them
    halves.iter_mut().filter(|half| !half.is_normal()).for_each(|half| *half = f16::ZERO);
    let word = |pair: &[f16]| {
        let upper = pair.get(1).map_or(0, |half| half.to_bits());
        u32::from(upper) << 16 | u32::from(pair[0].to_bits())
    };
    Ok(halves.chunks(features).flat_map(|entry| entry.chunks(2).map(word)).collect())
}

impl DeviceField {
    /// With a table of halves; see [`Renderer::upload_with_half_grids`].
    pub fn upload_halves(
        device: &Device,
        grid: &GridConfig,
        field: &Field,
        name: &str,
    ) -> Result<Self> {
        let words = pack_halves(&field.grid, grid.features as usize, name)?;
        let half_table = Some(device.upload("hash grid of halves", &words)?);
        Self::around(device, grid, field, device.zeros("hash grid", 0)?, half_table)
    }
}

impl Renderer {
    /// As [`Renderer::upload`], with both hash grids in half precision: half their memory, for rendering alone.  Each
    /// feature is off by up to 2^-11 of the largest entry around it.
    ///
    /// # Errors
    /// As [`Renderer::upload`]; [`Error::Argument`] where a value is above 65,504.
    pub fn upload_with_half_grids(&self, scene: &Scene) -> Result<DeviceScene> {
        scene.validate()?;
        self.upload_fields(scene, &|grid, field, name| {
            DeviceField::upload_halves(self.device(), grid, field, name)
        })
    }
}

impl DeviceScene {
    /// Fails where the grids are halves, which cannot be moved.
    pub(crate) fn require_full_grids(&self) -> Result<()> {
        match self.color.half_table {
            None => Ok(()),
            Some(_) => {
                let reason =
                    "the scene's grids are halves, which have no gradients: upload it as it is";
                Err(Error::Argument { reason: reason.into() })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use organza_kernels::hash_grid_half::half_value;

    use super::*;

    #[test]
    fn every_half_keeps_its_value() {
        for bits in 0..=u16::MAX {
            let half = f16::from_bits(bits);
            if half.is_normal() || half.to_bits() << 1 == 0 {
                assert_eq!(half_value(u32::from(bits)).to_bits(), half.to_f32().to_bits());
            }
        }
    }

    #[test]
    fn entries_are_whole_words() {
        let words = pack_halves(&[1.0, 2.0, -0.5, 1e-6, 65_504.0, 0.1], 3, "a grid").unwrap();
        let value = |word: u32, upper: bool| half_value(word >> (16 * u32::from(upper)) & 0xffff);
        assert_eq!(words.len(), 4);
        assert_eq!((value(words[0], false), value(words[0], true)), (1.0, 2.0));
        assert_eq!((value(words[1], false), value(words[1], true)), (-0.5, 0.0));
        assert_eq!((value(words[2], false), value(words[2], true)), (0.0, 65_504.0));
        assert!((value(words[3], false) - 0.1).abs() < 0.1 / 2048.0);
        let error = pack_halves(&[1.0, 1e5], 2, "color_grid").unwrap_err().to_string();
        assert!(error.contains("color_grid") && error.contains("100000"), "{error}");
    }
}
