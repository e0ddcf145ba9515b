//! Cases of `expose` and `expose_backward`.

use muslin_check::prelude::*;
use organza_shaders::exposure::{ExposeBackwardInputs, ExposeInputs, ExposureParams};

use super::loss::{TILES, sets};

/// Gain and offset of a value's plane.
fn gain_and_offset(exposure: &[f32], index: usize, side: u32) -> [Rounded; 2] {
    let plane = index / (side * side) as usize;
    [exposure[2 * plane].into(), exposure[2 * plane + 1].into()]
}

case!(pub Expose(ExposeInputs));

impl Expose {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let planes = 3 * TILES as usize;
        let pixels = planes * (side * side) as usize;
        Self(ExposeInputs {
            params: ExposureParams { planes: planes as u32, side },
            image: fill.values(random, pixels, [0.0, 1.0], 1e18),
            exposure: fill.values(random, 2 * planes, [-0.5, 2.0], 1e18),
            exposed: unwritten(pixels),
        })
    }
}

impl Parity for Expose {
    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [gain, offset] = gain_and_offset(&self.exposure, index, self.params.side);
        Some(gain * self.image[index].into() + offset)
    }
}

case!(pub ExposeBackward(ExposeBackwardInputs));

impl Parity for ExposeBackward {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let Expose(ExposeInputs { params, image, exposure, .. }) =
                Expose::new(side, fill, random);
            let gradient = fill.values(random, image.len(), [-1.0, 1.0], 1e18);
            let row_sum = unwritten(2 * (3 * TILES * side) as usize);
            Self(ExposeBackwardInputs { params, image, exposure, gradient, row_sum })
        })
    }

    /// `x' = gain x + offset`, so `dx'/dx = gain`, `dx'/dgain = x` and `dx'/doffset = 1`.
    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        if output == "gradient" {
            let [gain, _] = gain_and_offset(&self.exposure, index, self.params.side);
            return Some(gain * self.gradient[index].into());
        }
        let side = self.params.side as usize;
        let row = index / 2 * side;
        let pixels = self.image[row..row + side].iter().zip(&self.gradient[row..]);
        Some(Number::sum(pixels.map(|(&x, &slope)| {
            let [x, slope] = [x, slope].map(Rounded::from);
            if index.is_multiple_of(2) { slope * x } else { slope }
        })))
    }
}
