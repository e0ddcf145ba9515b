//! Kernels that break the rules for kernels.

use muslin::atomic;
use muslin::prelude::*;
use muslin::samples::Samples;

/// Uses indices past the end of either buffer.
#[kernel(threads(64))]
pub fn reaches_too_far(id: Invocation, input: Read<u32>, output: Write<u32>) {
    output.write(id.index(), input.read(id.index()));
}

/// Reads a value that its neighbor writes.
#[kernel(threads(64))]
pub fn missing_barrier(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let below = if id.local.x > 0 { id.local.x - 1 } else { 0 };
    values.write(id.local.x, id.local.x);
    output.write(id.index(), values.read(below));
}

/// Not broken: passes on the next invocation's number through workgroup memory.
#[kernel(threads(64))]
pub fn neighbor(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    id.barrier();
    output.write(id.index(), values.read((id.local.x + 1) % 64));
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

/// Adds to an unwritten element.
#[kernel(threads(64), over(input.len()))]
pub fn adds_to_nothing(id: Invocation, input: Read<u32>, output: Write<u32>) {
    if id.index() < 64 {
        output.write(id.index(), output.read(id.index()) + input.read(id.index()));
    }
}

/// Parameters of [`histogram`].
#[params]
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

/// Reads one byte more than there are.
#[kernel(threads(64))]
pub fn reads_bytes(id: Invocation, bytes: Packed<u8>, output: Write<u32>) {
    output.write(id.index(), bytes.read(id.index()));
}

/// Copies rows of samples.
#[kernel(threads(64), lanes(samples))]
pub fn copies_fours<S: Samples>(
    id: Invocation,
    params: &CopiesFoursParams,
    input: ReadFours<f32>,
    output: WriteFours<f32>,
) {
    let at = id.index();
    if at < params.samples {
        S::read(input, at).write(output, at, params.samples - at);
    }
}

/// Parameters of [`copies_fours`].
#[params]
pub struct CopiesFoursParams {
    /// Samples.
    pub samples: u32,
}
