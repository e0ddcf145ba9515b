//! Every invocation of the workgroup stores the workgroup's sum, not only the first one.

use crate::bug::*;

#[kernel(threads(64))]
pub fn sum_by_every_invocation(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    sums: Shared<u32, 64>,
) {
    let at = id.local_index();
    sums.write(at, input.read(id.index()));
    id.barrier();
    output.write(id.workgroup.x, sums.read(0) + sums.read(63)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 128])?, bench.output(2)?);
    bench.run(&SumByEveryInvocationKernel { input: &input, output: &output }, 128)?;
    bench.expect(&output, |_| 2)
}
