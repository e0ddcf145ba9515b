//! The invocations without an item do not reach the sum of their subgroup.

use crate::bug::*;

#[kernel(threads(64), subgroups)]
pub fn lanes_without_items(id: Invocation, params: &Count, input: Read<u32>, sums: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let sum = id.subgroup_sum(input.read(index)); //~
        if id.subgroup_lane() == 0 {
            sums.atomic_add(0, sum);
        }
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, sums) = (bench.input(&numbers(100))?, bench.holding(&[0; 1])?);
    bench.run(&LanesWithoutItemsKernel { params: Count { count: 100 }, input: &input, sums: &sums }, 100)?;
    bench.expect(&sums, |_| 4950)
}
