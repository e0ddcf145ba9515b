//! Cases of `expose` and `expose_backward`.

use organza_check::{
    Bound, KernelRunner, Output, Parity, Rounding,
    inputs::{Fill, Random},
};
use organza_kernel::math::TINY;
use organza_shaders::exposure::{ExposeBackwardKernel, ExposeKernel, ExposureParams};

use super::loss::{TILES, sets};
use organza_device::Result;

/// Inputs of `expose`, and most of those of `expose_backward`.
#[derive(Clone, Debug)]
pub struct Expose {
    /// S
    pub side: u32,
    /// x `[planes, S, S]`
    pub image: Vec<f32>,
    /// Gain and offset `[planes, 2]`.
    pub exposure: Vec<f32>,
}

impl Expose {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let planes = 3 * TILES as usize;
        let pixels = planes * (side * side) as usize;
        Self {
            side,
            image: fill.values(random, pixels, [0.0, 1.0], 1e18),
            exposure: fill.values(random, 2 * planes, [-0.5, 2.0], 1e18),
        }
    }

    fn params(&self) -> ExposureParams {
        ExposureParams { planes: 3 * TILES, side: self.side }
    }

    fn area(&self) -> usize {
        (self.side * self.side) as usize
    }

    /// Gain and offset of a plane.
    fn of_plane(&self, plane: usize) -> [f64; 2] {
        [0, 1].map(|part| f64::from(self.exposure[2 * plane + part]))
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
        let kernel = ExposeKernel {
            params: self.params(),
            image: &self.image,
            exposure: &self.exposure,
            exposed: &runner.unwritten(self.image.len()),
        };
        runner.run(&kernel, self.image.len() as u32, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let x = self.image[index];
        let [gain, offset] = self.of_plane(index / self.area());
        let scale = (gain * f64::from(x)).abs() + offset.abs();
        Bound { scale, floor: f64::from(TINY) * (1.0 + gain.abs() + f64::from(x.abs())) }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let x = f64::from(self.image[index]);
        let [gain, offset] = self.of_plane(index / self.area());
        Some(gain * x + offset)
    }
}

/// Inputs of `expose_backward`.
#[derive(Clone, Debug)]
pub struct ExposeBackward {
    /// Those of the way there.
    pub forward: Expose,
    /// dL/dx' `[planes, S, S]`
    pub gradient: Vec<f32>,
}

impl ExposeBackward {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let forward = Expose::new(side, fill, random);
        let gradient = fill.values(random, forward.image.len(), [-1.0, 1.0], 1e18);
        Self { forward, gradient }
    }

    /// The pixels of a row: x and dL/dx'.
    fn row(&self, row: usize) -> Option<impl Iterator<Item = [f64; 2]>> {
        let side = self.forward.side as usize;
        let image = self.forward.image.get(row * side..(row + 1) * side)?;
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
        let set = &self.forward;
        let rows = 3 * TILES * set.side;
        let kernel = ExposeBackwardKernel {
            params: set.params(),
            image: &set.image,
            exposure: &set.exposure,
            gradient: &self.gradient,
            row_sum: &runner.unwritten(2 * rows as usize),
        };
        runner.run(&kernel, rows, 1)
    }

    fn bound(&self, output: &Output, index: usize, _: Rounding) -> Bound {
        let tiny = f64::from(TINY);
        if output.name == "gradient" {
            let slope = self.gradient[index];
            let [gain, _] = self.forward.of_plane(index / self.forward.area());
            let slope = f64::from(slope.abs());
            return Bound { scale: gain.abs() * slope, floor: tiny * (1.0 + gain.abs() + slope) };
        }
        let Some(row) = self.row(index / 2) else { return Bound::of(0.0) };
        let roundings = f64::from(self.forward.side + 1);
        let (mut scale, mut floor) = (0.0, 0.0);
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
            return Some(slope * self.forward.of_plane(index / self.forward.area())[0]);
        }
        let by = |[x, slope]: [f64; 2]| if index.is_multiple_of(2) { slope * x } else { slope };
        Some(self.row(index / 2)?.map(by).sum::<f64>())
    }
}
