//! A blur writes to the image that its neighbors read.

use crate::bug::*;

#[kernel(threads(64))]
pub fn blur_in_place(id: Invocation, params: &Count, image: Write<f32>) {
    let index = id.index();
    if index > 0 && index + 1 < params.count {
        let sum = image.read(index - 1) + image.read(index) + image.read(index + 1); //~
        image.write(index, sum / 3.0); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let ramp: Vec<f32> = (0..200).map(|i| (i * i % 7) as f32).collect();
    let image = bench.holding(&ramp)?;
    bench.run(&BlurInPlaceKernel { params: Count { count: 200 }, image: &image }, 200)?;
    bench.expect(&image, |i| {
        let i = i as usize;
        if i == 0 || i == 199 { ramp[i] } else { (ramp[i - 1] + ramp[i] + ramp[i + 1]) / 3.0 }
    })
}
