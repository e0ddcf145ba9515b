//! On which side of a line a point is: both products are the same for a point on it. Where one of them is fused with the difference, it is beside.

use crate::bug::*;

#[kernel(threads(64))]
pub fn side_of_a_fused_line(id: Invocation, params: &Count, at: Read<f32>, is_left: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let x = at.read(2 * index);
        let y = at.read(2 * index + 1);
        is_left.write(index, (x * 0.3 - y * 0.1 > 0.0) as u32); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let points: Vec<f32> = (1..20).flat_map(|i| [0.1 * i as f32, 0.3 * i as f32]).collect();
    let at = bench.input(&points)?;
    let is_left = bench.output(19)?;
    let params = Count { count: 19 };
    bench.run(&SideOfAFusedLineKernel { params, at: &at, is_left: &is_left }, 19)?;
    let side = |[x, y]: [f32; 2]| u32::from(x * 0.3 - y * 0.1 > 0.0);
    bench.expect(&is_left, |i| side([points[2 * i as usize], points[2 * i as usize + 1]]))
}
