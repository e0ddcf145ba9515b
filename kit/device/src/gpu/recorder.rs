//! Dispatches, collected into command buffers, with bind groups that are kept.

use std::collections::HashMap;
use std::ops::Range;

use muslin_kernel::count::PLACEMENT_VALUES;
use muslin_kernel::{Access, KernelInfo};

use super::counts::{COUNT_FILL, Counted, Fill};
use super::memory::{MemoryPool, SUBMISSIONS};
use super::pipeline::Pipeline;
use super::timer::Timer;
use crate::Traffic;

/// Most dispatches in one submission: each keeps its slot until then. The device works on them while the host records the next.
const SLOTS: u64 = 64;
/// Bytes of a uniform slot: the largest alignment that an adapter may require.
const SLOT: u64 = 256;
/// Bytes of the placements of a submission. A dispatch has at most 64 parameters, each takes a row of 16 bytes, and whatever
/// begins at a multiple of [`SLOT`] takes another row.
const PLACEMENT: u64 = 5 * SLOT * SLOTS;

/// Command buffers under construction. They are submitted together.
#[derive(Debug)]
pub struct Recorder {
    /// Commands before all others.
    first: Option<wgpu::CommandEncoder>,
    /// Command buffers before `encoder`.
    finished: Vec<wgpu::CommandBuffer>,
    /// Parameters that the device fills in, between `finished` and `encoder`.
    fills: Vec<Fill>,
    /// The pass of the last dispatches. It ends before other commands, and each timed dispatch has its own.
    pass: Option<wgpu::ComputePass<'static>>,
    encoder: Option<wgpu::CommandEncoder>,
    uniforms: wgpu::Buffer,
    /// Content of the slots.
    slots: Vec<u8>,
    /// What each `count_fill` of a submission reads.
    placement: wgpu::Buffer,
    /// Content of it.
    placements: Vec<u8>,
    /// `None` if the device has no timestamps.
    timer: Option<Timer>,
    /// Whether dispatches are timed.
    times: bool,
    memory: MemoryPool,
    bind_groups: BindGroups,
    pub traffic: Traffic,
}

