//! Counts keys in a hash table.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::hash_table::{
    HashCountInputs, HashCountKernel, HashFindInputs, HashFindKernel, TableParams,
};

/// Places for `count` keys: twice as many, and a power of two.
fn places(count: usize) -> usize {
    (2 * count).next_power_of_two()
}

/// How often each of some keys occurs in `keys`, none of which is 0.
///
/// # Errors
/// Any error of the device.
///
/// # Panics
/// If a key has found no place.
pub fn occurrences(
    device: &Device,
    keys: &Buffer<u32>,
    wanted: &Buffer<u32>,
) -> Result<Buffer<u32>> {
    let places = places(keys.len());
    let params =
        |keys: &Buffer<u32>| TableParams { count: keys.len() as u32, places: places as u32 };
    let table = device.zeros("keys of the table", places)?;
    let counts = device.zeros("counts of the table", places)?;
    let lost = device.zeros("lost keys", 1)?;
    let kernel =
        HashCountKernel { params: params(keys), keys, table: &table, counts: &counts, lost: &lost };
    device.run_all(&kernel)?;
    let found = device.unwritten("found", wanted.len())?;
    let kernel = HashFindKernel {
        params: params(wanted),
        keys: wanted,
        table: &table,
        counts: &counts,
        found: &found,
    };
    device.run_all(&kernel)?;
    assert_eq!(device.read(&lost)?, [0], "the table has no room");
    Ok(found)
}

/// Some keys, among them equal ones.
fn keys(count: u32, random: &mut Random) -> Vec<u32> {
    (0..count).map(|_| 1 + random.below(count.max(2) / 2)).collect()
}

case!(pub HashCount(HashCountInputs));

impl Parity for HashCount {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let places = places(count as usize);
            Self(HashCountInputs {
                params: TableParams { count, places: places as u32 },
                keys: keys(count, random),
                table: vec![0; places],
                counts: vec![0; places],
                lost: vec![0],
            })
        })
    }

    /// Which place a key has depends on the order of the invocations. So the places are sorted, each output by itself.
    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs.iter_mut().for_each(|output| output.values.sort_by(f64::total_cmp));
        outputs
    }

    fn exact(&self, output: &str, places: usize) -> Vec<Option<Rounded>> {
        let mut sorted = self.keys.clone();
        sorted.sort_unstable();
        let runs: Vec<_> = sorted.chunk_by(|a, b| a == b).collect();
        let mut all: Vec<_> = match output {
            "table" => runs.iter().map(|run| run[0]).collect(),
            "counts" => runs.iter().map(|run| run.len() as u32).collect(),
            _ => Vec::new(),
        };
        all.resize(places, 0);
        all.sort_unstable();
        listed(all)
    }
}

case!(pub HashFind(HashFindInputs));

impl Parity for HashFind {
    fn sets() -> Vec<(String, Self)> {
        // key 5 has the only place: key 6 looks for one as often as it may
        let set = |count: u32| {
            let params = TableParams { count, places: 1 };
            let inputs = HashFindInputs {
                params,
                keys: (0..count).map(|at| 5 + at % 2).collect(),
                table: vec![5],
                counts: vec![9],
                found: unwritten(count as usize),
            };
            (format!("{count} keys"), Self(inputs))
        };
        [0, 1, 300].map(set).into()
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        Some(if self.keys[index] == 5 { 9_u32 } else { 0 }.into())
    }
}
