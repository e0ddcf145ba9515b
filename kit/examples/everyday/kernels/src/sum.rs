//! The sum of many values: each workgroup adds up its own, by halving.

use muslin::prelude::*;

/// Values that a workgroup adds up.
pub const GROUP: u32 = 256;

/// Parameters of [`sum`].
#[params]
pub struct SumParams {
    /// Values.
    pub count: u32,
}

/// The sums of 256 values each: `values [count]`, `sums [count / 256]`, rounded up.
#[kernel(threads(GROUP), over(params.count), iterations = 8)]
pub fn sum(
    id: Invocation,
    params: &SumParams,
    values: Read<f32>,
    sums: Write<f32>,
    part: Shared<f32, { GROUP as usize }>,
) {
    let own = id.local.x;
    let index = id.index();
    // all invocations take all barriers: what has no value adds 0
    let value = if index < params.count { values.read(index) } else { 0.0 };
    part.write(own, value);
    id.barrier();
    let mut stride = GROUP / 2;
    while stride > 0 {
        if own < stride {
            part.write(own, part.read(own) + part.read(own + stride));
        }
        id.barrier();
        stride /= 2;
    }
    if own == 0 && index < params.count {
        sums.write(id.workgroup_index(), part.read(0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_workgroup_adds_up_what_it_has() {
        let values = [1.0, 2.0, 3.0];
        let mut sums = [0.0];
        let part = SharedMemory::new();
        let output = Write::from(&mut sums[..]);
        let params = SumParams { count: 3 };
        Workgroup::new([GROUP, 1, 1])
            .run(|id| sum(id, &params, Read::from(&values[..]), output, part.view()));
        assert_eq!(sums, [6.0]);
    }
}
