//! Two outputs are the same memory, seen as two types.

use crate::bug::*;

#[kernel(threads(64))]
pub fn view_of_the_output(id: Invocation, bits: Write<u32>, value: Write<f32>) {
    bits.write(id.index(), id.index());
    value.write(id.index(), 1.0);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let bits = bench.output::<u32>(64)?;
    let value = bits.view::<f32>();
    bench.run(&ViewOfTheOutputKernel { bits: &bits, value: &value }, 64)?;
    bench.expect(&bits, |i| i)
}
