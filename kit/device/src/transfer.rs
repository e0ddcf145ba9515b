//! Creates, fills, clears and reads buffers.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bytemuck::Pod;

use crate::buffer::{Buffer, Memory, RawBuffer};
use crate::cpu_memory::Writer;
use crate::device::{Device, DeviceKind};
use crate::gpu::Reading;
use crate::{Error, Result};

impl Device {
    /// Creates a buffer of `len` zeros.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], with the size.
    pub fn zeros<T: Pod>(&self, label: &'static str, len: usize) -> Result<Buffer<T>> {
        self.buffer(label, len, true)
    }

    fn buffer<T: Pod>(&self, label: &'static str, len: usize, zeros: bool) -> Result<Buffer<T>> {
        let bytes = len as u64 * size_of::<T>() as u64;
        self.refuse(label, bytes)?;
        let memory = match &self.kind {
            DeviceKind::Cpu(cpu) => Memory::Cpu(Arc::new(cpu.allocate(label, bytes, zeros)?)),
            DeviceKind::Gpu(gpu) => Memory::Gpu(gpu.allocate(label, bytes, zeros)?),
            DeviceKind::Planner(planner) => Memory::Planned(planner.allocate(label, bytes)?),
        };
        Ok(Buffer::new(RawBuffer { memory, label, begin: 0, bytes }))
    }

    /// Creates a buffer of `len` elements that kernels write before anything reads them. Until then they can have any
    /// value.
    ///
    /// A device that [checks](crate::DeviceOptions::check_races) fails if a kernel reads an unwritten element.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`].
    pub fn unwritten<T: Pod>(&self, label: &'static str, len: usize) -> Result<Buffer<T>> {
        let buffer = self.buffer(label, len, false)?;
        self.forget(&buffer);
        Ok(buffer)
    }

    /// Marks a buffer as unwritten, even if it was written: see [`Device::unwritten`].
    pub fn forget<T: Pod>(&self, buffer: &Buffer<T>) {
        let raw = buffer.raw();
        if let (DeviceKind::Cpu(cpu), Memory::Cpu(memory)) = (&self.kind, &raw.memory) {
            cpu.forget(memory, raw.begin, raw.bytes);
        }
    }

    /// Fails if [`Device::refuse_one`] has asked for it.
    fn refuse(&self, label: &'static str, bytes: u64) -> Result<()> {
        let is_due = |left: u64| left.checked_sub(1);
        match self.refused.fetch_update(Ordering::Relaxed, Ordering::Relaxed, is_due) {
            Ok(1) => Err(Error::OutOfMemory {
                needed: bytes,
                available: None,
                what: format!("the buffer `{label}`"),
            }),
            _ => Ok(()),
        }
    }

    /// Makes the device refuse memory once: for the buffer number `number` from now on, counted from 1. For tests.
    /// Returns whether an earlier request is still pending.
    #[doc(hidden)]
    pub fn refuse_one(&self, number: u64) -> bool {
        self.refused.swap(number, Ordering::Relaxed) > 0
    }

    /// Creates a buffer that contains `values`.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`].
    pub fn upload<T: Pod>(&self, label: &'static str, values: &[T]) -> Result<Buffer<T>> {
        let mut buffer = self.buffer(label, values.len(), false)?;
        match (&self.kind, &mut buffer.raw_mut().memory) {
            (DeviceKind::Cpu(_), Memory::Cpu(memory)) => {
                let memory = Arc::get_mut(memory).expect("it is not shared yet");
                memory.bytes_mut()[..size_of_val(values)]
                    .copy_from_slice(bytemuck::cast_slice(values));
            }
            (DeviceKind::Gpu(gpu), Memory::Gpu(memory)) => {
                gpu.write(memory, bytemuck::cast_slice(values))
            }
            (DeviceKind::Planner(planner), Memory::Planned(buffer)) => {
                planner.fill(*buffer, bytemuck::cast_slice(values));
            }
            _ => unreachable!("the buffer was made by this device"),
        }
        Ok(buffer)
    }

    /// Sets a buffer to zeros, after all earlier dispatches.
    pub fn clear<T: Pod>(&self, buffer: &Buffer<T>) {
        let raw = buffer.raw();
        match (&self.kind, &raw.memory) {
            (DeviceKind::Cpu(cpu), Memory::Cpu(memory)) => cpu.clear(memory, raw.begin, raw.bytes),
            (DeviceKind::Gpu(gpu), _) => gpu.clear(raw),
            (DeviceKind::Planner(planner), Memory::Planned(buffer)) => {
                planner.clear(*buffer, raw.begin, raw.bytes);
            }
            _ => panic!("the buffer `{}` belongs to another device", raw.label),
        }
    }

