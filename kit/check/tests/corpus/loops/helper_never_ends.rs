//! A bisection in a helper never ends: where two numbers are left, the middle is the lower one.

use crate::bug::*;

/// The largest integer whose square is at most `x`.
#[loops]
fn root(x: u32) -> u32 {
    let mut low = 0;
    let mut high = 1 << 16;
    //~
    while low < high {
        let middle = (low + high) / 2;
        if middle * middle <= x {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[kernel(threads(64), iterations = 17)]
pub fn helper_never_ends(id: Invocation, input: Read<u32>, output: Write<u32>) {
    output.write(id.index(), root(input.read(id.index())));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[9; 64])?;
    let output = bench.output(64)?;
    bench.run(&HelperNeverEndsKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 3)
}
