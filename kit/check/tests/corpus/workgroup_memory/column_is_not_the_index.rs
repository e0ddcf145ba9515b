//! A workgroup of 8 x 8 invocations indexes its memory with x alone.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn column_is_not_the_index(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local_index()); //~
    id.barrier();
    output.write(id.local_index(), values.read(id.local.x));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.device.run_over(&ColumnIsNotTheIndexKernel { output: &output }, [8, 8, 1])?;
    bench.expect(&output, |i| i)
}