    /// Copies a buffer to another of the same size, after all earlier dispatches.
    pub fn copy<T: Pod>(&self, from: &Buffer<T>, to: &Buffer<T>) {
        let labels = [from, to].map(|buffer| buffer.raw().label);
        assert_eq!(from.len(), to.len(), "{labels:?} are of one size");
        self.copy_to(from, to, 0);
    }

    /// Copies a buffer into another, starting at the element `first`.
    fn copy_to<T: Pod>(&self, from: &Buffer<T>, to: &Buffer<T>, first: usize) {
        let from = from.raw();
        let to = to.raw();
        let range = from.begin..from.begin + from.bytes;
        let first = (first * size_of::<T>()) as u64;
        let begin = to.begin + first;
        match (&self.kind, &from.memory, &to.memory) {
            (DeviceKind::Cpu(cpu), Memory::Cpu(source), Memory::Cpu(target)) => {
                cpu.copy(source, range, target, begin);
            }
            (DeviceKind::Gpu(gpu), ..) => gpu.copy(from, to, first),
            (DeviceKind::Planner(planner), Memory::Planned(source), Memory::Planned(target)) => {
                planner.copy(*source, range, *target, begin);
            }
            _ => panic!("the buffer `{}` belongs to another device", from.label),
        }
    }

    /// Copies `values` into a buffer, starting at the element `first`, after all earlier dispatches.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    ///
    /// # Panics
    /// If the values extend past the buffer's end, or if an element's size is not a multiple of 4 bytes.
    pub fn write<T: Pod>(&self, buffer: &Buffer<T>, first: usize, values: &[T]) -> Result<()> {
        // a GPU copies whole words
        assert!(size_of::<T>().is_multiple_of(4), "elements of {} bytes", size_of::<T>());
        assert!(first + values.len() <= buffer.len(), "past the end of `{}`", buffer.raw().label);
        if values.is_empty() {
            return Ok(());
        }
        let raw = buffer.raw();
        if let (DeviceKind::Cpu(cpu), Memory::Cpu(memory)) = (&self.kind, &raw.memory) {
            let begin = raw.begin + (first * size_of::<T>()) as u64;
            cpu.write(memory, begin, bytemuck::cast_slice(values));
            return Ok(());
        }
        // through a buffer: a copy comes after earlier dispatches
        let values = self.upload(raw.label, values)?;
        self.copy_to(&values, buffer, first);
        Ok(())
    }

