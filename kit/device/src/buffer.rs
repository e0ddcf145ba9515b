//! Typed buffers for both backends.

use std::marker::PhantomData;
use std::sync::Arc;

use bytemuck::Pod;
use muslin_kernel::count::{self, OVERFLOW};
use muslin_kernel::kernel::Storage;

use crate::cpu_memory::CpuMemory;

/// `len` values of `T` on a device. A clone is the same memory.
#[derive(Clone, Debug)]
pub struct Buffer<T> {
    raw: RawBuffer,
    element: PhantomData<T>,
}

/// A buffer without its element type.
#[derive(Clone, Debug)]
pub struct RawBuffer {
    pub(super) memory: Memory,
    pub(super) label: &'static str,
    /// Offset in the memory, in bytes.
    pub(super) begin: u64,
    pub(super) bytes: u64,
}

/// Alignment of a buffer within a GPU's memory, in bytes.
pub const TAIL_ALIGNMENT: usize = 256;

#[derive(Clone, Debug)]
pub(super) enum Memory {
    Cpu(Arc<CpuMemory>),
    Gpu(GpuBuffer),
    /// The number of a buffer in a [plan](crate::plan).
    Planned(u32),
}

impl Memory {
    /// Whether both lie in the same memory.
    pub(super) fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Cpu(one), Self::Cpu(other)) => Arc::ptr_eq(one, other),
            (Self::Gpu(one), Self::Gpu(other)) => one == other,
            (Self::Planned(one), Self::Planned(other)) => one == other,
            _ => false,
        }
    }
}

impl<T: Pod> Buffer<T> {
    pub(super) fn new(raw: RawBuffer) -> Self {
        Self { raw, element: PhantomData }
    }

    pub(super) fn raw(&self) -> &RawBuffer {
        &self.raw
    }

    pub(super) fn raw_mut(&mut self) -> &mut RawBuffer {
        &mut self.raw
    }

    /// The same memory with another element type. A write through one is visible through the other.
    ///
    /// # Panics
    /// If the memory does not hold a whole number of elements.
    #[must_use]
    pub fn view<U: Pod>(&self) -> Buffer<U> {
        let label = self.raw.label;
        let bytes = self.raw.bytes;
        assert!(
            bytes.is_multiple_of(size_of::<U>() as u64),
            "the buffer `{label}` has {bytes} bytes"
        );
        Buffer::new(self.raw.clone())
    }

    /// The same memory, starting at the element `first`.
    ///
    /// # Panics
    /// If `first` is past the end, or not at a multiple of 256 bytes.
    #[must_use]
    pub fn tail(&self, first: usize) -> Self {
        let skipped = first * size_of::<T>();
        let label = self.raw.label;
        assert!(skipped as u64 <= self.raw.bytes, "`{label}` ends before its element {first}");
        assert!(skipped.is_multiple_of(TAIL_ALIGNMENT), "`{label}` is cut at {skipped} bytes");
        let mut raw = self.raw.clone();
        raw.begin += skipped as u64;
        raw.bytes -= skipped as u64;
        Buffer::new(raw)
    }

    /// Number of values.
    #[must_use]
    pub fn len(&self) -> usize {
        self.raw.bytes as usize / size_of::<T>()
    }

    /// Whether it has no values.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.raw.bytes == 0
    }

    /// Number in a [`DevicePlan`](crate::DevicePlan); `None` on a device that runs kernels.
    #[must_use]
    pub fn planned(&self) -> Option<u32> {
        match self.raw.memory {
            Memory::Planned(buffer) => Some(buffer),
            _ => None,
        }
    }

    /// Size in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.raw.bytes
    }
}

/// Marks the host's side of kernels: buffers belong to a [`Device`](crate::Device).
#[derive(Debug)]
pub enum Host {}

impl Storage for Host {
    type Buffer<T: Pod> = Buffer<T>;
    type Binding<'a> = &'a RawBuffer;
    type Count = Count;

    fn bind<T: Pod>(buffer: &Buffer<T>) -> &RawBuffer {
        buffer.raw()
    }

    fn upper_bound(count: &Count) -> u32 {
        count.upper_bound()
    }
}

/// A buffer of a GPU.
#[cfg(feature = "gpu")]
pub type GpuBuffer = crate::gpu::memory::GpuMemory;

/// No buffer: there is no GPU without the feature `gpu`.
#[cfg(not(feature = "gpu"))]
#[derive(Clone, Debug, PartialEq)]
pub enum GpuBuffer {}

/// A number of items: known to the host, or written on the device by a kernel.
#[derive(Clone, Debug)]
pub struct Count {
    /// The number, or the capacity if only the device knows the number.
    upper_bound: u32,
    total: Option<Total>,
}

/// The total of which a number on the device is a part.
#[derive(Clone, Debug)]
pub(super) struct Total {
    /// The buffer of counts: see [`muslin_kernel::count`].
    pub counts: Arc<Buffer<u32>>,
    pub place: u32,
    /// Number of items before this piece.
    pub first: u32,
}

impl Count {
    /// A number that the host knows.
    #[must_use]
    pub fn known(number: u32) -> Self {
        Self { upper_bound: number, total: None }
    }

    /// The number at index `place` of `counts`. Tables have room for `upper_bound` items.
    pub fn on_device(counts: &Arc<Buffer<u32>>, place: u32, upper_bound: u32) -> Self {
        Self { upper_bound, total: Some(Total { counts: counts.clone(), place, first: 0 }) }
    }

    /// The number that determines the size of tables and dispatches.
    #[must_use]
    pub fn upper_bound(&self) -> u32 {
        self.upper_bound
    }

    /// The number of items from `first` on, at most `max`.
    #[must_use]
    pub fn piece(&self, first: u32, max: u32) -> Self {
        let upper_bound = count::piece(self.upper_bound, first, max);
        let further = |total: &Total| Total { first: total.first + first, ..total.clone() };
        Self { upper_bound, total: self.total.as_ref().map(further) }
    }

    /// Whether the host knows the number.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.total.is_none()
    }

    pub(super) fn total(&self) -> Option<&Total> {
        self.total.as_ref()
    }

    /// The number, on the CPU backend.
    pub(super) fn on_cpu(&self) -> u32 {
        let Some(total) = &self.total else { return self.upper_bound };
        let Memory::Cpu(memory) = &total.counts.raw().memory else {
            panic!("the counts belong to a GPU")
        };
        let counts: &[u32] = bytemuck::cast_slice(&memory.bytes()[..total.counts.bytes() as usize]);
        match counts[OVERFLOW as usize] {
            0 => count::piece(counts[total.place as usize], total.first, self.upper_bound),
            _ => 0,
        }
    }
}
