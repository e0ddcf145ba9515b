//! Rendered tiles beside photographs: the loss, its gradient, and what is measured of each tile.

use super::part::Part;
use crate::stages::counts::Needed;
use crate::stages::cut::{PlannedTile, values_of_tiles};
use crate::stages::distortion::Distortion;
use crate::stages::exposure::{self, Exposed, ExposureGradient};
use crate::stages::loss::{Loss, LossInputs, LossOutput, LossTarget, TileLoss};
use muslin_device::{Buffer, Device};
use organza_core::error::Result;
use organza_core::ranks::Ranks;
use organza_core::tile::TileBatch;

/// Losses of tiles, and the gradients of their exposures if they are learned, in the order of the batch.
pub(crate) type Compared = (Vec<TileLoss>, Vec<ExposureGradient>);

/// Tiles that were compared.
#[derive(Debug)]
pub struct Comparison {
    pub output: LossOutput,
    /// Of the exposures, if they are learned: see [`exposure::gradients`].
    row_sum: Option<Buffer<f32>>,
    /// The terms of the loss beside the image.
    pub distortion: Option<Distortion>,
}

impl Comparison {
    /// Compares `rendered [K, 3, S, S]`, some tiles of a batch.
    pub fn new(
        device: &Device,
        loss: &Loss,
        target: &LossTarget<'_>,
        (tiles, side): (&[PlannedTile], u32),
        rendered: &Buffer<f32>,
    ) -> Result<Self> {
        let area = (side * side) as usize;
        let image =
            device.upload("photographs", &values_of_tiles(target.image, tiles, 3 * area))?;
        let valid = device.upload("masks", &values_of_tiles(target.valid, tiles, area))?;
        let expose = |all: &[f32]| {
            let exposure = values_of_tiles(all, tiles, exposure::VALUES);
            Exposed::new(device, rendered, side, &exposure)
        };
        let exposed = target.exposure.map(expose).transpose()?;
        let inputs = LossInputs {
            image: exposed.as_ref().map_or(rendered, |exposed| &exposed.image),
            target: &image,
            valid: &valid,
            valid_pixels: target.valid_pixels,
            ssim_weight: target.ssim_weight,
        };
        let output = loss.evaluate(device, &inputs)?;
        let back = |exposed: &Exposed| exposed.backward(device, rendered, &output.grad_image);
        let row_sum = exposed.as_ref().map(back).transpose()?;
        Ok(Self { output, row_sum, distortion: target.distortion(&valid) })
    }

    /// Reads what was found, and the capacity that the part needed: waits for the device.
    pub fn read(
        &self,
        device: &Device,
        part: &Part,
        (tiles, side): (&[PlannedTile], u32),
    ) -> Result<(Found, Needed)> {
        let (losses, rows, needed) =
            self.output.sums_and_needed(device, part, self.row_sum.as_ref())?;
        Ok((Found::new(tiles, losses, exposure::gradients(&rows, side, tiles)), needed))
    }

    /// Reads what was found, and dLoss/dY `[K, 3, S, S]`.
    pub fn read_gradient(
        &self,
        device: &Device,
        (tiles, side): (&[PlannedTile], u32),
    ) -> Result<(Found, Vec<f32>)> {
        let rows = self.row_sum.as_ref().map(|rows| device.read(rows)).transpose()?;
        let exposures = exposure::gradients(&rows.unwrap_or_default(), side, tiles);
        let found = Found::new(tiles, self.output.sums(device)?, exposures);
        Ok((found, device.read(&self.output.grad_image)?))
    }
}

/// Losses of tiles and gradients of their exposures, in any order.
#[derive(Debug, Default)]
pub struct Found {
    /// By the tiles' places in the batch.
    losses: Vec<(usize, TileLoss)>,
    exposures: Vec<ExposureGradient>,
}

/// Values of a tile that ranks tell each other: its place, its loss, and its exposure's gradient if that is learned.
const LOSS_VALUES: usize = 5;
const EXPOSURE_VALUES: usize = 6;

impl Found {
    fn new(tiles: &[PlannedTile], losses: Vec<TileLoss>, exposures: Vec<ExposureGradient>) -> Self {
        let losses = tiles.iter().map(|tile| tile.place).zip(losses).collect();
        Self { losses, exposures }
    }

    /// Takes what another has.
    pub fn extend(&mut self, other: Self) {
        self.losses.extend(other.losses);
        self.exposures.extend(other.exposures);
    }

    /// In the order of the batch.
    pub fn in_order(mut self) -> Compared {
        self.losses.sort_by_key(|(place, _)| *place);
        self.exposures.sort_by_key(|exposure| exposure.place);
        (self.losses.into_iter().map(|(_, loss)| loss).collect(), self.exposures)
    }

    /// The results of all ranks for a batch.
    pub fn gather(
        &self,
        batch: &TileBatch,
        target: &LossTarget<'_>,
        ranks: &dyn Ranks,
    ) -> Result<Self> {
        let mut values = Vec::new();
        let mut exposures = self.exposures.iter();
        for (place, loss) in &self.losses {
            values.push(*place as f64);
            values.extend(bytemuck::cast::<_, [f64; LOSS_VALUES - 1]>(*loss));
            values.extend(exposures.next().iter().flat_map(|found| found.gradient.as_flattened()));
        }
        let width = LOSS_VALUES + target.exposure.map_or(0, |_| EXPOSURE_VALUES);
        let mut all = Self::default();
        for bytes in ranks.gather(bytemuck::cast_slice(&values).to_vec())? {
            let values: Vec<f64> = bytemuck::pod_collect_to_vec(&bytes);
            for row in values.chunks_exact(width) {
                let place = row[0] as usize;
                let (loss, exposure) = row[1..].split_at(LOSS_VALUES - 1);
                all.losses.push((place, bytemuck::pod_read_unaligned(bytemuck::cast_slice(loss))));
                if let [gradient] = exposure.as_chunks::<EXPOSURE_VALUES>().0 {
                    let camera = batch.tiles[place].camera;
                    let gradient = bytemuck::cast(*gradient);
                    all.exposures.push(ExposureGradient { place, camera, gradient });
                }
            }
        }
        Ok(all)
    }
}
