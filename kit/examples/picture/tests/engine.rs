//! An engine that has opened a `wgpu::Device` runs a kernel on its own buffers, between its own passes.

use muslin::check::devices;
use muslin::device::wgpu::{self, BufferUsages};
use muslin::device::{Buffer, Device, DeviceOptions, Result, SpirvPath};
use picture::MODULES;
use picture_kernels::{BINS, HistogramKernel, Picture};

const PIXELS: u32 = 192;

/// Fills the pixels, and draws each bin as a pixel of its own.
const SHADERS: &str = include_str!("engine.wgsl");

/// What an engine keeps.
struct Engine {
    device: wgpu::Device,
    queue: wgpu::Queue,
    shaders: wgpu::ShaderModule,
}

impl Engine {
    /// Opens a device, with features of its own.
    fn new(wanted: wgpu::Features) -> Self {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = instance.request_adapter(&wgpu::RequestAdapterOptions::default());
        let adapter = pollster::block_on(adapter).expect("an adapter");
        let experimental_features = match wanted.is_empty() {
            true => wgpu::ExperimentalFeatures::disabled(),
            // SAFETY: the kernels are valid SPIR-V
            false => unsafe { wgpu::ExperimentalFeatures::enabled() },
        };
        let required_features = wanted & adapter.features();
        let request = wgpu::DeviceDescriptor {
            required_features,
            experimental_features,
            ..Default::default()
        };
        let (device, queue) =
            pollster::block_on(adapter.request_device(&request)).expect("a device");
        let source = wgpu::ShaderSource::Wgsl(SHADERS.into());
        let shaders =
            device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
        Self { device, queue, shaders }
    }

    fn buffer(&self, usage: BufferUsages, size: u64) -> wgpu::Buffer {
        let descriptor =
            wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
        self.device.create_buffer(&descriptor)
    }

    fn bind(&self, layout: &wgpu::BindGroupLayout, values: &wgpu::Buffer) -> wgpu::BindGroup {
        let entries = [wgpu::BindGroupEntry { binding: 0, resource: values.as_entire_binding() }];
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout,
            entries: &entries,
        })
    }

    /// Its compute pass: fills the pixels.
    fn fill(&self, gray: &wgpu::Buffer) {
        let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &self.shaders,
            entry_point: Some("fill"),
            compilation_options: Default::default(),
            cache: None,
        });
        let group = self.bind(&pipeline.get_bind_group_layout(0), gray);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(PIXELS / 64, 1, 1);
        drop(pass);
        self.queue.submit([encoder.finish()]);
    }

    /// Its render pass: draws the bins, and reads the picture.
    fn draw(&self, bins: &wgpu::Buffer) -> Vec<u32> {
        let format = wgpu::TextureFormat::R32Uint;
        let size = wgpu::Extent3d { width: BINS as u32, height: 1, depth_or_array_layers: 1 };
        let picture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let pipeline = self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: None,
            vertex: wgpu::VertexState {
                module: &self.shaders,
                entry_point: Some("corner"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &self.shaders,
                entry_point: Some("pixel"),
                compilation_options: Default::default(),
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let group = self.bind(&pipeline.get_bind_group_layout(0), bins);
        let view = picture.create_view(&Default::default());
        let target = wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations::default(),
        };
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(target)],
            ..Default::default()
        });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.draw(0..3, 0..1);
        drop(pass);
        // a row of a picture is 256 bytes, or a multiple of that
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(256),
            rows_per_image: None,
        };
        let buffer = &self.buffer(BufferUsages::MAP_READ | BufferUsages::COPY_DST, 256);
        let to = wgpu::TexelCopyBufferInfo { buffer, layout };
        encoder.copy_texture_to_buffer(picture.as_image_copy(), to, size);
        self.queue.submit([encoder.finish()]);
        buffer.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.expect("a picture"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("a picture");
        let bytes = buffer.slice(..).get_mapped_range().expect("a picture");
        let (words, _) = bytes.as_chunks();
        words[..BINS].iter().map(|word| u32::from_ne_bytes(*word)).collect()
    }

    /// The device as muslin has it.
    fn muslin(&self, options: &DeviceOptions) -> Result<Device> {
        Device::from_wgpu(self.device.clone(), self.queue.clone(), options, &MODULES)
    }
}

