//! Which of a kernel's entry points a GPU runs.

use organza_kernel::kernel::{EntryPoint, KernelInfo};

/// Whether a device runs the variants of kernels that have one.
#[derive(Clone, Copy, Debug)]
pub struct Variants(bool);

impl Variants {
    /// For an adapter; `wanted` as [`DeviceOptions::variants`](crate::DeviceOptions::variants).
    pub fn of(adapter: &wgpu::Adapter, wanted: Option<bool>) -> Self {
        // a software device's workgroup memory is memory like all other: docs/performance.md has what that costs
        let is_hardware = adapter.get_info().device_type != wgpu::DeviceType::Cpu;
        Self(wanted.unwrap_or(is_hardware))
    }

    /// The entry point of a kernel.
    pub fn entry_point(self, kernel: &KernelInfo) -> EntryPoint {
        kernel.variant.filter(|_| self.0).unwrap_or(kernel.plain())
    }

    /// For who wants to know.
    pub fn as_str(self) -> &'static str {
        if self.0 { "variants with workgroup memory" } else { "plain kernels" }
    }
}
