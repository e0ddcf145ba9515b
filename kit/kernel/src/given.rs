//! Buffers in the host's memory, for tests.

extern crate std;

use std::vec::Vec;

use bytemuck::Pod;

use crate::kernel::Storage;

/// Where a test's buffers are: a kernel's struct takes a `&Vec` for each of them.
///
/// `#[kernel]` also writes a struct that owns them, here `SquareInputs`. Its function `kernel` lends them to a `SquareKernel`.
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
