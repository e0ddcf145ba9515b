//! Keeps some values, in their order: prefix sums say where each one goes.

use muslin::prelude::*;

/// Parameters of the kernels of this file.
#[params]
pub struct CompactParams {
    /// Values.
    pub count: u32,
    /// The smallest value that is kept.
    pub least: f32,
}

/// 1 for each value of `values [count]` that is kept, and 0 for others: `is_kept [count]`.
#[kernel(threads(256), over(params.count))]
pub fn compact_mark(
    id: Invocation,
    params: &CompactParams,
    values: Read<f32>,
    is_kept: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        is_kept.write(index, u32::from(values.read(index) >= params.least));
    }
}

/// Writes what is kept to its place: `place [count]` has how many are kept before each value, `kept` has room for all.
#[kernel(threads(256), over(params.count))]
pub fn compact_write(
    id: Invocation,
    params: &CompactParams,
    values: Read<f32>,
    place: Read<u32>,
    kept: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        let value = values.read(index);
        if value >= params.least {
            kept.write(place.read(index), value);
        }
    }
}
