//! Keeps some values, in their order.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::compact::{
    CompactMarkInputs, CompactMarkKernel, CompactParams, CompactWriteInputs, CompactWriteKernel,
};

use crate::prefix_sum;

/// The values that are at least `least`, in their order.
///
/// # Errors
/// Any error of the device.
pub fn compact(device: &Device, values: &Buffer<f32>, least: f32) -> Result<Vec<f32>> {
    let Some(last) = values.len().checked_sub(1) else { return Ok(Vec::new()) };
    let params = CompactParams { count: values.len() as u32, least };
    let is_kept = device.unwritten("marks", values.len())?;
    device.run_all(&CompactMarkKernel { params, values, is_kept: &is_kept })?;
    let place = prefix_sum::in_passes(device, &is_kept)?;
    let count = device.read_range(&place, last, 1)?[0] + device.read_range(&is_kept, last, 1)?[0];
    let kept = device.unwritten("kept values", count as usize)?;
    device.run_all(&CompactWriteKernel { params, values, place: &place, kept: &kept })?;
    device.read(&kept)
}

case!(pub CompactMark(CompactMarkInputs));

impl Parity for CompactMark {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let values = fill.values(random, count as usize, [-1.0, 1.0], 1e30);
            let params = CompactParams { count, least: 0.25 };
            Self(CompactMarkInputs { params, values, is_kept: unwritten(count as usize) })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        Some(u32::from(self.values[index] >= 0.25).into())
    }
}

case!(pub CompactWrite(CompactWriteInputs));

impl Parity for CompactWrite {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let values = random.values(count as usize, -1.0, 1.0);
            let kept = values.iter().scan(0, |kept, value| {
                let before = *kept;
                *kept += u32::from(*value >= 0.25);
                Some(before)
            });
            let place: Vec<_> = kept.collect();
            let kept = unwritten(values.iter().filter(|value| **value >= 0.25).count());
            let params = CompactParams { count, least: 0.25 };
            Self(CompactWriteInputs { params, values, place, kept })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        listed(self.values.iter().copied().filter(|value| *value >= 0.25))
    }
}
