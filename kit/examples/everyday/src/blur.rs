//! A blur of a picture, and steps of the heat equation.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::blur::{BlurInputs, BlurKernel, GridParams, HeatInputs, HeatKernel};

/// The mean of 5 x 5 pixels.
///
/// # Errors
/// Any error of the device.
pub fn blur(device: &Device, params: GridParams, input: &Buffer<f32>) -> Result<Buffer<f32>> {
    let output = device.unwritten("blurred", input.len())?;
    device.run_all(&BlurKernel { params, input, output: &output })?;
    Ok(output)
}

/// Steps of the heat equation. Two buffers take turns.
///
/// # Errors
/// Any error of the device.
pub fn heat(
    device: &Device,
    params: GridParams,
    input: &Buffer<f32>,
    steps: u32,
) -> Result<Buffer<f32>> {
    let mut now = device.unwritten("heat", input.len())?;
    let mut next = device.unwritten("next heat", input.len())?;
    device.copy(input, &now);
    for _ in 0..steps {
        device.run_all(&HeatKernel { params, input: &now, output: &next })?;
        std::mem::swap(&mut now, &mut next);
    }
    Ok(now)
}

/// Sizes of grids, among them ones that no workgroup fits.
const SIZES: [[u32; 2]; 6] = [[1, 1], [2, 3], [16, 16], [17, 1], [1, 40], [50, 33]];

/// A grid for each size: its parameters, and values.
fn grids(rate: f32) -> impl Iterator<Item = (String, GridParams, Vec<f32>)> {
    SIZES.into_iter().map(move |[width, height]| {
        let mut random = Random::new((100 * width + height).into());
        let values = random.values((width * height) as usize, -1.0, 1.0);
        (format!("{width} x {height}"), GridParams { width, height, rate }, values)
    })
}

case!(pub Blur(BlurInputs));

impl Parity for Blur {
    fn sets() -> Vec<(String, Self)> {
        let set = |(name, params, input): (String, GridParams, Vec<f32>)| {
            let output = unwritten(input.len());
            (name, Self(BlurInputs { params, input, output }))
        };
        grids(0.0).map(set).collect()
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [width, height] = [self.params.width, self.params.height].map(|x| x as i64);
        let [x, y] = [index as i64 % width, index as i64 / width];
        let at = |at: i64| {
            let row = (y + at / 5 - 2).clamp(0, height - 1);
            Rounded::from(self.input[(row * width + (x + at % 5 - 2).clamp(0, width - 1)) as usize])
        };
        Some(Rounded::sum((0..25).map(at)) * Rounded::from(1.0_f32 / 25.0))
    }
}

case!(pub Heat(HeatInputs));

impl Parity for Heat {
    fn sets() -> Vec<(String, Self)> {
        let set = |(name, params, input): (String, GridParams, Vec<f32>)| {
            let output = unwritten(input.len());
            (name, Self(HeatInputs { params, input, output }))
        };
        grids(0.2).map(set).collect()
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [width, height] = [self.params.width, self.params.height].map(|x| x as usize);
        let [x, y] = [index % width, index / width];
        let at = |index: usize| Rounded::from(self.input[index]);
        if x == 0 || y == 0 || x + 1 == width || y + 1 == height {
            return Some(at(index));
        }
        let around = [index - 1, index + 1, index - width, index + width].map(at);
        let change = Rounded::sum(around) - Rounded::from(4.0) * at(index);
        Some(at(index) + Rounded::from(self.params.rate) * change)
    }
}
