//! What a kernel binds, on the CPU: buffers, parameters and workgroup memory.

use core::{ptr, slice};

use bytemuck::Pod;

use crate::memory::{AccessMonitor, Packed, Read, Shared, Write};

/// An array of a kernel in workgroup memory.
#[derive(Clone, Copy, Debug)]
pub struct SharedInfo {
    /// Name of the parameter.
    pub name: &'static str,
    /// Type of an element.
    pub element: &'static str,
    /// Number of elements.
    pub len: u32,
    /// Size of the array, in bytes.
    pub bytes: u32,
}

/// Structs with `#[params]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not declared as parameters of a kernel",
    label = "write `#[params]` above this struct"
)]
pub trait Params: Pod {}

/// Types of the fields of [`Params`]: they lie on a GPU as in Rust.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no type for a field of `#[params]`",
    label = "use `u32`, `i32` and `f32`: one field for each number"
)]
pub trait Number: Pod {}

impl Number for u32 {}
impl Number for i32 {}
impl Number for f32 {}

/// Memory of one binding.
#[derive(Clone, Copy)]
pub struct CpuBinding<'a> {
    /// Address of the first byte.
    pub data: *mut u8,
    /// Size in bytes.
    pub bytes: usize,
    /// Watches every access: if the binding is written and races are checked, and if parts of it are unwritten.
    pub monitor: Option<&'a dyn AccessMonitor>,
}

// SAFETY: a pointer and a size; the contract of `CpuRun` restricts their use
unsafe impl Send for CpuBinding<'_> {}
// SAFETY: as above
unsafe impl Sync for CpuBinding<'_> {}

impl<'a> CpuBinding<'a> {
    /// # Safety
    /// The binding must contain a `T`.
    pub unsafe fn uniform<T: Params>(self) -> &'a T {
        // SAFETY: the caller's
        let bytes = unsafe { slice::from_raw_parts(self.data, self.bytes) };
        bytemuck::from_bytes(bytes)
    }

    /// # Safety
    /// The same as for [`Read::from_raw`].
    pub unsafe fn read<T: Pod>(self) -> Read<'a, T> {
        // SAFETY: the caller's
        unsafe { Read::from_raw(self.data.cast(), self.bytes / size_of::<T>()) }
            .monitored(self.monitor)
    }

    /// # Safety
    /// The same as for [`Read::from_raw`].
    pub unsafe fn packed<T: Pod>(self) -> Packed<'a, T> {
        // SAFETY: the caller's
        Packed(unsafe { self.read() })
    }

    /// # Safety
    /// The same as for [`Write::from_raw`].
    pub unsafe fn write<T: Pod>(self) -> Write<'a, T> {
        // SAFETY: the caller's
        unsafe { Write::from_raw(self.data.cast(), self.bytes / size_of::<T>()) }
            .monitored(self.monitor)
    }

    /// # Safety
    /// The same as for [`Shared::from_raw`].
    pub unsafe fn shared<T: Pod, const N: usize>(self) -> Shared<'a, T, N> {
        debug_assert_eq!(self.bytes, size_of::<[T; N]>());
        // SAFETY: the caller's
        unsafe { Shared::from_raw(self.data.cast()) }.monitored(self.monitor)
    }
}

impl<'a, T: Params> From<&'a T> for CpuBinding<'a> {
    fn from(params: &'a T) -> Self {
        Self { data: ptr::from_ref(params).cast_mut().cast(), bytes: size_of::<T>(), monitor: None }
    }
}

/// The bindings of views.
macro_rules! impl_from {
    ($($view:ident $(<$n:ident>)? $(.$field:tt)?),*) => {$(
        impl<'a, T: Copy $(, const $n: usize)?> From<$view<'a, T $(, $n)?>> for CpuBinding<'a> {
            fn from(view: $view<'a, T $(, $n)?>) -> Self {
                let (data, len, monitor) = view$(.$field)?.parts();
                Self { data: data.cast(), bytes: len * size_of::<T>(), monitor }
            }
        }
    )*};
}

impl_from!(Read, Write, Packed.0, Shared<N>.0);
