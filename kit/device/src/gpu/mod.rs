//! The GPU backend: wgpu buffers, and dispatches queued into command buffers.

mod adapter;
mod counts;
pub mod memory;
mod pipeline;
mod recorder;
mod timer;

use std::sync::{Arc, mpsc};
use std::time::Duration;

use muslin_kernel::{EntryPoint, KernelInfo};
use parking_lot::Mutex;

use crate::buffer::{Count, Memory, RawBuffer, Total};
use crate::{DeviceOptions, Error, Modules, Result, SpirvPath, Traffic};
pub use adapter::adapters;
use counts::{COUNT_FILL, Counted, PendingCount};
use memory::{GpuMemory, MemoryPool};
use pipeline::{Pipelines, Variants};
use recorder::Recorder;

/// The largest buffer for reading that is kept, in bytes.
const MAX_STAGING: u64 = 64 << 20;

/// The GPU backend.
#[derive(Debug)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    limits: wgpu::Limits,
    spirv: SpirvPath,
    pipelines: Pipelines,
    recorder: Mutex<Recorder>,
    memory: MemoryPool,
    /// Unused buffers for bytes that the host reads.
    staging: Mutex<Vec<wgpu::Buffer>>,
    failures: Arc<Mutex<Failures>>,
    /// Whether this is a software device that has not been opened [like a card](DeviceOptions::like_a_card).
    is_software: bool,
    /// The bytes of its largest heap of its own memory; `None` if it is a software device, or not Vulkan's.
    memory_bytes: Option<u64>,
}

