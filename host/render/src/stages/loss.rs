//! The loss of rendered tiles and its gradient with respect to their pixels. [`organza_shaders::loss`] has the formula.

use glam::Vec4;
use organza_shaders::limits;
use organza_shaders::loss::{
    LossGradientKernel, LossGradientParams, LossParams, LossRowsKernel, LossTermsKernel,
};
use organza_shaders::ssim::{
    MOMENTS, SLOPES, SsimColumnsKernel, SsimParams, SsimRowsBackwardKernel, SsimRowsKernel,
};

use super::distortion::Distortion;
use muslin_device::{Buffer, Device};
use organza_core::tile::MAX_TILE_SIDE;
use organza_core::{Error, Result, metrics};

const _: () = assert!(limits::MAX_TILE_SIDE == MAX_TILE_SIDE, "the longest row of `loss_rows`");

/// Evaluates losses of up to a number of tiles; holds the memory that it takes, 196 bytes a pixel.
#[derive(Debug)]
pub struct Loss {
    side: u32,
    tiles: u32,
    /// `[11]`
    window: Buffer<f32>,
    /// `[tiles, S, S]`: d and the mask.
    difference: Buffer<Vec4>,
    /// `[tiles, S, S]`: s.
    sum: Buffer<Vec4>,
    /// `[tiles, S, S, 4]`
    moments: Buffer<Vec4>,
    /// `[tiles, S, S]`: 1 - SSIM, of all channels.
    dissimilarity: Buffer<f32>,
    /// `[tiles, S, S, 3]`
    slopes: Buffer<Vec4>,
    /// `[tiles, S, S, 3]`
    row_slopes: Buffer<Vec4>,
}

/// The images to compare a batch with, and the loss.
#[derive(Clone, Copy, Debug)]
pub struct LossInputs<'a> {
    /// x `[K, 3, S, S]`, the rendered tiles.
    pub image: &'a Buffer<f32>,
    /// y `[K, 3, S, S]`, the photographs' tiles.
    pub target: &'a Buffer<f32>,
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: &'a Buffer<f32>,
    /// n, the pixels that the mean is taken over: how many of `valid` are 1, in all parts of the batch together.
    pub valid_pixels: f64,
    /// w, the weight of `1 - SSIM`, 0 to 1; 0.2 is usual.
    pub ssim_weight: f32,
}

/// The outputs of [`Loss::evaluate`] on the device.
#[derive(Debug)]
pub struct LossOutput {
    /// `[K, 3, S, S]`: the derivative of the loss with respect to each value of the image; 0 at masked pixels.
    pub grad_tiles: Buffer<f32>,
    /// `[K, S]`: sums of rows, as [`organza_shaders::loss::loss_rows`] writes them.
    pub(crate) row_sum: Buffer<Vec4>,
    side: u32,
}

/// The ground truth of tiles: K tiles of S x S pixels.
#[derive(Clone, Copy, Debug)]
pub struct LossTarget<'a> {
    /// `[K, 3, S, S]`: the photographs; 0 where there is no pixel.
    pub image: &'a [f32],
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: &'a [f32],
    /// How many of `valid` are 1.
    pub valid_pixels: f64,
    /// w, the weight of `1 - SSIM` in the settings.
    pub ssim_weight: f32,
    /// The weight of the [distortion](organza_shaders::distortion). A loss of your own has none.
    pub distortion_weight: f32,
    /// `[K, 3, 2]`: a gain and an offset for each channel, which the rendered tiles get before they are compared.
    /// Without them they are compared as they are. A loss of your own never has them.
    pub exposure: Option<&'a [f32]>,
}

