//! Finds a GPU and opens it.

use crate::{AdapterInfo, DeviceOptions, Error, Result, SpirvPath};
use muslin_kernel::kernel::{MAX_STORAGE_BUFFERS, MAX_WORKGROUP_BYTES, MAX_WORKGROUP_INVOCATIONS};

fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::PRIMARY;
    // the validation layers come with WGPU_VALIDATION=1
    descriptor.flags = wgpu::InstanceFlags::empty();
    // refuse a buffer before it brings the system down
    descriptor.memory_budget_thresholds.for_resource_creation = Some(95);
    wgpu::Instance::new(wgpu::InstanceDescriptor {
        flags: descriptor.flags.with_env(),
        ..descriptor
    })
}

/// Sort key: the most capable kind of adapter first.
fn rank(kind: wgpu::DeviceType) -> u32 {
    match kind {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    }
}

/// Every GPU that the system offers, the most capable first. Of several with the same name, only the first is listed.
#[must_use]
pub fn adapters() -> Vec<AdapterInfo> {
    let mut adapters = enumerate();
    let mut names = std::collections::HashSet::new();
    adapters.retain(|adapter| names.insert(adapter.get_info().name));
    let describe = |adapter: &wgpu::Adapter| {
        let info = adapter.get_info();
        let driver = [info.backend.to_string(), info.driver, info.driver_info];
        let known: Vec<_> = driver.into_iter().filter(|part| !part.is_empty()).collect();
        AdapterInfo {
            name: info.name,
            driver: known.join(", "),
            passes_through: can_pass_through(adapter),
        }
    };
    adapters.iter().map(describe).collect()
}

/// Every adapter, the most capable first.
fn enumerate() -> Vec<wgpu::Adapter> {
    let mut adapters = pollster::block_on(instance().enumerate_adapters(wgpu::Backends::PRIMARY));
    adapters.sort_by_key(|adapter| rank(adapter.get_info().device_type));
    adapters
}

/// Whether an adapter accepts SPIR-V unchanged.
fn can_pass_through(adapter: &wgpu::Adapter) -> bool {
    passes_through(&adapter.get_info(), adapter.features())
}

fn passes_through(info: &wgpu::AdapterInfo, features: wgpu::Features) -> bool {
    info.backend == wgpu::Backend::Vulkan && features.contains(wgpu::Features::PASSTHROUGH_SHADERS)
}

/// The path of SPIR-V to a device that the program has opened, which must have the limits that kernels may use.
pub fn path_of(device: &wgpu::Device, wanted: Option<SpirvPath>) -> Result<SpirvPath> {
    let info = device.adapter_info();
    path(&info, &device.limits(), wanted, passes_through(&info, device.features()))
}

/// The path of SPIR-V, by default passed through if possible.
fn path(
    info: &wgpu::AdapterInfo,
    limits: &wgpu::Limits,
    wanted: Option<SpirvPath>,
    can_pass_through: bool,
) -> Result<SpirvPath> {
    let name = &info.name;
    require(limits).map_err(|reason| Error::NoGpu { reason: format!("{name} {reason}") })?;
    match wanted {
        Some(SpirvPath::Passthrough) if !can_pass_through => Err(Error::NoGpu {
            reason: format!(
                "{name} ({}) does not take SPIR-V as it is; use `--spirv naga`",
                info.backend
            ),
        }),
        Some(spirv) => Ok(spirv),
        None if can_pass_through => Ok(SpirvPath::Passthrough),
        None => Ok(SpirvPath::Naga),
    }
}

/// The adapter that `options` name, or else the most capable one, and the path of SPIR-V.
pub fn choose(options: &DeviceOptions) -> Result<(wgpu::Adapter, SpirvPath)> {
    let adapters = enumerate();
    if adapters.is_empty() {
        return Err(Error::NoGpu {
            reason: "no Vulkan, Metal or DirectX 12 driver was found".into(),
        });
    }
    let names: Vec<_> = adapters.iter().map(|adapter| adapter.get_info().name).collect();
    let wanted = options.adapter.as_deref().unwrap_or("").to_lowercase();
    let is_wanted =
        |adapter: &wgpu::Adapter| adapter.get_info().name.to_lowercase().contains(&wanted);
    let mut adapters: Vec<_> = adapters.into_iter().filter(is_wanted).collect();
    let kind = |adapter: &wgpu::Adapter| rank(adapter.get_info().device_type);
    let Some(best) = adapters.first().map(kind) else {
        let names = names.join(", ");
        let reason = format!("no adapter's name contains {wanted:?}; there is: {names}");
        return Err(Error::NoGpu { reason });
    };
    adapters.retain(|adapter| kind(adapter) == best);
    let adapter = adapters.swap_remove(options.place % adapters.len());

    let info = adapter.get_info();
    let spirv = path(&info, &adapter.limits(), options.spirv, can_pass_through(&adapter))?;
    Ok((adapter, spirv))
}

