//! Storage barriers order what a workgroup does to buffers, and plain barriers do not.

use muslin::prelude::*;
use muslin_check::devices;
use muslin_device::Device;

use crate::{assert_contains, failure, line};

const WORKGROUPS: u32 = 4;
const VALUES: u32 = 64 * WORKGROUPS;

/// Reverses the values of each workgroup in place, and adds how many of them are odd. `odd [workgroups]` is zero before and after.
#[kernel(threads(64), storage_barriers)]
pub fn reverse_and_add(id: Invocation, data: Write<u32>, odd: Write<u32>) {
    let workgroup = id.workgroup.x;
    if workgroup < WORKGROUPS {
        let own = data.read(id.index());
        odd.atomic_add(workgroup, own % 2);
        id.storage_barrier();
        data.write(workgroup * 64 + 63 - id.local.x, own + odd.read(workgroup));
        id.storage_barrier();
        if id.local.x == 63 {
            odd.write(workgroup, 0);
        }
    }
}

/// The last barrier is a plain one.
#[kernel(threads(64))]
pub fn last_one_is_plain(id: Invocation, data: Write<u32>, unused: Shared<u32, 64>) {
    if id.index() < VALUES {
        unused.write(id.local.x, 0);
        data.write(id.index(), id.index());
        id.storage_barrier();
        let neighbor = data.read(id.index() ^ 1);
        id.storage_barrier();
        data.write(id.index(), neighbor);
        id.barrier();
        data.write(id.index() ^ 1, 0); // another one's element
    }
}

/// Does not declare its barrier.
#[kernel(threads(64))]
pub fn undeclared_barrier(id: Invocation, data: Write<u32>) {
    data.write(id.index(), 1);
    id.storage_barrier();
}

/// Devices that look for mistakes.
fn watchful() -> [Device; 2] {
    [devices::checked(), devices::thorough(5)]
}

#[test]
fn accesses_ordered_by_a_storage_barrier_are_no_race() {
    let values: Vec<u32> = (0..VALUES).map(|i| i * i / 3).collect();
    for device in watchful() {
        let data = device.upload("data", &values).unwrap();
        let odd = device.zeros("odd", WORKGROUPS as usize).unwrap();
        device.run(&ReverseAndAddKernel { data: &data, odd: &odd }, VALUES, 1).unwrap();
        let expected = values.chunks(64).flat_map(|workgroup| {
            let odd = workgroup.iter().filter(|value| *value % 2 == 1).count() as u32;
            workgroup.iter().rev().map(move |value| value + odd)
        });
        assert!(device.read(&data).unwrap().into_iter().eq(expected));
        assert_eq!(device.read(&odd).unwrap(), [0; WORKGROUPS as usize]);
    }
}

#[test]
fn a_plain_barrier_after_storage_barriers_orders_no_storage() {
    for device in watchful() {
        let data = device.unwritten("data", VALUES as usize).unwrap();
        let message = failure(&device, &LastOneIsPlainKernel { data: &data }, VALUES);
        let source = ["storage_barriers.rs", include_str!("storage_barriers.rs")];
        let parts = [
            "in the same dispatch, and no storage barrier lies between",
            &line(source, "// another one's element"),
        ];
        assert_contains(&message, &parts);
    }
}

#[test]
fn storage_barriers_are_declared() {
    let device = devices::checked();
    let data = device.unwritten("data", 64).unwrap();
    let message = failure(&device, &UndeclaredBarrierKernel { data: &data }, 64);
    let parts = [
        "a barrier in a kernel without workgroup memory",
        "`#[kernel(.., storage_barriers)]`",
        "invocation [0, 0, 0]",
    ];
    assert_contains(&message, &parts);
}
