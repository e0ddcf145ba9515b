//! The tools to test a wrong kernel, and the results of its test.

use std::fmt::Debug;
use std::time::Duration;

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
#[derive(Debug)]
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

/// Time after which a run that does not end is stopped.
const LIMIT: Duration = Duration::from_millis(500);

/// A device, and the functions that tests of kernels need.
pub struct Bench {
    /// The CPU with one thread, so that each run gives the same result.
    pub device: Device,
}

impl Bench {
    /// The CPU as programs use it, with eight lanes on every machine.
    pub fn plain() -> Self {
        // programs have no limit of time, and would hang
        let options = DeviceOptions::cpu(1).time_limit(LIMIT);
        Self::open(options.instruction_set(InstructionSet::Plain))
    }

    /// The CPU as tests of kernels should use it.
    pub fn checked() -> Self {
        Self::open(DeviceOptions::checked().threads(1).time_limit(LIMIT))
    }

    /// The CPU as a project's CI should use it.
    pub fn thorough() -> Self {
        Self::open(DeviceOptions::thorough(1).threads(1).time_limit(LIMIT))
    }

    fn open(options: DeviceOptions) -> Self {
        Self { device: Device::open(&options, Modules::none()).expect("the CPU") }
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

    /// A buffer of zeros for counters, followed by canaries.
    pub fn cleared(&self, len: usize) -> Result<Buffer<u32>, Error> {
        self.holding(&vec![0; len])
    }

    /// A buffer that one kernel writes and the next one reads.
    pub fn scratch<T: Pod>(&self, len: usize) -> Result<Buffer<T>, Error> {
        self.device.unwritten("scratch", len)
    }

    /// Runs a kernel over items.
    pub fn run<'a>(&self, kernel: &impl Dispatch<'a, Host>, items: u32) -> Result<(), Error> {
        self.layers(kernel, items, 1)
    }

    /// Runs a kernel over items, in layers of z.
    pub fn layers<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        items: u32,
        layers: u32,
    ) -> Result<(), Error> {
        self.device.run(kernel, items.max(1), layers.max(1))
    }

    /// Runs a kernel over pixels.
    pub fn pixels<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        [width, height]: [u32; 2],
    ) -> Result<(), Error> {
        self.device.run_over(kernel, [width, height, 1])
    }

    /// Runs a kernel over a number of workgroups that the test has computed.
    pub fn workgroups<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        workgroups: [u32; 3],
    ) -> Result<(), Error> {
        self.device.dispatch(kernel, workgroups)
    }

    /// Reads an output, which the kernel must have written entirely.
    pub fn read<T: Canary>(&self, buffer: &Buffer<T>) -> Result<Vec<T>, Error> {
        self.runner().read_all(buffer)
    }

    /// Compares an output with the expected value of each element.
    pub fn expect<T: Canary + Debug>(
        &self,
        buffer: &Buffer<T>,
        expected: impl Fn(u32) -> T,
    ) -> Result<(), Found> {
        self.expect_values(&self.read(buffer)?, expected)
    }

    /// Compares values with the expected ones.
    pub fn expect_values<T: Canary + Debug>(
        &self,
        values: &[T],
        expected: impl Fn(u32) -> T,
    ) -> Result<(), Found> {
        let wrong = (0..).zip(values).find(|(i, value)| expected(*i) != **value);
        match wrong {
            Some((i, value)) => {
                let message = format!("element {i} is {value:?}, not {:?}", expected(i));
                Err(Found::Value(message))
            }
            None => Ok(()),
        }
    }

    /// Fails if a kernel without work has written something.
    pub fn expect_unwritten<T: Canary + Debug>(&self, buffer: &Buffer<T>) -> Result<(), Found> {
        self.expect_values(&self.runner().read(buffer)?, |_| T::CANARY)
    }
}
