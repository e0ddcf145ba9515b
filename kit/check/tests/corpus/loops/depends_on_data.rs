//! A search runs as often as the data says, which is more than is declared.

use crate::bug::*;

#[kernel(threads(64), iterations = 16)]
pub fn depends_on_data(id: Invocation, next: Read<u32>, output: Write<u32>) {
    let (mut at, mut steps) = (id.index(), 0);
    //~
    while at != 0 {
        at = next.read(at);
        steps += 1;
    }
    output.write(id.index(), steps);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let next: Vec<u32> = (0..64_u32).map(|i| i.saturating_sub(1)).collect();
    let (next, output) = (bench.input(&next)?, bench.output(64)?);
    bench.run(&DependsOnDataKernel { next: &next, output: &output }, 64)?;
    bench.expect(&output, |i| i)
}
