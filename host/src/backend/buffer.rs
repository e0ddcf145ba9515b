//! Typed buffers of either backend.

use std::marker::PhantomData;

use bytemuck::Pod;
use organza_kernels::kernel::Storage;

use super::cpu::CpuMemory;

/// The host's storage: its buffers live on a [`Device`](super::Device).
#[derive(Debug)]
pub enum Host {}

/// `len` values of `T` on a device.
#[derive(Debug)]
pub struct Buffer<T> {
    raw: RawBuffer,
    element: PhantomData<T>,
}

/// A buffer whose element type is forgotten.
#[derive(Debug)]
pub struct RawBuffer {
    pub(super) memory: Memory,
    pub(super) label: &'static str,
    pub(super) bytes: u64,
}

#[derive(Debug)]
pub(super) enum Memory {
    Cpu(CpuMemory),
    Gpu(wgpu::Buffer),
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

    /// Number of values.
    #[must_use]
    pub fn len(&self) -> usize {
        self.raw.bytes as usize / size_of::<T>()
    }

    /// Whether it holds nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.raw.bytes == 0
    }

    /// Size in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.raw.bytes
    }
}

impl Storage for Host {
    type Buffer<T: Pod> = Buffer<T>;
    type Binding<'a> = &'a RawBuffer;

    fn bind<T: Pod>(buffer: &Buffer<T>) -> &RawBuffer {
        buffer.raw()
    }
}
