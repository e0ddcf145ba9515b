//! Devices that fail: lost, or with too little memory.

use organza::error::DeviceError;
use organza::{DeviceOptions, Error, Renderer, SpirvPath};
use organza_tests::{cases, devices};

#[test]
fn a_lost_device_is_an_error() {
    for (backend, device) in devices::gpus() {
        let renderer = Renderer::new(device);
        let case = &cases::all()[0];
        let scene = renderer.upload(&case.scene).expect("the scene fits");
        renderer.render(&scene, &case.cameras, &case.tiles).expect("the device is there");
        renderer.device().lose();
        for attempt in 0..2 {
            let error = renderer
                .render(&scene, &case.cameras, &case.tiles)
                .expect_err("the device is gone");
            assert!(
                matches!(error, Error::Device(DeviceError::DeviceLost { .. })),
                "{backend}, attempt {attempt}: {error:?}"
            );
            assert!(error.to_string().contains("lost"), "{error}");
        }
    }
}

#[test]
fn too_little_memory_is_an_error_that_says_how_much() {
    for (backend, device) in devices::all() {
        // more than any machine has
        let needed = 1u64 << 50;
        let error = device.zeros::<u32>("test", (needed / 4) as usize).expect_err("a pebibyte");
        match &error {
            DeviceError::OutOfMemory { needed: found, .. } => {
                assert_eq!(*found, needed, "{backend}")
            }
            other => panic!("{backend}: {other:?}"),
        }
        let text = error.to_string();
        assert!(text.contains("1048576.00 GiB") && text.contains("test"), "{backend}: {text}");
        // and the device still works
        let buffer = device.upload("after", &[1u32, 2, 3]).expect("twelve bytes");
        assert_eq!(device.read(&buffer).expect("the device goes on"), [1, 2, 3]);
    }
}

/// What a GPU keeps between passes follows its memory, and a software device keeps little.
#[test]
fn a_share_of_memory_is_a_cards_own() {
    let share = |device: &organza::Device, shares| device.memory_share(shares, 5);
    for (backend, device) in devices::all() {
        let is_card = backend != "cpu" && !device.is_cpu_like();
        assert_eq!(share(&device, 4) == 5, !is_card, "{backend}");
    }
    if devices::has_gpu() {
        let options = DeviceOptions::gpu(SpirvPath::Passthrough).like_a_card(true);
        let card = organza::open_device(&options).expect("a GPU");
        let all = share(&card, 1);
        assert!(all >= 1 << 28, "{all} bytes");
        assert_eq!((share(&card, 4), share(&card, all)), (all / 4, 5));
    }
}

#[test]
fn an_adapter_that_is_not_there_is_named() {
    let options = DeviceOptions::gpu(SpirvPath::Naga).adapter("no such adapter".to_owned());
    let error = organza::open_device(&options).expect_err("there is none of that name");
    assert!(matches!(&error, Error::Device(DeviceError::NoGpu { .. })), "{error:?}");
    let without_driver = error.to_string().contains("driver");
    assert!(without_driver || error.to_string().contains("no such adapter"), "{error}");
}
