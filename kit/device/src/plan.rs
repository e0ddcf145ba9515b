//! A device that runs nothing. It records all requests, so that something else can run them, such as a browser.

use std::ops::Range;

use muslin_kernel::KernelInfo;
use parking_lot::Mutex;

use crate::buffer::{Count, Memory, RawBuffer};
use crate::{Error, Result};

/// Largest buffer that every browser with WebGPU can bind, in bytes: `maxStorageBufferBindingSize`.
const MAX_BUFFER_BYTES: u64 = 128 << 20;

/// The requests to a device: buffers, and steps that use them.
#[derive(Clone, Debug, Default)]
pub struct DevicePlan {
    /// Number of the first buffer. Lower numbers belong to earlier plans.
    pub first_buffer: u32,
    /// The created buffers, in the order of their numbers.
    pub buffers: Vec<PlannedBuffer>,
    /// The steps, in order.
    pub steps: Vec<Step>,
}

/// A buffer of a [`DevicePlan`].
#[derive(Clone, Debug)]
pub struct PlannedBuffer {
    /// Label for debugging.
    pub label: &'static str,
    /// Size in bytes, a multiple of 4.
    pub bytes: u64,
    /// Initial content; `None` means zeros.
    pub contents: Option<Vec<u8>>,
}

/// A range of a buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BufferRange {
    /// Number of the buffer.
    pub buffer: u32,
    /// Offset of the first byte.
    pub begin: u64,
    /// Number of bytes, a multiple of 4.
    pub bytes: u64,
}

/// An operation on buffers.
#[derive(Clone, Debug)]
pub enum Step {
    /// Runs a kernel.
    Dispatch {
        /// Name of the kernel and of its plain entry point.
        kernel: &'static str,
        /// Bytes of the kernel's parameters.
        params: Vec<u8>,
        /// Parameters that only the device knows.
        counts: Vec<PlannedCount>,
        /// Ranges of buffers for the other bindings, in order.
        buffers: Vec<BufferRange>,
        /// Number of workgroups along x, y and z.
        workgroups: [u32; 3],
    },
    /// Sets bytes to zero.
    Clear(BufferRange),
    /// Copies bytes.
    Copy {
        /// The source.
        from: BufferRange,
        /// Number of the target buffer.
        to: u32,
        /// Offset in the target buffer, in bytes.
        begin: u64,
    },
    /// Earlier dispatches have written the [counts](PlannedCount) that later ones use.
    PublishCounts,
}

/// A kernel parameter that `count_fill` writes: see [`muslin_kernel::count`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlannedCount {
    /// Offset in the parameters, in bytes.
    pub offset: usize,
    /// Number of the buffer with the counts.
    pub counts: u32,
    /// Index of the count in that buffer.
    pub place: u32,
    /// Number of items before this piece.
    pub first: u32,
    /// Largest number that there is room for.
    pub upper_bound: u32,
}

/// The planning backend.
#[derive(Debug, Default)]
pub(crate) struct Planner(Mutex<DevicePlan>);

impl Planner {
    /// The requests since the last call.
    pub fn take(&self) -> DevicePlan {
        let mut plan = self.0.lock();
        let first_buffer = plan.first_buffer + plan.buffers.len() as u32;
        std::mem::replace(&mut *plan, DevicePlan { first_buffer, ..DevicePlan::default() })
    }

    pub fn max_buffer_bytes(&self) -> u64 {
        MAX_BUFFER_BYTES
    }

    /// Records a buffer, and returns its number.
    pub fn allocate(&self, label: &'static str, bytes: u64) -> Result<u32> {
        // the same size as on a GPU
        let size = bytes.max(16).next_multiple_of(4);
        if size > MAX_BUFFER_BYTES {
            return Err(Error::OutOfMemory {
                needed: bytes,
                available: Some(MAX_BUFFER_BYTES),
                what: format!("the buffer `{label}` in a browser"),
            });
        }
        let mut plan = self.0.lock();
        let number = plan.first_buffer + plan.buffers.len() as u32;
        plan.buffers.push(PlannedBuffer { label, bytes: size, contents: None });
        Ok(number)
    }

    /// Sets the initial content of a new buffer.
    pub fn fill(&self, buffer: u32, contents: &[u8]) {
        let mut plan = self.0.lock();
        let at = (buffer - plan.first_buffer) as usize;
        let mut contents = contents.to_vec();
        contents.resize(plan.buffers[at].bytes as usize, 0);
        plan.buffers[at].contents = Some(contents);
    }

    /// Reads the initial content of a buffer of this plan, from a byte on. Returns whether there is any.
    pub fn read(&self, buffer: u32, begin: usize, target: &mut [u8]) -> bool {
        let plan = self.0.lock();
        let at = buffer.checked_sub(plan.first_buffer).and_then(|at| plan.buffers.get(at as usize));
        let Some(contents) = at.and_then(|buffer| buffer.contents.as_deref()) else { return false };
        target.copy_from_slice(&contents[begin..begin + target.len()]);
        true
    }

