//! A loop over tiles fills the next tile while others still read the last one.

use crate::bug::*;

#[kernel(threads(64), iterations = 256 + 4)]
pub fn next_tile_overwrites(
    id: Invocation,
    params: &Count,
    input: Read<u32>,
    output: Write<u32>,
    tile: Shared<u32, 64>,
) {
    let (mut sum, mut first) = (0, 0);
    while first < params.count {
        tile.write(id.local_index(), input.read(first + id.local_index())); //~
        id.barrier();
        let mut i = 0;
        while i < 64 {
            sum += tile.read(i); //~
            i += 1;
        }
        first += 64;
    }
    output.write(id.index(), sum);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 256])?, bench.output(64)?);
    let params = Count { count: 256 };
    bench.run(&NextTileOverwritesKernel { params, input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 256)
}
