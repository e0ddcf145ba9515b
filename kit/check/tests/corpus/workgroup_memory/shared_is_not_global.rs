//! Workgroup memory carries nothing from one workgroup to the next.

use crate::bug::*;

#[kernel(threads(64))]
pub fn shared_is_not_global(id: Invocation, output: Write<u32>, total: Shared<u32, 1>) {
    if id.local_index() == 0 && id.workgroup.x == 0 {
        total.write(0, 7);
    }
    id.barrier();
    output.write(id.index(), total.read(0)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(128)?;
    bench.run(&SharedIsNotGlobalKernel { output: &output }, 128)?;
    bench.expect(&output, |_| 7)
}
