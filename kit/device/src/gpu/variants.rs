//! Which of a kernel's entry points a GPU runs.

use organza_kernel::kernel::{EntryPoint, KernelInfo, Variant};

/// The variants that a device takes; plain entry points for all other kernels.
#[derive(Clone, Copy, Debug)]
pub struct Variants {
    staged: bool,
    subgroups: bool,
}

impl Variants {
    /// Those of an adapter; `wanted` as [`DeviceOptions::variants`](crate::DeviceOptions::variants).
    pub fn of(adapter: &wgpu::Adapter, wanted: Option<bool>) -> Self {
        // a software device's workgroup memory is memory like all other: docs/performance.md has what that costs
        let is_hardware = adapter.get_info().device_type != wgpu::DeviceType::Cpu;
        let wanted = wanted.unwrap_or(is_hardware);
        let has_subgroups = adapter.features().contains(wgpu::Features::SUBGROUP);
        Self { staged: wanted, subgroups: wanted && has_subgroups }
    }

    /// What a device must be asked for.
    pub fn features(self) -> wgpu::Features {
        if self.subgroups { wgpu::Features::SUBGROUP } else { wgpu::Features::empty() }
    }

    /// The entry point of a kernel.
    pub fn entry_point(self, kernel: &KernelInfo) -> EntryPoint {
        let takes = |point: &EntryPoint| match point.variant {
            None => true,
            Some(Variant::Staged) => self.staged,
            Some(Variant::Subgroups) => self.subgroups,
        };
        kernel.entry_points().filter(takes).last().unwrap_or(kernel.plain())
    }

    /// For who wants to know.
    pub fn as_str(self) -> &'static str {
        match (self.staged, self.subgroups) {
            (true, true) => "variants with workgroup memory and subgroups",
            (true, false) => "variants with workgroup memory",
            _ => "plain kernels",
        }
    }
}
