//! Kernels that do what no kernel may do.

use organza_kernel::atomic;
use organza_kernel::prelude::*;

/// Indices past the end of either buffer.
#[kernel(threads(64))]
pub fn reaches_too_far(id: Invocation, input: Read<u32>, output: Write<u32>) {
    output.write(id.index(), input.read(id.index()));
}

/// Parameters of [`arithmetic`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ArithmeticParams {
    /// First value.
    pub start: u32,
    /// Divisor of all.
    pub divisor: u32,
}

/// Overflows where `start` is large enough, and divides by zero where it is told to.
#[kernel(threads(64))]
pub fn arithmetic(id: Invocation, params: &ArithmeticParams, output: Write<u32>) {
    output.write(id.index(), (params.start + id.index()) / params.divisor);
}

/// Reads what its neighbor writes.
#[kernel(threads(64))]
pub fn missing_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let below = if id.local.x > 0 { id.local.x - 1 } else { 0 };
    values.write(id.local.x, id.local.x);
    output.write(id.index(), values.read(below));
}

/// Overwrites what its neighbor reads.
#[kernel(threads(64))]
pub fn missing_second_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    id.barrier();
    output.write(id.index(), values.read((id.local.x + 1) % 64));
    values.write(id.local.x, 0);
}

/// All write the same element.
#[kernel(threads(64))]
pub fn one_cell(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(0, id.local.x);
    id.barrier();
    output.write(id.index(), values.read(0));
}

/// Reads what only even invocations wrote.
#[kernel(threads(64))]
pub fn never_written(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    if id.local.x.is_multiple_of(2) {
        values.write(id.local.x, id.local.x);
    }
    id.barrier();
    output.write(id.index(), values.read(id.local.x));
}

/// Only 40 invocations come to the barrier.
#[kernel(threads(64))]
pub fn divergent_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    if id.local.x < 40 {
        id.barrier(); // some wait
    }
    output.write(id.index(), values.read(id.local.x));
}

/// All come to a barrier, but not to the same.
#[kernel(threads(64))]
pub fn two_barriers(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    if id.local.x < 32 {
        id.barrier(); // the lower half
    } else {
        id.barrier(); // the upper half
    }
    output.write(id.index(), values.read(63 - id.local.x));
}

/// A barrier that guards nothing.
#[kernel(threads(64))]
pub fn barrier_alone(id: Invocation, output: Write<u32>) {
    id.barrier();
    output.write(id.index(), 0);
}

/// Not broken: the next invocation's number, by way of workgroup memory.
#[kernel(threads(64))]
pub fn neighbor(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    id.barrier();
    output.write(id.index(), values.read((id.local.x + 1) % 64));
}

/// Two invocations write each element.
#[kernel(threads(64))]
pub fn same_element(id: Invocation, output: Write<u32>) {
    output.write(id.index() / 2, id.index());
}

/// Reads what another invocation writes.
#[kernel(threads(64))]
pub fn reads_neighbor(id: Invocation, output: Write<u32>) {
    let next = output.read((id.index() + 1) % 256);
    output.write(id.index(), next);
}

/// One writes what the others change atomically.
#[kernel(threads(64))]
pub fn atomic_and_plain(id: Invocation, output: Write<u32>) {
    if id.index() == 77 {
        output.write(0, 1);
    } else {
        atomic::add(output, 0, 1);
    }
}

/// Adds as a kernel of `layers` may, and is none.
#[kernel(threads(64))]
pub fn layers_undeclared(id: Invocation, sums: Write<u32>) {
    if id.index() < 128 {
        atomic::add_wide(sums, 0, [1, 0]);
    }
}

/// Two layers add to the same sum.
#[kernel(threads(64), z_serial)]
pub fn layers_overlap(id: Invocation, sums: Write<u32>) {
    atomic::add_wide(sums, id.workgroup.z / 2, [1, 0]);
}

/// Not broken: a sum for each layer.
#[kernel(threads(64), z_serial)]
pub fn layers_apart(id: Invocation, sums: Write<u32>) {
    atomic::add_wide(sums, id.workgroup.z, [u32::MAX, 0]);
}
