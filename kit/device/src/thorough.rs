//! Runs each dispatch in several ways that must agree, because devices differ in them: one of them is without denormals.

use muslin_kernel::kernel::{Access, BindingInfo, CpuBinding, is_far};
use muslin_kernel::{KernelInfo, running, subgroup};

use crate::buffer::{Memory, RawBuffer};
use crate::cpu::Cpu;
use crate::cpu_memory::Written;
use crate::job::{Arithmetic, KernelJob, Order, RunMode};
use crate::races::Monitor;

/// The elements of one binding that a kernel can write.
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

/// How a run differs from the usual one.
#[derive(Clone, Copy)]
enum Other {
    /// The reverse order of invocations.
    Order,
    /// Numbers smaller than any normal number count as zero.
    Flushing,
    /// Other arithmetic.
    Arithmetic(Arithmetic),
    /// Subgroups of other sizes: the usual one and this.
    Subgroups([u32; 2]),
}

/// Runs a dispatch in an order of the invocations, and in all other ways. Any two invocations are run in both orders.
pub fn run(cpu: &Cpu, job: &KernelJob<'_>, seed: u64) -> Result<(), String> {
    let outputs = outputs(job);
    let before: Vec<_> = outputs.iter().map(Output::save).collect();
    let order = Order { seed, is_reversed: false };
    let first = cpu.run_once(job, RunMode { order: Some(order), ..RunMode::default() })?;
    let expected: Vec<_> = outputs.iter().map(Output::save).collect();
    let is_variant = cpu.entry_point(job.info).name != job.info.name;
    let arithmetic = [Arithmetic::Fused, Arithmetic::Regrouped].into_iter();
    let changes = |change| job.info.run_arithmetic[change as usize].is_some() && !is_variant;
    let arithmetic = arithmetic.filter(|change| changes(*change)).map(Other::Arithmetic);
    let sizes = subgroup::SIZES.into_iter().filter(|size| *size != cpu.subgroup_size);
    let sizes = sizes
        .filter(|_| job.info.subgroups)
        .map(|size| Other::Subgroups([cpu.subgroup_size, size]));
    for other in [Other::Order, Other::Flushing].into_iter().chain(arithmetic).chain(sizes) {
        restore(&outputs, &before);
        running::take_regrouped();
        let monitors = other.run(cpu, job, order)?;
        let place = running::take_regrouped();
        for (output, expected) in outputs.iter().zip(&expected) {
            let Some(Some(Monitor::Written(usual))) = first.get(output.index) else { continue };
            let Some(Some(Monitor::Written(races))) = monitors.get(output.index) else { continue };
            let is_atomic = usual.has_atomics() || races.has_atomics();
            if let Some(difference) = output.difference(expected, other, is_atomic) {
                let writer = races.writer(difference.element);
                let place = place.map_or_else(String::new, |place| {
                    format!(", as they may be through naga: see {place}")
                });
                return Err(other.describe(output.info.name, &difference, seed) + &place + &writer);
            }
        }
    }
    restore(&outputs, &expected);
    Ok(())
}

impl Other {
    /// Like the usual run in an order, but for what differs.
    fn mode(self, order: Order) -> RunMode {
        let usual = RunMode { order: Some(order), ..RunMode::default() };
        match self {
            Self::Order => RunMode { order: Some(Order { is_reversed: true, ..order }), ..usual },
            Self::Flushing => RunMode { is_flushing: true, ..usual },
            Self::Arithmetic(change) => RunMode { arithmetic: Some(change), ..usual },
            Self::Subgroups([_, size]) => RunMode { subgroup_size: Some(size), ..usual },
        }
    }

