//! Both branches call one helper, and its barrier is the same place for both.

use crate::bug::*;

/// Swaps the halves of a workgroup's values.
fn swapped(id: Invocation, values: Shared<u32, 64>, own: u32) -> u32 {
    values.write(id.local_index(), own);
    id.barrier(); //~
    values.read(id.local_index() ^ 32)
}

#[kernel(threads(64))]
pub fn helper_in_both_branches(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    let found = if at < 32 { swapped(id, values, at) } else { swapped(id, values, 2 * at) };
    output.write(id.index(), found);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&HelperInBothBranchesKernel { output: &output }, 64)?;
    bench.expect(&output, |i| if i < 32 { 2 * (i + 32) } else { i - 32 })
}
