//! A loop waits once a round, but the next round overwrites what others still read in this one.

use crate::bug::*;

#[kernel(threads(64), storage_barriers, iterations = 6)]
pub fn storage_barrier_is_missing(id: Invocation, sums: Write<u32>) {
    sums.write(id.index(), 1);
    id.storage_barrier();
    let mut distance = 1;
    while distance < 64 {
        let neighbor = sums.read(id.index() ^ distance); //~
        let own = sums.read(id.index());
        sums.write(id.index(), own + neighbor);
        id.storage_barrier();
        distance *= 2;
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let sums = bench.output(64)?;
    bench.run(&StorageBarrierIsMissingKernel { sums: &sums }, 64)?;
    bench.expect(&sums, |_| 64)
}
