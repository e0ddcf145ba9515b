//! The first invocation publishes a value, and the others read it: nothing says that it comes first.

use crate::bug::*;

#[kernel(threads(64))]
pub fn reader_before_publisher(id: Invocation, shared: Write<u32>, output: Write<u32>) {
    if id.index() == 0 {
        shared.atomic_store(0, 7);
    }
    if id.index() < 100 {
        output.write(id.index(), shared.atomic_load(0)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let shared = bench.holding(&[0; 1])?;
    let output = bench.output(100)?;
    bench.run(&ReaderBeforePublisherKernel { shared: &shared, output: &output }, 100)?;
    bench.expect(&output, |_| 7)
}
