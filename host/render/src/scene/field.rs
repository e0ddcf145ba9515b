//! A hash grid and its network on a device.

use glam::Vec4;
use organza_shaders::hash_grid::GridLevel;

use super::network::LayerPlace;
use super::options::UploadOptions;
use muslin_device::{Buffer, Device};
use organza_core::error::Result;
use organza_core::halves::pack_halves;
use organza_core::scene::{Field, FieldTensors, GridConfig};

/// A field on a device. It shares `table` and `parameters` with the scene's tensors.
#[derive(Clone, Debug)]
pub struct DeviceField {
    pub(crate) levels: Buffer<GridLevel>,
    pub(crate) table: Buffer<f32>,
    /// The table in half precision, which kernels read in place of `table`.
    pub(crate) half_table: Option<Buffer<u32>>,
    pub parameters: Buffer<Vec4>,
    pub(crate) features: u32,
    pub(crate) layers: Vec<LayerPlace>,
}

impl DeviceField {
    /// Makes a field from tensors that are on the device. The tensors' names begin with `name`.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`]; [`Error::Invalid`](organza_core::Error::Invalid) if a value is too large
    /// for a half.
    pub fn new(
        device: &Device,
        name: &str,
        grid: &GridConfig,
        field: &Field,
        tensors: &FieldTensors<Buffer<f32>>,
        options: UploadOptions,
    ) -> Result<Self> {
        let half_table = || -> Result<_> {
            let words = pack_halves(&field.grid, grid.features as usize, &format!("{name}.grid"))?;
            Ok(device.upload("hash grid of halves", &words)?)
        };
        Ok(Self {
            levels: device.upload("grid levels", &grid.levels_for_kernels())?,
            table: tensors.grid.clone(),
            half_table: options.half_grids.then(half_table).transpose()?,
            parameters: tensors.network.view(),
            features: grid.features,
            layers: LayerPlace::from_network(&field.network),
        })
    }

    /// Bytes on the device, without the tensors.
    pub fn bytes_beside_tensors(&self) -> u64 {
        self.levels.bytes() + self.half_table.as_ref().map_or(0, Buffer::bytes)
    }

    /// The last layer, which each head evaluates on its own.
    pub fn head(&self) -> LayerPlace {
        self.layers[self.layers.len() - 1]
    }

    /// The layers before the last one.
    pub(crate) fn hidden_layers(&self) -> &[LayerPlace] {
        &self.layers[..self.layers.len() - 1]
    }

    /// Rows of the widest hidden layer.
    pub(crate) fn widest(&self) -> u32 {
        self.hidden_layers().iter().map(|layer| layer.columns * 4).max().unwrap_or(0)
    }
}
