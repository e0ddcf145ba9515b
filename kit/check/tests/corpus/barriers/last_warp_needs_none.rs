//! The last 32 invocations go on without barriers, as if they ran in lockstep.

use crate::bug::*;

#[kernel(threads(64), iterations = 6)]
pub fn last_warp_needs_none(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    sums: Shared<u32, 64>,
) {
    let at = id.local_index();
    sums.write(at, input.read(id.index()));
    let mut half = 32;
    while half > 0 {
        if half >= 32 {
            id.barrier();
        }
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
    let (input, output) = (bench.input(&[1; 64])?, bench.output(1)?);
    bench.run(&LastWarpNeedsNoneKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 64)
}
