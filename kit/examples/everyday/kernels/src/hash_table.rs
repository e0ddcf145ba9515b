//! Counts keys in a hash table with open addressing, which many invocations fill at once.

use muslin::prelude::*;

/// Most places that a key is looked for.
pub const MAX_PROBES: u32 = 4096;

/// Parameters of the kernels of this file.
#[params]
pub struct TableParams {
    /// Keys.
    pub count: u32,
    /// Places of the table: a power of two.
    pub places: u32,
}

/// A key's first place (Murmur3's finalizer, Appleby 2008).
#[inline(always)]
fn hash(key: u32) -> u32 {
    let key = (key ^ (key >> 16)).wrapping_mul(0x85eb_ca6b);
    let key = (key ^ (key >> 13)).wrapping_mul(0xc2b2_ae35);
    key ^ (key >> 16)
}

/// Puts keys into the table, and counts them: `keys [count]`, none of them 0; `table [places]` and `counts [places]` begin as zeros.
/// `lost [1]` is the number of keys for which there was no place.
#[kernel(threads(256), over(params.count), iterations = MAX_PROBES, unordered(table, counts))]
pub fn hash_count(
    id: Invocation,
    params: &TableParams,
    keys: Read<u32>,
    table: Write<u32>,
    counts: Write<u32>,
    lost: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        let key = keys.read(index);
        let first = hash(key);
        let mut probes = 0;
        let mut is_placed = false;
        while probes < MAX_PROBES && !is_placed {
            let place = (first + probes) % params.places;
            let found = table.atomic_compare_exchange(place, 0, key);
            is_placed = found == 0 || found == key;
            if is_placed {
                counts.atomic_add(place, 1);
            }
            probes += 1;
        }
        if !is_placed {
            lost.atomic_add(0, 1);
        }
    }
}

/// How often keys were counted: `keys [count]`, `table [places]`, `counts [places]`, `found [count]`.
#[kernel(threads(256), over(params.count), iterations = MAX_PROBES)]
pub fn hash_find(
    id: Invocation,
    params: &TableParams,
    keys: Read<u32>,
    table: Read<u32>,
    counts: Read<u32>,
    found: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        let key = keys.read(index);
        let first = hash(key);
        let mut probes = 0;
        let mut count = 0;
        let mut is_over = false;
        while probes < MAX_PROBES && !is_over {
            let place = (first + probes) % params.places;
            let other = table.read(place);
            if other == key {
                count = counts.read(place);
            }
            is_over = other == key || other == 0;
            probes += 1;
        }
        found.write(index, count);
    }
}