/// All that kernels need of a buffer.
const NEEDED: BufferUsages =
    BufferUsages::STORAGE.union(BufferUsages::COPY_SRC).union(BufferUsages::COPY_DST);

#[test]
fn a_kernel_runs_between_the_passes_of_an_engine() {
    let mut expected = [0; BINS];
    for pixel in 0..PIXELS {
        expected[((pixel * pixel % 192) as f32 / 192.0 * 15.99) as usize] += 1;
    }
    for (name, _) in devices::gpus(&MODULES) {
        let is_naga = name.ends_with("naga");
        let path = if is_naga { "through naga" } else { "passed through" };
        let features =
            if is_naga { wgpu::Features::empty() } else { wgpu::Features::PASSTHROUGH_SHADERS };
        let engine = Engine::new(features);
        let device = engine.muslin(&DeviceOptions::default()).expect("the engine's device");
        let choice = device.choice();
        assert!(choice.contains(path) && choice.ends_with("(the program's own)"), "{choice}");
        let gray = engine.buffer(NEEDED, u64::from(4 * PIXELS));
        let bins = engine.buffer(NEEDED, 4 * BINS as u64);
        engine.fill(&gray);
        let gray = Buffer::<f32>::from_wgpu(&device, "gray", gray).expect("its buffer");
        let own = Buffer::<u32>::from_wgpu(&device, "bins", bins.clone()).expect("its buffer");
        let params = Picture { side: 0, pixels: PIXELS };
        device.run_all(&HistogramKernel { params, gray: &gray, bins: &own }).expect("a histogram");
        device.submit();
        assert_eq!(engine.draw(&bins), expected, "{choice}");
        assert_eq!(device.read(&own).expect("the bins"), expected);

        // the other way round: the engine draws what is the kernels'
        let other = device.upload("other", &expected).expect("a buffer");
        let lent = other.wgpu().expect("a GPU's memory");
        if lent.offset == 0 {
            assert_eq!(engine.draw(lent.buffer), expected, "{choice}");
        }
        assert_eq!(device.wgpu().map(|(device, _)| device), Some(&engine.device));

        // the next buffer takes the memory of a dropped one, but not if it is the engine's
        drop(own);
        device.submit();
        let next = device.unwritten::<u32>("next", BINS).expect("a buffer");
        assert_ne!(next.wgpu().expect("a GPU's memory").buffer, &bins);
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    if devices::gpus(&MODULES).is_empty() {
        return;
    }
    let engine = Engine::new(wgpu::Features::empty());
    let passed = DeviceOptions::default().spirv(SpirvPath::Passthrough);
    let refused = engine.muslin(&passed).expect_err("the feature is off").to_string();
    assert!(refused.contains("does not take SPIR-V as it is"), "{refused}");
    let device = engine.muslin(&DeviceOptions::default()).expect("the engine's device");
    for (usage, part) in [
        (BufferUsages::STORAGE, "without the usage BufferUsages(COPY_SRC | COPY_DST)"),
        (NEEDED, "and its elements have 36"),
    ] {
        let error = Buffer::<[u32; 9]>::from_wgpu(&device, "other", engine.buffer(usage, 256));
        let error = error.expect_err("it does not fit").to_string();
        assert!(error.contains(part), "{error}");
    }
    let of_cpu = Buffer::<u32>::from_wgpu(&devices::checked(), "other", engine.buffer(NEEDED, 256));
    let error = of_cpu.expect_err("the CPU has memory of its own").to_string();
    assert!(error.contains("this device is the cpu"), "{error}");
}
