//! Metrics of images.

use numpy::{PyReadonlyArray3, PyUntypedArrayMethods};
use organza::metrics;
use pyo3::prelude::*;

use crate::error::invalid;
use crate::job;

/// The pixels of two images, and their width and height.
struct Pair {
    image: Vec<[f32; 3]>,
    truth: Vec<[f32; 3]>,
    size: [usize; 2],
}

impl Pair {
    fn new(image: &PyReadonlyArray3<'_, f32>, truth: &PyReadonlyArray3<'_, f32>) -> PyResult<Self> {
        let [height, width, channels] = [0, 1, 2].map(|axis| image.shape()[axis]);
        if channels != 3 || image.shape() != truth.shape() {
            let found = image.shape();
            let beside = truth.shape();
            return Err(invalid(format!(
                "the images are {found:?} and {beside:?}, expected two of one shape [H, W, 3]"
            )));
        }
        let pixels = |image: &PyReadonlyArray3<'_, f32>| -> PyResult<Vec<[f32; 3]>> {
            Ok(image.as_slice()?.as_chunks().0.to_vec())
        };
        Ok(Self { image: pixels(image)?, truth: pixels(truth)?, size: [width, height] })
    }
}

/// PSNR of two images `[H, W, 3]`, in dB; `None` without a pixel.
#[pyfunction]
pub fn psnr(
    image: PyReadonlyArray3<'_, f32>,
    truth: PyReadonlyArray3<'_, f32>,
) -> PyResult<Option<f64>> {
    let Pair { image, truth, .. } = Pair::new(&image, &truth)?;
    Ok(metrics::psnr(&image, &truth, None))
}

/// SSIM of two images `[H, W, 3]`; `None` if one is smaller than its window.
#[pyfunction]
pub fn ssim(
    py: Python<'_>,
    image: PyReadonlyArray3<'_, f32>,
    truth: PyReadonlyArray3<'_, f32>,
) -> PyResult<Option<f64>> {
    let Pair { image, truth, size } = Pair::new(&image, &truth)?;
    job::run(py, move || Ok(metrics::ssim(size, &image, &truth, None)))
}
