//! The loss of rendered tiles and its gradient with respect to their pixels. [`organza_shaders::loss`] has the formula.

use std::borrow::Cow;
use std::fmt;

use glam::Vec4;
use organza_shaders::limits;
use organza_shaders::loss::{
    LossGradientKernel, LossGradientParams, LossParams, LossRowsKernel, LossTermsKernel,
};
use organza_shaders::ssim::{
    MOMENTS, SLOPES, SsimColumnsKernel, SsimParams, SsimRowsBackwardKernel, SsimRowsKernel,
};

use crate::stages::cut::values_of_tiles;
use muslin_device::{Buffer, Device};
use organza_core::error::argument;
use organza_core::tile::MAX_TILE_SIDE;
use organza_core::{Result, metrics};

const _: () = assert!(limits::MAX_TILE_SIDE == MAX_TILE_SIDE, "the longest row of `loss_rows`");

/// The images to compare a batch with, and the loss.
#[derive(Clone, Copy, Debug)]
pub struct LossInputs<'a> {
    /// x `[K, 3, S, S]`, the rendered tiles.
    pub image: &'a Buffer<f32>,
    /// y `[K, 3, S, S]`, the photographs' tiles.
    pub target: &'a Buffer<f32>,
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: &'a Buffer<f32>,
    /// n, the pixels that the mean is taken over: how many of `valid` are 1, over all parts of the batch.
    pub valid_pixels: f64,
    /// w, the weight of `1 - SSIM`, 0 to 1; 0.2 is usual.
    pub ssim_weight: f32,
}

/// The outputs of [`image_loss`] on the device.
#[derive(Debug)]
pub struct LossOutput {
    /// `[K, 3, S, S]`: the derivative of the loss with respect to each value of the image; 0 at masked pixels.
    pub grad_tiles: Buffer<f32>,
    /// `[K, S]`: sums of rows, as [`organza_shaders::loss::loss_rows`] writes them.
    pub(crate) row_sum: Buffer<Vec4>,
    side: u32,
}

/// The ground truth of tiles, and the loss that compares with it.
#[derive(Clone, Copy, Debug)]
pub struct LossTarget<'a> {
    /// The photographs behind the tiles.
    pub photographs: &'a dyn Photographs,
    /// How many of their pixels are valid.
    pub valid_pixels: f64,
    /// w, the weight of `1 - SSIM` in the settings.
    pub ssim_weight: f32,
    /// `[photographs, STRIDE]`: [exposures](organza_shaders::exposure) of the cameras' photographs, which the rendered tiles get
    /// before they are compared. [`SceneGradient::with_exposures`](crate::SceneGradient::with_exposures) takes their gradients.
    /// Without them, tiles are compared as they are.
    pub exposure: Option<&'a Buffer<f32>>,
}

/// The photographs behind the tiles of a batch.
pub trait Photographs: fmt::Debug + Sync {
    /// Colors `[tiles, 3, S, S]`, 0 where there is no pixel, and validity `[tiles, S, S]`, 1 where a photograph has a pixel and 0 elsewhere:
    /// of the batch's tiles in some places, in this order.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    fn on_device(&self, device: &Device, places: &[usize]) -> Result<[Buffer<f32>; 2]>;

    /// The same of all K tiles, on the host.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    fn on_host(&self) -> Result<[Cow<'_, [f32]>; 2]>;
}

/// Photographs' tiles on the host: K tiles of S x S pixels.
#[derive(Clone, Copy, Debug)]
pub struct TileImages<'a> {
    /// `[K, 3, S, S]`: colors; 0 where there is no pixel.
    pub image: &'a [f32],
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: &'a [f32],
    /// S
    pub side: u32,
}

impl Photographs for TileImages<'_> {
    fn on_device(&self, device: &Device, places: &[usize]) -> Result<[Buffer<f32>; 2]> {
        let area = (self.side * self.side) as usize;
        let image = values_of_tiles(self.image, places, 3 * area);
        let valid = values_of_tiles(self.valid, places, area);
        Ok([device.upload("photographs", &image)?, device.upload("masks", &valid)?])
    }

    fn on_host(&self) -> Result<[Cow<'_, [f32]>; 2]> {
        Ok([self.image.into(), self.valid.into()])
    }
}

/// Sums over the valid pixels of a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct TileLoss {
    /// The sum of `|x - y|` over pixels and channels.
    pub absolute: f64,
    /// The sum of `1 - SSIM` over pixels and channels.
    pub dissimilarity: f64,
    /// The sum of `(x - y)^2` over pixels and channels: `metrics::psnr_of(squared / 3 valid)` is the PSNR.
    pub squared: f64,
    /// The number of valid pixels.
    pub valid: f64,
}

impl TileLoss {
    /// From the sums of a tile's rows `[S, 4]`, as [`organza_shaders::loss::loss_rows`] writes them.
    pub(crate) fn of_rows(rows: &[f32]) -> Self {
        let row = |row: &[f32; 4]| {
            let [absolute, dissimilarity, squared, valid] = row.map(f64::from);
            Self { absolute, dissimilarity, squared, valid }
        };
        Self::total(&rows.as_chunks().0.iter().map(row).collect::<Vec<_>>())
    }

    /// The sum of many tiles.
    pub fn total(tiles: &[Self]) -> Self {
        tiles.iter().fold(Self::default(), |sum, tile| Self {
            absolute: sum.absolute + tile.absolute,
            dissimilarity: sum.dissimilarity + tile.dissimilarity,
            squared: sum.squared + tile.squared,
            valid: sum.valid + tile.valid,
        })
    }