impl Recorder {
    pub fn new(device: &wgpu::Device, memory: &MemoryPool) -> Self {
        let buffer = |label, size, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: usage | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        Self {
            first: None,
            finished: Vec::new(),
            fills: Vec::new(),
            pass: None,
            encoder: None,
            uniforms: buffer("uniforms", SLOT * SLOTS, wgpu::BufferUsages::UNIFORM),
            slots: Vec::new(),
            placement: buffer("placement", PLACEMENT, wgpu::BufferUsages::empty()),
            placements: Vec::new(),
            timer: Timer::new(device, SLOTS),
            times: false,
            memory: memory.clone(),
            bind_groups: BindGroups::default(),
            traffic: Traffic::default(),
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
        if let Some(counted) = counts {
            counted.add_to(&mut self.fills, offset as usize);
        }

        let uniforms = wgpu::BufferBinding {
            buffer: &self.uniforms,
            offset: 0,
            size: std::num::NonZero::new((uniform.len() as u64).next_multiple_of(16)),
        };
        let mut buffers = buffers.iter();
        let resource = |access: Access| match access {
            Access::Uniform => uniforms.clone(),
            Access::Read | Access::Write => {
                buffers.next().expect("the typed dispatch binds every buffer").clone()
            }
        };
        let resources: Vec<_> =
            kernel.bindings.iter().map(|info| info.access).map(resource).collect();
        let bind_group =
            self.bind_groups.get(device, kernel.name, &pipeline.layout, &resources).clone();
        let has_uniform = kernel.bindings.iter().any(|info| info.access == Access::Uniform);
        let slot = [offset as u32];
        let pass = match self.pass.take().filter(|_| !self.times) {
            Some(pass) => self.pass.insert(pass),
            None => self.begin_pass(device, kernel),
        };
        pass.set_pipeline(&pipeline.pipeline);
        pass.set_bind_group(0, &bind_group, if has_uniform { &slot } else { &[] });
        pass.dispatch_workgroups(x, y, z);
        self.traffic.dispatches += 1;
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

    /// Clears the beginning of a buffer that no recorded command uses. It happens before all of them, so that it ends no pass.
    pub fn clear_unused(&mut self, device: &wgpu::Device, buffer: &wgpu::Buffer, bytes: u64) {
        let first = self.first.get_or_insert_with(|| new_encoder(device));
        first.clear_buffer(buffer, 0, Some(bytes));
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
            self.fill_in(device);
            self.finished.push(encoder.finish());
        }
    }

    /// Fills in the parameters of the dispatches in `encoder`. If nothing of the submission comes before these, `first` can do it.
    fn fill_in(&mut self, device: &wgpu::Device) {
        let fills = std::mem::take(&mut self.fills);
        if fills.is_empty() {
            return;
        }
        let is_first = self.finished.is_empty();
        let encoder = self.first.take_if(|_| is_first);
        let mut encoder = encoder.unwrap_or_else(|| new_encoder(device));
        let label = Some(COUNT_FILL.name);
        let mut pass = encoder
            .begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes: None });
        for Fill { counts, pipeline, placement } in fills {
            let numbers = placement.len() as u32 / PLACEMENT_VALUES;
            let offset = self.placements.len() as u64;
            let rows = [&[numbers, 0, 0, 0], &placement[..]].concat();
            self.placements.extend_from_slice(bytemuck::cast_slice(&rows));
            let size = std::num::NonZero::new(self.placements.len() as u64 - offset);
            self.placements.resize(self.placements.len().next_multiple_of(SLOT as usize), 0);
            // in the order of its bindings
            let buffers = [
                wgpu::BufferBinding { buffer: &self.placement, offset, size },
                wgpu::BufferBinding { buffer: &counts, offset: 0, size: None },
                wgpu::BufferBinding { buffer: &self.uniforms, offset: 0, size: None },
            ];
            let layout = &pipeline.layout;
            pass.set_pipeline(&pipeline.pipeline);
            let bind_group = self.bind_groups.get(device, COUNT_FILL.name, layout, &buffers);
            pass.set_bind_group(0, bind_group, &[]);
            pass.dispatch_workgroups(numbers.div_ceil(COUNT_FILL.workgroup_size[0]), 1, 1);
            self.traffic.dispatches += 1;
        }
        drop(pass);
        self.finished.push(encoder.finish());
    }

    /// Submits all commands to the device. Returns the number of the submission, if there was something to submit.
    pub fn submit(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
    ) -> Option<wgpu::SubmissionIndex> {
        self.pass = None;
        if let Some(timer) = self.timer.as_mut().filter(|timer| timer.has_unresolved()) {
            // not `self.encoder()`, which would also borrow the timer
            timer.resolve(device, self.encoder.get_or_insert_with(|| new_encoder(device)));
        }
        self.publish_counts(device);
        let first = self.first.take().map(wgpu::CommandEncoder::finish);
        if self.finished.is_empty() && first.is_none() {
            return None;
        }
        // happens after earlier submissions and before the next one
        for (buffer, bytes) in
            [(&self.uniforms, &mut self.slots), (&self.placement, &mut self.placements)]
        {
            if !bytes.is_empty() {
                queue.write_buffer(buffer, 0, bytes);
                self.traffic.bytes_up += bytes.len() as u64;
                bytes.clear();
            }
        }
        self.traffic.submissions += 1;
        let submission = queue.submit(first.into_iter().chain(self.finished.drain(..)));
        self.memory.submitted();
        self.bind_groups.submitted();
        Some(submission)
    }

    /// Forgets all bind groups, so that the memory that they hold can return to the driver.
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

/// What a bind group is made of: its layout, and each buffer with an offset and a size.
type Key = (wgpu::BindGroupLayout, Vec<(wgpu::Buffer, u64, Option<wgpu::BufferSize>)>);

/// Bind groups, each with the number of the submission of its last use.
#[derive(Debug, Default)]
pub struct BindGroups {
    made: HashMap<Key, (wgpu::BindGroup, u64)>,
    /// Number of submissions so far.
    submissions: u64,
}

impl BindGroups {
    /// The bind group of these buffers, made if there is none.
    pub fn get(
        &mut self,
        device: &wgpu::Device,
        kernel: &'static str,
        layout: &wgpu::BindGroupLayout,
        buffers: &[wgpu::BufferBinding<'_>],
    ) -> &wgpu::BindGroup {
        let now = self.submissions;
        let key = buffers.iter().map(|of| (of.buffer.clone(), of.offset, of.size)).collect();
        let (group, used) = self.made.entry((layout.clone(), key)).or_insert_with(|| {
            let resources = buffers.iter().cloned().map(wgpu::BindingResource::Buffer);
            let entry = |(resource, binding)| wgpu::BindGroupEntry { binding, resource };
            let entries: Vec<_> = resources.zip(0..).map(entry).collect();
            let label = Some(kernel);
            let of = wgpu::BindGroupDescriptor { label, layout, entries: &entries };
            (device.create_bind_group(&of), now)
        });
        *used = now;
        group
    }

    /// Declares that all recorded commands are submitted. Bind groups go no later than the unused memory that they hold.
    pub fn submitted(&mut self) {
        self.submissions += 1;
        let now = self.submissions;
        self.made.retain(|_, (_, used)| now - *used < SUBMISSIONS);
    }

    /// Forgets all bind groups, and so the memory that they hold.
    pub fn clear(&mut self) {
        self.made.clear();
    }
}
