//! Cases of `expose` and `expose_backward`.

use muslin_check::prelude::*;
use organza_shaders::exposure::{ExposeBackwardInputs, ExposeInputs, ExposureParams};

use super::loss::{TILES, sets};

/// Gain and offset of a value's plane.
fn gain_and_offset(exposure: &[f32], index: usize, side: u32) -> [f64; 2] {
    let plane = index / (side * side) as usize;
    [0, 1].map(|part| f64::from(exposure[2 * plane + part]))
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

    /// x, and its plane's gain and offset.
    fn at(&self, index: usize) -> [f64; 3] {
        let [gain, offset] = gain_and_offset(&self.exposure, index, self.params.side);
        [self.image[index].into(), gain, offset]
    }
}

impl Parity for Expose {
    const KERNEL: &'static str = "expose";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of a product and one of a sum, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.image.len() as u32, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let [x, gain, offset] = self.at(index).map(f64::abs);
        Bound { scale: gain * x + offset, floor: f64::from(TINY) * (1.0 + gain + x) }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let [x, gain, offset] = self.at(index);
        Some(gain * x + offset)
    }
}

case!(pub ExposeBackward(ExposeBackwardInputs));

impl ExposeBackward {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let Expose(ExposeInputs { params, image, exposure, .. }) = Expose::new(side, fill, random);
        let gradient = fill.values(random, image.len(), [-1.0, 1.0], 1e18);
        let row_sum = unwritten(2 * (3 * TILES * side) as usize);
        Self(ExposeBackwardInputs { params, image, exposure, gradient, row_sum })
    }

    /// The pixels of a row: x and dL/dx'.
    fn row(&self, row: usize) -> Option<impl Iterator<Item = [f64; 2]>> {
        let side = self.params.side as usize;
        let image = self.image.get(row * side..(row + 1) * side)?;
        let pixels = image.iter().zip(&self.gradient[row * side..]);
        Some(pixels.map(|(&x, &slope)| [x, slope].map(f64::from)))
    }
}

impl Parity for ExposeBackward {
    const KERNEL: &'static str = "expose_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each product, and for each pixel of the row, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), 3 * TILES * self.params.side, 1)
    }

    fn bound(&self, output: &Output, index: usize, _: Rounding) -> Bound {
        let tiny = f64::from(TINY);
        if output.name == "gradient" {
            let slope = self.gradient[index];
            let [gain, _] = gain_and_offset(&self.exposure, index, self.params.side);
            let slope = f64::from(slope.abs());
            return Bound { scale: gain.abs() * slope, floor: tiny * (1.0 + gain.abs() + slope) };
        }
        let Some(row) = self.row(index / 2) else { return Bound::relative_to(0.0) };
        let roundings = f64::from(self.params.side + 1);
        let mut scale = 0.0;
        let mut floor = 0.0;
        for [x, slope] in row {
            let size = if index.is_multiple_of(2) { x.abs() } else { 1.0 };
            scale += size * slope.abs();
            floor += tiny * (2.0 + size + slope.abs());
        }
        Bound { scale: roundings * scale, floor: roundings * floor }
    }

    /// `x' = gain x + offset`, so `dx'/dx = gain`, `dx'/dgain = x` and `dx'/doffset = 1`.
    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        if output == "gradient" {
            let slope = f64::from(self.gradient[index]);
            return Some(slope * gain_and_offset(&self.exposure, index, self.params.side)[0]);
        }
        let by = |[x, slope]: [f64; 2]| if index.is_multiple_of(2) { slope * x } else { slope };
        Some(self.row(index / 2)?.map(by).sum::<f64>())
    }
}