/// Fails if an adapter has lower limits than kernels may use. `#[kernel]` refuses kernels that use more.
fn require(limits: &wgpu::Limits) -> std::result::Result<(), String> {
    let needed = [
        ("storage buffers", limits.max_storage_buffers_per_shader_stage, MAX_STORAGE_BUFFERS),
        (
            "bytes of workgroup memory",
            limits.max_compute_workgroup_storage_size,
            MAX_WORKGROUP_BYTES,
        ),
        (
            "invocations in a workgroup",
            limits.max_compute_invocations_per_workgroup,
            MAX_WORKGROUP_INVOCATIONS,
        ),
    ];
    match needed.into_iter().find(|(_, offered, needed)| offered < needed) {
        Some((what, offered, needed)) => {
            Err(format!("has {offered} {what}, but the kernels need {needed}"))
        }
        None => Ok(()),
    }
}

/// What the variants of kernels with 64-bit sums need.
pub const WIDE: wgpu::Features =
    wgpu::Features::SHADER_INT64.union(wgpu::Features::SHADER_INT64_ATOMIC_ALL_OPS);

/// What the variants of kernels with tiles need.
pub const TILES: wgpu::Features =
    wgpu::Features::EXPERIMENTAL_COOPERATIVE_MATRIX.union(wgpu::Features::SHADER_F16);

/// The shapes of an adapter's products of halves with sums of `f32`: rows, columns, and products in a sum.
pub fn tiles(adapter: &wgpu::Adapter) -> Vec<[u32; 3]> {
    use wgpu::CooperativeScalarType::{F16, F32};
    let all = adapter.cooperative_matrix_properties().into_iter();
    let ours =
        all.filter(|of| [of.ab_type, of.cr_type] == [F16, F32] && !of.saturating_accumulation);
    ours.map(|of| [of.m_size, of.n_size, of.k_size]).collect()
}

/// Opens an adapter with its own limits: the default ones end at 128 MiB per binding.
pub fn request(adapter: &wgpu::Adapter, spirv: SpirvPath) -> Result<(wgpu::Device, wgpu::Queue)> {
    let (required_features, experimental_features) = match spirv {
        SpirvPath::Passthrough => {
            // SAFETY: passing shaders through is what is experimental; they are our own compiler's, validated when built
            let experimental = unsafe { wgpu::ExperimentalFeatures::enabled() };
            let tiles =
                if adapter.features().contains(TILES) { TILES } else { wgpu::Features::empty() };
            (wgpu::Features::PASSTHROUGH_SHADERS | adapter.features() & WIDE | tiles, experimental)
        }
        SpirvPath::Naga => (wgpu::Features::empty(), wgpu::ExperimentalFeatures::disabled()),
    };
    // for users who measure kernels, and for kernels that declare subgroups
    let optional = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::SUBGROUP;
    let device = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("muslin"),
        required_features: required_features | (adapter.features() & optional),
        required_limits: adapter.limits(),
        experimental_features,
        ..Default::default()
    }));
    device.map_err(|error| Error::NoGpu {
        reason: format!("{} cannot be opened: {error}", adapter.get_info().name),
    })
}

/// The bytes of a device's largest heap of its own memory. Only Vulkan tells them.
#[cfg(any(windows, target_os = "linux"))]
pub fn memory_bytes(device: &wgpu::Device) -> Option<u64> {
    // SAFETY: the device is only asked, and nothing of it is kept
    let device = unsafe { device.as_hal::<wgpu::hal::api::Vulkan>() }?;
    let instance = device.shared_instance().raw_instance();
    // SAFETY: the physical device belongs to this instance
    let memory =
        unsafe { instance.get_physical_device_memory_properties(device.raw_physical_device()) };
    let heaps = memory.memory_heaps_as_slice().iter();
    let own = heaps.filter(|heap| heap.flags.contains(ash::vk::MemoryHeapFlags::DEVICE_LOCAL));
    own.map(|heap| heap.size).max()
}

/// Unknown: wgpu has no Vulkan here.
#[cfg(not(any(windows, target_os = "linux")))]
pub fn memory_bytes(_: &wgpu::Device) -> Option<u64> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_adapter_below_webgpus_limits_is_refused() {
        let limits = wgpu::Limits::default();
        assert_eq!(require(&limits), Ok(()));
        let few = wgpu::Limits { max_storage_buffers_per_shader_stage: 7, ..limits.clone() };
        assert!(require(&few).unwrap_err().contains("7 storage buffers"));
        let little = wgpu::Limits { max_compute_workgroup_storage_size: 16_383, ..limits.clone() };
        assert!(require(&little).unwrap_err().contains("16383 bytes"));
        let small = wgpu::Limits { max_compute_invocations_per_workgroup: 128, ..limits };
        assert!(require(&small).unwrap_err().contains("128 invocations"));
    }
}
