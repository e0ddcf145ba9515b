//! Units: a unit is all that a batch has of one camera. Networks' gradients are summed unit by unit, so that no sum depends
//! on which units a batch is cut into parts with.
//!
//! A unit's samples are cut into slices of the same length, from the unit's first sample on; its last slice may be shorter.
//! Both are numbered over all units of a part.

use organza_kernel::prelude::*;

use crate::limits::MAX_CAMERAS;

/// Values of a unit in `unit [units + 1, 2]`: its first sample and its first slice.
pub const UNIT_VALUES: u32 = 2;

/// Iterations of a search among all units.
pub const SEARCH: u32 = u32::BITS;

/// Parameters of [`unit_begin`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct UnitBeginParams {
    /// Units: cameras of the part.
    pub units: u32,
    /// Words of a camera's mask.
    pub words: u32,
    /// Samples of a slice.
    pub slice: u32,
    /// 1 for samples of the transmittance network, 0 for those of the color network: they are the pairs.
    pub of_rays: u32,
}

/// Where each unit's samples and slices begin, and the totals, `unit [units + 1, 2]`: a single invocation.
///
/// `first_pair [units, words] + 1`, `first_sample [pairs + 1]`, which is not read for pairs.
#[kernel(threads(1), iterations = MAX_CAMERAS + 1)]
pub fn unit_begin(
    id: Invocation,
    params: &UnitBeginParams,
    first_pair: Read<u32>,
    first_sample: Read<u32>,
    unit: Write<u32>,
) {
    if id.index() == 0 {
        let (mut before, mut slices) = (0, 0);
        let mut index = 0;
        while index <= params.units {
            let pair = first_pair.read(index * params.words);
            let first = if params.of_rays != 0 { first_sample.read(pair) } else { pair };
            slices += (first - before).div_ceil(params.slice);
            unit.write(UNIT_VALUES * index, first);
            unit.write(UNIT_VALUES * index + 1, slices);
            before = first;
            index += 1;
        }
    }
}

/// The first sample of a unit, of `unit [units + 1, 2]`.
#[inline(always)]
pub fn first_sample_of(unit: Read<u32>, index: u32) -> u32 {
    unit.read(UNIT_VALUES * index)
}

/// The first slice of a unit.
#[inline(always)]
pub fn first_slice_of(unit: Read<u32>, index: u32) -> u32 {
    unit.read(UNIT_VALUES * index + 1)
}

/// The slice of a sample; slices have `slice` samples.
#[inline(always)]
pub fn slice_of_sample(unit: Read<u32>, units: u32, slice: u32, sample: u32) -> u32 {
    let index = last_from(unit, units, 0, sample);
    first_slice_of(unit, index) + (sample - first_sample_of(unit, index)) / slice
}

/// The unit of a slice.
#[inline(always)]
pub fn unit_of_slice(unit: Read<u32>, units: u32, index: u32) -> u32 {
    last_from(unit, units, 1, index)
}

/// The samples of a slice: begin and end. Behind the last slice, the end is not above the begin.
#[inline(always)]
pub fn samples_of_slice(unit: Read<u32>, units: u32, slice: u32, index: u32) -> (u32, u32) {
    let owner = unit_of_slice(unit, units, index);
    let begin = first_sample_of(unit, owner) + (index - first_slice_of(unit, owner)) * slice;
    let (end, last) = (begin + slice, first_sample_of(unit, owner + 1));
    (begin, if end < last { end } else { last })
}

/// The last unit whose value is not above `value`. Those before it with the same value are empty.
#[loops]
#[inline(always)]
fn last_from(unit: Read<u32>, units: u32, place: u32, value: u32) -> u32 {
    let (mut low, mut high) = (0, units);
    while low + 1 < high {
        let middle = (low + high) / 2;
        let is_before = unit.read(UNIT_VALUES * middle + place) <= value;
        low = if is_before { middle } else { low };
        high = if is_before { high } else { middle };
    }
    low
}
