//! Buffers of other devices, and devices and buffers that a program has opened itself.

use std::panic::{AssertUnwindSafe, catch_unwind};

use muslin_device::{Buffer, DeviceOptions, Error, wgpu};
use organza::{Device, MODULES, SpirvPath};
use organza_shaders::scan::{BLOCK, ScanAddKernel, ScanParams};
use organza_tests::devices;

/// Elements of two blocks: the first gets 5 more, the second 7.
const COUNT: u32 = BLOCK + 40;

fn add(device: &Device, block_prefix: &Buffer<u32>, prefix: &Buffer<u32>) -> Result<(), Error> {
    let params = ScanParams { count: COUNT - 1 };
    device.run(&ScanAddKernel { params, block_prefix, prefix }, COUNT, 1)
}

/// What [`add`] makes of 0, 1, 2 and so on.
fn expected() -> Vec<u32> {
    (0..COUNT).map(|index| index + if index < BLOCK { 5 } else { 7 }).collect()
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

/// A device as an engine opens one, without anything that only kernels need.
fn engine() -> (wgpu::Device, wgpu::Queue) {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).unwrap();
    pollster::block_on(adapter.request_device(&Default::default())).unwrap()
}

#[test]
fn kernels_run_on_a_device_and_buffers_of_the_program() {
    if !devices::has_gpu() {
        return;
    }
    let (engine, queue) = engine();
    let take = |options: &DeviceOptions| {
        Device::from_wgpu(engine.clone(), queue.clone(), options, &MODULES)
    };
    let device = take(&DeviceOptions::default()).unwrap();
    let choice = device.choice();
    let [path, whose] = ["through naga", "(the program's own)"];
    assert!(choice.contains(path) && choice.ends_with(whose), "{choice}");
    let refused = take(&DeviceOptions::default().spirv(SpirvPath::Passthrough)).unwrap_err();
    assert!(refused.to_string().contains("does not take SPIR-V as it is"), "{refused}");

    let numbers: Vec<u32> = (0..COUNT).collect();
    let make = |usage| {
        let size = u64::from(4 * COUNT);
        let mapped_at_creation = false;
        engine.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation,
        })
    };
    let needed =
        wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
    let own = make(needed);
    queue.write_buffer(&own, 0, bytemuck::cast_slice(&numbers));
    let prefix = Buffer::<u32>::from_wgpu(&device, "prefix", own.clone()).unwrap();
    let block_prefix = device.upload("block_prefix", &[5_u32, 7]).unwrap();
    add(&device, &block_prefix, &prefix).unwrap();
    device.submit();

    // the engine's own commands, on its buffer and on one of the kernels
    let result = make(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
    let mut encoder = engine.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(&own, 0, &result, 0, None);
    let copied = device.unwritten::<u32>("copied", COUNT as usize).unwrap();
    let binding = copied.wgpu().unwrap();
    encoder.copy_buffer_to_buffer(&own, 0, binding.buffer, binding.offset, None);
    queue.submit([encoder.finish()]);
    result.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.unwrap());
    engine.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    let bytes = result.slice(..).get_mapped_range().unwrap();
    assert_eq!(bytemuck::cast_slice::<u8, u32>(&bytes), expected());
    assert_eq!(device.read(&copied).unwrap(), expected());
    assert_eq!(device.wgpu().map(|(device, _)| device), Some(&engine));

    // the next buffer takes the memory of a dropped one, but not if it is the program's
    drop(prefix);
    device.submit();
    let next = device.unwritten::<u32>("next", COUNT as usize).unwrap();
    assert_ne!(next.wgpu().unwrap().buffer, &own);

    for (usage, part) in [
        (wgpu::BufferUsages::STORAGE, "without the usage BufferUsages(COPY_SRC | COPY_DST)"),
        (needed, "and its elements have 36"),
    ] {
        let error = Buffer::<[u32; 9]>::from_wgpu(&device, "other", make(usage)).unwrap_err();
        assert!(error.to_string().contains(part), "{error}");
    }
    let error = Buffer::<u32>::from_wgpu(&devices::cpu(None), "other", own).unwrap_err();
    assert!(error.to_string().contains("this device is the cpu"), "{error}");
}
