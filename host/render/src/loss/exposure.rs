//! Photographs' exposures applied to rendered tiles, and their gradients. [`organza_shaders::exposure`] has the formula.

use organza_shaders::exposure::{ExposeBackwardKernel, ExposeKernel, ExposureParams};

use muslin_device::{Buffer, Device, Result};

/// Values of a tile's exposure: a gain and an offset for each channel.
pub(crate) const VALUES: usize = 6;

/// Rendered tiles as their photographs' cameras would have exposed them.
#[derive(Debug)]
pub(crate) struct Exposed {
    params: ExposureParams,
    /// `[K, 3, 2]`
    exposure: Buffer<f32>,
    /// x' `[K, 3, S, S]`
    pub image: Buffer<f32>,
}

/// dL/dgain and dL/doffset of a tile's channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExposureGradient {
    /// The tile's place in the batch.
    pub place: usize,
    /// Camera of the photograph.
    pub camera: usize,
    /// `[3, 2]`
    pub gradient: [[f64; 2]; 3],
}

impl Exposed {
    /// `image [K, 3, S, S]`, with `exposure [K, 3, 2]`: a gain and an offset for each channel.
    pub fn new(device: &Device, image: &Buffer<f32>, side: u32, exposure: &[f32]) -> Result<Self> {
        let params = ExposureParams { planes: exposure.len() as u32 / 2, side };
        let exposure = device.upload("exposures", exposure)?;
        let exposed = device.unwritten("exposed tiles", image.len())?;
        let kernel = ExposeKernel { params, image, exposure: &exposure, exposed: &exposed };
        device.run(&kernel, image.len() as u32, 1)?;
        Ok(Self { params, exposure, image: exposed })
    }

    /// Turns `gradient [K, 3, S, S]` from dL/dx' into dL/dx; returns the sums of rows `[K, 3, S, 2]`, for [`gradient`].
    pub fn backward(
        &self,
        device: &Device,
        image: &Buffer<f32>,
        gradient: &Buffer<f32>,
    ) -> Result<Buffer<f32>> {
        let params = self.params;
        let exposure = &self.exposure;
        let rows = params.planes * params.side;
        let row_sum = device.unwritten("exposures' row sums", 2 * rows as usize)?;
        let kernel = ExposeBackwardKernel { params, image, exposure, gradient, row_sum: &row_sum };
        device.run(&kernel, rows, 1)?;
        Ok(row_sum)
    }
}

/// Exposes a tile `[3, S, S]` on the host.
pub(crate) fn expose_tile(tile: &mut [f32], exposure: &[f32]) {
    let area = tile.len() / 3;
    for (plane, values) in tile.chunks_exact_mut(area).zip(exposure.chunks_exact(2)) {
        plane.iter_mut().for_each(|value| *value = values[0] * *value + values[1]);
    }
}

/// The gradient `[3, 2]` of a tile's exposure, from the sums of its rows `[3, S, 2]`.
pub(crate) fn gradient(rows: &[f32]) -> [[f64; 2]; 3] {
    let add = |sum: [f64; 2], row: &[f32; 2]| [0, 1].map(|at| sum[at] + f64::from(row[at]));
    let plane = |rows: &[[f32; 2]]| rows.iter().fold([0.0; 2], add);
    let (rows, _) = rows.as_chunks::<2>();
    let side = rows.len() / 3;
    [0, 1, 2].map(|channel| plane(&rows[channel * side..][..side]))
}
