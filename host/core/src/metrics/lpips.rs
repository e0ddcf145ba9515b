//! LPIPS, the learned perceptual image patch similarity, version 0.1 (Zhang, Isola, Efros, Shechtman and Wang 2018).
//!
//! Both images go through the layers of a network that was trained to classify photographs. After each of five layers,
//! the features of a pixel are scaled to length 1. The squares of their differences are weighted, and averaged over the
//! pixels. LPIPS is the sum over the five layers: 0 for equal images, and larger the more different they look.

#[cfg(test)]
mod tests;

use std::path::Path;

use rayon::prelude::*;

use crate::error::{Error, Result};
use crate::input::open_regular;
use crate::scene::{TensorSpec, read_metadata, read_tensors};
use muslin_device::memory;

/// The value of `format` in a weights file's metadata.
const FORMAT: &str = "organza.lpips";

/// A layer of the network.
#[derive(Clone, Copy, Debug)]
enum Step {
    /// A convolution with a bias, then a ReLU.
    Convolve { outputs: usize, side: usize, stride: usize, padding: usize },
    /// The largest value of each square.
    Pool { side: usize, stride: usize },
    /// Compares the features at this point.
    Compare,
}

const fn convolve(outputs: usize, side: usize, stride: usize, padding: usize) -> Step {
    Step::Convolve { outputs, side, stride, padding }
}

const fn pool(side: usize) -> Step {
    Step::Pool { side, stride: 2 }
}

/// AlexNet (Krizhevsky 2014), as torchvision has it.
const ALEX: &[Step] = &[
    convolve(64, 11, 4, 2),
    Step::Compare,
    pool(3),
    convolve(192, 5, 1, 2),
    Step::Compare,
    pool(3),
    convolve(384, 3, 1, 1),
    Step::Compare,
    convolve(256, 3, 1, 1),
    Step::Compare,
    convolve(256, 3, 1, 1),
    Step::Compare,
];

/// VGG with 16 layers (Simonyan and Zisserman 2014).
const VGG: &[Step] = &[
    convolve(64, 3, 1, 1),
    convolve(64, 3, 1, 1),
    Step::Compare,
    pool(2),
    convolve(128, 3, 1, 1),
    convolve(128, 3, 1, 1),
    Step::Compare,
    pool(2),
    convolve(256, 3, 1, 1),
    convolve(256, 3, 1, 1),
    convolve(256, 3, 1, 1),
    Step::Compare,
    pool(2),
    convolve(512, 3, 1, 1),
    convolve(512, 3, 1, 1),
    convolve(512, 3, 1, 1),
    Step::Compare,
    pool(2),
    convolve(512, 3, 1, 1),
    convolve(512, 3, 1, 1),
    convolve(512, 3, 1, 1),
    Step::Compare,
];

/// Mean and deviation of each channel that the networks expect, for colors from -1 to 1.
const SHIFT: [f32; 3] = [-0.030, -0.088, -0.188];
const SCALE: [f32; 3] = [0.458, 0.448, 0.450];

/// A network and its weights.
#[derive(Clone, Debug)]
pub struct Lpips {
    network: &'static str,
    steps: &'static [Step],
    /// `[side, side, inputs, outputs]` and `[outputs]` of each convolution.
    convolutions: Vec<[Vec<f32>; 2]>,
    /// `[features]` of each comparison.
    weights: Vec<Vec<f32>>,
}