    /// The loss `((1 - w) absolute + w dissimilarity) / 3n`, for n valid pixels: all of the batch's, and this sum its
    /// [`TileLoss::total`].  0 if no pixel is valid.
    pub fn value(&self, ssim_weight: f32) -> f64 {
        let [absolute, ssim] = scales(self.valid, ssim_weight);
        absolute * self.absolute + ssim * self.dissimilarity
    }
}

/// The factors of both terms: `(1 - w) / 3n` and `w / 3n`.
fn scales(valid_pixels: f64, ssim_weight: f32) -> [f64; 2] {
    let share = if valid_pixels > 0.0 { 1.0 / (3.0 * valid_pixels) } else { 0.0 };
    let weight = f64::from(ssim_weight);
    [(1.0 - weight) * share, weight * share]
}

/// The loss of K tiles of `side` x `side` pixels, and its gradient. On a GPU, both are queued. They take 196 bytes a pixel until then.
///
/// # Errors
/// [`Error::Argument`](organza_core::Error::Argument) where the buffers do not hold a number of tiles, for a side of 0 or more than
/// [`MAX_TILE_SIDE`], more than 65,535 tiles, or more pixels than 32 bits address; as [`Device::run_over`].
pub fn image_loss(device: &Device, side: u32, inputs: &LossInputs<'_>) -> Result<LossOutput> {
    let tiles = inputs.tiles(side)?;
    let pixels = inputs.valid.len();
    let params = LossParams { side, tiles };
    let difference = device.unwritten::<Vec4>("differences", pixels)?;
    let sum = device.unwritten::<Vec4>("sums", pixels)?;
    device.run_all(&LossTermsKernel {
        params,
        image: inputs.image,
        target: inputs.target,
        valid: inputs.valid,
        difference: &difference,
        sum: &sum,
    })?;
    let window = metrics::window().map(|weight| weight as f32);
    let window = device.upload("window", &window)?;
    let (dissimilarity, row_slopes) = ssim(device, side, &window, &difference, &sum)?;
    let row_sum = device.unwritten("row sums", (tiles * side) as usize)?;
    device.run_all(&LossRowsKernel {
        params,
        difference: &difference,
        dissimilarity: &dissimilarity,
        row_sum: &row_sum,
    })?;
    let grad_tiles = device.unwritten("gradient of the image", inputs.image.len())?;
    let [absolute_scale, ssim_scale] =
        scales(inputs.valid_pixels, inputs.ssim_weight).map(|scale| scale as f32);
    device.run_all(&LossGradientKernel {
        params: LossGradientParams { side, absolute_scale, ssim_scale },
        window: &window,
        difference: &difference,
        sum: &sum,
        row_slopes: &row_slopes,
        grad_image: &grad_tiles,
    })?;
    Ok(LossOutput { grad_tiles, row_sum, side })
}

/// `1 - SSIM` of each pixel, `[K, S, S]`, and the derivatives of their sum, which lack only the pass over columns,
/// `[K, S, S, SLOPES]`.
fn ssim(
    device: &Device,
    side: u32,
    window: &Buffer<f32>,
    difference: &Buffer<Vec4>,
    sum: &Buffer<Vec4>,
) -> Result<(Buffer<f32>, Buffer<Vec4>)> {
    let pixels = difference.len();
    let params = SsimParams { side };
    let moments = device.unwritten("moments", pixels * MOMENTS as usize)?;
    device.run_all(&SsimRowsKernel { params, window, difference, sum, moments: &moments })?;
    let dissimilarity = device.unwritten("dissimilarities", pixels)?;
    let slopes = device.unwritten("slopes", pixels * SLOPES as usize)?;
    device.run_all(&SsimColumnsKernel {
        params,
        window,
        difference,
        moments: &moments,
        dissimilarity: &dissimilarity,
        slopes: &slopes,
    })?;
    let row_slopes = device.unwritten("slopes of rows", pixels * SLOPES as usize)?;
    device.run_all(&SsimRowsBackwardKernel {
        params,
        window,
        slopes: &slopes,
        row_slopes: &row_slopes,
    })?;
    Ok((dissimilarity, row_slopes))
}

impl LossInputs<'_> {
    /// K, of tiles of this side.
    fn tiles(&self, side: u32) -> Result<u32> {
        let pixels = self.valid.len();
        let area = side as usize * side as usize;
        let tiles = pixels.checked_div(area).unwrap_or(0);
        let is_addressed = pixels as u64 * u64::from(MOMENTS) < 1 << 32;
        if side == 0 || side > MAX_TILE_SIDE || tiles > 65_535 || !is_addressed {
            return argument(format!(
                "{pixels} pixels in tiles of side {side} are too many for the loss; use fewer"
            ));
        }
        let [image, target] = [self.image, self.target].map(Buffer::len);
        if pixels == tiles * area && [image, target] == [3 * pixels; 2] {
            return Ok(tiles as u32);
        }
        argument(format!(
            "{image} values of an image, {target} of its target and {pixels} of the mask do not make tiles of \
             side {side}"
        ))
    }
}

impl LossOutput {
    /// The sums of each tile, read from the device: waits for it. The order of the sums is fixed.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn sums(&self, device: &Device) -> Result<Vec<TileLoss>> {
        let rows: Vec<f32> = device.read(&self.row_sum.view())?;
        Ok(rows.chunks_exact(4 * self.side as usize).map(TileLoss::of_rows).collect())
    }
}