    fn run<'a>(
        self,
        cpu: &Cpu,
        job: &KernelJob<'a>,
        order: Order,
    ) -> Result<Vec<Option<Monitor<'a>>>, String> {
        cpu.run_once(job, self.mode(order)).map_err(|reason| match self {
            Self::Order => reason,
            _ => format!("{}: {reason}", self.place()),
        })
    }

    /// Where it is so.
    fn place(self) -> String {
        match self {
            Self::Order => "in the reverse order".into(),
            Self::Flushing => "where denormals are flushed to zero".into(),
            Self::Arithmetic(Arithmetic::Fused) => {
                "where multiplications and additions are fused".into()
            }
            Self::Arithmetic(Arithmetic::Regrouped) => {
                "where sums and products are regrouped".into()
            }
            Self::Subgroups([_, size]) => format!("in subgroups of {size}"),
        }
    }

    fn describe(self, name: &str, difference: &Difference, seed: u64) -> String {
        let Difference { element, usual, other } = difference;
        let place = self.place();
        match self {
            Self::Order => format!(
                "element {element} of `{name}` depends on the order of invocations: it is {usual}, and {other} {place} (seed {seed})"
            ),
            Self::Subgroups([size, _]) => format!(
                "element {element} of `{name}` depends on the size of subgroups: it is {usual} in subgroups of {size}, and {other} {place}"
            ),
            _ => format!(
                "element {element} of `{name}` depends on the device: it is {usual}, and {other} {place}"
            ),
        }
    }

    /// Whether two words of an output agree. How much a float may differ between devices is not known here: only what is regrouped must not
    /// make another number of it. Integers that are changed
    /// atomically can be floats, too: their bits for a maximum, or fixed-point sums of them. Subgroups change neither.
    fn agree(self, [one, other]: [[u8; 4]; 2], is_float: bool, is_atomic: bool) -> bool {
        let [a, b] = [one, other].map(f32::from_ne_bytes);
        let may_be_far = !matches!(self, Self::Arithmetic(Arithmetic::Regrouped));
        let may_differ = match is_float {
            true => a.is_finite() == b.is_finite() && (may_be_far || !is_far(a, b)),
            false => is_atomic && !matches!(self, Self::Subgroups(..)),
        };
        one == other || may_differ && !matches!(self, Self::Order)
    }
}

/// A value of an output that differs.
struct Difference {
    element: usize,
    usual: String,
    other: String,
}

fn outputs<'a>(job: &KernelJob<'a>) -> Vec<Output<'a>> {
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

    /// The first value that does not agree with what was expected.
    fn difference(&self, expected: &Content, other: Other, is_atomic: bool) -> Option<Difference> {
        let bytes = self.info.element_bytes as usize;
        let sorted = |content: &[u8]| {
            let mut elements: Vec<_> = content.chunks_exact(bytes).collect();
            elements.sort_unstable();
            elements.concat()
        };
        let [usual, found] = match self.is_unordered {
            true => [sorted(&expected.bytes), sorted(self.bytes())],
            false => [expected.bytes.clone(), self.bytes().to_vec()],
        };
        let element = self.info.element.rsplit("::").next().unwrap_or_default().trim();
        let is_float = ["f32", "Vec2", "Vec4"].contains(&element);
        let text = |word: [u8; 4]| match element {
            "i32" => i32::from_ne_bytes(word).to_string(),
            _ if is_float => format!("{:?}", f32::from_ne_bytes(word)),
            _ => u32::from_ne_bytes(word).to_string(),
        };
        let words = usual.as_chunks::<4>().0.iter().zip(found.as_chunks::<4>().0);
        let mut all = words.enumerate().map(|(word, (usual, found))| (word, [*usual, *found]));
        let (word, [usual, found]) =
            all.find(|(_, pair)| !other.agree(*pair, is_float, is_atomic))?;
        Some(Difference { element: word * 4 / bytes, usual: text(usual), other: text(found) })
    }
}

/// While it lives, its thread flushes denormals to zero, where the CPU can do that.
pub struct Flushing {
    #[cfg(target_arch = "x86_64")]
    before: u32,
}

#[cfg(target_arch = "x86_64")]
impl Flushing {
    /// Bits of MXCSR: results are flushed, and denormal arguments are zeros.
    const BITS: u32 = 1 << 15 | 1 << 6;

    pub fn enable() -> Self {
        let mut before = 0_u32;
        // SAFETY: it writes to `before`
        unsafe { std::arch::asm!("stmxcsr [{}]", in(reg) &raw mut before) };
        Self::set(before | Self::BITS);
        Self { before }
    }

    fn set(bits: u32) {
        // SAFETY: The register has no other bits. Compilers compute constants without flushing: such a result
        // equals the usual run's, and then nothing is found.
        unsafe { std::arch::asm!("ldmxcsr [{}]", in(reg) &raw const bits) };
    }
}

#[cfg(target_arch = "x86_64")]
impl Drop for Flushing {
    fn drop(&mut self) {
        Self::set(self.before);
    }
}

#[cfg(not(target_arch = "x86_64"))]
impl Flushing {
    pub fn enable() -> Self {
        Self {}
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use std::hint::black_box;

    use super::*;

    #[test]
    fn a_denormal_is_zero_while_it_lives() {
        // functions that the compiler does not know keep it from moving arithmetic out of here: so do kernels
        let add: fn(f32, f32) -> f32 = black_box(|a, b| a + b);
        let multiply: fn(f32, f32) -> f32 = black_box(|a, b| a * b);
        let results = || [add(1e-40, 0.0), multiply(1e-30, 1e-10)];
        let usual = results();
        let flushing = Flushing::enable();
        let flushed = results();
        drop(flushing);
        assert!(usual.iter().all(|x| *x != 0.0));
        assert_eq!(flushed, [0.0; 2]);
        assert_eq!(results(), usual);
    }
}
