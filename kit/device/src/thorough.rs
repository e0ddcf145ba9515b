//! Runs each dispatch in several ways that must agree: GPUs differ in them.

use organza_kernel::KernelInfo;
use organza_kernel::kernel::{Access, BindingInfo, CpuBinding};

use crate::buffer::{Memory, RawBuffer};
use crate::cpu::Cpu;
use crate::cpu_bindings::Monitor;
use crate::cpu_dispatch::Job;
use crate::order::Order;
use crate::written::Written;

/// What a kernel can write of one binding.
struct Output<'a> {
    /// Number of the binding.
    index: usize,
    info: &'static BindingInfo,
    /// Whether its elements come in any order.
    is_unordered: bool,
    binding: CpuBinding<'a>,
    written: Option<&'a Written>,
}

/// The content of an output.
struct Content {
    bytes: Vec<u8>,
    flags: Option<Vec<u8>>,
}

/// Runs a dispatch in an order of the invocations and in the reverse one. Any two of them are run in both orders.
pub fn run(cpu: &Cpu, job: &Job<'_>, seed: u64) -> Result<(), String> {
    let outputs = outputs(job);
    let before: Vec<_> = outputs.iter().map(Output::save).collect();
    let order = Order { seed, is_reversed: false };
    cpu.run_once(job, Some(order))?;
    let expected: Vec<_> = outputs.iter().map(Output::save).collect();
    let reverse = Order { is_reversed: true, ..order };
    restore(&outputs, &before);
    let monitors = cpu.run_once(job, Some(reverse))?;
    for (output, expected) in outputs.iter().zip(&expected) {
        let Some((element, [one, other])) = output.difference(expected) else { continue };
        let writer = match monitors.get(output.index) {
            Some(Some(Monitor::Written(races))) => races.writer(element),
            _ => String::new(),
        };
        let name = output.info.name;
        return Err(format!(
            "element {element} of `{name}` depends on the order of invocations: it is {one}, and {other} in the reverse \
             order (seed {seed}){writer}"
        ));
    }
    restore(&outputs, &expected);
    Ok(())
}

fn outputs<'a>(job: &Job<'a>) -> Vec<Output<'a>> {
    let mut buffers = job.buffers.iter();
    let output = |(index, info): (usize, &'static BindingInfo)| {
        let buffer: &RawBuffer =
            if info.access == Access::Uniform { None } else { buffers.next() }?;
        if info.access != Access::Write {
            return None;
        }
        let written = match &buffer.memory {
            Memory::Cpu(memory) => memory.written(),
            _ => None,
        };
        let is_unordered = is_unordered(job.info, info);
        Some(Output { index, info, is_unordered, binding: job.bindings[index], written })
    };
    job.info.bindings.iter().enumerate().filter_map(output).collect()
}

fn is_unordered(kernel: &KernelInfo, binding: &BindingInfo) -> bool {
    kernel.unordered.contains(&binding.name)
}

fn restore(outputs: &[Output<'_>], contents: &[Content]) {
    for (output, content) in outputs.iter().zip(contents) {
        output.restore(content);
    }
}

impl Output<'_> {
    fn bytes(&self) -> &[u8] {
        // SAFETY: the bytes of a buffer, and no dispatch runs
        unsafe { std::slice::from_raw_parts(self.binding.data, self.binding.bytes) }
    }

    fn save(&self) -> Content {
        let flags = self.written.map(Written::save);
        Content { bytes: self.bytes().to_vec(), flags }
    }

    fn restore(&self, content: &Content) {
        // SAFETY: as in `bytes`; the content is as long as the buffer
        unsafe { self.binding.data.copy_from(content.bytes.as_ptr(), content.bytes.len()) };
        if let (Some(written), Some(flags)) = (self.written, &content.flags) {
            written.restore(flags);
        }
    }

    /// The first element that differs from what was expected, and both values.
    fn difference(&self, expected: &Content) -> Option<(usize, [String; 2])> {
        let bytes = self.info.element_bytes as usize;
        let sorted = |content: &[u8]| {
            let mut elements: Vec<_> = content.chunks_exact(bytes).map(<[u8]>::to_vec).collect();
            elements.sort_unstable();
            elements.concat()
        };
        let [one, other] = match self.is_unordered {
            true => [sorted(&expected.bytes), sorted(self.bytes())],
            false => [expected.bytes.clone(), self.bytes().to_vec()],
        };
        let words = one.chunks_exact(4).zip(other.chunks_exact(4));
        let (word, pair) = words.enumerate().find(|(_, (one, other))| one != other)?;
        let text = |word: &[u8]| self.text(word.try_into().unwrap_or_default());
        Some((word * 4 / bytes, [text(pair.0), text(pair.1)]))
    }

    /// A word of the binding, as a number.
    fn text(&self, word: [u8; 4]) -> String {
        match self.info.element.rsplit("::").next().unwrap_or_default().trim() {
            "f32" | "Vec2" | "Vec4" => format!("{:?}", f32::from_ne_bytes(word)),
            "i32" => i32::from_ne_bytes(word).to_string(),
            _ => u32::from_ne_bytes(word).to_string(),
        }
    }
}
