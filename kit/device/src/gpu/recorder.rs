//! Dispatches, collected into command buffers.

use std::ops::Range;
use std::sync::Arc;

use muslin_kernel::{Access, KernelInfo};

use super::bind_groups::BindGroups;
use super::fill::Fills;
use super::memory::MemoryPool;
use super::pipeline::Pipeline;
use super::timer::{SLOTS, Timer};
use crate::count::Count;

/// Bytes of a uniform slot: the largest alignment that an adapter may require.
const SLOT: u64 = 256;

/// Parameters of a dispatch that the device fills in.
#[derive(Clone, Copy, Debug)]
pub struct Counted<'a> {
    /// Counts by their offset in the uniform buffer.
    pub counts: &'a [(usize, &'a Count)],
    /// Pipeline of `count_fill`.
    pub fill: &'a Arc<Pipeline>,
}

/// Command buffers under construction. They are submitted together.
#[derive(Debug)]
pub struct Recorder {
    /// Command buffers before `encoder`.
    finished: Vec<wgpu::CommandBuffer>,
    /// Parameters that the device fills in, between `finished` and `encoder`.
    fills: Fills,
    /// The pass of the last dispatches. It ends before other commands, and each timed dispatch has its own.
    pass: Option<wgpu::ComputePass<'static>>,
    encoder: Option<wgpu::CommandEncoder>,
    uniforms: wgpu::Buffer,
    /// Content of the slots.
    slots: Vec<u8>,
    /// `None` if the device has no timestamps.
    timer: Option<Timer>,
    /// Whether dispatches are timed.
    times: bool,
    memory: MemoryPool,
    bind_groups: BindGroups,
}

impl Recorder {
    pub fn new(device: &wgpu::Device, memory: &MemoryPool) -> Self {
        let uniforms = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("uniforms"),
            size: SLOT * SLOTS,
            usage: wgpu::BufferUsages::UNIFORM
                | wgpu::BufferUsages::STORAGE
                | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self {
            finished: Vec::new(),
            fills: Fills::default(),
            pass: None,
            encoder: None,
            uniforms,
            slots: Vec::new(),
            timer: Timer::new(device),
            times: false,
            memory: memory.clone(),
            bind_groups: BindGroups::default(),
        }
    }

    /// The encoder, for commands outside of passes.
    fn encoder(&mut self, device: &wgpu::Device) -> &mut wgpu::CommandEncoder {
        self.pass = None;
        self.encoder.get_or_insert_with(|| new_encoder(device))
    }

