//! A reduction by halves waits before its loop, but not within it.

use crate::bug::*;

#[kernel(threads(64), iterations = 6)]
pub fn reduction_without_barrier(
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
        half /= 2;
    }
    if at == 0 {
        output.write(id.workgroup.x, sums.read(0));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1; 128])?;
    let output = bench.output(2)?;
    bench.run(&ReductionWithoutBarrierKernel { input: &input, output: &output }, 128)?;
    bench.expect(&output, |_| 64)
}
