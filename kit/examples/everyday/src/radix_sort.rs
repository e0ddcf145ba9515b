//! Sorts keys with values.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::radix_sort::{
    BITS, BLOCK, DIGITS, RadixCountInputs, RadixCountKernel, RadixParams, RadixScatterInputs,
    RadixScatterKernel,
};

use crate::prefix_sum;

/// The keys, the smallest first, and their values. Values of equal keys keep their order.
///
/// # Errors
/// Any error of the device.
pub fn radix_sort(
    device: &Device,
    keys: &Buffer<u32>,
    values: &Buffer<u32>,
) -> Result<(Buffer<u32>, Buffer<u32>)> {
    let count = keys.len() as u32;
    let blocks = count.div_ceil(BLOCK);
    let mut sorted = (keys.clone(), values.clone());
    for shift in (0..u32::BITS).step_by(BITS as usize) {
        let params = RadixParams { count, blocks, shift };
        let counts = device.unwritten("digits", (DIGITS * blocks) as usize)?;
        device.run_all(&RadixCountKernel { params, keys: &sorted.0, counts: &counts })?;
        let places = prefix_sum::in_passes(device, &counts)?;
        let next = (
            device.unwritten("sorted keys", keys.len())?,
            device.unwritten("sorted values", keys.len())?,
        );
        device.run_all(&RadixScatterKernel {
            params,
            keys: &sorted.0,
            values: &sorted.1,
            places: &places,
            sorted_keys: &next.0,
            sorted_values: &next.1,
        })?;
        sorted = next;
    }
    Ok(sorted)
}

/// Some keys, with a digit of which only some values occur.
fn keys(count: u32, random: &mut Random) -> Vec<u32> {
    let keys = |_| if random.below(8) == 0 { u32::MAX } else { random.bits() & 0xffff_f3ff };
    (0..count).map(keys).collect()
}

/// The digit of a key.
fn digit(key: u32, params: &RadixParams) -> u32 {
    (key >> params.shift) & (DIGITS - 1)
}

/// How often each digit occurs in each block, digit by digit.
fn counts(keys: &[u32], params: &RadixParams) -> Vec<u32> {
    let blocks: Vec<_> = keys.chunks(BLOCK as usize).collect();
    let count = |wanted: u32, block: &[u32]| {
        block.iter().filter(|key| digit(**key, params) == wanted).count() as u32
    };
    (0..DIGITS).flat_map(|wanted| blocks.iter().map(move |block| count(wanted, block))).collect()
}

case!(pub RadixCount(RadixCountInputs));

impl Parity for RadixCount {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let blocks = count.div_ceil(BLOCK);
            Self(RadixCountInputs {
                params: RadixParams { count, blocks, shift: 8 },
                keys: keys(count, random),
                counts: unwritten((DIGITS * blocks) as usize),
            })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        listed(counts(&self.keys, &self.params))
    }
}

case!(pub RadixScatter(RadixScatterInputs));

impl Parity for RadixScatter {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let params = RadixParams { count, blocks: count.div_ceil(BLOCK), shift: 8 };
            let keys = keys(count, random);
            Self(RadixScatterInputs {
                params,
                places: prefix_sum::exclusive(&counts(&keys, &params)).collect(),
                values: (0..count).collect(),
                keys,
                sorted_keys: unwritten(count as usize),
                sorted_values: unwritten(count as usize),
            })
        })
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let mut order: Vec<_> = (0..self.keys.len()).collect();
        order.sort_by_key(|&at| digit(self.keys[at], &self.params));
        let of = if output == "sorted_keys" { &self.keys } else { &self.values };
        listed(order.into_iter().map(|at| of[at]))
    }
}
