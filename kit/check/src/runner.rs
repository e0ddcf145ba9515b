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
}

/// Fills an output before the kernel runs: elements that the kernel should not write must keep this value.
pub trait Canary: Pod + PartialEq {
    /// A value that no kernel computes.
    const CANARY: Self;
}

impl Canary for f32 {
    const CANARY: Self = -12_345.5;
}

impl Canary for u32 {
    const CANARY: Self = 0x00c0_ffee;
}

impl Canary for Vec4 {
    const CANARY: Self = Self::splat(f32::CANARY);
}

impl<'d> KernelRunner<'d> {
    /// Only the kernel of this name may run.
    #[must_use]
    pub fn new(device: &'d Device, kernel: &'static str) -> Self {
        Self { device, kernel }
    }

    /// A buffer that holds `values`.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn upload<T: Pod>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.device.upload("parity input", values)
    }

    /// A buffer of `len` elements to write to, and canaries after them.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn output<T: Canary>(&self, len: usize) -> Result<Buffer<T>> {
        self.output_of(&vec![T::CANARY; len])
    }

    /// A buffer of `values` that the kernel writes to, and canaries after them.
    ///
    /// # Errors
    /// As [`Device::upload`].
    pub fn output_of<T: Canary>(&self, values: &[T]) -> Result<Buffer<T>> {
        self.upload(&[values, &[T::CANARY; TAIL]].concat())
    }

    /// What an output holds, canaries included.
    ///
    /// # Errors
    /// As [`Device::read`], or if the kernel has written after the output.
    pub fn read<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>> {
        let values = self.device.read(buffer)?;
        if values[values.len() - TAIL..].iter().any(|value| *value != T::CANARY) {
            let reason = "it writes behind its output".into();
            return Err(Error::Kernel { kernel: self.kernel.into(), reason });
        }
        Ok(values)
    }

    /// Runs the kernel with at least `items` invocations, and always with a workgroup: an empty input must be
    /// left by the kernel's own test.
    ///
    /// # Errors
    /// As [`Device::run`].
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
    /// As [`Device::dispatch`].
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