/// Bytes that a submission copies for the host.
#[derive(Debug)]
pub struct Reading {
    staging: wgpu::Buffer,
    /// Bytes of `staging` that are used.
    size: u64,
    /// Of each range, in `staging`: the first byte, and the number of bytes.
    ranges: Vec<(usize, usize)>,
    submission: Option<wgpu::SubmissionIndex>,
    mapped: mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Gpu {
    /// Opens the adapter that `options` name, or else the most capable one.
    pub fn open(options: &DeviceOptions, modules: &'static Modules) -> Result<Self> {
        let (adapter, spirv) = adapter::choose(options)?;
        let (device, queue) = adapter::request(&adapter, spirv)?;
        // naga does not know cooperative matrices
        let tiles = match spirv {
            SpirvPath::Passthrough => adapter::tiles(&adapter),
            SpirvPath::Naga => Vec::new(),
        };
        let gpu = Self::new(device, queue, spirv, tiles, options, modules);
        record_failures(&gpu.device, &gpu.failures);
        Ok(gpu)
    }

    /// A device that was opened elsewhere, which keeps its own callbacks.
    pub fn adopt(
        device: wgpu::Device,
        queue: wgpu::Queue,
        options: &DeviceOptions,
        modules: &'static Modules,
    ) -> Result<Self> {
        let spirv = adapter::path_of(&device, options.spirv)?;
        // only an adapter tells the shapes of cooperative matrices
        Ok(Self::new(device, queue, spirv, Vec::new(), options, modules))
    }

    fn new(
        device: wgpu::Device,
        queue: wgpu::Queue,
        spirv: SpirvPath,
        tiles: Vec<[u32; 3]>,
        options: &DeviceOptions,
        modules: &'static Modules,
    ) -> Self {
        let variants = Variants::new(&device, options.variants, tiles);
        let memory = MemoryPool::default();
        let info = device.adapter_info();
        let is_software = info.device_type == wgpu::DeviceType::Cpu && !options.like_a_card;
        let memory_bytes = if is_software { None } else { adapter::memory_bytes(&device) };
        Self {
            recorder: Mutex::new(Recorder::new(&device, &memory)),
            memory,
            staging: Mutex::default(),
            pipelines: Pipelines::new(spirv, variants, modules),
            is_software,
            memory_bytes,
            info,
            limits: device.limits(),
            device,
            queue,
            spirv,
            failures: Arc::default(),
        }
    }

    /// The device and its queue.
    pub fn wgpu(&self) -> (&wgpu::Device, &wgpu::Queue) {
        (&self.device, &self.queue)
    }

    /// Memory that was made elsewhere, on this device.
    pub fn adopt_buffer(&self, buffer: wgpu::Buffer) -> GpuMemory {
        self.memory.adopt(buffer)
    }

    /// The memory of a buffer of this device. Under the number of another device's buffer, wgpu finds other memory, or none.
    fn memory<'a>(&self, buffer: &'a RawBuffer) -> &'a GpuMemory {
        match &buffer.memory {
            Memory::Gpu(memory) if memory.is_of(&self.memory) => memory,
            _ => panic!("the buffer `{}` belongs to another device", buffer.label),
        }
    }

    pub fn name(&self) -> &str {
        &self.info.name
    }

    pub fn description(&self) -> String {
        format!(
            "{}, {}, SPIR-V {}, {}",
            self.info.name,
            self.info.backend,
            match self.spirv {
                SpirvPath::Passthrough => "passed through",
                SpirvPath::Naga => "through naga",
            },
            self.pipelines.variants.as_str()
        )
    }

    /// The driver, with its version if known.
    pub fn driver(&self) -> String {
        format!("{} {}", self.info.driver, self.info.driver_info)
    }

    pub fn entry_point(&self, kernel: &KernelInfo) -> EntryPoint {
        self.pipelines.variants.entry_point(kernel)
    }

    pub fn tiles(&self) -> &[[u32; 3]] {
        self.pipelines.variants.tiles()
    }

    pub fn is_software(&self) -> bool {
        self.is_software
    }

    pub fn max_buffer_bytes(&self) -> u64 {
        self.limits.max_buffer_size.min(self.limits.max_storage_buffer_binding_size)
    }

    pub fn memory_bytes(&self) -> Option<u64> {
        self.memory_bytes
    }

    /// Memory for a buffer. Without `zeros` it can contain anything.
    pub fn allocate(&self, label: &'static str, bytes: u64, zeros: bool) -> Result<GpuMemory> {
        self.check()?;
        let what = || format!("the buffer `{label}` on {}", self.info.name);
        // an empty buffer cannot be bound, and a copy needs a multiple of four bytes
        let size = bytes.max(16).next_multiple_of(4);
        if size > self.max_buffer_bytes() {
            return Err(Error::OutOfMemory {
                needed: bytes,
                available: Some(self.max_buffer_bytes()),
                what: what(),
            });
        }
        if let Some(memory) = self.memory.take(size) {
            if zeros {
                self.recorder.lock().clear_unused(&self.device, &memory, size);
            }
            return Ok(memory);
        }
        let new = self.allocate_new(label, size).or_else(|| {
            self.recorder.lock().forget_bind_groups();
            self.memory.clear();
            // the driver gets it back when what uses it has run
            let _ = self.device.poll(wgpu::PollType::wait_indefinitely());
            self.allocate_new(label, size)
        });
        let new =
            new.ok_or_else(|| Error::OutOfMemory { needed: bytes, available: None, what: what() })?;
        Ok(self.memory.lend(new))
    }

    /// A new buffer of zeros; `None` if the GPU has no memory for it.
    fn allocate_new(&self, label: &'static str, size: u64) -> Option<wgpu::Buffer> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size,
            usage: wgpu::BufferUsages::STORAGE
                | wgpu::BufferUsages::COPY_SRC
                | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        pollster::block_on(scope.pop()).is_none().then_some(buffer)
    }

    pub fn write(&self, buffer: &wgpu::Buffer, bytes: &[u8]) {
        self.recorder.lock().traffic.bytes_up += bytes.len() as u64;
        // wgpu writes whole words
        let (words, rest) = bytes.split_at(bytes.len() / 4 * 4);
        if !words.is_empty() {
            self.queue.write_buffer(buffer, 0, words);
        }
        if !rest.is_empty() {
            let mut last = [0; 4];
            last[..rest.len()].copy_from_slice(rest);
            self.queue.write_buffer(buffer, words.len() as u64, &last);
        }
    }

    /// Waits for all queued work, and gives the bytes of each range to `take`: a buffer, an offset in it, and a length.
    pub fn read(
        &self,
        ranges: &[(&RawBuffer, u64, usize)],
        take: impl FnMut(&[u8]) -> Result<()>,
    ) -> Result<()> {
        let reading = self.read_later(ranges);
        self.recorder.lock().traffic.waits += 1;
        self.finish_reading(reading, take)
    }

    /// Submits all recorded work, which then copies each range for the host: a buffer, an offset in it, and a length.
    pub fn read_later(&self, ranges: &[(&RawBuffer, u64, usize)]) -> Reading {
        // wgpu copies whole words
        let words = |&(buffer, first, len): &(&RawBuffer, u64, usize)| {
            let begin = buffer.begin + first;
            begin / 4 * 4..(begin + len as u64).next_multiple_of(4)
        };
        let size: u64 = ranges.iter().map(words).map(|words| words.end - words.start).sum();
        let staging = self.take_staging(size);
        let mut places = Vec::with_capacity(ranges.len());
        let mut recorder = self.recorder.lock();
        let mut at = 0;
        for range in ranges {
            let words = words(range);
            let memory = self.memory(range.0);
            recorder.copy(&self.device, memory, words.clone(), &staging, at);
            places.push(((at + range.0.begin + range.1 - words.start) as usize, range.2));
            at += words.end - words.start;
        }
        let submission = recorder.submit(&self.device, &self.queue);
        drop(recorder);
        let (sender, mapped) = mpsc::channel();
        // not more than the copy writes: wgpu would clear the rest first
        staging.slice(..size).map_async(wgpu::MapMode::Read, move |result| {
            // the receiver is gone only if nobody wants the bytes anymore
            let _ = sender.send(result);
        });
        Reading { staging, size, ranges: places, submission, mapped }
    }

    /// Waits for the submission that copies the bytes, and gives the bytes of each range to `take`. Later submissions go on.
    pub fn finish_reading(
        &self,
        reading: Reading,
        mut take: impl FnMut(&[u8]) -> Result<()>,
    ) -> Result<()> {
        let Reading { staging, size, ranges, submission, mapped } = reading;
        let lost = |reason: String| Error::DeviceLost { reason };
        let polled =
            self.device.poll(wgpu::PollType::Wait { submission_index: submission, timeout: None });
        self.check()?;
        polled.map_err(|error| lost(error.to_string()))?;
        let mapped = mapped.recv().map_err(|_| lost("it did not answer".into()))?;
        mapped.map_err(|error| lost(error.to_string()))?;
        let bytes =
            staging.slice(..size).get_mapped_range().map_err(|error| lost(error.to_string()))?;
        let taken =
            ranges.into_iter().try_for_each(|(first, len)| take(&bytes[first..first + len]));
        drop(bytes);
        staging.unmap();
        if staging.size() <= MAX_STAGING {
            self.staging.lock().push(staging);
        }
        taken
    }

    /// A buffer that the host can read, of at least `size` bytes.
    fn take_staging(&self, size: u64) -> wgpu::Buffer {
        let mut unused = self.staging.lock();
        let large_enough = unused.iter().position(|buffer| buffer.size() >= size);
        match large_enough {
            Some(place) => unused.swap_remove(place),
            None => {
                // a larger one takes the place of one that is too small
                unused.pop();
                self.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("read back"),
                    size,
                    usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                    mapped_at_creation: false,
                })
            }
        }
    }

    pub fn dispatch(
        &self,
        kernel: &'static KernelInfo,
        uniform: &[u8],
        counts: &[(usize, &Count)],
        buffers: &[&RawBuffer],
        workgroups: [u32; 3],
    ) -> Result<()> {
        self.check()?;
        let pipeline = self.pipelines.get(&self.device, kernel)?;
        let workgroups = self.pipelines.variants.workgroups(kernel, workgroups);
        let mut pending = Vec::new();
        for &(offset, count) in counts {
            let Some(&Total { ref counts, place, first }) = count.total() else { continue };
            assert_eq!(counts.raw().begin, 0, "counts have a buffer of their own");
            let counts = self.memory(counts.raw());
            let upper_bound = count.upper_bound();
            pending.push((offset, PendingCount { counts, place, first, upper_bound }));
        }
        let fill = match pending.is_empty() {
            true => None,
            false => Some(self.pipelines.get(&self.device, &COUNT_FILL)?),
        };
        let counts = fill.as_ref().map(|fill| Counted { counts: &pending, fill });
        let buffers: Vec<_> = buffers
            .iter()
            .map(|buffer| wgpu::BufferBinding {
                buffer: self.memory(buffer),
                offset: buffer.begin,
                // an empty buffer has memory, too
                size: std::num::NonZero::new(buffer.bytes.next_multiple_of(4)),
            })
            .collect();
        self.failures.lock().kernel = Some(kernel.name);
        self.recorder.lock().dispatch(
            &self.device,
            &self.queue,
            kernel,
            &pipeline,
            uniform,
            counts,
            &buffers,
            workgroups,
        );
        self.failures.lock().kernel = None;
        self.check()
    }

    pub fn clear(&self, buffer: &RawBuffer) {
        let range = buffer.begin..buffer.begin + buffer.bytes.next_multiple_of(4);
        self.recorder.lock().clear(&self.device, self.memory(buffer), range);
    }

    /// Copies a whole buffer into another, to byte `first` of it.
    pub fn copy(&self, from: &RawBuffer, to: &RawBuffer, first: u64) {
        let range = from.begin..from.begin + from.bytes.next_multiple_of(4);
        let target = self.memory(to);
        self.recorder.lock().copy(&self.device, self.memory(from), range, target, to.begin + first);
    }

    /// Declares that earlier dispatches have written the numbers that are filled in from here on.
    pub fn publish_counts(&self) {
        self.recorder.lock().publish_counts(&self.device);
    }

    /// Submits what is recorded.
    pub fn submit(&self) {
        self.recorder.lock().submit(&self.device, &self.queue);
    }

    /// Waits for all queued work.
    pub fn wait(&self) -> Result<()> {
        self.submit();
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.check()?;
        polled.map(drop).map_err(|error| Error::DeviceLost { reason: error.to_string() })
    }

    /// Turns the timing of dispatches on or off. Returns whether this device has timestamps for it.
    pub fn time_dispatches(&self, times: bool) -> bool {
        self.recorder.lock().time(times)
    }

    /// Waits for timed dispatches, and returns their times; empty if the device is lost.
    pub fn take_times(&self) -> Vec<(&'static str, Duration)> {
        let mut recorder = self.recorder.lock();
        if recorder.timer().is_none_or(|timer| timer.is_empty()) {
            return Vec::new();
        }
        recorder.submit(&self.device, &self.queue);
        let Some(timer) = recorder.timer() else { return Vec::new() };
        timer.map();
        match self.device.poll(wgpu::PollType::wait_indefinitely()) {
            Ok(_) => timer.take(self.queue.get_timestamp_period()),
            Err(_) => Vec::new(),
        }
    }

    pub fn traffic(&self) -> Traffic {
        self.recorder.lock().traffic
    }

    pub fn lose(&self) {
        self.device.destroy();
    }

    /// The first failure that the device reported since the last call. The loss of the device is reported every time.
    fn check(&self) -> Result<()> {
        let first = self.failures.lock().first.take();
        if first.is_some() {
            // on a lost device, new objects are invalid, and their use is reported instead of the loss: polling
            // reports the loss
            let _ = self.device.poll(wgpu::PollType::Poll);
        }
        match (&self.failures.lock().lost, first) {
            (Some(reason), _) => Err(Error::DeviceLost { reason: reason.clone() }),
            (None, Some(first)) => Err(first),
            (None, None) => Ok(()),
        }
    }
}

