//! Each half of the workgroup leaves out another round: all reach the barrier three times, but not together.

use crate::bug::*;

#[kernel(threads(64), iterations = 4)]
pub fn rounds_apart(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    let left_out = if at < 32 { 0 } else { 3 };
    let mut sum = 0;
    values.write(at, 1);
    for round in 0..4 {
        if round != left_out {
            id.barrier(); //~
            sum += values.read(at);
        }
    }
    output.write(id.index(), sum);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&RoundsApartKernel { output: &output }, 64)?;
    bench.expect(&output, |_| 3)
}
