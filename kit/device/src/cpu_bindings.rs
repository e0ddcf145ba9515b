//! The CPU backend's bindings of a kernel: memory, and monitors of its use.

use muslin_kernel::kernel::{Access, BindingInfo, CpuBinding, KernelInfo};
use muslin_kernel::memory::AccessMonitor;

use crate::buffer::{Memory, RawBuffer};
use crate::job::Workgroups;
use crate::races::{Elements, Races, Reads};
use crate::written::Written;

/// The memory of every binding, in order.
pub fn bind(
    info: &KernelInfo,
    uniform: &[u8],
    buffers: &[&RawBuffer],
) -> Result<Vec<CpuBinding<'static>>, String> {
    refuse_swapped(info, buffers)?;
    let mut buffers = buffers.iter();
    let mut bindings = Vec::with_capacity(info.bindings.len());
    for binding in info.bindings {
        let (data, bytes) = match binding.access {
            Access::Uniform => (uniform.as_ptr().cast_mut(), uniform.len()),
            Access::Read | Access::Write => {
                let buffer = buffers.next().expect("the typed dispatch binds every buffer");
                let Memory::Cpu(memory) = &buffer.memory else {
                    panic!("the buffer `{}` belongs to a GPU", buffer.label)
                };
                (memory.data().wrapping_add(buffer.begin as usize), buffer.bytes as usize)
            }
        };
        bindings.push(CpuBinding { data, bytes, monitor: None });
    }
    Ok(bindings)
}

/// Fails if two buffers are bound in each other's place: each has the other binding's name as its label.
fn refuse_swapped(info: &KernelInfo, buffers: &[&RawBuffer]) -> Result<(), String> {
    let bindings = || info.bindings.iter().filter(|info| info.access != Access::Uniform);
    for (at, (info, buffer)) in bindings().zip(buffers).enumerate() {
        for (other, other_buffer) in bindings().zip(buffers).take(at) {
            let are_swapped = buffer.label == other.name && other_buffer.label == info.name;
            // in passes that take turns, one's output is the other's input
            if are_swapped && info.access == other.access {
                let first = other.name;
                let second = info.name;
                return Err(format!(
                    "`{first}` is the buffer `{second}`, and `{second}` is the buffer `{first}`: they are swapped"
                ));
            }
        }
    }
    Ok(())
}

/// Watches the accesses to a binding.
pub enum Monitor<'a> {
    Written(Races<'a>),
    Read(Reads<'a>),
}

impl Monitor<'_> {
    pub fn as_dyn(&self) -> &dyn AccessMonitor {
        match self {
            Self::Written(races) => races,
            Self::Read(reads) => reads,
        }
    }
}

/// A monitor for every binding that is written, or that may have unwritten elements.
pub fn monitors<'a>(
    info: &KernelInfo,
    bindings: &[CpuBinding<'_>],
    buffers: &[&'a RawBuffer],
    workgroups: Workgroups,
) -> Vec<Option<Monitor<'a>>> {
    let mut buffers = buffers.iter();
    let monitor = |(binding_info, binding): (&BindingInfo, &CpuBinding<'_>)| {
        if binding_info.access == Access::Uniform {
            return None;
        }
        let buffer = buffers.next()?;
        let (written, begin): (Option<&Written>, _) = match &buffer.memory {
            Memory::Cpu(memory) => (memory.written(), buffer.begin as usize),
            _ => (None, 0),
        };
        if binding_info.access != Access::Write {
            return Some(Monitor::Read(Reads::new(binding_info, written?, begin)));
        }
        if let Some(written) = written {
            written.set_kernel(info.name, binding_info.name);
        }
        let elements = written.map(|written| Elements::new(binding_info, written, begin));
        let len = binding.bytes / binding_info.element_bytes as usize;
        Some(Monitor::Written(Races::new(info, len, workgroups, elements)))
    };
    info.bindings.iter().zip(bindings).map(monitor).collect()
}
