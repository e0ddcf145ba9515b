//! Times and memory of kernels, on every device.

use muslin_device::KernelTime;
use organza::Device;
use organza_shaders::scan::{ScanAddKernel, ScanParams};
use organza_tests::devices;

const COUNT: u32 = 1_000;

fn dispatch(device: &Device, times: u32) {
    let scan = ScanAddKernel {
        params: ScanParams { count: COUNT },
        block_prefix: &device.zeros("blocks", COUNT as usize).unwrap(),
        prefix: &device.zeros("prefix", COUNT as usize + 1).unwrap(),
    };
    for _ in 0..times {
        device.run(&scan, COUNT, 1).unwrap();
    }
}

fn names(timings: &[KernelTime]) -> Vec<(&'static str, u64)> {
    timings.iter().map(|time| (time.kernel, time.dispatches)).collect()
}

#[test]
fn dispatches_are_timed_and_counted_where_asked_for() {
    for (name, device) in devices::all() {
        dispatch(&device, 2);
        assert_eq!(device.take_timings().is_empty(), device.backend() == "gpu", "{name}");

        device.time_dispatches(true);
        // more than fit into one command buffer
        dispatch(&device, 300);
        let timed = device.take_timings();
        assert_eq!(names(&timed), [("scan_add", 300)], "{name}");
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
    for (name, device) in devices::all() {
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
    for (name, device) in devices::all() {
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
    for (name, device) in devices::all() {
        for len in [LEN, LEN - 3, LEN] {
            let ones = device.upload("ones", &vec![1_u32; len]).unwrap();
            assert_eq!(device.read_range(&ones, len - 1, 1).unwrap(), [1], "{name}");
            drop(ones);
            let zeros = device.zeros::<u32>("zeros", len).unwrap();
            assert!(device.read(&zeros).unwrap().iter().all(|&value| value == 0), "{name}");
        }
    }
}
