//! The bin of a mean without members is that of 0 / 0: NaN ends in an integer, and no output shows it.

use crate::bug::*;
use muslin::math;

#[kernel(threads(64))]
pub fn nan_becomes_an_index(
    id: Invocation,
    params: &Count,
    sum: Read<f32>,
    members: Read<f32>,
    bins: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        let bin = math::to_u32(sum.read(index) / members.read(index)); //~
        atomic::add(bins, bin % 4, 1);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (sum, members) = (bench.input(&[3.0_f32, 0.0, 4.0])?, bench.input(&[1.0_f32, 0.0, 2.0])?);
    let (params, bins) = (Count { count: 3 }, bench.cleared(4)?);
    let kernel = NanBecomesAnIndexKernel { params, sum: &sum, members: &members, bins: &bins };
    bench.run(&kernel, 3)?;
    bench.expect(&bins, |i| [1, 0, 1, 1][i as usize])
}
