//! The last tile is shorter, and what lies behind its end is the tile before.

use crate::bug::*;

#[kernel(threads(64), iterations = 128 + 2)]
pub fn end_of_the_last_tile(
    id: Invocation,
    params: &Count,
    input: Read<u32>,
    output: Write<u32>,
    tile: Shared<u32, 64>,
) {
    let at = id.local_index();
    let mut sum = 0;
    let mut first = 0;
    while first < params.count {
        if first + at < params.count {
            tile.write(at, input.read(first + at));
        }
        id.barrier();
        let mut i = 0;
        while i < 64 {
            sum += tile.read(i); //~
            i += 1;
        }
        id.barrier();
        tile.begin_round();
        first += 64;
    }
    output.write(id.index(), sum);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1; 100])?;
    let output = bench.output(64)?;
    let params = Count { count: 100 };
    bench.run(&EndOfTheLastTileKernel { params, input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 100)
}
