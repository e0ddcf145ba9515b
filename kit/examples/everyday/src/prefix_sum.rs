//! Exclusive prefix sums: in passes, and in one that looks back.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::prefix_sum::{
    BLOCK, PrefixAddInputs, PrefixAddKernel, PrefixBlocksInputs, PrefixBlocksKernel,
    PrefixLookBackInputs, PrefixLookBackKernel, PrefixParams,
};

/// How many blocks `count` values have.
fn blocks(count: usize) -> usize {
    count.div_ceil(BLOCK as usize)
}

/// The sums of all values before each one, in two passes over the values, and the same for the sums of blocks.
///
/// # Errors
/// Any error of the device.
pub fn in_passes(device: &Device, values: &Buffer<u32>) -> Result<Buffer<u32>> {
    let params = PrefixParams { count: values.len() as u32 };
    let prefix = device.unwritten("prefix", values.len())?;
    let sums = device.unwritten("sums of blocks", blocks(values.len()))?;
    let kernel = PrefixBlocksKernel { params, values, prefix: &prefix, sums: &sums };
    device.run_all(&kernel)?;
    if sums.len() > 1 {
        let before = in_passes(device, &sums)?;
        device.run_all(&PrefixAddKernel { params, before: &before, prefix: &prefix })?;
    }
    Ok(prefix)
}

/// The same in one pass, for sums below 2^30.
///
/// # Errors
/// Any error of the device.
pub fn look_back(device: &Device, values: &Buffer<u32>) -> Result<Buffer<u32>> {
    let prefix = device.unwritten("prefix", values.len())?;
    let kernel = PrefixLookBackKernel {
        params: PrefixParams { count: values.len() as u32 },
        values,
        ticket: &device.zeros("ticket", 1)?,
        state: &device.zeros("states of blocks", blocks(values.len()))?,
        prefix: &prefix,
    };
    device.run_all(&kernel)?;
    Ok(prefix)
}

/// Values whose sums stay small, of some number.
fn values(count: u32, random: &mut Random) -> Vec<u32> {
    (0..count).map(|_| random.below(1000)).collect()
}

/// The sums of all values before each one, by ordinary Rust.
pub(crate) fn exclusive(values: &[u32]) -> impl Iterator<Item = u32> {
    values.iter().scan(0, |sum, value| {
        let before = *sum;
        *sum += value;
        Some(before)
    })
}

case!(pub PrefixBlocks(PrefixBlocksInputs));

impl Parity for PrefixBlocks {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            Self(PrefixBlocksInputs {
                params: PrefixParams { count },
                values: values(count, random),
                prefix: unwritten(count as usize),
                sums: unwritten(blocks(count as usize)),
            })
        })
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let blocks = self.values.chunks(BLOCK as usize);
        match output {
            "sums" => listed(blocks.map(|block| block.iter().sum::<u32>())),
            _ => listed(blocks.flat_map(exclusive)),
        }
    }
}

case!(pub PrefixAdd(PrefixAddInputs));

impl Parity for PrefixAdd {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            Self(PrefixAddInputs {
                params: PrefixParams { count },
                before: values(blocks(count as usize) as u32, random),
                prefix: values(count, random),
            })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        Some((self.prefix[index] + self.before[index / BLOCK as usize]).into())
    }
}

case!(pub PrefixLookBack(PrefixLookBackInputs));

impl Parity for PrefixLookBack {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            Self(PrefixLookBackInputs {
                params: PrefixParams { count },
                values: values(count, random),
                ticket: vec![0],
                state: vec![0; blocks(count as usize)],
                prefix: unwritten(count as usize),
            })
        })
    }

    /// Tickets and states are no results: an additional workgroup takes a ticket, too.
    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs.retain(|output| output.name == "prefix");
        outputs
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        listed(exclusive(&self.values))
    }
}
