//! Chooses between a kernel's plain entry point and its variant, on a GPU.

use muslin_kernel::kernel::{EntryPoint, KernelInfo};

/// Whether a device runs the variants of kernels.
#[derive(Clone, Copy, Debug)]
pub struct Variants(bool);

impl Variants {
    /// The choice for an adapter. `wanted` is [`DeviceOptions::variants`](crate::DeviceOptions::variants).
    pub fn new(adapter: &wgpu::Adapter, wanted: Option<bool>) -> Self {
        // on a software device, workgroup memory is ordinary memory, and slower
        let is_hardware = adapter.get_info().device_type != wgpu::DeviceType::Cpu;
        Self(wanted.unwrap_or(is_hardware))
    }

    /// The entry point of a kernel.
    pub fn entry_point(self, kernel: &KernelInfo) -> EntryPoint {
        kernel.variant.filter(|_| self.0).unwrap_or(kernel.plain())
    }

    /// A description for the user.
    pub fn as_str(self) -> &'static str {
        if self.0 { "variants with workgroup memory" } else { "plain kernels" }
    }
}
