//! Two dispatches in the wrong order: the first one reads what the second one will write.

use crate::bug::*;

#[kernel(threads(64))]
pub fn consumer_before_producer(id: Invocation, scratch: Write<u32>, output: Write<u32>) {
    output.write(id.index(), scratch.read(id.index()) + 1); //~
}

#[kernel(threads(64))]
pub fn producer(id: Invocation, scratch: Write<u32>) {
    scratch.write(id.index(), id.index());
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (scratch, output) = (bench.scratch(64)?, bench.output(64)?);
    bench.run(&ConsumerBeforeProducerKernel { scratch: &scratch, output: &output }, 64)?;
    bench.run(&ProducerKernel { scratch: &scratch }, 64)?;
    bench.expect(&output, |i| i + 1)
}
