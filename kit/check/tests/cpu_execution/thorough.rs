//! The thorough device: what does not depend on the device is not found.

use muslin::prelude::*;
use muslin_check::devices;

/// Where a number is not zero.
#[kernel(threads(64))]
pub fn not_zero(id: Invocation, input: Read<f32>, output: Write<u32>) {
    if id.index() < 3 {
        output.write(id.index(), u32::from(input.read(id.index()) != 0.0));
    }
}

/// The next random number from 0 to 1.
#[inline(always)]
fn random(state: &mut u32) -> f32 {
    *state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    (*state >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// A generator within another struct.
struct Generators {
    first: Generator,
}

struct Generator(u32);

impl Generator {
    #[inline(always)]
    fn next(&mut self) -> f32 {
        random(&mut self.0)
    }
}

/// Adds noise of -1 to 1, in four ways: the difference of two calls, which no driver takes for the same.
#[kernel(threads(64))]
pub fn dither(id: Invocation, output: Write<f32>) {
    if id.index() < 100 {
        let mut state = id.index();
        let direct = random(&mut state) - random(&mut state);
        let mut next = || random(&mut state);
        let closure = next() - next();
        let reference = &mut state;
        let passed = random(reference) - random(reference);
        let mut all = Generators { first: Generator(state) };
        let of_field = all.first.next() - all.first.next();
        output.write(id.index(), direct + 10.0 * closure + 100.0 * passed + 1000.0 * of_field);
    }
}

#[test]
fn two_calls_with_effects_are_not_the_same_value() {
    let device = devices::thorough(1);
    let output = device.unwritten("output", 100).unwrap();
    device.run(&DitherKernel { output: &output }, 100, 1).expect("no regrouped sum");
    assert!(device.read(&output).unwrap().iter().all(|noise| *noise != 0.0));
}

#[test]
#[cfg(target_arch = "x86_64")]
fn a_device_flushes_denormals() {
    for (device, expected) in [(devices::cpu(None), [0, 1, 1]), (devices::flushing(), [0, 0, 1])] {
        let input = device.upload("input", &[0.0, -1e-40, 1.0]).unwrap();
        let output = device.unwritten("output", 3).unwrap();
        device.run(&NotZeroKernel { input: &input, output: &output }, 3, 1).unwrap();
        assert_eq!(device.read(&output).unwrap(), expected);
    }
}