    pub fn dispatch(
        &self,
        kernel: &'static KernelInfo,
        uniform: &[u8],
        counts: &[(usize, &Count)],
        buffers: &[&RawBuffer],
        workgroups: [u32; 3],
    ) {
        let count = |(offset, count): &(usize, &Count)| {
            let total = count.total()?;
            Some(PlannedCount {
                offset: *offset,
                counts: total.counts.raw().planned().0,
                place: total.place,
                first: total.first,
                upper_bound: count.upper_bound(),
            })
        };
        let step = Step::Dispatch {
            kernel: kernel.name,
            params: uniform.to_vec(),
            counts: counts.iter().filter_map(count).collect(),
            buffers: buffers.iter().map(|buffer| buffer.planned().1).collect(),
            workgroups,
        };
        self.push(step);
    }

    pub fn clear(&self, buffer: u32, begin: u64, bytes: u64) {
        self.push(Step::Clear(BufferRange { buffer, begin, bytes: bytes.next_multiple_of(4) }));
    }

    pub fn copy(&self, from: u32, range: Range<u64>, to: u32, begin: u64) {
        let bytes = (range.end - range.start).next_multiple_of(4);
        self.push(Step::Copy {
            from: BufferRange { buffer: from, begin: range.start, bytes },
            to,
            begin,
        });
    }

    pub fn publish_counts(&self) {
        self.push(Step::PublishCounts);
    }

    fn push(&self, step: Step) {
        self.0.lock().steps.push(step);
    }
}

impl RawBuffer {
    /// The number of the buffer, and its part in the plan.
    fn planned(&self) -> (u32, BufferRange) {
        let Memory::Planned(buffer) = self.memory else {
            panic!("the buffer `{}` belongs to another device", self.label)
        };
        // an empty buffer has memory, too
        let bytes = self.bytes.max(4).next_multiple_of(4);
        (buffer, BufferRange { buffer, begin: self.begin, bytes })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::device::Device;
    use muslin_kernel::count::CountFillKernel;

    #[test]
    fn plans_record_buffers_and_steps() {
        let device = Device::planner();
        let numbers = device.upload("numbers", &[1_u32, 2, 3]).unwrap();
        let scene = device.take_plan();
        assert_eq!((scene.first_buffer, scene.buffers.len()), (0, 1));
        let contents = scene.buffers[0].contents.as_deref().unwrap();
        // at least 16 bytes, so that it can be bound
        assert_eq!(bytemuck::cast_slice::<u8, u32>(contents), [1, 2, 3, 0]);

        let counts = Arc::new(device.zeros::<u32>("counts", 4).unwrap());
        let output = device.zeros::<u32>("output", 128).unwrap();
        device.clear(&output.tail(64));
        device.publish_counts();
        let kernel = CountFillKernel { placement: &numbers, counts: &*counts, parameters: &output };
        device.run(&kernel, 65, 1).unwrap();
        let plan = device.take_plan();
        assert_eq!((plan.first_buffer, plan.buffers.len()), (1, 2));
        let [Step::Clear(part), Step::PublishCounts, Step::Dispatch { buffers, workgroups, .. }] =
            &plan.steps[..]
        else {
            panic!("{:?}", plan.steps)
        };
        assert_eq!(*part, BufferRange { buffer: 2, begin: 256, bytes: 256 });
        let bound: Vec<_> = buffers.iter().map(|part| (part.buffer, part.bytes)).collect();
        assert_eq!(bound, [(0, 12), (1, 16), (2, 512)]);
        assert_eq!(*workgroups, [2, 1, 1]);
        assert!(device.take_plan().steps.is_empty());
    }

    /// What every device refuses, not only the CPU.
    #[test]
    fn a_dispatch_has_one_limit_and_each_buffer_its_place() {
        let device = Device::planner();
        let numbers = device.zeros::<u32>("placement", 128).unwrap();
        let output = device.zeros::<u32>("output", 128).unwrap();
        let counts = device.zeros::<u32>("counts", 4).unwrap();
        let right = CountFillKernel { placement: &numbers, counts: &counts, parameters: &output };
        device.run_over(&right, [65_535 * 64, 1, 1]).unwrap();
        let error = device.run_over(&right, [65_535 * 64 + 1, 1, 1]).unwrap_err().to_string();
        assert!(error.contains("65536 x 1 x 1 workgroups"), "{error}");
        assert!(device.run(&right, 1, 65_536).is_err());
        for part in [&numbers, &numbers.tail(64), &numbers.view::<f32>().view()] {
            let wrong = CountFillKernel { placement: &numbers, counts: &counts, parameters: part };
            let error = device.run(&wrong, 1, 1).unwrap_err().to_string();
            assert!(error.contains("`placement` and `parameters` are one buffer"), "{error}");
        }
        let swapped = CountFillKernel { placement: &counts, counts: &numbers, parameters: &output };
        let error = device.run(&swapped, 1, 1).unwrap_err().to_string();
        assert!(error.contains("they are swapped"), "{error}");
    }

    #[test]
    fn a_planner_has_the_limits_of_browsers_and_reads_no_results() {
        let device = Device::planner();
        let refused = device.zeros::<u8>("large", (MAX_BUFFER_BYTES + 1) as usize).unwrap_err();
        assert!(matches!(refused, Error::OutOfMemory { .. }), "{refused}");
        let buffer = device.zeros::<u32>("small", 1).unwrap();
        assert!(matches!(device.read(&buffer), Err(Error::Argument { .. })));
        // but for what a buffer began with, until its plan is taken
        let known = device.upload("known", &[1_u32, 2, 3]).unwrap();
        assert_eq!(device.read_range(&known, 1, 2).unwrap(), [2, 3]);
        let _ = device.take_plan();
        assert!(device.read(&known).is_err());
    }
}
