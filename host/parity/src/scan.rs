//! Cases of `scan_block` and `scan_add`.

use muslin_check::prelude::*;
use organza_shaders::scan::{BLOCK, ScanAddInputs, ScanBlockInputs, ScanParams};

/// The exclusive sums of numbers, and their total.
pub fn prefix(numbers: impl IntoIterator<Item = u32>) -> Vec<u32> {
    let mut sums = vec![0];
    numbers.into_iter().for_each(|number| sums.push(sums[sums.len() - 1] + number));
    sums
}

/// Sizes around the workgroup and around the block.
fn sizes() -> impl Iterator<Item = u32> {
    SIZES
        .into_iter()
        .chain([15, 16, 17, 1022, 1023, 1024, 1025, 2047, 2048, 3071, 3072, 3073, 5000])
}

/// Random values and zeros of every size.
fn sets<T>(make: impl Fn(Vec<u32>) -> T) -> Vec<(String, T)> {
    let of = |size: u32, below: u32| {
        let mut random = Random::new(u64::from(size));
        let values = (0..size).map(|_| random.below(below)).collect();
        (format!("{size} values below {below}"), make(values))
    };
    // 800,000 times 5000 is just no overflow
    sizes().flat_map(|size| [1, 1000, 800_000].map(|below| of(size, below))).collect()
}

case!(pub ScanBlock(ScanBlockInputs));

impl Parity for ScanBlock {
    fn sets() -> Vec<(String, Self)> {
        sets(|value| {
            let count = value.len();
            Self(ScanBlockInputs {
                params: ScanParams { count: count as u32 },
                value,
                prefix: unwritten(count + 1),
                block_sum: unwritten((count + 1).div_ceil(BLOCK as usize)),
            })
        })
    }

    /// The exclusive sums within each block, with one sum behind the last value; and the sum of each whole block.
    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let mut sum = 0;
        let mut prefix = Vec::new();
        let mut block_sum = Vec::new();
        for (index, value) in self.value.iter().copied().chain([0]).enumerate() {
            if index > 0 && index % 1024 == 0 {
                block_sum.push(std::mem::take(&mut sum));
            }
            prefix.push(sum);
            sum += value;
        }
        block_sum.push(sum);
        listed(if output == "prefix" { prefix } else { block_sum })
    }
}

case!(pub ScanAdd(ScanAddInputs));

impl Parity for ScanAdd {
    fn sets() -> Vec<(String, Self)> {
        sets(|mut prefix| {
            let count = prefix.len() as u32;
            prefix.push(1);
            let blocks = 0..(count + 1).div_ceil(BLOCK);
            Self(ScanAddInputs {
                params: ScanParams { count },
                block_prefix: blocks.map(|block| block * 1_000_003).collect(),
                prefix,
            })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let blocks = self.prefix.chunks(1024).zip(&self.block_prefix);
        listed(blocks.flat_map(|(block, before)| block.iter().map(move |x| x + before)))
    }
}
