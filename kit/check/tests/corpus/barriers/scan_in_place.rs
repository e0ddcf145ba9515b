//! A prefix sum reads and writes one array in the same step.

use crate::bug::*;

#[kernel(threads(64), iterations = 6)]
pub fn scan_in_place(id: Invocation, input: Read<u32>, output: Write<u32>, sums: Shared<u32, 64>) {
    let at = id.local_index();
    sums.write(at, input.read(id.index()));
    id.barrier();
    let mut step = 1;
    while step < 64 {
        if at >= step {
            sums.write(at, sums.read(at) + sums.read(at - step)); //~
        }
        id.barrier();
        step *= 2;
    }
    output.write(id.index(), sums.read(at));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 64])?, bench.output(64)?);
    bench.run(&ScanInPlaceKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |i| i + 1)
}
