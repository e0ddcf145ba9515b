//! Kernels that break the rules for kernels.

use muslin::atomic;
use muslin::prelude::*;

/// Uses indices past the end of either buffer.
#[kernel(threads(64))]
pub fn reaches_too_far(id: Invocation, input: Read<u32>, output: Write<u32>) {
    output.write(id.index(), input.read(id.index()));
}

/// Parameters of [`arithmetic`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ArithmeticParams {
    /// The first value.
    pub start: u32,
    /// The divisor of all values.
    pub divisor: u32,
}

/// Overflows if `start` is large enough, and divides by zero if `divisor` is 0.
#[kernel(threads(64))]
pub fn arithmetic(id: Invocation, params: &ArithmeticParams, output: Write<u32>) {
    output.write(id.index(), (params.start + id.index()) / params.divisor);
}

/// Reads a value that its neighbor writes.
#[kernel(threads(64))]
pub fn missing_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let below = if id.local.x > 0 { id.local.x - 1 } else { 0 };
    values.write(id.local.x, id.local.x);
    output.write(id.index(), values.read(below));
}

/// Overwrites a value that its neighbor reads.
#[kernel(threads(64))]
pub fn missing_second_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    id.barrier();
    output.write(id.index(), values.read((id.local.x + 1) % 64));
    values.write(id.local.x, 0);
}

/// All invocations write the same element.
#[kernel(threads(64))]
pub fn one_cell(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(0, id.local.x);
    id.barrier();
    output.write(id.index(), values.read(0));
}

/// Reads elements that only even invocations have written.
#[kernel(threads(64))]
pub fn never_written(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    if id.local.x.is_multiple_of(2) {
        values.write(id.local.x, id.local.x);
    }
    id.barrier();
    output.write(id.index(), values.read(id.local.x));
}

/// Only 40 invocations reach the barrier.
#[kernel(threads(64))]
pub fn divergent_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    if id.local.x < 40 {
        id.barrier(); // some wait
    }
    output.write(id.index(), values.read(id.local.x));
}

/// All invocations reach a barrier, but not the same one.
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

/// Not broken: passes on the next invocation's number through workgroup memory.
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

/// Reads a value that another invocation writes.
#[kernel(threads(64))]
pub fn reads_neighbor(id: Invocation, output: Write<u32>) {
    let next = output.read((id.index() + 1) % 256);
    output.write(id.index(), next);
}

/// One invocation writes an element that the others change atomically.
#[kernel(threads(64))]
pub fn atomic_and_plain(id: Invocation, output: Write<u32>) {
    if id.index() == 77 {
        output.write(0, 1);
    } else {
        atomic::add(output, 0, 1);
    }
}

/// Adds like a kernel with `layers`, but does not declare it.
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

/// The first half waits at a barrier while the second half reads the first half's values. Only the barrier is wrong.
#[kernel(threads(64))]
pub fn skips_the_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    if id.local.x < 32 {
        values.write(id.local.x, id.local.x);
        id.barrier(); // half of them
    }
    output.write(id.index(), values.read(id.local.x % 32));
}

/// Parameters of kernels that loop.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct LoopParams {
    /// Number of iterations.
    pub steps: u32,
}

/// Declares fewer iterations than it runs.
#[kernel(threads(64), iterations = 8)]
pub fn loops_too_long(id: Invocation, params: &LoopParams, output: Write<u32>) {
    let mut step = 0;
    let mut sum = 0;
    // the first half of them
    while step < params.steps / 2 {
        sum += step;
        step += 1;
    }
    if id.index() < 64 {
        output.write(id.index(), sum + rest(step, params.steps));
    }
}

/// Runs the second half.
#[loops]
fn rest(begin: u32, end: u32) -> u32 {
    let mut sum = 0;
    for step in begin..end {
        sum += step;
    }
    sum
}

/// Adds to an unwritten element.
#[kernel(threads(64))]
pub fn adds_to_nothing(id: Invocation, input: Read<u32>, output: Write<u32>) {
    if id.index() < 64 {
        output.write(id.index(), output.read(id.index()) + input.read(id.index()));
    }
}

/// Reads in every round elements that only the first, larger round has written.
#[kernel(threads(64), iterations = 2)]
pub fn stale_round(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let mut round = 0;
    let mut sum = 0;
    while round < 2 {
        values.begin_round();
        if id.local.x < 64 - round {
            values.write(id.local.x, round);
        }
        id.barrier();
        sum += values.read(63 - id.local.x);
        id.barrier();
        round += 1;
    }
    output.write(id.index(), sum);
}

/// Has no test of its index, as if all workgroups were full.
#[kernel(threads(64))]
pub fn whole_workgroups(id: Invocation, output: Write<u32>) {
    output.write(id.index(), id.index());
}

/// Parameters of [`histogram`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct HistogramParams {
    /// Number of values.
    pub count: u32,
}

/// Not broken: counts the values of a workgroup in each of 8 bins, and gives each value its place in its bin.
#[kernel(threads(64))]
pub fn histogram(
    id: Invocation,
    params: &HistogramParams,
    input: Read<u32>,
    place: Write<u32>,
    bins: Write<u32>,
    counts: Shared<u32, 8>,
) {
    if id.local.x < 8 {
        counts.write(id.local.x, 0);
    }
    id.barrier();
    if id.index() < params.count {
        place.write(id.index(), counts.atomic_add(input.read(id.index()) % 8, 1));
    }
    id.barrier();
    if id.local.x < 8 {
        bins.atomic_add(id.local.x, counts.read(id.local.x));
    }
}

/// Counts in bins that were never cleared.
#[kernel(threads(64))]
pub fn uncleared_bins(id: Invocation, output: Write<u32>, counts: Shared<u32, 8>) {
    counts.atomic_add(id.local.x % 8, 1);
    id.barrier();
    output.write(id.index(), counts.read(id.local.x % 8));
}

/// Reads a bin while other invocations count in it.
#[kernel(threads(64))]
pub fn reads_while_counting(id: Invocation, output: Write<u32>, counts: Shared<u32, 1>) {
    if id.local.x == 0 {
        counts.write(0, 0);
    }
    id.barrier();
    counts.atomic_add(0, 1);
    output.write(id.index(), counts.read(0));
}
