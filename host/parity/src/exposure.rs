//! Cases of `expose`, `expose_backward` and `exposure_center`.

use muslin_check::prelude::*;
use organza_shaders::exposure::{
    ExposeBackwardInputs, ExposeBackwardParams, ExposeInputs, ExposeParams, ExposureCenterInputs,
    ExposureCenterParams, STRIDE, VALUES,
};

use super::binned::{read_sums, write_sums};
use super::loss::{TILES, sets};

/// The photographs of the tiles, of three.
const PHOTOGRAPH: [u32; TILES as usize] = [2, 0, 2];

/// The first value of a plane's exposure.
fn place(plane: usize) -> usize {
    (PHOTOGRAPH[plane / 3] * STRIDE) as usize + plane % 3 * 2
}

case!(pub Expose(ExposeInputs));

impl Expose {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let planes = 3 * TILES;
        let pixels = (planes * side * side) as usize;
        Self(ExposeInputs {
            params: ExposeParams { planes, side },
            photograph: PHOTOGRAPH.to_vec(),
            exposure: fill.values(random, 3 * STRIDE as usize, [-1.0, 1.0], 9.0),
            image: fill.values(random, pixels, [0.0, 1.0], 1e15),
            exposed: unwritten(pixels),
        })
    }
}

impl Parity for Expose {
    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let place = place(index / (self.params.side * self.params.side) as usize);
        let [log_gain, offset] = [0, 1].map(|at| Rounded::from(self.exposure[place + at]));
        Some(log_gain.exp() * self.image[index].into() + offset)
    }
}

case!(pub ExposeBackward(ExposeBackwardInputs) { before: Vec<f32> });

impl Parity for ExposeBackward {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let Expose(ExposeInputs { photograph, exposure, image, .. }) =
                Expose::new(side, fill, random);
            let values = 3 * STRIDE;
            let before: Vec<_> = (0..values).map(|value| value as f32 / 8.0 - 1.0).collect();
            let inputs = ExposeBackwardInputs {
                params: ExposeBackwardParams { rows: 3 * TILES * side, side, values },
                gradient: fill.values(random, image.len(), [-1.0, 1.0], 1e15),
                photograph,
                exposure,
                image,
                sum: write_sums(&before),
            };
            Self { inputs, before }
        })
    }

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs[1] = Output::float("sum", read_sums(&outputs[1].words(), self.before.len()));
        outputs
    }

    /// `x' = exp(a) x + b`, so `dx'/dx = exp(a)`, `dx'/da = exp(a) x` and `dx'/db = 1`.
    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let area = (self.params.side * self.params.side) as usize;
        let gain = |plane: usize| Rounded::from(self.exposure[place(plane)]).exp();
        if output == "gradient" {
            return Some(gain(index / area) * self.gradient[index].into());
        }
        let terms = (0..self.image.len()).filter_map(|at| {
            let slope = Rounded::from(self.gradient[at]);
            match index.checked_sub(place(at / area))? {
                0 => Some(slope * self.image[at].into() * gain(at / area)),
                1 => Some(slope),
                _ => None,
            }
        });
        Some(Number::sum(terms.chain([self.before[index].into()])))
    }
}

case!(pub ExposureCenter(ExposureCenterInputs));

impl Parity for ExposureCenter {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|photographs, fill, random| {
            let len = (photographs * STRIDE) as usize;
            Self(ExposureCenterInputs {
                params: ExposureCenterParams { photographs, values: VALUES },
                exposure: fill.values(random, len, [-1.0, 1.0], 1e30),
            })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let value = Rounded::from(self.exposure[index]);
        let stride = STRIDE as usize;
        if index % stride >= VALUES as usize {
            return Some(value);
        }
        let all = self.exposure.iter().skip(index % stride).step_by(stride);
        let sum: Rounded = Number::sum(all.map(|&value| value.into()));
        Some(value - sum / (self.params.photographs as f32).into())
    }
}
