//! How often each value occurs.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::histogram::{BINS, HistogramInputs, HistogramKernel, HistogramParams};

/// How often each of 256 values occurs.
///
/// # Errors
/// Any error of the device.
pub fn histogram(device: &Device, values: &Buffer<u8>) -> Result<Vec<u32>> {
    let params = HistogramParams { count: values.len() as u32 };
    let bins = device.zeros("bins", BINS as usize)?;
    device.run_all(&HistogramKernel { params, values, bins: &bins })?;
    device.read(&bins)
}

case!(pub Histogram(HistogramInputs));

impl Parity for Histogram {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let values = (0..count).map(|_| random.bits() as u8).collect();
            let params = HistogramParams { count };
            Self(HistogramInputs { params, values, bins: vec![3; BINS as usize] })
        })
    }

    fn exact_at(&self, _: &str, bin: usize) -> Option<Rounded> {
        let count = self.values.iter().filter(|value| usize::from(**value) == bin).count();
        Some(Rounded::exact(3.0 + count as f64))
    }
}
