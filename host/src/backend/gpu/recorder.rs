//! Dispatches, collected into command buffers.

use organza_kernels::{Access, KernelInfo};

use super::pipeline::Pipeline;

/// Bytes of a uniform slot: the largest alignment that an adapter may ask for.
const SLOT: u64 = 256;

/// Dispatches of one command buffer: each has its slot until it is submitted.
const SLOTS: u64 = 256;

/// The command buffer that is being written.
#[derive(Debug)]
pub struct Recorder {
    encoder: Option<wgpu::CommandEncoder>,
    uniforms: wgpu::Buffer,
    used: u64,
}

impl Recorder {
    pub fn new(device: &wgpu::Device) -> Self {
        let uniforms = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("uniforms"),
            size: SLOT * SLOTS,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { encoder: None, uniforms, used: 0 }
    }

    fn encoder(&mut self, device: &wgpu::Device) -> &mut wgpu::CommandEncoder {
        self.encoder.get_or_insert_with(|| {
            device
                .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("kernels") })
        })
    }

    #[expect(clippy::too_many_arguments, reason = "a dispatch is what it is")]
    pub fn dispatch(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        kernel: &KernelInfo,
        pipeline: &Pipeline,
        uniform: &[u8],
        buffers: &[&wgpu::Buffer],
        [x, y, z]: [u32; 3],
    ) {
        if self.used == SLOTS {
            self.submit(queue);
        }
        // such writes happen before the next submission: a slot is free again once it is submitted
        let offset = self.used * SLOT;
        let mut slot = [0; SLOT as usize];
        slot[..uniform.len()].copy_from_slice(uniform);
        queue.write_buffer(&self.uniforms, offset, &slot);
        self.used += 1;

        let mut buffers = buffers.iter();
        let entries: Vec<_> = kernel
            .bindings
            .iter()
            .zip(0..)
            .map(|(info, binding)| {
                let resource = match info.access {
                    Access::Uniform => wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                        buffer: &self.uniforms,
                        offset,
                        size: std::num::NonZero::new((uniform.len() as u64).next_multiple_of(16)),
                    }),
                    Access::Read | Access::Write => buffers
                        .next()
                        .expect("the typed dispatch binds every buffer")
                        .as_entire_binding(),
                };
                wgpu::BindGroupEntry { binding, resource }
            })
            .collect();
        let label = Some(kernel.name);
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label,
            layout: &pipeline.layout,
            entries: &entries,
        });
        let mut pass = self
            .encoder(device)
            .begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes: None });
        pass.set_pipeline(&pipeline.pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.dispatch_workgroups(x, y, z);
    }

    pub fn clear(&mut self, device: &wgpu::Device, buffer: &wgpu::Buffer) {
        self.encoder(device).clear_buffer(buffer, 0, None);
    }

    /// Copies into `target` after everything recorded, and submits.
    pub fn copy(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        source: &wgpu::Buffer,
        begin: u64,
        target: &wgpu::Buffer,
    ) {
        self.encoder(device).copy_buffer_to_buffer(source, begin, target, 0, target.size());
        self.submit(queue);
    }

    /// Hands what is recorded to the device.
    pub fn submit(&mut self, queue: &wgpu::Queue) {
        if let Some(encoder) = self.encoder.take() {
            queue.submit([encoder.finish()]);
        }
        self.used = 0;
    }
}
