//! The host's side of kernels.

use bytemuck::Pod;
use muslin_kernel::kernel::Storage;

use crate::buffer::{Buffer, RawBuffer};
use crate::count::Count;

/// Marks the host's side of kernels: buffers are those of a [`Device`](crate::Device).
#[derive(Debug)]
pub enum Host {}

impl Storage for Host {
    type Buffer<T: Pod> = Buffer<T>;
    type Binding<'a> = &'a RawBuffer;
    type Count = Count;

    fn bind<T: Pod>(buffer: &Buffer<T>) -> &RawBuffer {
        buffer.raw()
    }

    fn upper_bound(count: &Count) -> u32 {
        count.upper_bound()
    }
}
