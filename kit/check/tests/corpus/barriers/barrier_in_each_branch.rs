//! Both branches have a barrier, but it is not the same one.

use crate::bug::*;

#[kernel(threads(64))]
pub fn barrier_in_each_branch(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    if at < 32 {
        values.write(at, at);
        id.barrier(); //~
    } else {
        values.write(at, 2 * at);
        id.barrier();
    }
    output.write(id.index(), values.read(63 - at));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&BarrierInEachBranchKernel { output: &output }, 64)?;
    bench.expect(&output, |i| if i < 32 { 2 * (63 - i) } else { 63 - i })
}
