//! Adds neighbors in place: with lanes, both read before one writes, and on a GPU one may write first.

use crate::bug::*;

#[kernel(threads(64), lanes(count))]
pub fn lanes_overwrite_their_neighbors<L: Lane>(
    id: Invocation,
    params: &Count,
    input: Read<f32>,
    output: Write<f32>,
    values: Shared<f32, 64>,
) {
    let at = id.local.x;
    L::read_below(input, id.index(), params.count).write_shared(values, at);
    id.barrier();
    let neighbor = L::ramp().index().wrapping_add(L::Index::splat(at)) ^ L::Index::splat(1);
    let sum = L::read_shared(values, at) + L::gather_shared(values, neighbor); //~
    sum.write_shared(values, at);
    id.barrier();
    if id.index() < params.count {
        L::read_shared(values, at).write(output, id.index());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1.0; 64])?;
    let output = bench.output(64)?;
    let params = Count { count: 64 };
    bench.run(
        &LanesOverwriteTheirNeighborsKernel { params, input: &input, output: &output },
        64,
    )?;
    bench.expect(&output, |_| 2.0)
}
