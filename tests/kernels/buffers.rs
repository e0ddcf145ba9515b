//! Buffers of other devices.

use std::panic::{AssertUnwindSafe, catch_unwind};

use muslin_device::{Buffer, Error};
use organza::Device;
use organza_shaders::scan::{BLOCK, ScanAddKernel, ScanParams};
use organza_tests::devices;

/// Elements of two blocks: the first gets 5 more, the second 7.
const COUNT: u32 = BLOCK + 40;

fn add(device: &Device, block_prefix: &Buffer<u32>, prefix: &Buffer<u32>) -> Result<(), Error> {
    let params = ScanParams { count: COUNT - 1 };
    device.run(&ScanAddKernel { params, block_prefix, prefix }, COUNT, 1)
}

#[test]
fn a_buffer_of_another_device_is_refused() {
    let others = devices::all();
    for (name, device) in devices::all() {
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
