//! Tickets of workgroup memory put values into a list, and the list is read as if it were in order.

use crate::bug::*;

#[kernel(threads(64))]
pub fn ticket_within_a_workgroup(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    next: Shared<u32, 1>,
) {
    if id.local_index() == 0 {
        next.write(0, 0);
    }
    id.barrier();
    let place = next.atomic_add(0, 1);
    output.write(64 * id.workgroup.x + place, input.read(id.index())); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&numbers(128))?, bench.output(128)?);
    let kernel = TicketWithinAWorkgroupKernel { input: &input, output: &output };
    bench.device.dispatch(&kernel, [2, 1, 1])?;
    bench.expect(&output, |i| i)
}