impl Lpips {
    /// Reads a safetensors file of weights: `conv.I.weight [rows, columns, inputs, outputs]`, `conv.I.bias [outputs]`
    /// and `linear.I.weight [features]`. In its metadata, `format` is `organza.lpips` and `network` is `alex` or
    /// `vgg`. `scripts/lpips-weights.py` writes it.
    ///
    /// # Errors
    /// [`Error::ReadFile`]; [`Error::Invalid`] for any other file; [`Error::MissingTensor`] and
    /// [`Error::WrongShape`].
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let metadata = |key| {
            let (mut file, length) = open_regular(path)?;
            read_metadata(&mut file, length, path, key)
        };
        let no_weights = |what: String| {
            let reason = format!(
                "{what}, so it is no file of LPIPS weights; scripts/lpips-weights.py makes one"
            );
            Error::Invalid { origin: path.to_owned(), reason }
        };
        match metadata("format")?.as_deref() {
            Some(FORMAT) => {}
            Some(other) => return Err(no_weights(format!("its format is `{other}`"))),
            None => return Err(no_weights("its metadata have no `format`".to_owned())),
        }
        let (network, steps) = match metadata("network")?.as_deref() {
            Some("alex") => ("alex", ALEX),
            Some("vgg") => ("vgg", VGG),
            _ => return Err(no_weights("its `network` is neither `alex` nor `vgg`".to_owned())),
        };
        let mut tensors = read_tensors(path)?;
        let mut take = |name: String, shape: &[usize]| {
            let spec = TensorSpec { name, shape: shape.to_vec(), why: "a layer of the network" };
            spec.take(&mut tensors, path)
        };
        let mut convolutions = Vec::new();
        let mut weights = Vec::new();
        let mut channels = 3;
        for step in steps {
            match *step {
                Step::Convolve { outputs, side, .. } => {
                    let name = format!("conv.{}", convolutions.len());
                    let shape = [side, side, channels, outputs];
                    let weight = take(format!("{name}.weight"), &shape)?;
                    convolutions.push([weight, take(format!("{name}.bias"), &[outputs])?]);
                    channels = outputs;
                }
                Step::Compare => {
                    let name = format!("linear.{}.weight", weights.len());
                    weights.push(take(name, &[channels])?);
                }
                Step::Pool { .. } => {}
            }
        }
        Ok(Self { network, steps, convolutions, weights })
    }

    /// Name of the network: `alex` or `vgg`.
    #[must_use]
    pub fn network(&self) -> &'static str {
        self.network
    }

    /// The LPIPS distance of two images of `[width, height]`. Pixels are RGB, row by row, with colors from 0 to 1.
    /// `None` if an image is too small for the network: less than 31 pixels wide or high for `alex`, 16 for `vgg`.
    /// # Errors
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    ///
    /// # Panics
    /// If the images do not have width x height pixels.
    pub fn distance(
        &self,
        size: [usize; 2],
        first: &[[f32; 3]],
        second: &[[f32; 3]],
    ) -> Result<Option<f64>> {
        let mut maps = [Map::from_image(size, first)?, Map::from_image(size, second)?];
        let mut convolutions = self.convolutions.iter();
        let mut weights = self.weights.iter();
        let mut sum = 0.0;
        for step in self.steps {
            match *step {
                Step::Convolve { side, stride, padding, .. } => {
                    let layer = convolutions.next().expect("as many as the steps have");
                    for map in &mut maps {
                        let Some(next) = map.convolve(layer, side, stride, padding)? else {
                            return Ok(None);
                        };
                        *map = next;
                    }
                }
                Step::Pool { side, stride } => {
                    for map in &mut maps {
                        let Some(next) = map.pool(side, stride)? else { return Ok(None) };
                        *map = next;
                    }
                }
                Step::Compare => {
                    let weights = weights.next().expect("as many as the steps have");
                    sum += compare(&maps, weights);
                }
            }
        }
        Ok(Some(sum))
    }
}

/// Features of an image: `[height, width, channels]`.
struct Map {
    width: usize,
    height: usize,
    channels: usize,
    values: Vec<f32>,
}

impl Map {
    fn zeros([width, height]: [usize; 2], channels: usize) -> Result<Self> {
        let values = memory::zeros(width * height * channels, "the features of LPIPS")?;
        Ok(Self { width, height, channels, values })
    }

    /// The colors, scaled as the networks expect them.
    fn from_image([width, height]: [usize; 2], pixels: &[[f32; 3]]) -> Result<Self> {
        assert_eq!(pixels.len(), width * height, "pixels of an image of {width} x {height}");
        let mut map = Self::zeros([width, height], 3)?;
        for (values, pixel) in map.values.chunks_exact_mut(3).zip(pixels) {
            for channel in 0..3 {
                values[channel] = (2.0 * pixel[channel] - 1.0 - SHIFT[channel]) / SCALE[channel];
            }
        }
        Ok(map)
    }

    /// The output size of a window of `side` pixels; `None` if no window fits.
    fn windows(&self, side: usize, stride: usize, padding: usize) -> Option<[usize; 2]> {
        let of = |length: usize| Some((length + 2 * padding).checked_sub(side)? / stride + 1);
        Some([of(self.width)?, of(self.height)?])
    }

