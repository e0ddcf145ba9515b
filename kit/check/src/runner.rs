//! Runs one kernel on one device, with given contents of its bindings.

use bytemuck::Pod;
use glam::{IVec2, IVec4, UVec2, UVec4, Vec2, Vec4};
use muslin_kernel::given::Given;
use muslin_kernel::kernel::{Access, BindingInfo, Dispatch, Items, Storage};

use super::measure::Output;
use muslin_device::{Buffer, Device, Error, Host, Result};
use muslin_kernel::KernelInfo;

/// Number of elements after every output that no kernel may touch.
const TAIL: usize = 8;

/// A device with one kernel under test.
#[derive(Debug)]
pub struct KernelRunner<'d> {
    device: &'d Device,
    kernel: &'static str,
    has_other_canaries: bool,
}

impl<'d> KernelRunner<'d> {
    /// A runner for one kernel: only the kernel of this name may run.
    #[must_use]
    pub fn new(device: &'d Device, kernel: &'static str) -> Self {
        Self { device, kernel, has_other_canaries: false }
    }

    /// Like [`KernelRunner::new`], but with [`Canary::OTHER_CANARY`] in the outputs. [`KernelRunner::read`] returns
    /// it as [`Canary::CANARY`].
    #[must_use]
    pub fn with_other_canaries(device: &'d Device, kernel: &'static str) -> Self {
        Self { has_other_canaries: true, ..Self::new(device, kernel) }
    }

    fn canary<T: Canary>(&self) -> T {
        if self.has_other_canaries { T::OTHER_CANARY } else { T::CANARY }
    }

    /// A buffer that contains `values`.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    pub fn upload<T: Pod>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.device.upload("parity input", values)
    }

    /// A buffer of `len` elements for output, followed by canaries. On a device that checks it, a kernel fails if it
    /// reads an element that it has not written.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    pub fn output<T: Canary>(&self, len: usize) -> Result<Buffer<T>> {
        let buffer = self.output_of(&vec![self.canary::<T>(); len])?;
        self.device.forget(&buffer);
        Ok(buffer)
    }

    /// A buffer of `values` that the kernel may write to, followed by canaries.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    pub fn output_of<T: Canary>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.upload(&[values, &[self.canary::<T>(); TAIL]].concat())
    }

    /// Reads an output. Unwritten elements are canaries.
    ///
    /// # Errors
    /// The same errors as [`Device::read`], or an error if the kernel has written after the output's end.
    pub fn read<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        self.read_words(buffer, TAIL, self.canary(), T::CANARY)
    }

    /// Reads an output without its last `tail` elements, which must be canaries. Other canaries become `usual`.
    fn read_words<T: Pod + PartialEq>(
        &self,
        buffer: &Buffer<T>,
        tail: usize,
        canary: T,
        usual: T,
    ) -> Result<Vec<T>> {
        let mut values = self.device.read_unchecked(buffer)?;
        let behind = values.split_off(values.len() - tail);
        if behind.iter().any(|value| *value != canary) {
            let reason = "it writes behind its output".into();
            return Err(Error::Kernel { kernel: self.kernel.into(), reason });
        }
        // unwritten elements get the same value on all devices
        values.iter_mut().filter(|value| **value == canary).for_each(|value| *value = usual);
        Ok(values)
    }

    /// Reads an output that the kernel must have written entirely.
    ///
    /// # Errors
    /// The same errors as [`KernelRunner::read`], or an error if an element still is a canary. On a device that checks, also the
    /// errors of [`Device::read`].
    pub fn read_all<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        let values = self.read(buffer)?;
        self.device.read_range(buffer, 0, values.len())?;
        match values.iter().position(|value| *value == T::CANARY) {
            Some(index) => {
                let reason = format!("it has not written element {index} of its output");
                Err(Error::Kernel { kernel: self.kernel.into(), reason })
            }
            None => Ok(values),
        }
    }

    /// Uploads the inputs, and runs the kernel over its declared size, but with at least one workgroup: the kernel itself must
    /// test for an empty input. Returns the outputs, by the names of the bindings.
    ///
    /// # Errors
    /// The same errors as [`Device::run`], or an error if the kernel has written after an output's end.
    ///
    /// # Panics
    /// If the kernel does not declare a size (`over`).
    pub fn run<'a>(&self, kernel: &impl Dispatch<'a, Given>) -> Result<Vec<Output>> {
        let info = kernel.info();
        let uniform = kernel.uniform();
        assert_eq!(info.name, self.kernel, "the parity case of `{}` runs another", self.kernel);
        let given = contents(kernel);
        let buffers = given.iter().map(|(binding, bytes)| self.upload_given(binding, bytes));
        let buffers = buffers.collect::<Result<Vec<_>>>()?;
        let over = info.over.unwrap_or_else(|| {
            panic!("`{}` does not say what it runs over: `#[kernel(.., over(..))]`", info.name)
        });
        let len = |(binding, bytes): &(&BindingInfo, &[u8])| {
            bytes.len() as u64 / u64::from(binding.element_bytes)
        };
        let elements: Vec<_> = given.iter().map(len).collect();
        let kernel = Uploaded { info, uniform, buffers: &buffers };
        match over(uniform, &elements) {
            Items::Line(items, z) => self.device.run(&kernel, items.max(1), z.max(1))?,
            Items::Grid(size) => self.device.run_over(&kernel, size)?,
        }
        let outputs = given.iter().zip(&buffers).filter(|((binding, _), _)| is_written(binding));
        outputs.map(|((binding, _), buffer)| self.output_given(binding, buffer)).collect()
    }

    fn upload_given(&self, binding: &BindingInfo, bytes: &[u8]) -> Result<Buffer<u8>> {
        if !is_written(binding) {
            return self.device.upload(binding.name, bytes);
        }
        let mut words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
        let canaries = canaries(binding);
        let canary = canaries[usize::from(self.has_other_canaries)];
        let is_unwritten = words.iter().all(|word| *word == canaries[0]);
        let len = words.len() + tail(binding);
        if is_unwritten {
            words.clear();
        }
        words.resize(len, canary);
        let buffer = self.device.upload(binding.name, &words)?;
        if is_unwritten {
            self.device.forget(&buffer);
        }
        Ok(buffer.view())
    }

    fn output_given(&self, binding: &BindingInfo, buffer: &Buffer<u8>) -> Result<Output> {
        let canaries = canaries(binding);
        let canary = canaries[usize::from(self.has_other_canaries)];
        let words = self.read_words(&buffer.view(), tail(binding), canary, canaries[0])?;
        Ok(output(binding, words))
    }
}

