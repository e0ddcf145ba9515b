//! Computes a place in `usize`, which has 64 bits on the CPU and 32 on a GPU.

use crate::bug::*;

#[kernel(threads(64))]
pub fn usize_has_64_bits(id: Invocation, params: &Count, rows: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let place = rows.read(index) as usize * 70_000; //~
        output.write(index, (place / 1000) as u32);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let rows = bench.input(&[1, 100, 70_000])?;
    let output = bench.output(3)?;
    let params = Count { count: 3 };
    bench.run(&UsizeHas64BitsKernel { params, rows: &rows, output: &output }, 3)?;
    bench.expect(&output, |i| [70, 7000, 4_900_000][i as usize])
}
