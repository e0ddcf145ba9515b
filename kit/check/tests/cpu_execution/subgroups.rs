//! Subgroups of every size: what they compute, and what is said of wrong ones.

use muslin::prelude::*;
use muslin::subgroup::SIZES;
use muslin_check::devices;
use muslin_device::{Device, DeviceOptions, Error, Modules};

use crate::{assert_contains, failure, line};

const INVOCATIONS: u32 = 96;

/// Of each invocation: lane, sum, smallest, largest and first of the squares, and how many are odd.
#[kernel(threads(INVOCATIONS), subgroups)]
pub fn each_operation(id: Invocation, output: Write<u32>, floats: Write<f32>) {
    combined(id, output, floats);
}

/// The same in a workgroup that can be one whole subgroup, or a part of one.
#[kernel(threads(64), subgroups)]
pub fn each_of_64(id: Invocation, output: Write<u32>, floats: Write<f32>) {
    combined(id, output, floats);
}

fn combined(id: Invocation, output: Write<u32>, floats: Write<f32>) {
    let own = id.local.x * id.local.x;
    let first = 6 * id.index();
    if id.workgroup.x == 0 {
        output.write(first, id.subgroup_lane());
        output.write(first + 1, id.subgroup_sum(own));
        output.write(first + 2, id.subgroup_min(own));
        output.write(first + 3, id.subgroup_max(own));
        output.write(first + 4, id.subgroup_broadcast_first(own));
        output.write(first + 5, muslin::subgroup::lanes(id.subgroup_ballot(own % 2 == 1)));
        let float = own as f32 - 1000.0;
        let first = 4 * id.index();
        floats.write(first, id.subgroup_sum(float));
        floats.write(first + 1, id.subgroup_min(float));
        floats.write(first + 2, id.subgroup_max(float));
        floats.write(first + 3, id.subgroup_broadcast_first(float));
    }
}

/// Of each invocation: the sums of the squares up to it and before it, the square of the next lane, and of its neighbor in a pair; then
/// both sums of floats.
#[kernel(threads(INVOCATIONS), subgroups)]
pub fn scans_and_shuffles(id: Invocation, output: Write<u32>, floats: Write<f32>) {
    let own = id.local.x * id.local.x;
    let first = 4 * id.index();
    let next = (id.subgroup_lane() + 1) % id.subgroup_sum(1);
    if id.workgroup.x == 0 {
        output.write(first, id.subgroup_inclusive_sum(own));
        output.write(first + 1, id.subgroup_exclusive_sum(own));
        output.write(first + 2, id.subgroup_shuffle(own, next));
        output.write(first + 3, id.subgroup_shuffle_xor(own, 1));
        let float = own as f32 - 1000.0;
        floats.write(2 * id.index(), id.subgroup_inclusive_sum(float));
        floats.write(2 * id.index() + 1, id.subgroup_exclusive_sum(float));
    }
}

/// Asks for a lane that the last subgroup of 64 does not have.
#[kernel(threads(INVOCATIONS), subgroups)]
pub fn absent_lane(id: Invocation, output: Write<u32>) {
    output.write(id.index(), id.subgroup_shuffle(id.local.x, 40)); // absent
}

/// The first subgroup waits at an operation, and the others wait at a barrier.
#[kernel(threads(INVOCATIONS), subgroups)]
pub fn own_ways(id: Invocation, output: Write<u32>, unused: Shared<u32, 1>) {
    let mut sum = 0;
    if id.local.x == 0 {
        unused.write(0, 0);
    }
    if id.local.x < id.subgroup_size() {
        sum = id.subgroup_sum(1);
    }
    id.barrier();
    if id.workgroup.x == 0 {
        output.write(id.index(), sum);
    }
}

/// Half of a subgroup waits at a barrier.
#[kernel(threads(64), subgroups)]
pub fn operation_or_barrier(id: Invocation, output: Write<u32>) {
    if id.local.x.is_multiple_of(2) {
        id.barrier(); // one half
    }
    output.write(id.index(), id.subgroup_sum(1)); // the other half
}

/// Declares none.
#[kernel(threads(64))]
pub fn undeclared(id: Invocation, output: Write<u32>) {
    output.write(id.index(), id.subgroup_sum(1));
}

/// Declares none, and waits at barriers.
#[kernel(threads(64))]
pub fn undeclared_lane(id: Invocation, output: Write<u32>, unused: Shared<u32, 64>) {
    unused.write(id.local.x, 0);
    output.write(id.index(), id.subgroup_lane());
}

/// Devices of every size that look for mistakes.
fn every_size() -> impl Iterator<Item = (usize, Device)> {
    SIZES.into_iter().map(|size| {
        let options = DeviceOptions::checked().subgroup_size(size);
        (size as usize, Device::open(&options, Modules::none()).expect("the CPU"))
    })
}

