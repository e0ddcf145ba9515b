//! The thorough device: what depends on the order of invocations is found, and what is declared to have none is not.

use muslin::atomic;
use muslin::prelude::*;
use muslin_check::devices;
use muslin_device::{Buffer, Device, DeviceOptions, Modules, Result};

/// Puts the even values into a list.
#[kernel(threads(64), unordered(list))]
pub fn list_without_order(id: Invocation, input: Read<u32>, next: Write<u32>, list: Write<u32>) {
    if id.index() < 100 && input.read(id.index()).is_multiple_of(2) {
        list.write(atomic::add(next, 0, 1), input.read(id.index()));
    }
}

/// Declares a list without order, and its elements depend on the order.
#[kernel(threads(64), unordered(list))]
pub fn list_of_sums(id: Invocation, input: Read<u32>, next: Write<u32>, list: Write<u32>) {
    if id.index() < 100 {
        let ticket = atomic::add(next, 0, 1);
        list.write(ticket, input.read(id.index()) + ticket);
    }
}

/// Where a number is not zero.
#[kernel(threads(64))]
pub fn not_zero(id: Invocation, input: Read<f32>, output: Write<u32>) {
    if id.index() < 3 {
        output.write(id.index(), u32::from(input.read(id.index()) != 0.0));
    }
}

/// Takes a ticket for each workgroup, which says what the workgroup writes.
#[kernel(threads(64))]
pub fn work_by_tickets(
    id: Invocation,
    next: Write<u32>,
    output: Write<u32>,
    ticket: Shared<u32, 1>,
) {
    if id.local.x == 0 {
        ticket.write(0, atomic::add(next, 0, 1));
    }
    id.barrier();
    let place = 64 * ticket.read(0) + id.local.x;
    if place < 256 {
        output.write(place, place);
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

fn buffers(device: &Device) -> Result<[Buffer<u32>; 3]> {
    let input: Vec<u32> = (0..100).map(|i| i * i / 7).collect();
    let list = device.zeros("list", 100)?;
    Ok([device.upload("input", &input)?, device.zeros("next", 1)?, list])
}

#[test]
fn a_list_may_have_any_order_where_it_says_so() {
    let device = devices::thorough(3);
    let [input, next, list] = &buffers(&device).unwrap();
    device.run(&ListWithoutOrderKernel { input, next, list }, 100, 1).expect("any order");
    let count = device.read(next).unwrap()[0] as usize;
    let mut found = device.read_range(list, 0, count).unwrap();
    found.sort_unstable();
    let expected = device.read(input).unwrap().into_iter().filter(|value| value % 2 == 0);
    assert!(found.into_iter().eq(expected));
}

#[test]
fn a_list_without_order_has_the_same_elements() {
    let device = devices::thorough(3);
    let [input, next, list] = &buffers(&device).unwrap();
    let message = device.run(&ListOfSumsKernel { input, next, list }, 100, 1).unwrap_err();
    assert!(message.to_string().contains("of `list`"), "{message}");
}

/// What a device says of tickets that are work.
fn by_tickets(options: &DeviceOptions) -> Result<Vec<u32>> {
    let device = Device::open(options, Modules::none())?;
    let [next, output] = [device.zeros("next", 1)?, device.unwritten("output", 256)?];
    device.run(&WorkByTicketsKernel { next: &next, output: &output }, 256, 1)?;
    device.read(&output)
}

#[test]
fn a_ticket_of_the_additional_workgroup_is_told_apart() {
    let errors = (0..9).filter_map(|seed| by_tickets(&DeviceOptions::thorough(seed)).err());
    let messages: Vec<_> = errors.map(|error| error.to_string()).collect();
    assert!(!messages.is_empty());
    for message in messages {
        assert!(
            message.contains("It has taken a ticket at kit/check/tests/cpu_execution/thorough.rs:"),
            "{message}"
        );
        assert!(message.ends_with("run the kernel with `extra_workgroup(false)`"), "{message}");
    }
    for seed in 0..9 {
        let found = by_tickets(&DeviceOptions::thorough(seed).extra_workgroup(false)).unwrap();
        assert!(found.into_iter().eq(0..256));
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
