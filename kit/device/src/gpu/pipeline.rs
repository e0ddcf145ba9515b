//! Compute pipelines, created when a kernel is dispatched for the first time.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use muslin_kernel::{Access, EntryPoint, KernelInfo};
use parking_lot::Mutex;

use crate::gpu::adapter::{TILES, WIDE};
use crate::job::MAX_WORKGROUPS;
use crate::{Error, Modules, Result, SpirvPath};

/// Whether a device runs the variants of kernels.
#[derive(Debug)]
pub struct Variants {
    wanted: bool,
    /// Whether the device has atomics of 64 bits.
    wide: bool,
    /// The shapes of its cooperative matrices.
    tiles: Vec<[u32; 3]>,
    /// The most lanes of a subgroup.
    lanes: u32,
}

impl Variants {
    /// The choice for a device. `wanted` is [`DeviceOptions::variants`](crate::DeviceOptions::variants).
    pub fn new(device: &wgpu::Device, wanted: Option<bool>, mut tiles: Vec<[u32; 3]>) -> Self {
        let info = device.adapter_info();
        // on a software device, workgroup memory is ordinary memory, and slower
        let is_hardware = info.device_type != wgpu::DeviceType::Cpu;
        let features = device.features();
        tiles.retain(|_| features.contains(TILES));
        Self {
            wanted: wanted.unwrap_or(is_hardware),
            wide: features.contains(WIDE),
            tiles,
            lanes: info.subgroup_max_size,
        }
    }

    /// The entry point of a kernel.
    pub fn entry_point(&self, kernel: &KernelInfo) -> EntryPoint {
        let can_run = |point: &EntryPoint| {
            // subgroups are full
            let is_full = kernel.workgroup_size[0].is_multiple_of(self.lanes);
            self.wanted
                && (self.wide || point.sums.is_empty())
                && point.tiles.is_none_or(|shape| is_full && self.tiles.contains(&shape))
        };
        kernel.variant.filter(can_run).unwrap_or(kernel.plain())
    }

    /// The workgroups of a dispatch: with cooperative matrices, each invocation takes a subgroup.
    pub fn workgroups(&self, kernel: &KernelInfo, [x, y, z]: [u32; 3]) -> [u32; 3] {
        if self.entry_point(kernel).tiles.is_none() {
            return [x, y, z];
        }
        let all = u64::from(x) * u64::from(y) * u64::from(self.lanes);
        let x = all.min(MAX_WORKGROUPS.into());
        [x as u32, all.div_ceil(x.max(1)) as u32, z]
    }

    /// The shapes of cooperative matrices that kernels run with.
    pub fn tiles(&self) -> &[[u32; 3]] {
        if self.wanted { &self.tiles } else { &[] }
    }

    /// A description for the user.
    pub fn as_str(&self) -> &'static str {
        match (self.wanted, self.wide) {
            (true, true) => "variants with workgroup memory and 64-bit atomics",
            (true, false) => "variants with workgroup memory",
            (false, _) => "plain kernels",
        }
    }
}

/// A kernel's package and name: different packages can have kernels of the same name.
type Key = (&'static str, &'static str);

/// The pipelines of a device, by kernel.
#[derive(Debug)]
pub struct Pipelines {
    spirv: SpirvPath,
    pub variants: Variants,
    modules: &'static Modules,
    made: Mutex<HashMap<Key, Arc<Pipeline>>>,
}

/// A kernel that is ready to be bound.
#[derive(Debug)]
pub struct Pipeline {
    pub pipeline: wgpu::ComputePipeline,
    pub layout: wgpu::BindGroupLayout,
}

impl Pipelines {
    pub fn new(spirv: SpirvPath, variants: Variants, modules: &'static Modules) -> Self {
        Self { spirv, variants, modules, made: Mutex::default() }
    }