#[test]
fn operations_combine_the_lanes_of_one_subgroup() {
    let devices: Vec<_> = every_size().collect();
    let with_counts = devices.iter().flat_map(|of| [(of, INVOCATIONS), (of, 64)]);
    for ((size, device), count) in with_counts {
        let squares: Vec<u32> = (0..count).map(|i| i * i).collect();
        let output = device.unwritten("output", 6 * squares.len()).unwrap();
        let floats = device.unwritten("floats", 4 * squares.len()).unwrap();
        let (output, floats) = (&output, &floats);
        match count {
            64 => device.run(&EachOf64Kernel { output, floats }, count, 1).unwrap(),
            _ => device.run(&EachOperationKernel { output, floats }, count, 1).unwrap(),
        }
        let (output, floats) = (device.read(output).unwrap(), device.read(floats).unwrap());
        for lanes in squares.chunks(*size) {
            for (lane, own) in lanes.iter().enumerate() {
                let at = squares.iter().position(|square| square == own).unwrap();
                let sum: u32 = lanes.iter().sum();
                let odd = lanes.iter().filter(|square| *square % 2 == 1).count();
                let (first, last) = (lanes[0], lanes[lanes.len() - 1]);
                let expected = [lane as u32, sum, first, last, first, odd as u32];
                assert_eq!(output[6 * at..6 * at + 6], expected, "{size}: {at}");
                let float = |square| square as f32 - 1000.0;
                let sum = sum as f32 - 1000.0 * lanes.len() as f32;
                let expected = [sum, float(first), float(last), float(first)];
                assert_eq!(floats[4 * at..4 * at + 4], expected, "{size}: {at}");
            }
        }
    }
}

#[test]
fn scans_and_shuffles_take_the_values_of_other_lanes() {
    let squares: Vec<u32> = (0..INVOCATIONS).map(|i| i * i).collect();
    for (size, device) in every_size() {
        let output = device.unwritten("output", 4 * squares.len()).unwrap();
        let floats = device.unwritten("floats", 2 * squares.len()).unwrap();
        let kernel = ScansAndShufflesKernel { output: &output, floats: &floats };
        device.run(&kernel, INVOCATIONS, 1).unwrap();
        let (output, floats) = (device.read(&output).unwrap(), device.read(&floats).unwrap());
        let mut found = output.chunks_exact(4).zip(floats.chunks_exact(2));
        for lanes in squares.chunks(size) {
            for lane in 0..lanes.len() {
                let before: u32 = lanes[..lane].iter().sum();
                let next = lanes[(lane + 1) % lanes.len()];
                let expected = [before + lanes[lane], before, next, lanes[lane ^ 1]];
                let float = |sum: u32, count: usize| sum as f32 - 1000.0 * count as f32;
                let sums = [float(before + lanes[lane], lane + 1), float(before, lane)];
                assert_eq!(found.next().unwrap(), (&expected[..], &sums[..]), "{size}: {lane}");
            }
        }
    }
}

#[test]
fn a_shuffle_asks_for_a_lane_that_is_there() {
    let options = DeviceOptions::checked().subgroup_size(64);
    let device = Device::open(&options, Modules::none()).unwrap();
    let output = device.unwritten("output", INVOCATIONS as usize).unwrap();
    let message = failure(&device, &AbsentLaneKernel { output: &output }, INVOCATIONS);
    let source = ["subgroups.rs", include_str!("subgroups.rs")];
    let parts = [
        "`absent_lane`: invocation [64, 0, 0] asks for the value of lane 40 of its subgroup, which has 32 lanes, at ",
        &line(source, "// absent"),
    ];
    assert_contains(&message, &parts);
}

#[test]
fn a_subgroup_may_go_its_own_way() {
    for (size, device) in every_size() {
        let output = device.unwritten("output", INVOCATIONS as usize).unwrap();
        device.run(&OwnWaysKernel { output: &output }, INVOCATIONS, 1).unwrap();
        let lanes = size.min(INVOCATIONS as usize);
        let expected = (0..INVOCATIONS as usize).map(|i| if i < lanes { lanes as u32 } else { 0 });
        assert!(device.read(&output).unwrap().into_iter().eq(expected), "{size}");
    }
}

#[test]
fn lanes_that_wait_elsewhere_are_named() {
    let options = DeviceOptions::checked().subgroup_size(16);
    let device = Device::open(&options, Modules::none()).unwrap();
    let output = device.unwritten("output", 64).unwrap();
    let message = failure(&device, &OperationOrBarrierKernel { output: &output }, 64);
    let source = ["subgroups.rs", include_str!("subgroups.rs")];
    let parts = [
        "`operation_or_barrier`: a subgroup's operation in divergent control flow: ",
        "invocation [0, 0, 0] (with 7 more) waits at the barrier of ",
        "while invocation [1, 0, 0] (with 7 more) waits at the operation of ",
        "in a subgroup of 16, in workgroup [0, 0, 0]",
        &line(source, "// one half"),
        &line(source, "// the other half"),
    ];
    assert_contains(&message, &parts);
}

#[test]
fn subgroups_are_declared() {
    let device = devices::checked();
    let output = device.unwritten("output", 64).unwrap();
    let messages = [
        failure(&device, &UndeclaredKernel { output: &output }, 64),
        failure(&device, &UndeclaredLaneKernel { output: &output }, 64),
    ];
    for message in messages {
        assert_contains(&message, &["`#[kernel(.., subgroups)]`, at "]);
    }
}

#[test]
fn a_device_has_one_of_the_sizes() {
    let error =
        Device::open(&DeviceOptions::cpu(1).subgroup_size(12), Modules::none()).unwrap_err();
    assert!(matches!(error, Error::Argument { .. }));
    assert!(error.to_string().contains("12 lanes: its size is one of [4, 8,"), "{error}");
}
