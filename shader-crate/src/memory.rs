//! Buffers as kernels see them.
//!
//! On the GPU [`Read`] and [`Write`] are slices, indexed without checks: a bounds check inside nested loops
//! becomes an exit through several levels, which naga's SPIR-V reader miscompiles
//! (<https://github.com/gfx-rs/wgpu/issues/4449>), and plain `get_unchecked` is not known to Rust-GPU.
//! On the CPU they are views that check every access.

#[cfg(target_arch = "spirv")]
pub use device::{Read, ReadBuffer, Shared, Write, WriteBuffer};
#[cfg(not(target_arch = "spirv"))]
pub use host::{Read, Shared, Write};

#[cfg(target_arch = "spirv")]
mod device {
    use spirv_std::arch::IndexUnchecked;

    /// A storage buffer that is only read.
    pub type Read<'a, T> = &'a [T];
    /// A storage buffer that is read and written.
    pub type Write<'a, T> = &'a mut [T];
    /// Workgroup memory.
    pub type Shared<'a, T, const N: usize> = &'a mut [T; N];

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
}

#[cfg(not(target_arch = "spirv"))]
mod host {
    use core::marker::PhantomData;

    /// A storage buffer that is only read.
    #[derive(Clone, Copy)]
    pub struct Read<'a, T> {
        data: *const T,
        len: usize,
        lifetime: PhantomData<&'a [T]>,
    }

    /// A storage buffer that is read and written, by many invocations at once.
    #[derive(Clone, Copy)]
    pub struct Write<'a, T> {
        data: *mut T,
        len: usize,
        lifetime: PhantomData<&'a mut [T]>,
    }

    /// Workgroup memory.
    #[derive(Clone, Copy)]
    pub struct Shared<'a, T, const N: usize>(Write<'a, T>);

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn out_of_range(index: u32, len: usize) -> ! {
        panic!("index {index} is out of range of a buffer of {len}");
    }

    impl<'a, T: Copy> Read<'a, T> {
        /// # Safety
        /// `data` points to `len` values that no one writes while the view is in use.
        pub const unsafe fn from_raw(data: *const T, len: usize) -> Self {
            Self { data, len, lifetime: PhantomData }
        }

        /// The value at `index`; panics out of range.
        #[inline(always)]
        #[track_caller]
        pub fn read(&self, index: u32) -> T {
            if index as usize >= self.len {
                out_of_range(index, self.len);
            }
            // SAFETY: checked above
            unsafe { *self.data.add(index as usize) }
        }
    }

    impl<'a, T: Copy> Write<'a, T> {
        /// # Safety
        /// `data` points to `len` values that are read and written through such views alone, an element
        /// by one invocation at a time.
        pub const unsafe fn from_raw(data: *mut T, len: usize) -> Self {
            Self { data, len, lifetime: PhantomData }
        }

        /// The value at `index`; panics out of range.
        #[inline(always)]
        #[track_caller]
        pub fn read(&self, index: u32) -> T {
            // SAFETY: `address` is in range, and no other invocation writes this element meanwhile
            unsafe { *self.address(index) }
        }

        /// Stores `value` at `index`; panics out of range.
        #[inline(always)]
        #[track_caller]
        pub fn write(&self, index: u32, value: T) {
            // SAFETY: as in `read`
            unsafe { *self.address(index) = value }
        }

        /// Where the value at `index` lies; panics out of range.
        #[inline(always)]
        #[track_caller]
        pub(crate) fn address(&self, index: u32) -> *mut T {
            if index as usize >= self.len {
                out_of_range(index, self.len);
            }
            // SAFETY: checked above
            unsafe { self.data.add(index as usize) }
        }
    }

    impl<'a, T: Copy, const N: usize> Shared<'a, T, N> {
        /// # Safety
        /// As [`Write::from_raw`], for `N` values.
        pub const unsafe fn from_raw(data: *mut T) -> Self {
            // SAFETY: the caller's
            Self(unsafe { Write::from_raw(data, N) })
        }

        /// The value at `index`; panics out of range.
        #[inline(always)]
        #[track_caller]
        pub fn read(&self, index: u32) -> T {
            self.0.read(index)
        }

        /// Stores `value` at `index`; panics out of range.
        #[inline(always)]
        #[track_caller]
        pub fn write(&self, index: u32, value: T) {
            self.0.write(index, value);
        }
    }

    impl<'a, T> From<&'a [T]> for Read<'a, T> {
        fn from(slice: &'a [T]) -> Self {
            Self { data: slice.as_ptr(), len: slice.len(), lifetime: PhantomData }
        }
    }

    impl<'a, T> From<&'a mut [T]> for Write<'a, T> {
        fn from(slice: &'a mut [T]) -> Self {
            Self { data: slice.as_mut_ptr(), len: slice.len(), lifetime: PhantomData }
        }
    }
}