    pub fn get(&self, device: &wgpu::Device, kernel: &'static KernelInfo) -> Result<Arc<Pipeline>> {
        let mut made = self.made.lock();
        if let Some(pipeline) = made.get(&(kernel.package, kernel.name)) {
            return Ok(pipeline.clone());
        }
        let point = self.variants.entry_point(kernel);
        require(kernel, device.features())?;
        let scope = device.push_error_scope(wgpu::ErrorFilter::Validation);
        let module = module(device, kernel, &point, self.spirv, self.modules)?;
        let pipeline = Arc::new(make(device, kernel, &point, &module));
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(Error::Kernel { kernel: point.name.into(), reason: error.to_string() });
        }
        made.insert((kernel.package, kernel.name), pipeline.clone());
        Ok(pipeline)
    }
}

/// Fails if a kernel needs what a device lacks.
fn require(kernel: &KernelInfo, features: wgpu::Features) -> Result<()> {
    if !kernel.subgroups || features.contains(wgpu::Features::SUBGROUP) {
        return Ok(());
    }
    let reason = "it has operations of subgroups, and this GPU's driver offers none: choose another GPU, or the CPU";
    Err(Error::Kernel { kernel: kernel.name.into(), reason: reason.into() })
}

fn make(
    device: &wgpu::Device,
    kernel: &KernelInfo,
    point: &EntryPoint,
    module: &wgpu::ShaderModule,
) -> Pipeline {
    let entries: Vec<_> = kernel
        .bindings
        .iter()
        .zip(0..)
        .map(|(info, binding)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: match info.access {
                    Access::Uniform => wgpu::BufferBindingType::Uniform,
                    Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
                    Access::Write => wgpu::BufferBindingType::Storage { read_only: false },
                },
                // a bind group serves every slot of the uniform buffer
                has_dynamic_offset: info.access == Access::Uniform,
                min_binding_size: None,
            },
            count: None,
        })
        .collect();
    let label = Some(point.name);
    let layout = device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label, entries: &entries });
    let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label,
        bind_group_layouts: &[Some(&layout)],
        ..Default::default()
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label,
        layout: Some(&pipeline_layout),
        module,
        entry_point: Some(point.name),
        // kernels write workgroup memory before they read it, which the CPU run checks
        compilation_options: wgpu::PipelineCompilationOptions {
            zero_initialize_workgroup_memory: false,
            ..Default::default()
        },
        cache: None,
    });
    Pipeline { pipeline, layout }
}

fn module(
    device: &wgpu::Device,
    kernel: &KernelInfo,
    point: &EntryPoint,
    spirv: SpirvPath,
    modules: &'static Modules,
) -> Result<wgpu::ShaderModule> {
    let words = modules.compiled_kernel(kernel, point)?.spirv_words();
    let label = Some(point.name);
    let [x, y, z] = kernel.workgroup_size;
    Ok(match spirv {
        // SAFETY: our own compiler's output, validated when it was built; the CPU run checks every index
        SpirvPath::Passthrough => unsafe {
            device.create_shader_module_passthrough(wgpu::ShaderModuleDescriptorPassthrough {
                label,
                entry_points: Cow::Owned(vec![wgpu::PassthroughShaderEntryPoint {
                    name: point.name.into(),
                    workgroup_size: (x, y, z),
                }]),
                spirv: Some(words),
                ..Default::default()
            })
        },
        // SAFETY: as above; naga's own checks would add exits inside of loops, which it miscompiles
        SpirvPath::Naga => unsafe {
            device.create_shader_module_trusted(
                wgpu::ShaderModuleDescriptor { label, source: wgpu::ShaderSource::SpirV(words) },
                wgpu::ShaderRuntimeChecks::unchecked(),
            )
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use muslin_kernel::prelude::*;

    /// Writes the sum of each subgroup.
    #[kernel(threads(64), subgroups)]
    pub fn sums(id: Invocation, output: Write<u32>) {
        output.write(id.index(), id.subgroup_sum(id.local.x));
    }

    #[test]
    fn subgroups_need_a_device_that_has_them() {
        let all = wgpu::Features::all();
        require(&SUMS_KERNEL, all).expect("every feature");
        let error = require(&SUMS_KERNEL, all - wgpu::Features::SUBGROUP).unwrap_err();
        assert!(error.to_string().starts_with("kernel `sums`: it has operations of subgroups"));
    }
}