    fn convolve(
        &self,
        [weight, bias]: &[Vec<f32>; 2],
        side: usize,
        stride: usize,
        padding: usize,
    ) -> Result<Option<Self>> {
        let Some(size) = self.windows(side, stride, padding) else { return Ok(None) };
        let outputs = bias.len();
        let inputs = side * side * self.channels;
        let mut next = Self::zeros(size, outputs)?;
        let row = size[0] * outputs;
        next.values.par_chunks_exact_mut(row).enumerate().for_each(|(y, output)| {
            // all windows of the row, one after the other
            let mut windows = vec![0.0; size[0] * inputs];
            for (x, window) in windows.chunks_exact_mut(inputs).enumerate() {
                for (at, line) in window.chunks_exact_mut(side * self.channels).enumerate() {
                    self.copy_line(line, x * stride, y * stride + at, padding);
                }
            }
            output.chunks_exact_mut(outputs).for_each(|pixel| pixel.copy_from_slice(bias));
            multiply(&windows, weight, output, [size[0], inputs, outputs]);
            output.iter_mut().for_each(|value| *value = value.max(0.0));
        });
        Ok(Some(next))
    }

    /// Copies a part of a row, starting at column `left - padding`. Everything outside the map stays 0.
    fn copy_line(&self, line: &mut [f32], left: usize, top: usize, padding: usize) {
        let Some(y) = top.checked_sub(padding).filter(|&y| y < self.height) else { return };
        let pixels = line.len() / self.channels;
        let begin = left.max(padding);
        let end = (left + pixels).min(self.width + padding);
        if begin < end {
            let from = (y * self.width + begin - padding) * self.channels;
            let values = &self.values[from..][..(end - begin) * self.channels];
            line[(begin - left) * self.channels..][..values.len()].copy_from_slice(values);
        }
    }

    fn pool(&self, side: usize, stride: usize) -> Result<Option<Self>> {
        let Some(size) = self.windows(side, stride, 0) else { return Ok(None) };
        let mut next = Self::zeros(size, self.channels)?;
        for (at, output) in next.values.chunks_exact_mut(self.channels).enumerate() {
            let x = at % size[0] * stride;
            let y = at / size[0] * stride;
            output.fill(f32::NEG_INFINITY);
            for (row, column) in (0..side).flat_map(|row| (0..side).map(move |c| (row, c))) {
                let from = ((y + row) * self.width + x + column) * self.channels;
                let values = &self.values[from..][..self.channels];
                output.iter_mut().zip(values).for_each(|(most, value)| *most = most.max(*value));
            }
        }
        Ok(Some(next))
    }
}

/// `c += a b`, of `a [rows, inner]`, `b [inner, columns]` and `c [rows, columns]`.
fn multiply(a: &[f32], b: &[f32], c: &mut [f32], [rows, inner, columns]: [usize; 3]) {
    assert_eq!([a.len(), b.len(), c.len()], [rows * inner, inner * columns, rows * columns]);
    let inner_step = inner as isize;
    let column_step = columns as isize;
    // SAFETY: the lengths are those of the three matrices, row by row, and only `c` is written to.
    unsafe {
        matrixmultiply::sgemm(
            rows,
            inner,
            columns,
            1.0,
            a.as_ptr(),
            inner_step,
            1,
            b.as_ptr(),
            column_step,
            1,
            1.0,
            c.as_mut_ptr(),
            column_step,
            1,
        );
    }
}

/// The weighted squared differences of the normalized features, averaged over the pixels.
fn compare([first, second]: &[Map; 2], weights: &[f32]) -> f64 {
    /// Added to each length to avoid a division by 0.
    const LEAST: f64 = 1e-10;
    let length = |features: &[f32]| {
        features.iter().map(|&f| f64::from(f).powi(2)).sum::<f64>().sqrt() + LEAST
    };
    let pixel = |(a, b): (&[f32], &[f32])| {
        let length_a = length(a);
        let length_b = length(b);
        let term = |((&a, &b), &weight): ((&f32, &f32), &f32)| {
            f64::from(weight) * (f64::from(a) / length_a - f64::from(b) / length_b).powi(2)
        };
        a.iter().zip(b).zip(weights).map(term).sum::<f64>()
    };
    let channels = first.channels;
    let pixels = first.values.chunks_exact(channels).zip(second.values.chunks_exact(channels));
    pixels.map(pixel).sum::<f64>() / (first.width * first.height) as f64
}
