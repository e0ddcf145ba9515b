//! Buffers in the host's memory, for tests.

extern crate std;

use std::vec::Vec;

use bytemuck::Pod;

use crate::kernel::{Dispatch, Storage};

/// Where a test's buffers are: a kernel's struct takes a `&Vec` for each of them.
///
/// `#[kernel]` also writes a struct that owns them, here `SquareInputs`: see [`Inputs`].
#[derive(Debug)]
pub struct Given;

impl Storage for Given {
    type Buffer<T: Pod> = Vec<T>;
    type Binding<'a> = &'a [u8];
    type Count = u32;

    fn bind<T: Pod>(buffer: &Vec<T>) -> &[u8] {
        bytemuck::cast_slice(buffer)
    }

    fn upper_bound(count: &u32) -> u32 {
        *count
    }
}

/// What a test gives a kernel: its parameters, and a `Vec` for each buffer. `#[kernel]` implements it for `SquareInputs`.
pub trait Inputs: Clone {
    /// Name of the kernel.
    const KERNEL: &'static str;
    /// The kernel with buffers that are lent.
    type Kernel<'a>: Dispatch<'a, Given>
    where
        Self: 'a;
    /// The kernel with these buffers.
    fn kernel(&self) -> Self::Kernel<'_>;
}
