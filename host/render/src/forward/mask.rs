//! A bit for each Gaussian.

use muslin_device::{Buffer, Device, Result};

use super::scan::exclusive_scan;

/// Bits of a mask and how many lie before each of its words.
#[derive(Debug)]
pub struct Mask {
    pub bits: Buffer<u32>,
    /// `[words + 1]`: the exclusive sums, and the total.
    pub first: Buffer<u32>,
}

impl Mask {
    pub fn new(device: &Device, bits: Buffer<u32>, count: &Buffer<u32>) -> Result<Self> {
        let first = exclusive_scan(device, count, bits.len() as u32)?;
        Ok(Self { bits, first })
    }
}
