//! Numbers the items that are left with a counter's tickets: which item gets which number depends on who comes first.

use crate::bug::*;

#[kernel(threads(64))]
pub fn ticket_in_the_result(id: Invocation, next: Write<u32>, number: Write<u32>) {
    if id.index() < 100 {
        number.write(id.index(), atomic::add(next, 0, 1)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let next = bench.holding(&[0; 1])?;
    let number = bench.output(100)?;
    bench.run(&TicketInTheResultKernel { next: &next, number: &number }, 100)?;
    bench.expect(&number, |i| i)
}
