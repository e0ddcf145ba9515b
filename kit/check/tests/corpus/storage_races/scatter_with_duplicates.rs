//! Scatters to indices that occur twice.

use crate::bug::*;

#[kernel(threads(64))]
pub fn scatter_with_duplicates(
    id: Invocation,
    params: &Count,
    target: Read<u32>,
    output: Write<u32>,
) {
    if id.index() < params.count {
        output.write(target.read(id.index()), id.index()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let target: Vec<u32> = (0..128).map(|i| i % 100).collect();
    let target = bench.input(&target)?;
    let output = bench.output(100)?;
    let params = Count { count: 128 };
    bench.run(&ScatterWithDuplicatesKernel { params, target: &target, output: &output }, 128)?;
    bench.expect(&output, |i| if i < 28 { 100 + i } else { i })
}
