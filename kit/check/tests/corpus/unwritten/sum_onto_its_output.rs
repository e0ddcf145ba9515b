//! Adds a row of terms to an output that was never written.

use crate::bug::*;

#[kernel(threads(64), iterations = 4)]
pub fn sum_onto_its_output(id: Invocation, params: &Count, terms: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        let mut i = 0;
        while i < 4 {
            output.write(index, output.read(index) + terms.read(4 * index + i)); //~
            i += 1;
        }
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (terms, output) = (bench.input(&[1.0; 400])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&SumOntoItsOutputKernel { params, terms: &terms, output: &output }, 100)?;
    bench.expect(&output, |_| 4.0)
}
