//! Asks RADV, and reads its assembly.

use std::ffi::{CStr, CString};
use std::fs;
use std::path::Path;

use ash::khr::pipeline_executable_properties;
use ash::{Device, Entry, Instance, vk};
use muslin_manifest::{KernelEntry, Manifest};
use serde::{Deserialize, Serialize};

use crate::{Error, Kernel, Report};

/// Compiles the kernels of a folder. The environment already names the family.
pub fn report(folder: &Path, family: &str) -> Result<Report, Error> {
    let failed = |reason: &dyn std::fmt::Display| Error::Failed(format!("{family}: {reason}"));
    let manifest = Manifest::load(folder).map_err(|error| failed(&error))?;
    let compiler = Compiler::new(family)?;
    let compile = |entry: &KernelEntry| {
        let spirv = fs::read(folder.join(&entry.spirv));
        let spirv = spirv.map_err(|error| failed(&format_args!("{}: {error}", entry.spirv)))?;
        compiler.compile(entry, &spirv).map_err(|reason| {
            failed(&format_args!("the driver does not compile `{}`: {reason}", entry.name))
        })
    };
    // the device is opened without cooperative matrices, which older families lack
    let kernels = manifest.kernels.iter().filter(|entry| entry.interface.tiles.is_none());
    let kernels = kernels.map(compile).collect::<Result<_, _>>()?;
    Ok(Report { family: family.into(), driver: compiler.version.clone(), kernels })
}

/// RADV's device without hardware. It is not torn down: the process ends after it.
struct Compiler {
    device: Device,
    statistics: pipeline_executable_properties::Device,
    version: String,
    // keeps the loader
    _entry: Entry,
}

impl Compiler {
    fn new(family: &str) -> Result<Self, Error> {
        let missing = |reason: &dyn std::fmt::Display| Error::NoDriver {
            family: family.into(),
            reason: reason.to_string(),
        };
        // SAFETY: Vulkan's loader does nothing unsound when it is loaded.
        let entry = unsafe { Entry::load() }.map_err(|error| missing(&error))?;
        let application = vk::ApplicationInfo::default().api_version(vk::API_VERSION_1_2);
        let info = vk::InstanceCreateInfo::default().application_info(&application);
        // SAFETY: the description is complete, and lives until the call returns.
        let instance = unsafe { entry.create_instance(&info, None) };
        let instance = instance.map_err(|error| missing(&error))?;
        // SAFETY: the instance is alive.
        let all = unsafe { instance.enumerate_physical_devices() };
        let all = all.map_err(|error| missing(&error))?;
        let found = all.into_iter().find_map(|device| Some((device, radv(&instance, device)?)));
        let (physical, version) = found.ok_or_else(|| missing(&"Vulkan finds no such device"))?;
        let device = open(&instance, physical).map_err(|error| missing(&error))?;
        let statistics = pipeline_executable_properties::Device::new(&instance, &device);
        Ok(Self { device, statistics, version, _entry: entry })
    }

