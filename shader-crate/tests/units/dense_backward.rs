use glam::{UVec3, Vec4};
use muslin::prelude::*;
use muslin::samples::Four;

use organza_shaders::dense::{DenseParams, dense};
use organza_shaders::dense_backward::{DenseBackwardParams, dense_backward};

pub fn numbers(count: u32) -> Vec<f32> {
    (0..count).map(|i| (i * 37 % 101) as f32 / 50.0 - 1.0).collect()
}

fn vectors(count: u32) -> Vec<Vec4> {
    numbers(4 * count).as_chunks::<4>().0.iter().copied().map(Vec4::from_array).collect()
}

/// The invocations of two workgroups.
fn invocations(workgroup_z: u32) -> impl Iterator<Item = Invocation> {
    (0..128).map(move |x| {
        let workgroup = UVec3::new(x / 64, 0, workgroup_z);
        let local = UVec3::new(x % 64, 0, 0);
        Invocation::new(local, workgroup, UVec3::new(2, 1, 2), UVec3::new(64, 1, 1))
    })
}

/// A GPU reads quads without a check. Here every index is checked.
#[test]
fn layers_of_quads_equal_layers_of_single_samples() {
    for samples in [1, 2, 3, 4, 63, 70] {
        let stride = (samples + 3_u32).next_multiple_of(4);
        let inputs = 11;
        let columns = 8;
        let weight = 3;
        let bias = 3 + inputs * columns;
        let params = DenseParams { samples, stride, inputs, columns, weight, bias };
        let parameters = vectors(3 + (inputs + 1) * columns);
        let input = numbers(inputs * stride);
        let len = (4 * columns * stride) as usize;
        let mut one = vec![9.0; len];
        let mut four = vec![9.0; len];
        let back = DenseBackwardParams {
            samples,
            stride,
            inputs,
            columns,
            weight,
            first_input: 0,
            end_input: inputs,
            rectified: 1,
        };
        let gradient = numbers(4 * columns * stride);
        let back_len = (inputs * stride) as usize;
        let mut back_one = vec![9.0; back_len];
        let mut back_four = vec![9.0; back_len];
        let weights = Read::from(&parameters[..]);
        let input = Read::from(&input[..]);
        let gradient = Read::from(&gradient[..]);
        for id in [0, 1].into_iter().flat_map(invocations) {
            dense::<f32>(id, &params, weights, input, Write::from(&mut one[..]));
            dense::<Four>(id.with_items(4), &params, weights, input, Write::from(&mut four[..]));
            let output = Write::from(&mut back_one[..]);
            dense_backward::<f32>(id, &back, weights, input, gradient, output);
            let output = Write::from(&mut back_four[..]);
            dense_backward::<Four>(id.with_items(4), &back, weights, input, gradient, output);
        }
        assert_eq!(one, four, "{samples} samples");
        assert_eq!(back_one, back_four, "{samples} samples, backward");
        assert!(four.iter().any(|&value| value > 0.0 && value != 9.0));
    }
}
