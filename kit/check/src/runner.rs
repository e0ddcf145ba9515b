//! Runs one kernel on one device.

use bytemuck::Pod;
use glam::Vec4;
use organza_kernel::kernel::Dispatch;

use organza_device::{Buffer, Device, Error, Host, Result};

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

    /// Like [`KernelRunner::new`], with [`Canary::OTHER_CANARY`] in the outputs. [`KernelRunner::read`] gives [`Canary::CANARY`] for
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
    /// The same errors as [`Device::upload`].
    pub fn upload<T: Pod>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.device.upload("parity input", values)
    }

    /// A buffer of `len` elements to write to, and canaries after them. A device that checks it fails where the kernel reads what
    /// it has not written.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    pub fn output<T: Canary>(&self, len: usize) -> Result<Buffer<T>> {
        let buffer = self.output_of(&vec![self.canary::<T>(); len])?;
        self.device.forget(&buffer);
        Ok(buffer)
    }

    /// A buffer of `values` that the kernel writes to, and canaries after them.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`].
    pub fn output_of<T: Canary>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.upload(&[values, &[self.canary::<T>(); TAIL]].concat())
    }

    /// What an output holds, canaries included.
    ///
    /// # Errors
    /// The same errors as [`Device::read`], or if the kernel has written after the output.
    pub fn read<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        let mut values = self.device.read(buffer)?;
        let canary = self.canary::<T>();
        if values[values.len() - TAIL..].iter().any(|value| *value != canary) {
            let reason = "it writes behind its output".into();
            return Err(Error::Kernel { kernel: self.kernel.into(), reason });
        }
        // what was not written is the same on all devices
        for value in values.iter_mut().filter(|value| **value == canary) {
            *value = T::CANARY;
        }
        Ok(values)
    }

    /// What an output holds, without the canaries behind it. The kernel must have written all of it.
    ///
    /// # Errors
    /// The same errors as [`KernelRunner::read`], or if an element still holds its canary.
    pub fn read_all<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        let mut values = self.read(buffer)?;
        values.truncate(values.len() - TAIL);
        match values.iter().position(|value| *value == T::CANARY) {
            Some(index) => {
                let reason = format!("it has not written element {index} of its output");
                Err(Error::Kernel { kernel: self.kernel.into(), reason })
            }
            None => Ok(values),
        }
    }

    /// Runs the kernel with at least `items` invocations, and always with a workgroup: an empty input must be
    /// left by the kernel's own test.
    ///
    /// # Errors
    /// The same errors as [`Device::run`].
    pub fn items<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        items: u32,
        workgroups_z: u32,
    ) -> Result<()> {
        self.check(kernel);
        self.device.run(kernel, items.max(1), workgroups_z.max(1))
    }

    /// Runs the kernel over pixels: `side` x `side`, tiles along z.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn pixels<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        side: u32,
        tiles: u32,
    ) -> Result<()> {
        self.check(kernel);
        self.device.run_over(kernel, [side, side, tiles])
    }

    fn check<'a>(&self, kernel: &impl Dispatch<'a, Host>) {
        let name = kernel.info().name;
        assert_eq!(name, self.kernel, "the parity case of `{}` runs `{name}`", self.kernel);
    }
}
