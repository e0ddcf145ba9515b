//! Buffers on the GPU: slices, indexed without checks.

use core::marker::PhantomData;

use spirv_std::arch::IndexUnchecked;

use super::Fours;

/// A storage buffer that is only read.
pub type Read<'a, T> = &'a [T];
/// A storage buffer that is read and written.
pub type Write<'a, T> = &'a mut [T];
/// Workgroup memory.
pub type Shared<'a, T, const N: usize> = &'a mut [T; N];

/// A storage buffer that is only read, four numbers at once: one load, which no driver has to put together.
pub type ReadFours<'a, T> = &'a [<T as Fours>::Vector];
/// A storage buffer that is read and written, four numbers at once.
pub type WriteFours<'a, T> = &'a mut [<T as Fours>::Vector];

/// A storage buffer of `u8` or `u16` that is only read. Not every GPU has such integers, so it is a buffer of words.
pub type Packed<'a, T> = &'a [Word<T>];

/// A word that holds several `T`.
#[repr(transparent)]
pub struct Word<T>(u32, PhantomData<T>);

/// Integers that are smaller than a word.
pub trait Small {
    /// Base-2 logarithm of their number of bits.
    const LOG_BITS: u32;
}

impl Small for u8 {
    const LOG_BITS: u32 = 3;
}

impl Small for u16 {
    const LOG_BITS: u32 = 4;
}

impl<T: Small> ReadBuffer<u32> for [Word<T>] {
    #[inline(always)]
    fn read(&self, index: u32) -> u32 {
        let bit = index << T::LOG_BITS;
        // not `bit / 32`: the last bit of a large buffer has no number in 32 bits
        let at = index >> (5 - T::LOG_BITS);
        // SAFETY: the CPU run of every kernel checks its indices
        let word = unsafe { self.index_unchecked(at as usize) }.0;
        (word >> (bit & 31)) & ((1 << (1 << T::LOG_BITS)) - 1)
    }
}

/// Reading at an index.
pub trait ReadBuffer<T> {
    /// The value at `index`, which must be in range.
    fn read(&self, index: u32) -> T;
}

/// Writing at an index.
pub trait WriteBuffer<T>: ReadBuffer<T> {
    /// Stores `value` at `index`, which must be in range.
    fn write(&mut self, index: u32, value: T);
}

impl<T: Copy> ReadBuffer<T> for [T] {
    #[inline(always)]
    fn read(&self, index: u32) -> T {
        // SAFETY: the CPU run of every kernel checks its indices
        unsafe { *self.index_unchecked(index as usize) }
    }
}

impl<T: Copy> WriteBuffer<T> for [T] {
    #[inline(always)]
    fn write(&mut self, index: u32, value: T) {
        // SAFETY: as above
        unsafe { *self.index_unchecked_mut(index as usize) = value }
    }
}

impl<T: Copy, const N: usize> ReadBuffer<T> for [T; N] {
    #[inline(always)]
    fn read(&self, index: u32) -> T {
        // SAFETY: as above
        unsafe { *self.index_unchecked(index as usize) }
    }
}

impl<T: Copy, const N: usize> WriteBuffer<T> for [T; N] {
    #[inline(always)]
    fn write(&mut self, index: u32, value: T) {
        // SAFETY: as above
        unsafe { *self.index_unchecked_mut(index as usize) = value }
    }
}

/// Methods that only workgroup memory has.
pub trait SharedBuffer {
    /// Declares that a new round begins: see the CPU's `Shared::begin_round`. A GPU does nothing.
    fn begin_round(&self);
}

impl<T, const N: usize> SharedBuffer for [T; N] {
    #[inline(always)]
    fn begin_round(&self) {}
}
