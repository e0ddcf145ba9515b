//! Runs one kernel on one device.

use bytemuck::Pod;
use glam::Vec4;
use organza_kernel::kernel::{Access, BindingInfo, Dispatch};

use super::given::{self, Given, Uploaded};
use super::measure::Output;
use organza_device::{Buffer, Device, Error, Result};

/// Elements after every output that no kernel may touch.
const TAIL: usize = 8;

/// A device with one kernel under test.
#[derive(Debug)]
pub struct KernelRunner<'d> {
    device: &'d Device,
    kernel: &'static str,
    has_other_canaries: bool,
}

/// Fills an output before the kernel runs: elements that the kernel should not write must keep this value.
pub trait Canary: Pod + PartialEq {
    /// A value that no kernel computes.
    const CANARY: Self;
    /// Another one. A case fills the outputs of one device with this one, and those of the other device with that: a kernel
    /// that computes with what it finds in its output then gives two results.
    const OTHER_CANARY: Self;
}

impl Canary for f32 {
    const CANARY: Self = -12_345.5;
    const OTHER_CANARY: Self = 23_456.25;
}

impl Canary for u32 {
    const CANARY: Self = 0x00c0_ffee;
    const OTHER_CANARY: Self = 0x0bad_cafe;
}

impl Canary for Vec4 {
    const CANARY: Self = Self::splat(f32::CANARY);
    const OTHER_CANARY: Self = Self::splat(f32::OTHER_CANARY);
}

impl<'d> KernelRunner<'d> {
    /// Only the kernel of this name may run.
    #[must_use]
    pub fn new(device: &'d Device, kernel: &'static str) -> Self {
        Self { device, kernel, has_other_canaries: false }
    }

    /// As [`KernelRunner::new`], with [`Canary::OTHER_CANARY`] in the outputs. [`KernelRunner::read`] gives [`Canary::CANARY`] for
    /// it.
    #[must_use]
    pub fn with_other_canaries(device: &'d Device, kernel: &'static str) -> Self {
        Self { has_other_canaries: true, ..Self::new(device, kernel) }
    }

    fn canary<T: Canary>(&self) -> T {
        if self.has_other_canaries { T::OTHER_CANARY } else { T::CANARY }
    }

    /// A buffer that holds `values`.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn upload<T: Pod>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.device.upload("parity input", values)
    }

    /// A buffer of `len` elements to write to, and canaries after them. A device that checks it fails where the kernel reads what
    /// it has not written.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn output<T: Canary>(&self, len: usize) -> Result<Buffer<T>> {
        let buffer = self.output_of(&vec![self.canary::<T>(); len])?;
        self.device.forget(&buffer);
        Ok(buffer)
    }

    /// A buffer of `values` that the kernel writes to, and canaries after them.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn output_of<T: Canary>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.upload(&[values, &[self.canary::<T>(); TAIL]].concat())
    }

    /// What an output holds: the canary where nothing was written.
    ///
    /// # Errors
    /// As [`Device::read`], or if the kernel has written after the output.
    pub fn read<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        self.read_words(buffer, TAIL, self.canary(), T::CANARY)
    }

    /// What an output holds, without `tail` elements that must be as they were; `canary` becomes the usual one.
    fn read_words<T: Pod + PartialEq>(
        &self,
        buffer: &Buffer<T>,
        tail: usize,
        canary: T,
        usual: T,
    ) -> Result<Vec<T>> {
        let mut values = self.device.read(buffer)?;
        let behind = values.split_off(values.len() - tail);
        if behind.iter().any(|value| *value != canary) {
            let reason = "it writes behind its output".into();
            return Err(Error::Kernel { kernel: self.kernel.into(), reason });
        }
        // what was not written is the same on all devices
        values.iter_mut().filter(|value| **value == canary).for_each(|value| *value = usual);
        Ok(values)
    }

    /// What an output holds. The kernel must have written all of it.
    ///
    /// # Errors
    /// As [`KernelRunner::read`], or if an element still holds its canary.
    pub fn read_all<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        let values = self.read(buffer)?;
        match values.iter().position(|value| *value == T::CANARY) {
            Some(index) => {
                let reason = format!("it has not written element {index} of its output");
                Err(Error::Kernel { kernel: self.kernel.into(), reason })
            }
            None => Ok(values),
        }
    }

    /// Runs the kernel on buffers that hold what is given, with at least `items` invocations along x, and always with a
    /// workgroup: an empty input must be left by the kernel's own test. Returns what is in those that it writes, by the names of the bindings.
    ///
    /// # Errors
    /// As [`Device::run`], or if the kernel has written after an output.
    pub fn run<'a>(
        &self,
        kernel: &impl Dispatch<'a, Given>,
        items: u32,
        workgroups_z: u32,
    ) -> Result<Vec<Output>> {
        self.run_given(kernel, |kernel| self.device.run(kernel, items.max(1), workgroups_z.max(1)))
    }

    /// As [`run`](Self::run), over pixels: `side` x `side`, tiles along z.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_over<'a>(
        &self,
        kernel: &impl Dispatch<'a, Given>,
        side: u32,
        tiles: u32,
    ) -> Result<Vec<Output>> {
        self.run_given(kernel, |kernel| self.device.run_over(kernel, [side, side, tiles]))
    }

    fn run_given<'a>(
        &self,
        kernel: &impl Dispatch<'a, Given>,
        dispatch: impl FnOnce(&Uploaded<'_>) -> Result<()>,
    ) -> Result<Vec<Output>> {
        let (info, uniform) = (kernel.info(), kernel.uniform());
        assert_eq!(info.name, self.kernel, "the parity case of `{}` runs another", self.kernel);
        let given = given::words(kernel);
        let buffers = given.iter().map(|(binding, words)| self.upload_given(binding, words));
        let buffers = buffers.collect::<Result<Vec<_>>>()?;
        dispatch(&Uploaded { info, uniform, buffers: &buffers })?;
        let outputs = given.iter().zip(&buffers).filter(|((binding, _), _)| is_written(binding));
        outputs.map(|((binding, _), buffer)| self.output_given(binding, buffer)).collect()
    }

    /// An output of `len` elements for [`run`](Self::run). A device that checks it fails where the kernel reads what it has not
    /// written.
    #[must_use]
    pub fn unwritten<T: Canary>(&self, len: usize) -> Vec<T> {
        vec![self.canary(); len]
    }

    fn upload_given(&self, binding: &BindingInfo, words: &[u32]) -> Result<Buffer<u32>> {
        if !is_written(binding) {
            return self.device.upload(binding.name, words);
        }
        let canary = given::canaries(binding)[usize::from(self.has_other_canaries)];
        let is_unwritten = words.iter().all(|word| *word == canary);
        let words = [words, &vec![canary; tail(binding)]].concat();
        let buffer = self.device.upload(binding.name, &words)?;
        if is_unwritten {
            self.device.forget(&buffer);
        }
        Ok(buffer)
    }

    fn output_given(&self, binding: &BindingInfo, buffer: &Buffer<u32>) -> Result<Output> {
        let canaries = given::canaries(binding);
        let canary = canaries[usize::from(self.has_other_canaries)];
        let words = self.read_words(buffer, tail(binding), canary, canaries[0])?;
        Ok(given::output(binding, words))
    }
}

/// Words behind an output.
fn tail(binding: &BindingInfo) -> usize {
    TAIL * binding.element_bytes as usize / size_of::<u32>()
}

fn is_written(binding: &BindingInfo) -> bool {
    binding.access == Access::Write
}
