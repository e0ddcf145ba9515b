use glam::Vec4;
use muslin::binned;
use muslin::prelude::*;
use muslin::shared_tile::Unshared;
use muslin::workgroup::{SharedMemory, Workgroup};

use organza_shaders::dense_weight_backward::{dense_weight_backward, weight_invocations};
use organza_shaders::weight_slice::DenseWeightBackwardParams;
use organza_shaders::weight_tile::STAGED;

use crate::dense_backward::numbers;

/// The invocations of workgroups.
fn run(workgroups: [u32; 3], invocation: impl Fn(Invocation, Shared<Vec4, STAGED>)) {
    for z in 0..workgroups[2] {
        for x in 0..workgroups[0] {
            let staged = SharedMemory::new();
            let workgroup = Workgroup::new([64, 1, 1]).at([x, 0, z], workgroups);
            workgroup.run(|id| invocation(id, staged.view()));
        }
    }
}

/// Slices begin and end anywhere in a quad. The variant adds the same bits.
#[test]
fn weights_are_summed_slice_by_slice() {
    let sizes = [(1, 9), (3, 9), (4, 4), (70, 33), (64, 7), (12, 1), (11, 3)];
    let layers = [(6, 2), (6, 8), (67, 9)];
    for ((samples, slice), (inputs, columns)) in
        sizes.into_iter().flat_map(|size| layers.map(|layer| (size, layer)))
    {
        let stride = (samples + 3_u32).next_multiple_of(4);
        let parameters = (inputs + 1) * columns;
        let params = DenseWeightBackwardParams {
            samples,
            first_sample: 0,
            stride,
            inputs,
            columns,
            weight: 0,
            bias: inputs * columns,
            cameras: 1,
            words: 1,
            of_rays: 0,
            slice,
            parameters,
            turn: 0,
        };
        let input = numbers(inputs * stride);
        let gradient = numbers(4 * columns * stride);
        let [mut sum, sum_shared] = [false, true].map(|is_shared| {
            let mut carry = vec![0.0; 8 * parameters as usize];
            let mut sum = vec![0_u32; (2 * binned::ROWS * 4 * parameters) as usize];
            let workgroups =
                [weight_invocations(inputs, columns).div_ceil(64), 1, samples.div_ceil(slice) + 1];
            let carried = Write::from(&mut carry[..]);
            let sums = Write::from(&mut sum[..]);
            let first_pair = [0, samples];
            let pair = Read::from(&first_pair[..]);
            let sample = Read::from(&[0][..]);
            let x = Read::from(&input[..]);
            let g = Read::from(&gradient[..]);
            run(workgroups, |id, mut staged| {
                if is_shared {
                    let staged = &mut staged;
                    dense_weight_backward::<f32>(
                        id, &params, pair, sample, x, g, carried, sums, staged,
                    );
                } else {
                    let staged = &mut Unshared;
                    dense_weight_backward::<f32>(
                        id, &params, pair, sample, x, g, carried, sums, staged,
                    );
                }
            });
            assert!(carry.iter().all(|carried| *carried == 0.0), "every slice is whole");
            sum
        });
        assert_eq!(sum, sum_shared, "{samples} samples, {inputs} inputs");
        // the helpers' loops count on, outside of the kernel
        muslin::kernel::allow_iterations(u32::MAX);
        for index in 0..4 * parameters {
            let place = index / 4;
            let row = place / columns;
            let column = place % columns;
            let output = 4 * column + index % 4;
            let term = |sum: f32, sample: u32| {
                let g = gradient[(output * stride + sample) as usize];
                let x = match row < inputs {
                    true => input[(row * stride + sample) as usize],
                    false => 1.0,
                };
                x * g + sum
            };
            let of_slice = |at: u32| (at..samples.min(at + slice)).fold(0.0, term);
            let slices = (0..samples).step_by(slice as usize).map(of_slice);
            let (expected, size) = slices.fold((0.0, 0.0), |(expected, size), of_slice| {
                let of_slice = f64::from(of_slice);
                (expected + of_slice, size + of_slice.abs())
            });
            let found = binned::take(Write::from(&mut sum[..]), 4 * parameters, index);
            let error = (f64::from(found) - expected).abs();
            assert!(error <= 3e-7 * size, "{samples} samples, {index}: {found}, {expected}");
        }
    }
}
