//! The workgroup has 32 invocations, and the kernel was written for 64.

use crate::bug::*;

#[kernel(threads(32), iterations = 6)]
pub fn fewer_invocations_than_elements(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    sums: Shared<u32, 64>,
) {
    let at = id.local_index();
    sums.write(at, input.read(id.index()));
    id.barrier();
    let mut half = 32;
    while half > 0 {
        if at < half {
            sums.write(at, sums.read(at) + sums.read(at + half)); //~
        }
        id.barrier();
        half /= 2;
    }
    if at == 0 {
        output.write(id.workgroup.x, sums.read(0));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 64])?, bench.output(2)?);
    bench.run(&FewerInvocationsThanElementsKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 32)
}
