//! Counts weights that are not zero, and one is smaller than any normal number: where a GPU flushes it, it is zero.

use crate::bug::*;

#[kernel(threads(64))]
pub fn denormal_is_not_zero(id: Invocation, params: &Count, weight: Read<f32>, counts: Write<u32>) {
    let index = id.index();
    if index < params.count {
        counts.write(index, (weight.read(index) != 0.0) as u32); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let weight = bench.input(&[0.0_f32, 1e-40, 1.0])?;
    let counts = bench.output(3)?;
    let params = Count { count: 3 };
    bench.run(&DenormalIsNotZeroKernel { params, weight: &weight, counts: &counts }, 3)?;
    bench.expect(&counts, |i| u32::from(i > 0))
}