    /// Reads a buffer, after all earlier dispatches.
    ///
    /// # Errors
    /// [`Error::DeviceLost`], or the error of an earlier dispatch. [`Error::Kernel`] on a device that
    /// [checks](crate::DeviceOptions::check_races), if nothing has written an element.
    pub fn read<T: Pod>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        self.read_range(buffer, 0, buffer.len())
    }

    /// Reads `len` elements, starting at `first`: see [`Device::read`].
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn read_range<T: Pod>(
        &self,
        buffer: &Buffer<T>,
        first: usize,
        len: usize,
    ) -> Result<Vec<T>> {
        let mut values = crate::memory::zeros(len, buffer.raw().label)?;
        self.read_into(buffer, first, &mut values)?;
        Ok(values)
    }

    /// Reads elements, starting at `first`, until `values` is full: see [`Device::read`].
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    ///
    /// # Panics
    /// If the range extends past the buffer's end.
    pub fn read_into<T: Pod>(
        &self,
        buffer: &Buffer<T>,
        first: usize,
        values: &mut [T],
    ) -> Result<()> {
        let label = buffer.raw().label;
        assert!(first + values.len() <= buffer.len(), "read past the end of `{label}`");
        if values.is_empty() {
            return Ok(());
        }
        self.refuse_unwritten(buffer, first, values.len())?;
        self.copy_out(buffer, first, values)
    }

    /// Like [`Device::read`], also if parts of the buffer are unwritten: for tests of what a kernel leaves alone.
    ///
    /// # Errors
    /// [`Error::DeviceLost`], or the error of an earlier dispatch.
    #[doc(hidden)]
    pub fn read_unchecked<T: Pod>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        let mut values = crate::memory::zeros(buffer.len(), buffer.raw().label)?;
        if !values.is_empty() {
            self.copy_out(buffer, 0, &mut values)?;
        }
        Ok(values)
    }

    /// Fails if nothing has written one of some elements, on a device that checks this.
    fn refuse_unwritten<T: Pod>(&self, buffer: &Buffer<T>, first: usize, len: usize) -> Result<()> {
        let raw = buffer.raw();
        let Memory::Cpu(memory) = &raw.memory else { return Ok(()) };
        let Some(written) = memory.written() else { return Ok(()) };
        let begin = raw.begin as usize + first * size_of::<T>();
        let Some(missing) = written.missing(begin..begin + len * size_of::<T>()) else {
            return Ok(());
        };
        let index = (missing.at - raw.begin as usize) / size_of::<T>();
        let label = raw.label;
        let Some(Writer { kernel, name, ticket }) = written.writer() else {
            let reason =
                format!("element {index} of the buffer `{label}` is read, and no kernel writes it");
            return Err(Error::Argument { reason });
        };
        let additional = ": only an additional workgroup has, which no other device runs";
        let why = match (missing.is_additional, ticket.get()) {
            (true, Some(place)) => format!(
                "{additional}. It has taken a ticket at {place}: if tickets say what a workgroup does, run the kernel with \
                 `extra_workgroup(false)`"
            ),
            (true, None) => format!("{additional}, so the dispatch has too few"),
            (false, _) => String::new(),
        };
        let reason = format!("it has not written element {index} of `{name}`, which is read{why}");
        Err(Error::Kernel { kernel: kernel.into(), reason })
    }

    /// Copies elements to the host, starting at `first`.
    fn copy_out<T: Pod>(&self, buffer: &Buffer<T>, first: usize, values: &mut [T]) -> Result<()> {
        let label = buffer.raw().label;
        let first = first * size_of::<T>();
        let target: &mut [u8] = bytemuck::cast_slice_mut(values);
        match (&self.kind, &buffer.raw().memory) {
            (DeviceKind::Cpu(_), Memory::Cpu(memory)) => {
                let begin = buffer.raw().begin as usize + first;
                target.copy_from_slice(&memory.bytes()[begin..begin + target.len()]);
                Ok(())
            }
            (DeviceKind::Gpu(gpu), _) => {
                gpu.read(&[(buffer.raw(), first as u64, target.len())], |bytes| {
                    target.copy_from_slice(bytes);
                    Ok(())
                })
            }
            (DeviceKind::Planner(planner), Memory::Planned(number))
                if planner.read(*number, buffer.raw().begin as usize + first, target) =>
            {
                Ok(())
            }
            (DeviceKind::Planner(_), _) => Err(Error::Argument {
                reason: format!(
                    "`{label}` has no values to read: this device only records what another one will run"
                ),
            }),
            _ => panic!("the buffer `{label}` belongs to another device"),
        }
    }

    /// Like [`Device::read`], but reads many buffers and waits only once.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn read_all(&self, buffers: &[Buffer<u32>]) -> Result<Vec<Vec<u32>>> {
        let DeviceKind::Gpu(gpu) = &self.kind else {
            return buffers.iter().map(|buffer| self.read(buffer)).collect();
        };
        let mut values = Values::of(buffers);
        gpu.read(&whole(buffers), |bytes| values.take(bytes))?;
        Ok(values.found)
    }

    /// Like [`Device::read_all`], but a GPU goes on with what comes later, and [`Device::finish`] has the values.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn read_later(&self, buffers: &[Buffer<u32>]) -> Result<Pending> {
        let DeviceKind::Gpu(gpu) = &self.kind else {
            return Ok(Pending(PendingValues::Known(self.read_all(buffers)?)));
        };
        let reading = gpu.read_later(&whole(buffers));
        Ok(Pending(PendingValues::Reading(reading, Values::of(buffers))))
    }

    /// The values of [`Device::read_later`], which this device has given. Waits until they are there, and not for later work.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn finish(&self, pending: Pending) -> Result<Vec<Vec<u32>>> {
        match (&self.kind, pending.0) {
            (_, PendingValues::Known(values)) => Ok(values),
            (DeviceKind::Gpu(gpu), PendingValues::Reading(reading, mut values)) => {
                gpu.finish_reading(reading, |bytes| values.take(bytes))?;
                Ok(values.found)
            }
            _ => panic!("another device reads these values"),
        }
    }
}

/// Values of buffers that a device will have read: [`Device::finish`] takes them.
#[derive(Debug)]
pub struct Pending(PendingValues);

#[derive(Debug)]
enum PendingValues {
    Known(Vec<Vec<u32>>),
    Reading(Reading, Values),
}

/// The values of some buffers, one after the other.
#[derive(Debug)]
struct Values {
    labels: Vec<&'static str>,
    found: Vec<Vec<u32>>,
}

impl Values {
    fn of(buffers: &[Buffer<u32>]) -> Self {
        let labels = buffers.iter().map(|buffer| buffer.raw().label).collect();
        Self { labels, found: Vec::with_capacity(buffers.len()) }
    }

    fn take(&mut self, bytes: &[u8]) -> Result<()> {
        let words = bytemuck::cast_slice(bytes);
        // not zeros: these would take as long as the copy
        let mut copied = crate::memory::reserve(words.len(), self.labels[self.found.len()])?;
        copied.extend_from_slice(words);
        self.found.push(copied);
        Ok(())
    }
}

/// All bytes of each buffer.
fn whole(buffers: &[Buffer<u32>]) -> Vec<(&RawBuffer, u64, usize)> {
    buffers.iter().map(|buffer| (buffer.raw(), 0, buffer.raw().bytes as usize)).collect()
}
