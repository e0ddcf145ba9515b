//! The case of `binned_gradient`, and binned sums for other cases.

use muslin::binned::ROWS;
use muslin_check::prelude::*;
use organza_shaders::binned::{BinnedGradientInputs, BinnedGradientParams};

/// The unit of a row.
fn unit(row: usize) -> f64 {
    2_f64.powi(16 * row as i32 - 150)
}

/// An integer of two words.
pub fn integer([low, high]: [u32; 2]) -> i64 {
    (u64::from(high) << 32 | u64::from(low)) as i64
}

/// The inverse of [`integer`].
pub fn words(integer: i64) -> [u32; 2] {
    [integer as u32, (integer >> 32) as u32]
}

/// The numbers in the words of sums `[17, values, 2]`.
pub fn read_sums(words: &[u32], values: usize) -> Vec<f64> {
    let rows: Vec<_> = words.as_chunks().0.iter().copied().map(integer).collect();
    let sum = |value: usize| {
        (0..ROWS as usize - 1).map(|row| rows[row * values + value] as f64 * unit(row)).sum()
    };
    (0..values).map(sum).collect()
}

/// Sums of one number each, `[17, values, 2]`.
pub fn write_sums(values: &[f32]) -> Vec<u32> {
    let mut sums = vec![[0; 2]; ROWS as usize * values.len()];
    for (index, &value) in values.iter().enumerate().filter(|(_, value)| value.is_normal()) {
        let row = (value.to_bits() >> 23 & 0xff) as usize / 16;
        sums[row * values.len() + index] = words((f64::from(value) / unit(row)) as i64);
    }
    sums.into_flattened()
}

case!(pub BinnedGradient(BinnedGradientInputs));

impl Parity for BinnedGradient {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let len = count as usize;
            let mut sum = write_sums(&fill.values(random, len, [-1.0, 1.0], 1e30));
            if fill != Fill::Huge {
                // sums of many numbers, in rows that cancel each other
                for sum in sum.as_chunks_mut().0.iter_mut().take(9 * len) {
                    *sum = words((u64::from(random.below(u32::MAX)) << 20) as i64 - (1 << 51));
                }
            }
            Self(BinnedGradientInputs {
                params: BinnedGradientParams { values: count },
                sum,
                gradient: fill.values(random, len, [-1.0, 1.0], 1e30),
            })
        })
    }

    fn exact(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        if output == "sum" {
            return vec![Some(Rounded::exact(0.0)); len.min(self.sum.len())];
        }
        // only three rows matter
        let sums = read_sums(&self.sum, self.gradient.len()).into_iter();
        let sums = sums.map(|sum| Rounded::from(sum).rounded(3.0));
        listed(sums.zip(&self.gradient).map(|(sum, &before)| sum + before.into()))
    }
}
