//! Layers by ways that GPUs alone take: with copies in workgroup memory, and four samples at once.

extern crate std;

use std::cell::Cell;
use std::fmt::Debug;
use std::vec::Vec;

use glam::{UVec3, Vec4};

use organza_kernel::prelude::*;
use organza_kernel::samples::Four;
use organza_kernel::stage::InPlace;

use super::{DenseParams, dense};
use crate::dense_backward::{DenseBackwardParams, dense_backward};

/// Workgroup memory of an invocation that copies all of it: what a GPU reads without a check must have been copied
/// since the last wait, and be what lies in the buffer.
struct Copied<T, const N: usize> {
    elements: Vec<T>,
    passes: u32,
    largest: Cell<u32>,
}

impl<T, const N: usize> Copied<T, N> {
    fn new() -> Self {
        Self { elements: Vec::new(), passes: 0, largest: Cell::new(0) }
    }
}

impl<T: Copy + PartialEq + Debug, const N: usize> Stage<T, N> for Copied<T, N> {
    fn is_shared(&self) -> bool {
        true
    }

    fn end(&self, begin: u32, end: u32, size: u32) -> u32 {
        end.min(begin + N as u32 / size)
    }

    fn wait(&self, _: Invocation) {}

    fn fill(&mut self, _: Invocation, count: u32, source: impl Source<T>) {
        assert!(count as usize <= N, "{count} elements");
        self.elements = (0..count).map(|k| source.element(k)).collect();
        self.passes += 1;
    }

    fn at(&self, k: u32, buffer: Read<T>, index: u32) -> T {
        self.largest.set(self.largest.get().max(k));
        assert_eq!(self.elements[k as usize], buffer.read(index), "element {k}");
        self.elements[k as usize]
    }
}

fn numbers(count: u32) -> Vec<f32> {
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

#[test]
fn layers_copy_what_they_read() {
    let (samples, stride, inputs, columns) = (70, 75, 150, 8);
    let params =
        DenseParams { samples, stride, inputs, columns, weight: 3, bias: 3 + inputs * columns };
    let parameters = vectors(3 + (inputs + 1) * columns);
    let input = numbers(inputs * stride);
    let (mut plain, mut staged) = ([0.0; 32 * 75], [0.0; 32 * 75]);
    for id in [0, 1].into_iter().flat_map(invocations) {
        let read = (Read::from(&parameters[..]), Read::from(&input[..]));
        dense::<f32>(id, &params, read.0, read.1, Write::from(&mut plain[..]), &mut InPlace);
        let mut weights = Copied::<Vec4, 256>::new();
        dense::<f32>(id, &params, read.0, read.1, Write::from(&mut staged[..]), &mut weights);
        assert_eq!((weights.passes, weights.largest.get()), (3, 255));
    }
    assert_eq!(plain, staged);
    assert!(plain.iter().any(|&value| value > 0.0));
}

/// An invocation of a GPU, which reads without a check: here every index is checked.
#[test]
fn layers_of_four_samples_are_those_of_one() {
    for samples in [1, 2, 3, 4, 63, 70] {
        let (stride, inputs, columns) = (samples + 3, 11, 8);
        let (weight, bias) = (3, 3 + inputs * columns);
        let params = DenseParams { samples, stride, inputs, columns, weight, bias };
        let parameters = vectors(3 + (inputs + 1) * columns);
        let input = numbers(inputs * stride);
        let len = (4 * columns * stride) as usize;
        let (mut one, mut four) = (std::vec![9.0; len], std::vec![9.0; len]);
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
        let (mut back_one, mut back_four) = (std::vec![9.0; back_len], std::vec![9.0; back_len]);
        let (weights, input) = (Read::from(&parameters[..]), Read::from(&input[..]));
        let gradient = Read::from(&gradient[..]);
        for id in [0, 1].into_iter().flat_map(invocations) {
            let (output, stage) = (Write::from(&mut one[..]), &mut InPlace);
            dense::<f32>(id, &params, weights, input, output, stage);
            let output = Write::from(&mut four[..]);
            dense::<Four>(id.of(4), &params, weights, input, output, stage);
            let output = Write::from(&mut back_one[..]);
            dense_backward::<f32>(id, &back, weights, input, gradient, output, stage);
            let output = Write::from(&mut back_four[..]);
            dense_backward::<Four>(id.of(4), &back, weights, input, gradient, output, stage);
        }
        assert_eq!(one, four, "{samples} samples");
        assert_eq!(back_one, back_four, "{samples} samples on the way back");
        assert!(four.iter().any(|&value| value > 0.0 && value != 9.0));
    }
}

#[test]
fn the_way_back_copies_what_it_reads() {
    // eleven inputs of blocks of eight: the second block repeats its last one
    let (samples, stride, inputs, columns) = (70, 75, 11, 32);
    let params = DenseBackwardParams {
        samples,
        stride,
        inputs,
        columns,
        weight: 2,
        first_input: 0,
        end_input: inputs,
        rectified: 1,
    };
    let parameters = vectors(2 + inputs * columns);
    let (input, gradient) = (numbers(inputs * stride), numbers(4 * columns * stride));
    let (mut plain, mut staged) = ([0.0; 11 * 75], [0.0; 11 * 75]);
    for id in [0, 1].into_iter().flat_map(invocations) {
        let weights = Read::from(&parameters[..]);
        let (input, gradient) = (Read::from(&input[..]), Read::from(&gradient[..]));
        let output = Write::from(&mut plain[..]);
        dense_backward::<f32>(id, &params, weights, input, gradient, output, &mut InPlace);
        let (output, mut stage) = (Write::from(&mut staged[..]), Copied::<Vec4, 256>::new());
        dense_backward::<f32>(id, &params, weights, input, gradient, output, &mut stage);
        assert_eq!((stage.passes, stage.largest.get()), (1, 255));
    }
    assert_eq!(plain, staged);
    assert!(plain.iter().any(|&value| value != 0.0));
}
