//! The tools to test a wrong kernel, and the results of its test.

use std::fmt::Debug;

pub use muslin::atomic;
use muslin::kernel::{Dispatch, InstructionSet};
pub use muslin::prelude::*;
pub use muslin_check::Canary;
use muslin_check::KernelRunner;
use muslin_device::{Buffer, Device, DeviceOptions, Error, Host, Modules};

/// A number of items.
#[params]
pub struct Count {
    /// Items.
    pub count: u32,
}

/// The size of an image.
#[params]
pub struct Size {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// 0, 1, 2, ...
pub fn numbers(count: u32) -> Vec<u32> {
    (0..count).collect()
}

/// A wrong kernel of the corpus.
pub struct Bug {
    /// Name of its folder.
    pub kind: &'static str,
    /// Name of its file.
    pub name: &'static str,
    /// Text of its file.
    pub source: &'static str,
    /// The test that the kernel's author would write.
    pub test: fn(&Bench) -> Result<(), Found>,
}

/// The result of a failed test.
pub enum Found {
    /// A message from the kit.
    Message(String),
    /// An unexpected value, without a message that explains it.
    Value(String),
}

impl From<Error> for Found {
    fn from(error: Error) -> Self {
        Self::Message(error.to_string())
    }
}

/// A device, and the functions that tests of kernels need.
pub struct Bench {
    /// The CPU with one thread, so that each run gives the same result.
    pub device: Device,
}

impl Bench {
    /// The CPU as programs use it, with eight lanes on every machine; as tests should use it; and as a project's CI should.
    pub fn all() -> [Self; 3] {
        let plain = DeviceOptions::cpu(1).instruction_set(InstructionSet::Plain);
        let all =
            [plain, DeviceOptions::checked().threads(1), DeviceOptions::thorough(1).threads(1)];
        all.map(|options| Self {
            device: Device::open(&options, Modules::none()).expect("the CPU"),
        })
    }

    /// Checks behind the outputs.
    fn runner(&self) -> KernelRunner<'_> {
        KernelRunner::new(&self.device, "")
    }

    /// A buffer that contains `values`.
    pub fn input<T: Pod>(&self, values: &[T]) -> Result<Buffer<T>, Error> {
        self.runner().upload(values)
    }

    /// An output of `len` elements, filled with canaries and followed by more of them.
    pub fn output<T: Canary>(&self, len: usize) -> Result<Buffer<T>, Error> {
        self.runner().output(len)
    }

    /// A buffer to read and write, followed by canaries.
    pub fn holding<T: Canary>(&self, values: &[T]) -> Result<Buffer<T>, Error> {
        self.runner().output_of(values)
    }

    /// Runs a kernel over items.
    pub fn run<'a>(&self, kernel: &impl Dispatch<'a, Host>, items: u32) -> Result<(), Error> {
        self.device.run(kernel, items.max(1), 1)
    }

    /// Compares an output, which the kernel must have written entirely, with the expected value of each element.
    pub fn expect<T: Canary + Debug>(
        &self,
        buffer: &Buffer<T>,
        expected: impl Fn(u32) -> T,
    ) -> Result<(), Found> {
        let values = self.runner().read_all(buffer)?;
        match (0..).zip(values).find(|(i, value)| expected(*i) != *value) {
            Some((i, value)) => {
                let message = format!("element {i} is {value:?}, not {:?}", expected(i));
                Err(Found::Value(message))
            }
            None => Ok(()),
        }
    }
}
