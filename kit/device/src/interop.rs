//! Devices and buffers of wgpu that a program has made itself, or wants to use beside its kernels.
//!
//! A kernel can run inside of an engine that has a device already:
//!
//! ```no_run
//! use muslin_device::{Buffer, Device, DeviceOptions, Modules, Result, wgpu};
//!
//! fn inside(engine: &wgpu::Device, queue: &wgpu::Queue, particles: &wgpu::Buffer) -> Result<()> {
//!     let options = DeviceOptions::default();
//!     let device = Device::from_wgpu(engine.clone(), queue.clone(), &options, Modules::none())?;
//!     let particles = Buffer::<f32>::from_wgpu(&device, "particles", particles.clone())?;
//!     // kernels that change the particles run here; then the engine's commands see what they wrote:
//!     device.submit();
//!     assert!(particles.wgpu().is_some());
//!     Ok(())
//! }
//! ```
//!
//! Dispatches are recorded. [`Device::submit`] hands them to the queue, and what the program submits later comes after them.

use bytemuck::Pod;

use crate::buffer::{Buffer, Memory, RawBuffer};
use crate::device::{Device, DeviceKind};
use crate::gpu::Gpu;
use crate::{DeviceOptions, Error, Modules, Result};

impl Device {
    /// A device that the program has opened. Of the options, it takes [`spirv`](DeviceOptions::spirv),
    /// [`variants`](DeviceOptions::variants) and [`extra_workgroup`](DeviceOptions::extra_workgroup).
    ///
    /// With the feature `PASSTHROUGH_SHADERS`, Vulkan gets the kernels' SPIR-V; otherwise naga translates it. Kernels with subgroups need the feature
    /// `SUBGROUP`, variants with 64-bit sums `SHADER_INT64` and `SHADER_INT64_ATOMIC_ALL_OPS`, and timings `TIMESTAMP_QUERY`. Kernels
    /// with tiles run with ordinary arithmetic: only an adapter tells the shapes of its cooperative matrices.
    ///
    /// The device keeps its callbacks: an error that wgpu reports, or the loss of the device, goes to the program.
    ///
    /// # Errors
    /// [`Error::NoGpu`] if the device's limits are below what kernels may use, or if it cannot take SPIR-V in the demanded way.
    pub fn from_wgpu(
        device: wgpu::Device,
        queue: wgpu::Queue,
        options: &DeviceOptions,
        modules: &'static Modules,
    ) -> Result<Self> {
        let gpu = Gpu::adopt(device, queue, options, modules)?;
        let choice = format!("gpu: {} (the program's own)", gpu.description());
        let device = Self::new(DeviceKind::Gpu(Box::new(gpu)), choice);
        Ok(device.with_extra_workgroup(options.extra_workgroup))
    }

    /// The device and the queue of a GPU; `None` on the CPU.
    #[must_use]
    pub fn wgpu(&self) -> Option<(&wgpu::Device, &wgpu::Queue)> {
        match &self.kind {
            DeviceKind::Gpu(gpu) => Some(gpu.wgpu()),
            _ => None,
        }
    }
}

impl<T: Pod> Buffer<T> {
    /// A buffer that the program has made on this device: wgpu does not tell whose it is. Kernels read and write its memory; it never becomes another buffer's.
    ///
    /// # Errors
    /// [`Error::Argument`] if `device` is no GPU, if the buffer lacks the usage `STORAGE`, `COPY_SRC` or `COPY_DST`, or if its size is no whole number
    /// of elements and of words.
    pub fn from_wgpu(device: &Device, label: &'static str, buffer: wgpu::Buffer) -> Result<Self> {
        let refuse = |reason: String| {
            Err(Error::Argument { reason: format!("the buffer `{label}` {reason}") })
        };
        let DeviceKind::Gpu(gpu) = &device.kind else {
            return refuse(format!("is a GPU's, and this device is the {}", device.backend()));
        };
        let needed = wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::COPY_SRC
            | wgpu::BufferUsages::COPY_DST;
        let missing = needed - buffer.usage();
        if !missing.is_empty() {
            return refuse(format!("is made without the usage {missing:?}"));
        }
        let bytes = buffer.size();
        let size = size_of::<T>() as u64;
        if !bytes.is_multiple_of(size) || !bytes.is_multiple_of(4) {
            return refuse(format!("has {bytes} bytes, and its elements have {size}"));
        }
        let memory = Memory::Gpu(gpu.adopt_buffer(buffer));
        Ok(Self::new(RawBuffer { memory, label, begin: 0, bytes }))
    }

    /// The memory on a GPU, ready to be bound; `None` on the CPU. It is the buffer's as long as that lives: afterwards, the device gives it to another
    /// buffer.
    #[must_use]
    pub fn wgpu(&self) -> Option<wgpu::BufferBinding<'_>> {
        let raw = self.raw();
        let Memory::Gpu(memory) = &raw.memory else { return None };
        let size = std::num::NonZero::new(raw.bytes);
        Some(wgpu::BufferBinding { buffer: memory, offset: raw.begin, size })
    }
}
