//! Divides by a number of members that can be 0.

use crate::bug::*;

#[kernel(threads(64))]
pub fn divides_by_zero(
    id: Invocation,
    params: &Count,
    sum: Read<u32>,
    members: Read<u32>,
    output: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, sum.read(index) / members.read(index)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let members: Vec<u32> = (0..100).map(|i| i % 10).collect();
    let members = bench.input(&members)?;
    let output = bench.output(100)?;
    let params = Count { count: 100 };
    let sum = bench.input(&[0; 100])?;
    let kernel = DividesByZeroKernel { params, sum: &sum, members: &members, output: &output };
    bench.run(&kernel, 100)?;
    bench.expect(&output, |_| 0)
}
