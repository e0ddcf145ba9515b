//! A stencil reads a halo around its tile that no invocation has loaded.

use crate::bug::*;

#[kernel(threads(64))]
pub fn halo_is_missing(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    tile: Shared<u32, 66>,
) {
    let at = id.local_index();
    tile.write(at + 1, input.read(id.index()));
    id.barrier();
    output.write(id.index(), tile.read(at) + tile.read(at + 2)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 64])?, bench.output(64)?);
    bench.run(&HaloIsMissingKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |i| if i == 0 || i == 63 { 1 } else { 2 })
}