    #[expect(clippy::too_many_arguments, reason = "a dispatch is what it is")]
    pub fn dispatch(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        kernel: &'static KernelInfo,
        pipeline: &Pipeline,
        uniform: &[u8],
        counts: Option<Counted<'_>>,
        buffers: &[wgpu::BufferBinding<'_>],
        [x, y, z]: [u32; 3],
    ) {
        if self.slots.len() as u64 == SLOT * SLOTS {
            self.submit(device, queue);
        }
        let offset = self.slots.len() as u64;
        self.slots.extend_from_slice(uniform);
        self.slots.resize((offset + SLOT) as usize, 0);
        for counted in counts.iter() {
            for (place, count) in counted.counts {
                let word = (offset as usize + place) / size_of::<u32>();
                self.fills.add(counted.fill, word as u32, count);
            }
        }

        let key = buffers.iter().map(|binding| {
            (binding.buffer.clone(), binding.offset, binding.size.map_or(0, |size| size.get()))
        });
        let key = (pipeline.layout.clone(), key.collect());
        let uniforms = wgpu::BufferBinding {
            buffer: &self.uniforms,
            offset: 0,
            size: std::num::NonZero::new((uniform.len() as u64).next_multiple_of(16)),
        };
        let bind_group = self.bind_groups.get(key, || {
            let mut buffers = buffers.iter();
            let resource = |access: Access| match access {
                Access::Uniform => uniforms.clone(),
                Access::Read | Access::Write => {
                    buffers.next().expect("the typed dispatch binds every buffer").clone()
                }
            };
            let resources = kernel.bindings.iter().map(|info| info.access).map(resource);
            let entry = |(resource, binding)| wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::Buffer(resource),
            };
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(kernel.name),
                layout: &pipeline.layout,
                entries: &resources.zip(0..).map(entry).collect::<Vec<_>>(),
            })
        });
        let bind_group = bind_group.clone();
        let has_uniform = kernel.bindings.iter().any(|info| info.access == Access::Uniform);
        let slot = [offset as u32];
        let pass = match self.pass.take().filter(|_| !self.times) {
            Some(pass) => self.pass.insert(pass),
            None => self.begin_pass(device, kernel),
        };
        pass.set_pipeline(&pipeline.pipeline);
        pass.set_bind_group(0, &bind_group, if has_uniform { &slot } else { &[] });
        pass.dispatch_workgroups(x, y, z);
    }

    fn begin_pass(
        &mut self,
        device: &wgpu::Device,
        kernel: &'static KernelInfo,
    ) -> &mut wgpu::ComputePass<'static> {
        // not `self.encoder()`, which would also borrow the timer
        let encoder = self.encoder.get_or_insert_with(|| new_encoder(device));
        let timer = self.timer.as_mut().filter(|_| self.times);
        let timestamp_writes = timer.map(|timer| timer.time(kernel.name));
        let label = Some(if self.times { kernel.name } else { "kernels" });
        let pass =
            encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes });
        self.pass.insert(pass.forget_lifetime())
    }

    pub fn clear(&mut self, device: &wgpu::Device, buffer: &wgpu::Buffer, bytes: Range<u64>) {
        let size = Some(bytes.end - bytes.start);
        self.encoder(device).clear_buffer(buffer, bytes.start, size);
    }

    /// Copies bytes into `target` after everything recorded.
    pub fn copy(
        &mut self,
        device: &wgpu::Device,
        source: &wgpu::Buffer,
        bytes: Range<u64>,
        target: &wgpu::Buffer,
        to: u64,
    ) {
        let size = bytes.end - bytes.start;
        self.encoder(device).copy_buffer_to_buffer(source, bytes.start, target, to, size);
    }

    /// Declares that the commands so far write the numbers that later dispatches have filled in.
    pub fn publish_counts(&mut self, device: &wgpu::Device) {
        self.pass = None;
        if let Some(encoder) = self.encoder.take() {
            self.finished.extend(self.fills.take(device, &self.uniforms));
            self.finished.push(encoder.finish());
        }
    }

    /// Submits all commands to the device.
    pub fn submit(&mut self, device: &wgpu::Device, queue: &wgpu::Queue) {
        self.pass = None;
        if let Some(timer) = self.timer.as_mut().filter(|timer| timer.has_unresolved()) {
            // not `self.encoder()`, which would also borrow the timer
            timer.resolve(device, self.encoder.get_or_insert_with(|| new_encoder(device)));
        }
        self.publish_counts(device);
        if self.finished.is_empty() {
            return;
        }
        // happens after earlier submissions and before the next one
        if !self.slots.is_empty() {
            queue.write_buffer(&self.uniforms, 0, &self.slots);
            self.slots.clear();
        }
        queue.submit(self.finished.drain(..));
        self.memory.submitted();
        self.bind_groups.submitted();
    }

    /// Forgets all bind groups, so that the memory that they hold can go back to the driver.
    pub fn forget_bind_groups(&mut self) {
        self.bind_groups.clear();
    }

    /// Turns the timing of dispatches on or off. Returns whether the device can time them.
    pub fn time(&mut self, times: bool) -> bool {
        self.pass = None;
        self.times = times;
        self.timer.is_some()
    }

    /// The timer, with the timestamps of all timed and submitted dispatches.
    pub fn timer(&mut self) -> Option<&mut Timer> {
        self.timer.as_mut()
    }
}

fn new_encoder(device: &wgpu::Device) -> wgpu::CommandEncoder {
    device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("kernels") })
}