impl LossTarget<'_> {
    /// The terms of the loss beside the image, of a part with this mask `[K, S, S]`.
    pub(crate) fn distortion(&self, valid: &Buffer<f32>) -> Option<Distortion> {
        let scale = f64::from(self.distortion_weight) / self.valid_pixels.max(1.0);
        (scale > 0.0).then(|| Distortion { valid: valid.view(), scale: scale as f32 })
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
    /// The sum of many tiles.
    #[must_use]
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
    #[must_use]
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

impl Loss {
    /// Memory for up to `tiles` tiles of `side` pixels.
    ///
    /// # Errors
    /// [`Error::Argument`] for a side of 0 or more than [`MAX_TILE_SIDE`], more than 65,535 tiles, or more pixels than
    /// 32 bits address; as [`Device::zeros`].
    pub fn new(device: &Device, side: u32, tiles: u32) -> Result<Self> {
        let pixels = u64::from(tiles) * u64::from(side) * u64::from(side);
        let is_addressed = pixels * u64::from(MOMENTS) < 1 << 32;
        if side == 0 || side > MAX_TILE_SIDE || tiles > 65_535 || !is_addressed {
            let reason =
                format!("{tiles} tiles of side {side} are too many for the loss; use fewer");
            return Err(Error::Argument { reason });
        }
        let pixels = pixels as usize;
        let window = metrics::window().map(|weight| weight as f32);
        Ok(Self {
            side,
            tiles,
            window: device.upload("window", &window)?,
            difference: device.unwritten("differences", pixels)?,
            sum: device.unwritten("sums", pixels)?,
            moments: device.unwritten("moments", pixels * MOMENTS as usize)?,
            dissimilarity: device.unwritten("dissimilarities", pixels)?,
            slopes: device.unwritten("slopes", pixels * SLOPES as usize)?,
            row_slopes: device.unwritten("slopes of rows", pixels * SLOPES as usize)?,
        })
    }

    /// One for at least `tiles` tiles: the one that is there, or a new one in its place.
    pub(crate) fn reuse<'a>(
        slot: &'a mut Option<Self>,
        device: &Device,
        side: u32,
        tiles: usize,
    ) -> Result<&'a Self> {
        if slot.as_ref().is_none_or(|loss| loss.side != side || (loss.tiles as usize) < tiles) {
            // not both at once
            *slot = None;
        }
        match slot {
            Some(loss) => Ok(loss),
            None => Ok(slot.insert(Self::new(device, side, tiles as u32)?)),
        }
    }

    /// The most tiles that there is memory for.
    #[must_use]
    pub fn tiles(&self) -> u32 {
        self.tiles
    }

    /// The loss of K tiles and its gradient; on a GPU they are queued.
    ///
    /// # Errors
    /// [`Error::Argument`] where the buffers are not those of a number of tiles that there is memory for; as
    /// [`Device::run_over`].
    pub fn evaluate(&self, device: &Device, inputs: &LossInputs<'_>) -> Result<LossOutput> {
        let tiles = self.check(inputs)?;
        let side = self.side;
        let size = [side, side, tiles];
        let terms = LossTermsKernel {
            params: LossParams { side, tiles },
            image: inputs.image,
            target: inputs.target,
            valid: inputs.valid,
            difference: &self.difference,
            sum: &self.sum,
        };
        device.run_over(&terms, size)?;
        self.run_windows(device, size)?;

        let row_sum = device.unwritten("row sums", (tiles * side) as usize)?;
        let rows = LossRowsKernel {
            params: LossParams { side, tiles },
            difference: &self.difference,
            dissimilarity: &self.dissimilarity,
            row_sum: &row_sum,
        };
        device.run(&rows, tiles * side, 1)?;

        let grad_tiles = device.unwritten("gradient of the image", inputs.image.len())?;
        let [absolute_scale, ssim_scale] =
            scales(inputs.valid_pixels, inputs.ssim_weight).map(|scale| scale as f32);
        let gradient = LossGradientKernel {
            params: LossGradientParams { side, absolute_scale, ssim_scale },
            window: &self.window,
            difference: &self.difference,
            sum: &self.sum,
            row_slopes: &self.row_slopes,
            grad_image: &grad_tiles,
        };
        device.run_over(&gradient, size)?;
        Ok(LossOutput { grad_tiles, row_sum, side })
    }

    /// SSIM of all windows and, along rows, its adjoint.
    fn run_windows(&self, device: &Device, size: [u32; 3]) -> Result<()> {
        let params = SsimParams { side: self.side };
        let window = &self.window;
        let rows = SsimRowsKernel {
            params,
            window,
            difference: &self.difference,
            sum: &self.sum,
            moments: &self.moments,
        };
        device.run_over(&rows, size)?;
        let columns = SsimColumnsKernel {
            params,
            window,
            difference: &self.difference,
            moments: &self.moments,
            dissimilarity: &self.dissimilarity,
            slopes: &self.slopes,
        };
        device.run_over(&columns, size)?;
        let slopes = &self.slopes;
        let row_slopes = &self.row_slopes;
        Ok(device.run_over(&SsimRowsBackwardKernel { params, window, slopes, row_slopes }, size)?)
    }

    /// K
    fn check(&self, inputs: &LossInputs<'_>) -> Result<u32> {
        let area = (self.side * self.side) as usize;
        let pixels = inputs.valid.len();
        let tiles = inputs.valid.len() / area;
        let fits = pixels == tiles * area
            && tiles <= self.tiles as usize
            && [inputs.image, inputs.target].iter().all(|buffer| buffer.len() == 3 * pixels);
        if fits {
            return Ok(tiles as u32);
        }
        let image = inputs.image.len();
        let target = inputs.target.len();
        let reason = format!(
            "{image} values of an image, {target} of its target and {pixels} of the mask are not those of up to {} \
             tiles of side {}",
            self.tiles, self.side
        );
        Err(Error::Argument { reason })
    }
}

impl LossOutput {
    /// The sums of each tile, read from the device: waits for it.  The order of the sums is fixed.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn sums(&self, device: &Device) -> Result<Vec<TileLoss>> {
        Ok(self.sums_of(&device.read(&self.row_sum)?))
    }

    /// The sums of each tile, from the values of `row_sum`.
    pub(crate) fn sums_of(&self, rows: &[Vec4]) -> Vec<TileLoss> {
        let row = |row: &Vec4| {
            let [absolute, dissimilarity, squared, valid] = row.to_array().map(f64::from);
            TileLoss { absolute, dissimilarity, squared, valid }
        };
        let tile = |rows: &[Vec4]| TileLoss::total(&rows.iter().map(row).collect::<Vec<_>>());
        rows.chunks_exact(self.side as usize).map(tile).collect()
    }
}