    /// Compiles one kernel, with the features and the layout that it has on a device of wgpu's.
    fn compile(&self, entry: &KernelEntry, spirv: &[u8]) -> Result<Kernel, String> {
        let pipeline = self.pipeline(entry, spirv).map_err(|error| error.to_string())?;
        let info = vk::PipelineExecutableInfoKHR::default().pipeline(pipeline);
        // SAFETY: the pipeline was made with a flag that lets it be asked.
        let all = unsafe { self.statistics.get_pipeline_executable_statistics(&info) };
        let all = all.map_err(|error| error.to_string())?;
        let value = |name: &str| {
            let is_it = |found: &&vk::PipelineExecutableStatisticKHR<'_>| {
                found.name_as_c_str().is_ok_and(|found| found.to_bytes() == name.as_bytes())
            };
            let found = all.iter().find(is_it).ok_or(format!("it does not tell its {name}"))?;
            // SAFETY: all statistics of RADV are unsigned 64-bit numbers.
            Ok::<u64, String>(unsafe { found.value.u64 })
        };
        let assembly = self.assembly(&info).map_err(|error| error.to_string())?;
        Ok(Kernel {
            name: entry.name.clone(),
            registers: value("VGPRs")?,
            spills: value("Spilled SGPRs")? + value("Spilled VGPRs")?,
            scratch: value("Scratch size")?,
            shared: value("LDS size")?,
            subgroups: value("Subgroups per SIMD")?,
            instructions: value("Instructions")?,
            integer_multiplies: integer_multiplies(&assembly),
            loops: loops(&assembly),
        })
    }

    fn pipeline(&self, entry: &KernelEntry, spirv: &[u8]) -> Result<vk::Pipeline, vk::Result> {
        let words: Vec<u32> = spirv
            .chunks_exact(4)
            .map(|word| u32::from_le_bytes(word.try_into().unwrap()))
            .collect();
        let bindings = entry.interface.bindings.iter().zip(0..).map(|(binding, number)| {
            vk::DescriptorSetLayoutBinding::default()
                .binding(number)
                .descriptor_count(1)
                .stage_flags(vk::ShaderStageFlags::COMPUTE)
                .descriptor_type(match binding.access.as_str() {
                    "uniform" => vk::DescriptorType::UNIFORM_BUFFER,
                    _ => vk::DescriptorType::STORAGE_BUFFER,
                })
        });
        let bindings: Vec<_> = bindings.collect();
        let name = CString::new(entry.name.as_str()).unwrap_or_default();
        let flags = vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR
            | vk::PipelineCreateFlags::CAPTURE_INTERNAL_REPRESENTATIONS_KHR;
        // SAFETY: the kernel builder has checked the module against the manifest, and every description lives until its call returns.
        unsafe {
            let module = vk::ShaderModuleCreateInfo::default().code(&words);
            let module = self.device.create_shader_module(&module, None)?;
            let layout = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            let sets = [self.device.create_descriptor_set_layout(&layout, None)?];
            let layout = vk::PipelineLayoutCreateInfo::default().set_layouts(&sets);
            let layout = self.device.create_pipeline_layout(&layout, None)?;
            let stage = vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::COMPUTE)
                .module(module)
                .name(&name);
            let info =
                vk::ComputePipelineCreateInfo::default().flags(flags).stage(stage).layout(layout);
            let made =
                self.device.create_compute_pipelines(vk::PipelineCache::null(), &[info], None);
            made.map(|all| all[0]).map_err(|(_, error)| error)
        }
    }

    /// The text of the machine code.
    fn assembly(&self, info: &vk::PipelineExecutableInfoKHR<'_>) -> Result<String, vk::Result> {
        // SAFETY: the pipeline was made with a flag that lets it be asked.
        let all = unsafe { self.statistics.get_pipeline_executable_internal_representations(info) };
        let mut all = all?;
        let mut texts: Vec<Vec<u8>> = all.iter().map(|one| vec![0; one.data_size]).collect();
        for (one, text) in all.iter_mut().zip(&mut texts) {
            one.p_data = text.as_mut_ptr().cast();
        }
        let mut count = u32::try_from(all.len()).unwrap_or_default();
        let ask = self.statistics.fp().get_pipeline_executable_internal_representations_khr;
        // SAFETY: there is as much room for each text as the driver has asked for.
        unsafe { ask(self.device.handle(), info, &mut count, all.as_mut_ptr()) }.result()?;
        let at = all.iter().position(|one| one.name_as_c_str() == Ok(c"Assembly"));
        let text = at.map(|at| String::from_utf8_lossy(&texts[at]).into_owned());
        Ok(text.unwrap_or_default())
    }
}

/// The driver's version, such as `Mesa 22.3.6`; nothing if it is another driver.
fn radv(instance: &Instance, device: vk::PhysicalDevice) -> Option<String> {
    let mut driver = vk::PhysicalDeviceDriverProperties::default();
    let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut driver);
    // SAFETY: the device is the instance's.
    unsafe { instance.get_physical_device_properties2(device, &mut properties) };
    let text = |text: Result<&CStr, _>| text.ok().map(|text| text.to_string_lossy().into_owned());
    (driver.driver_id == vk::DriverId::MESA_RADV)
        .then(|| text(driver.driver_info_as_c_str()))
        .flatten()
}

/// Opens a device with all that it offers; buffers are checked as wgpu has them checked.
fn open(instance: &Instance, physical: vk::PhysicalDevice) -> Result<Device, vk::Result> {
    let mut robust = vk::PhysicalDeviceRobustness2FeaturesEXT::default();
    let mut of_1_1 = vk::PhysicalDeviceVulkan11Features::default();
    let mut of_1_2 = vk::PhysicalDeviceVulkan12Features::default();
    let mut executable = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default();
    let mut features = vk::PhysicalDeviceFeatures2::default()
        .push_next(&mut robust)
        .push_next(&mut of_1_1)
        .push_next(&mut of_1_2)
        .push_next(&mut executable);
    // SAFETY: the device is the instance's.
    unsafe { instance.get_physical_device_features2(physical, &mut features) };
    let queue = [vk::DeviceQueueCreateInfo::default().queue_priorities(&[1.0])];
    let extensions =
        [pipeline_executable_properties::NAME.as_ptr(), ash::ext::robustness2::NAME.as_ptr()];
    let info = vk::DeviceCreateInfo::default()
        .queue_create_infos(&queue)
        .enabled_extension_names(&extensions)
        .push_next(&mut features);
    // SAFETY: the features are those that the device offers.
    unsafe { instance.create_device(physical, &info, None) }
}

