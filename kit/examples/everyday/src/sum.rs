//! The sum of many values.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::sum::{GROUP, SumInputs, SumKernel, SumParams};

/// The sum of `values`. Each dispatch leaves a 256th of the values.
///
/// # Errors
/// Any error of the device.
pub fn sum(device: &Device, values: &Buffer<f32>) -> Result<f32> {
    let mut left = values.clone();
    while left.len() > 1 {
        let params = SumParams { count: left.len() as u32 };
        let sums = device.unwritten("sums", left.len().div_ceil(GROUP as usize))?;
        device.run_all(&SumKernel { params, values: &left, sums: &sums })?;
        left = sums;
    }
    Ok(device.read(&left)?.first().copied().unwrap_or(0.0))
}

case!(pub Sum(SumInputs));

impl Parity for Sum {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let values = fill.values(random, count as usize, [-1.0, 1.0], 1e30);
            let sums = unwritten(count.div_ceil(GROUP) as usize);
            Self(SumInputs { params: SumParams { count }, values, sums })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let groups = self.values.chunks(GROUP as usize);
        listed(groups.map(|group| Rounded::sum(group.iter().copied().map(Rounded::from))))
    }
}
