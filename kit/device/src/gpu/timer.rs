//! Timestamps around dispatches.

use std::time::Duration;

/// Size of a timestamp, in bytes.
const STAMP: u64 = size_of::<u64>() as u64;

/// Timestamps of one command buffer, and of submitted ones that have not been read yet.
#[derive(Debug)]
pub struct Timer {
    /// Begin and end of each dispatch.
    stamps: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    /// The kernels in the current command buffer.
    kernels: Vec<&'static str>,
    submitted: Vec<Submitted>,
}

/// Timestamps of a submitted command buffer.
#[derive(Debug)]
struct Submitted {
    kernels: Vec<&'static str>,
    /// Timestamps, `[kernels, 2]`: begin and end.
    stamps: wgpu::Buffer,
}

impl Timer {
    /// For command buffers of at most so many dispatches. `None` if the device has no timestamps.
    pub fn new(device: &wgpu::Device, dispatches: u64) -> Option<Self> {
        device.features().contains(wgpu::Features::TIMESTAMP_QUERY).then(|| Self {
            stamps: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: 2 * dispatches as u32,
            }),
            resolved: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: 2 * dispatches * STAMP,
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
            kernels: Vec::new(),
            submitted: Vec::new(),
        })
    }

    /// Whether all timestamps have been read.
    pub fn is_empty(&self) -> bool {
        self.kernels.is_empty() && self.submitted.is_empty()
    }

    /// Whether something was timed since the last [`Timer::resolve`].
    pub fn has_unresolved(&self) -> bool {
        !self.kernels.is_empty()
    }

    /// The timestamps that the pass of a kernel's dispatch must write.
    pub fn time(&mut self, kernel: &'static str) -> wgpu::ComputePassTimestampWrites<'_> {
        let begin = 2 * self.kernels.len() as u32;
        self.kernels.push(kernel);
        wgpu::ComputePassTimestampWrites {
            query_set: &self.stamps,
            beginning_of_pass_write_index: Some(begin),
            end_of_pass_write_index: Some(begin + 1),
        }
    }

    /// Adds the last commands before a submission, which copy the timestamps to where the host reads them.
    pub fn resolve(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        let kernels = std::mem::take(&mut self.kernels);
        let size = 2 * kernels.len() as u64 * STAMP;
        let stamps = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("timestamps read back"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        encoder.resolve_query_set(&self.stamps, 0..2 * kernels.len() as u32, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &stamps, 0, size);
        self.submitted.push(Submitted { kernels, stamps });
    }

    /// Maps the submitted timestamps. They are readable after waiting for the device.
    pub fn map(&self) {
        for submitted in &self.submitted {
            // an error shows up when reading
            submitted.stamps.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        }
    }

    /// Returns the time of each dispatch. `period` is [`wgpu::Queue::get_timestamp_period`]. Empty for a lost
    /// device.
    pub fn take(&mut self, period: f32) -> Vec<(&'static str, Duration)> {
        let mut times = Vec::new();
        for Submitted { kernels, stamps } in self.submitted.drain(..) {
            let Ok(bytes) = stamps.slice(..).get_mapped_range() else { continue };
            for (kernel, stamps) in kernels.into_iter().zip(bytes.chunks_exact(2 * STAMP as usize))
            {
                let [begin, end]: [u64; 2] = bytemuck::pod_read_unaligned(stamps);
                // some GPUs swap the timestamps of an empty pass
                let nanoseconds = end.saturating_sub(begin) as f64 * f64::from(period);
                times.push((kernel, Duration::from_nanos(nanoseconds.round() as u64)));
            }
        }
        times
    }
}
