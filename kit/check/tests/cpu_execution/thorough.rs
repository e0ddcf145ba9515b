//! The thorough device: what depends on the order of invocations is found, and what is declared to have none is not.

use muslin::atomic;
use muslin::prelude::*;
use muslin_check::devices;
use muslin_device::{Buffer, Device, Result};

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
