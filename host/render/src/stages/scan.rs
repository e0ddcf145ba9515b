//! Exclusive prefix sums of any length, and bit masks with the prefix sums of their words' bits.

use organza_shaders::scan::{BLOCK, ScanAddKernel, ScanBlockKernel, ScanParams};

use muslin_device::{Buffer, Count, Device, Result};

/// The exclusive sums of the first `count` values, and the total behind them: `[count + 1]`.
pub fn exclusive_scan(device: &Device, value: &Buffer<u32>, count: u32) -> Result<Buffer<u32>> {
    let prefix = device.unwritten("prefix sums", count as usize + 1)?;
    let blocks = (count + 1).div_ceil(BLOCK);
    let block_sum = device.unwritten("block sums", blocks as usize)?;
    let params = ScanParams { count };
    device.run_all(&ScanBlockKernel { params, value, prefix: &prefix, block_sum: &block_sum })?;
    if blocks > 1 {
        let block_prefix = exclusive_scan(device, &block_sum, blocks)?;
        device.run_all(&ScanAddKernel { params, block_prefix: &block_prefix, prefix: &prefix })?;
    }
    Ok(prefix)
}

/// The total at the end of exclusive sums: waits for the device.
pub fn total(device: &Device, prefix: &Buffer<u32>) -> Result<Count> {
    Ok(Count::known(device.read_range(prefix, prefix.len() - 1, 1)?[0]))
}

/// A bit mask, and the number of set bits before each of its words.
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

#[cfg(test)]
mod tests {
    use super::*;
    use muslin_device::DeviceOptions;

    #[test]
    fn sums_of_every_size_around_the_blocks() {
        let device = crate::open_device(&DeviceOptions::cpu(Some(2))).expect("the CPU");
        for count in
            [0, 1, 15, 16, 17, 1022, 1023, 1024, 1025, 2047, 2048, 1024 * 1024 - 1, 1024 * 1024 + 5]
        {
            let values: Vec<u32> =
                (0..count).map(|i: u32| i.wrapping_mul(2_654_435_761) >> 22).collect();
            let buffer = device.upload("values", &values).expect("memory");
            let prefix = exclusive_scan(&device, &buffer, count)
                .and_then(|p| device.read(&p))
                .expect("a scan");
            let mut sum = 0;
            for (index, value) in values.iter().enumerate() {
                assert_eq!(prefix[index], sum, "{count} values, at {index}");
                sum += value;
            }
            assert_eq!(prefix[count as usize], sum, "the total of {count} values");
        }
    }
}
