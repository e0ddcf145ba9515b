//! A bisection that never ends: it keeps the middle where it should step past it.

use crate::bug::*;

#[kernel(threads(64), iterations = 8)]
pub fn never_ends(id: Invocation, params: &Count, first: Read<u32>, output: Write<u32>) {
    let (mut low, mut high) = (0, params.count);
    //~
    while low + 1 < high + 1 {
        let middle = (low + high) / 2;
        if first.read(middle) <= id.index() {
            low = middle;
        } else {
            high = middle;
        }
    }
    output.write(id.index(), low);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (first, output) = (bench.input(&numbers(64))?, bench.output(64)?);
    let params = Count { count: 64 };
    bench.run(&NeverEndsKernel { params, first: &first, output: &output }, 64)?;
    bench.expect(&output, |i| i)
}
