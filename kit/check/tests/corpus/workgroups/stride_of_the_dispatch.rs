//! A loop over all elements steps by the workgroup's size, not by the dispatch's.

use crate::bug::*;

#[kernel(threads(64), iterations = 16)]
pub fn stride_of_the_dispatch(id: Invocation, params: &Count, output: Write<u32>) {
    let mut index = id.index();
    while index < params.count {
        output.write(index, index); //~
        index += id.size.x;
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(1024)?;
    let kernel = StrideOfTheDispatchKernel { params: Count { count: 1024 }, output: &output };
    bench.run(&kernel, 256)?;
    bench.expect(&output, |i| i)
}
