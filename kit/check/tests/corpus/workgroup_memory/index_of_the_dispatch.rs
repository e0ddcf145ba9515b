//! Workgroup memory is indexed with the position in the dispatch: wrong from the second workgroup on.

use crate::bug::*;

#[kernel(threads(64))]
pub fn index_of_the_dispatch(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.index(), id.index()); //~
    id.barrier();
    output.write(id.index(), values.read(id.index() ^ 1));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(128)?;
    bench.run(&IndexOfTheDispatchKernel { output: &output }, 128)?;
    bench.expect(&output, |i| i ^ 1)
}
