//! What a device does beside running a kernel: times, memory, and buffers of other devices.

use std::panic::{AssertUnwindSafe, catch_unwind};

use muslin_check::devices;
use muslin_device::{Buffer, Device, Error, KernelTime};
use muslin_everyday::MODULES;
use muslin_everyday_kernels::prefix_sum::{BLOCK, PrefixAddKernel, PrefixParams};

/// Values of two blocks: the first gets 5 more, the second 7.
const COUNT: u32 = BLOCK + 40;

fn add(device: &Device, before: &Buffer<u32>, prefix: &Buffer<u32>) -> Result<(), Error> {
    let params = PrefixParams { count: COUNT };
    device.run(&PrefixAddKernel { params, before, prefix }, COUNT, 1)
}

fn dispatch(device: &Device, times: u32) {
    let before = device.zeros("blocks", 2).unwrap();
    let prefix = device.zeros("prefix", COUNT as usize).unwrap();
    for _ in 0..times {
        add(device, &before, &prefix).unwrap();
    }
}

fn names(timings: &[KernelTime]) -> Vec<(&'static str, u64)> {
    timings.iter().map(|time| (time.kernel, time.dispatches)).collect()
}

#[test]
fn dispatches_are_timed_and_counted_where_asked_for() {
    for (name, device) in devices::all(&MODULES) {
        dispatch(&device, 2);
        assert_eq!(device.take_timings().is_empty(), device.backend() == "gpu", "{name}");

        device.time_dispatches(true);
        // more than fit into one command buffer
        dispatch(&device, 300);
        let timed = device.take_timings();
        assert_eq!(names(&timed), [("prefix_add", 300)], "{name}");
        assert!(timed.iter().all(|time| time.seconds > 0.0), "{name}: {timed:?}");
        assert!(device.take_timings().is_empty(), "{name}");

        device.time_dispatches(false);
        dispatch(&device, 2);
        assert_eq!(device.take_timings().is_empty(), device.backend() == "gpu", "{name}");
    }
}

/// A lost device gives no times, and asking for them does not hang.
#[test]
fn a_lost_device_has_no_times() {
    for (name, device) in devices::all(&MODULES) {
        if device.backend() == "gpu" {
            device.time_dispatches(true);
            dispatch(&device, 2);
            device.lose();
            assert!(device.take_timings().iter().all(|time| time.seconds == 0.0), "{name}");
        }
    }
}

/// Numbers of a buffer: a megabyte, a size that no pool rounds.
const LEN: usize = 1 << 18;

/// A GPU runs a copy later than the host writes.
#[test]
fn memory_waits_for_the_commands_that_use_it() {
    for (name, device) in devices::all(&MODULES) {
        let copy = device.unwritten::<u32>("copy", LEN).unwrap();
        let first = device.upload("first", &vec![1_u32; LEN]).unwrap();
        device.copy(&first, &copy);
        drop(first);
        let second = device.upload("second", &vec![2_u32; LEN]).unwrap();
        assert!(device.read(&copy).unwrap().iter().all(|&value| value == 1), "{name}");
        assert!(device.read(&second).unwrap().iter().all(|&value| value == 2), "{name}");
    }
}

#[test]
fn zeros_are_zeros_where_other_values_lay() {
    for (name, device) in devices::all(&MODULES) {
        for len in [LEN, LEN - 3, LEN] {
            let ones = device.upload("ones", &vec![1_u32; len]).unwrap();
            assert_eq!(device.read_range(&ones, len - 1, 1).unwrap(), [1], "{name}");
            drop(ones);
            let zeros = device.zeros::<u32>("zeros", len).unwrap();
            assert!(device.read(&zeros).unwrap().iter().all(|&value| value == 0), "{name}");
        }
    }
}

#[test]
fn a_buffer_of_another_device_is_refused() {
    let others = devices::all(&MODULES);
    for (name, device) in devices::all(&MODULES) {
        for (other, foreign) in &others {
            if [device.backend(), foreign.backend()] == ["cpu", "cpu"] {
                // both are the host's memory
                continue;
            }
            let own = device.upload("own", &[1_u32; COUNT as usize]).unwrap();
            let buffer = foreign.upload("foreign", &[2_u32; COUNT as usize]).unwrap();
            let uses: [(&str, &dyn Fn()); 6] = [
                ("read", &|| drop(device.read(&buffer))),
                ("read_all", &|| drop(device.read_all(&[own.clone(), buffer.clone()]))),
                ("clear", &|| device.clear(&buffer)),
                ("copy", &|| device.copy(&buffer, &own)),
                ("write", &|| drop(device.write(&buffer, 0, &[3]))),
                ("run", &|| drop(add(&device, &buffer, &own))),
            ];
            for (what, run) in uses {
                let panic = catch_unwind(AssertUnwindSafe(run)).expect_err(what);
                let message = panic.downcast_ref::<String>().expect("a message");
                assert!(message.contains("`foreign` belongs to"), "{name}, {other}: {message}");
            }
            // nothing of it is left over
            assert_eq!(device.read(&own).unwrap(), [1; COUNT as usize]);
            assert_eq!(foreign.read(&buffer).unwrap(), [2; COUNT as usize]);
        }
    }
}
