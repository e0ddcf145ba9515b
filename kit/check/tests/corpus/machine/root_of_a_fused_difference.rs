//! The root of a difference that is 0, if both products round alike. Where one of them is fused with the difference, it can be negative.

use crate::bug::*;

#[kernel(threads(64))]
pub fn root_of_a_fused_difference(
    id: Invocation,
    params: &Count,
    side: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        let (a, b) = (side.read(2 * index), side.read(2 * index + 1));
        output.write(index, (a * a - b * b).sqrt()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (side, output) = (bench.input(&[5.0_f32, 3.0, 0.1, 0.1, 0.3, 0.3])?, bench.output(3)?);
    let params = Count { count: 3 };
    bench.run(&RootOfAFusedDifferenceKernel { params, side: &side, output: &output }, 3)?;
    bench.expect(&output, |i| [4.0, 0.0, 0.0][i as usize])
}