/// Failures that a device reported.
#[derive(Debug, Default)]
struct Failures {
    /// The reason for the loss of the device.
    lost: Option<String>,
    /// The first of all other failures.
    first: Option<Error>,
    /// The kernel whose dispatch is recorded now.
    kernel: Option<&'static str>,
}

/// Stores a device's failures, which wgpu reports through callbacks.
fn record_failures(device: &wgpu::Device, failures: &Arc<Mutex<Failures>>) {
    let lost = failures.clone();
    device.set_device_lost_callback(move |reason, message| {
        // the regular end of a device is reported, too
        if !(reason == wgpu::DeviceLostReason::Destroyed && message.contains("Device dropped")) {
            lost.lock().lost.get_or_insert(message);
        }
    });
    let uncaptured = failures.clone();
    device.on_uncaptured_error(Arc::new(move |error| {
        let mut failures = uncaptured.lock();
        let error = match (error, failures.kernel) {
            (wgpu::Error::OutOfMemory { source }, _) => {
                Error::OutOfMemory { needed: 0, available: None, what: source.to_string() }
            }
            (other, Some(kernel)) => {
                Error::Kernel { kernel: kernel.into(), reason: other.to_string() }
            }
            (other, None) => Error::Argument { reason: format!("the GPU's driver: {other}") },
        };
        failures.first.get_or_insert(error);
    }));
}