/// Words behind an output.
fn tail(binding: &BindingInfo) -> usize {
    TAIL * binding.element_bytes as usize / size_of::<u32>()
}

fn is_written(binding: &BindingInfo) -> bool {
    binding.access == Access::Write
}

/// Fills an output before the kernel runs: elements that the kernel should not write must keep this value.
pub trait Canary: Pod + PartialEq {
    /// A value that no kernel computes.
    const CANARY: Self;
    /// Another value that no kernel computes. A case fills the outputs with this value on one device, and with
    /// [`Canary::CANARY`] on the other. A kernel that reads its unwritten output then gives two different results.
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

impl Canary for i32 {
    const CANARY: Self = u32::CANARY.cast_signed();
    const OTHER_CANARY: Self = u32::OTHER_CANARY.cast_signed();
}

macro_rules! vectors {
    ($($vector:ty: $element:ty;)*) => {$(
        impl Canary for $vector {
            const CANARY: Self = Self::splat(<$element>::CANARY);
            const OTHER_CANARY: Self = Self::splat(<$element>::OTHER_CANARY);
        }
    )*};
}

vectors! {
    Vec2: f32;
    Vec4: f32;
    UVec2: u32;
    UVec4: u32;
    IVec2: i32;
    IVec4: i32;
}

/// An output of `len` elements for [`KernelRunner::run`](crate::KernelRunner::run), which no kernel has written. If the kernel reads an element before it
/// writes it, a device with checks reports that.
#[must_use]
pub fn unwritten<T: Canary>(len: usize) -> Vec<T> {
    vec![T::CANARY; len]
}

/// The contents of a kernel's storage buffers.
fn contents<'a>(kernel: &impl Dispatch<'a, Given>) -> Vec<(&'static BindingInfo, &'a [u8])> {
    let mut given = Vec::new();
    kernel.bind(&mut |bytes| given.push(bytes));
    let bindings = kernel.info().bindings.iter();
    bindings.filter(|binding| binding.access != Access::Uniform).zip(given).collect()
}

/// The type of a binding's elements, without its path.
fn element(binding: &BindingInfo) -> &str {
    binding.element.rsplit(':').next().unwrap_or_default().trim()
}

/// Whether a binding has numbers that may differ by rounding.
fn is_float(binding: &BindingInfo) -> bool {
    ["f32", "Vec2", "Vec4"].contains(&element(binding))
}

/// A word that no kernel computes, and another one.
fn canaries(binding: &BindingInfo) -> [u32; 2] {
    match is_float(binding) {
        true => [f32::CANARY.to_bits(), f32::OTHER_CANARY.to_bits()],
        false => [u32::CANARY, u32::OTHER_CANARY],
    }
}

/// The outputs of a kernel, by the names of their bindings.
fn output(binding: &BindingInfo, words: Vec<u32>) -> Output {
    match element(binding) {
        _ if is_float(binding) => {
            Output::float(binding.name, words.into_iter().map(f32::from_bits))
        }
        "i32" | "IVec2" | "IVec4" => {
            Output::exact(binding.name, words.into_iter().map(u32::cast_signed))
        }
        _ => Output::exact(binding.name, words),
    }
}

/// A kernel with buffers of a device.
struct Uploaded<'a> {
    pub info: &'static KernelInfo,
    pub uniform: &'a [u8],
    pub buffers: &'a [Buffer<u8>],
}

impl<'a> Dispatch<'a, Host> for Uploaded<'a> {
    fn info(&self) -> &'static KernelInfo {
        self.info
    }

    fn uniform(&self) -> &[u8] {
        self.uniform
    }

    fn bind(&self, visit: &mut dyn FnMut(<Host as Storage>::Binding<'a>)) {
        self.buffers.iter().for_each(|buffer| visit(Host::bind(buffer)));
    }
}