/// An innermost loop.
#[derive(Debug, Serialize, Deserialize)]
pub struct Loop {
    /// All its instructions.
    pub instructions: usize,
    /// Copies from one vector register to another.
    pub moves: usize,
    /// Multiply-adds of floats.
    pub multiply_adds: usize,
    /// Multiplications of 32-bit integers.
    pub integer_multiplies: usize,
    /// Loads of one value for each invocation, from buffers and from workgroup memory.
    pub loads: usize,
    /// Loads of values that are the same for the whole subgroup.
    pub scalar_loads: usize,
}

/// A block without branches, but for its end.
struct Block<'a> {
    label: &'a str,
    lines: Vec<&'a str>,
}

/// The innermost loops of a kernel, the largest first.
pub fn loops(assembly: &str) -> Vec<Loop> {
    let blocks = blocks(assembly);
    let mut spans = Vec::new();
    for (end, block) in blocks.iter().enumerate() {
        for line in &block.lines {
            let target = line.strip_prefix("s_").and_then(|_| line.split_whitespace().nth(1));
            let is_branch = line.starts_with("s_branch") || line.starts_with("s_cbranch");
            let start = blocks[..=end].iter().position(|block| Some(block.label) == target);
            spans.extend(start.filter(|_| is_branch).map(|start| (start, end)));
        }
    }
    // A loop may branch back from several places.
    let merged: Vec<(usize, usize)> = spans
        .iter()
        .map(|&(start, _)| (start, spans.iter().filter(|s| s.0 == start).map(|s| s.1).max()))
        .filter_map(|(start, end)| Some((start, end?)))
        .collect();
    let contains = |a: &(usize, usize), b: &(usize, usize)| a != b && a.0 <= b.0 && b.1 <= a.1;
    let mut innermost: Vec<_> =
        merged.iter().filter(|&a| !merged.iter().any(|b| contains(a, b))).collect();
    innermost.dedup();
    let mut loops: Vec<Loop> =
        innermost.iter().map(|&&(start, end)| measure(&blocks[start..=end])).collect();
    loops.sort_by_key(|it| std::cmp::Reverse(it.instructions));
    loops
}

/// The multiplications of integers that a GPU takes long for: products of numbers of 24 bits are not among them.
pub fn integer_multiplies(assembly: &str) -> usize {
    let all = blocks(assembly);
    all.iter().map(|block| count(&block.lines, &INTEGER_MULTIPLIES)).sum()
}

const INTEGER_MULTIPLIES: [&str; 4] = ["v_mul_lo_", "v_mul_hi_", "v_mad_u64_", "v_mad_i64_"];

/// How many lines begin with one of these names.
fn count(lines: &[&str], names: &[&str]) -> usize {
    lines.iter().filter(|line| names.iter().any(|name| line.starts_with(name))).count()
}

/// Splits a text such as `BB3:`, then lines such as `s_add_u32 s0, s6, s7 ; 80000706`.
fn blocks(assembly: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    for line in assembly.lines() {
        if let Some(label) = line.strip_suffix(':').filter(|label| label.starts_with("BB")) {
            blocks.push(Block { label, lines: Vec::new() });
        } else if let (Some(block), Some(line)) = (blocks.last_mut(), line.strip_prefix('\t')) {
            block.lines.push(line.split(';').next().unwrap_or_default().trim_end());
        }
    }
    blocks
}

fn measure(blocks: &[Block<'_>]) -> Loop {
    let lines: Vec<&str> = blocks.iter().flat_map(|block| &block.lines).copied().collect();
    let count = |names: &[&str]| count(&lines, names);
    Loop {
        instructions: lines.len(),
        moves: count(&["v_mov_"]),
        multiply_adds: count(&["v_fma", "v_mac_f", "v_mad_f", "v_pk_fma", "v_madmk", "v_madak"]),
        integer_multiplies: count(&INTEGER_MULTIPLIES),
        loads: count(&["buffer_load", "global_load", "ds_read"]),
        scalar_loads: count(&["s_buffer_load", "s_load"]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_LOOPS: &str = include_str!("../tests/two_loops.txt");

    #[test]
    fn the_loops_that_hold_no_other_are_found() {
        let found = loops(TWO_LOOPS);
        let sizes: Vec<_> = found.iter().map(|it| it.instructions).collect();
        // BB1's has BB2's within, and a branch forward is none
        assert_eq!(sizes, [4, 3]);
        let [inner, last] = &found[..] else { panic!() };
        let counts = |it: &Loop| {
            [it.moves, it.multiply_adds, it.integer_multiplies, it.loads, it.scalar_loads]
        };
        assert_eq!(counts(inner), [0, 1, 1, 1, 0]);
        assert_eq!(counts(last), [0, 0, 0, 0, 1]);
        assert_eq!(integer_multiplies(TWO_LOOPS), 1);
    }
}
