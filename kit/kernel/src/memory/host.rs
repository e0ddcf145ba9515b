//! Buffers on the CPU: views that check every access.

extern crate std;

use core::marker::PhantomData;
use core::panic::Location;
use std::string::String;

/// An access of an invocation to an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Reads it.
    Read,
    /// Writes it.
    Write,
    /// Changes it atomically, or reads it atomically.
    Atomic,
    /// Writes it atomically, independent of the old value.
    Store,
    /// Changes it atomically on a GPU. On the CPU, no workgroup with another z changes it.
    Serial,
}

/// Sees every access to a binding that several invocations may write.
pub trait AccessMonitor: Sync {
    /// Reports that the current invocation accesses an element of the buffer that the kernel calls `name`, at a place
    /// in the source.
    ///
    /// # Errors
    /// The reason, if the access is wrong.
    fn touch(
        &self,
        name: &&str,
        index: u32,
        touch: Touch,
        at: &'static Location<'static>,
    ) -> Result<(), String>;

    /// Everything written before the last barrier counts as unwritten: see
    /// [`Shared::begin_round`](super::Shared::begin_round).
    fn begin_round(&self) {}
}

/// A storage buffer that is only read.
#[derive(Clone, Copy)]
pub struct Read<'a, T> {
    data: *const T,
    len: usize,
    name: &'static str,
    /// If reads are watched, `len` is 0. Then every read takes the path of an index out of range, and unwatched reads
    /// cost nothing more.
    #[cfg(debug_assertions)]
    watched: Option<Watched<'a>>,
    lifetime: PhantomData<&'a [T]>,
}

/// A buffer whose reads are watched: the monitor, and the real length.
#[cfg(debug_assertions)]
#[derive(Clone, Copy)]
struct Watched<'a> {
    monitor: &'a dyn AccessMonitor,
    len: usize,
}

/// A storage buffer that is read and written, by many invocations at once.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Write<'a, T> {
    data: *mut T,
    len: usize,
    name: &'static str,
    monitor: Option<&'a dyn AccessMonitor>,
    lifetime: PhantomData<&'a mut [T]>,
}

/// A storage buffer that is only read, and of which a GPU reads four numbers at once: see [`samples`](crate::samples).
pub type ReadFours<'a, T> = Read<'a, T>;
/// As [`ReadFours`], read and written.
pub type WriteFours<'a, T> = Write<'a, T>;

/// A storage buffer of `u8` or `u16` that is only read. Its values are read as `u32`, which every GPU has.
#[derive(Clone, Copy)]
pub struct Packed<'a, T>(pub(crate) Read<'a, T>);

/// Workgroup memory.
#[derive(Clone, Copy)]
pub struct Shared<'a, T, const N: usize>(pub(crate) Write<'a, T>);

/// Name of a buffer without a kernel.
const UNNAMED: &str = "a buffer";

#[cold]
#[inline(never)]
#[track_caller]
fn out_of_range(index: u32, len: usize, name: &str) -> ! {
    panic!("index {index} is out of range of `{name}`, which has {len} elements");
}

#[cold]
#[inline(never)]
#[track_caller]
fn monitored(monitor: &dyn AccessMonitor, name: &str, index: u32, touch: Touch) {
    if let Err(reason) = monitor.touch(&name, index, touch, Location::caller()) {
        panic!("{reason}");
    }
}

/// The address of an element of this `size`, of a buffer that is watched: what is not optimized only calls.
#[cfg(debug_assertions)]
#[inline(never)]
#[track_caller]
fn element(view: &Write<'_, u8>, size: usize, index: u32, touch: Touch) -> *mut u8 {
    if index as usize >= view.len {
        out_of_range(index, view.len, view.name);
    }
    if let Some(monitor) = view.monitor
        && let Err(reason) = monitor.touch(&view.name, index, touch, Location::caller())
    {
        panic!("{reason}");
    }
    view.data.wrapping_add(size.wrapping_mul(index as usize))
}

/// Methods of both views of a buffer.
macro_rules! impl_named {
    ($($view:ident),*) => {$(
        impl<T: Copy> $view<'_, T> {
            /// The same buffer, with a kernel's name for it.
            #[inline(always)]
            #[must_use]
            pub const fn named(self, name: &'static str) -> Self {
                Self { name, ..self }
            }
        }
    )*};
}

impl_named!(Read, Write);

impl<'a, T: Copy> Read<'a, T> {
    /// # Safety
    /// `data` must point to `len` values that nothing writes while the view is in use.
    pub const unsafe fn from_raw(data: *const T, len: usize) -> Self {
        Self {
            data,
            len,
            name: UNNAMED,
            #[cfg(debug_assertions)]
            watched: None,
            lifetime: PhantomData,
        }
    }

    /// The same buffer. In debug builds `monitor` sees every read.
    #[inline(always)]
    #[must_use]
    pub const fn monitored(self, monitor: Option<&'a dyn AccessMonitor>) -> Self {
        #[cfg(debug_assertions)]
        if let Some(monitor) = monitor {
            return Self { len: 0, watched: Some(Watched { monitor, len: self.len }), ..self };
        }
        let _ = monitor;
        self
    }

    /// The value at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read(&self, index: u32) -> T {
        if index as usize >= self.len {
            self.beyond([index], index);
        }
        // SAFETY: checked above
        unsafe { *self.data.add(index as usize) }
    }

    /// Called if the `largest` of some indices is not below `len`. Returns if the buffer is watched and the indices
    /// are in range.
    #[cfg(debug_assertions)]
    #[cold]
    #[inline(never)]
    #[track_caller]
    fn beyond<const N: usize>(&self, indices: [u32; N], largest: u32) {
        match self.watched {
            Some(Watched { monitor, len }) if (largest as usize) < len => {
                for index in indices {
                    monitored(monitor, self.name, index, Touch::Read);
                }
            }
            Some(Watched { len, .. }) => out_of_range(largest, len, self.name),
            None => out_of_range(largest, self.len, self.name),
        }
    }

    #[cfg(not(debug_assertions))]
    #[inline(always)]
    #[track_caller]
    fn beyond<const N: usize>(&self, _: [u32; N], largest: u32) -> ! {
        out_of_range(largest, self.len, self.name)
    }
}

impl<'a, T: Copy> Read<'a, T> {
    /// Its address, its length, and what watches it.
    pub(crate) fn parts(self) -> (*mut T, usize, Option<&'a dyn AccessMonitor>) {
        #[cfg(debug_assertions)]
        if let Some(Watched { monitor, len }) = self.watched {
            return (self.data.cast_mut(), len, Some(monitor));
        }
        (self.data.cast_mut(), self.len, None)
    }

    /// The `N` values starting at `first`. Panics if they are out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read_lanes<const N: usize>(&self, first: u32) -> [T; N] {
        let [values] = self.read_vectors(first);
        values
    }

    /// The `K` times `N` values starting at `first`. Panics if they are out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read_vectors<const K: usize, const N: usize>(&self, first: u32) -> [[T; N]; K] {
        let count = K * N;
        if first as usize + count > self.len {
            for vector in 0..K {
                let indices = core::array::from_fn(|i| first + (vector * N + i) as u32);
                self.beyond::<N>(indices, first + count as u32 - 1);
            }
        }
        // SAFETY: checked above; an array is aligned as its elements
        unsafe { *self.data.add(first as usize).cast::<[[T; N]; K]>() }
    }

    /// The values at `N` indices. Panics if one is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn gather<const N: usize>(&self, at: [u32; N]) -> [T; N] {
        // a single test for all indices
        let largest = largest_of(at);
        if largest as usize >= self.len {
            self.beyond(at, largest);
        }
        core::array::from_fn(
            #[inline(always)]
            // SAFETY: checked above
            |i| unsafe { *self.data.add(at[i] as usize) },
        )
    }
}

impl<'a, T: Copy> Write<'a, T> {
    /// # Safety
    /// `data` must point to `len` values that are read and written only through such views. Only one invocation at a
    /// time may use an element.
    pub const unsafe fn from_raw(data: *mut T, len: usize) -> Self {
        Self { data, len, name: UNNAMED, monitor: None, lifetime: PhantomData }
    }

    /// The same buffer. `monitor` sees every access.
    #[inline(always)]
    #[must_use]
    pub const fn monitored(self, monitor: Option<&'a dyn AccessMonitor>) -> Self {
        Self { monitor, ..self }
    }

    /// Like [`Read::parts`].
    pub(crate) fn parts(self) -> (*mut T, usize, Option<&'a dyn AccessMonitor>) {
        (self.data, self.len, self.monitor)
    }

    /// The value at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read(&self, index: u32) -> T {
        // SAFETY: `address` is in range, and no other invocation writes this element meanwhile
        unsafe { *self.address(index, Touch::Read) }
    }

    /// Stores `value` at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn write(&self, index: u32, value: T) {
        // SAFETY: as in `read`
        unsafe { *self.address(index, Touch::Write) = value }
    }

    /// The `N` values starting at `first`. Panics if they are out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read_lanes<const N: usize>(&self, first: u32) -> [T; N] {
        // SAFETY: `addresses` is in range, and no other invocation writes these elements meanwhile
        unsafe { *self.addresses::<N>(first, Touch::Read) }
    }

    /// Stores `N` values, starting at `first`. Panics if they are out of range.
    #[inline(always)]
    #[track_caller]
    pub fn write_lanes<const N: usize>(&self, first: u32, values: [T; N]) {
        // SAFETY: as in `read_lanes`
        unsafe { *self.addresses::<N>(first, Touch::Write) = values }
    }

    /// The address of an element of a buffer that is watched.
    #[cfg(debug_assertions)]
    #[inline(always)]
    #[track_caller]
    fn element(&self, index: u32, touch: Touch) -> *mut u8 {
        // SAFETY: it is `repr(C)`, and the elements' type is that of an address
        let view: &Write<'_, u8> = unsafe { core::mem::transmute(self) };
        element(view, const { size_of::<T>() }, index, touch)
    }

    /// The address of `N` values starting at `first`. Panics if they are out of range.
    #[inline(always)]
    #[track_caller]
    fn addresses<const N: usize>(&self, first: u32, touch: Touch) -> *mut [T; N] {
        if first as usize + N > self.len {
            out_of_range(first + N as u32 - 1, self.len, self.name);
        }
        if let Some(monitor) = self.monitor {
            // not a closure, because the message would name its place
            for index in first..first + N as u32 {
                monitored(monitor, self.name, index, touch);
            }
        }
        // SAFETY: checked above; an array is aligned as its elements
        unsafe { self.data.add(first as usize).cast() }
    }

    /// The address of the value at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub(crate) fn address(&self, index: u32, touch: Touch) -> *mut T {
        #[cfg(debug_assertions)]
        if self.monitor.is_some() {
            return self.element(index, touch).cast();
        }
        if index as usize >= self.len {
            out_of_range(index, self.len, self.name);
        }
        #[cfg(not(debug_assertions))]
        if let Some(monitor) = self.monitor {
            monitored(monitor, self.name, index, touch);
        }
        self.data.wrapping_add(index as usize)
    }
}

impl<T: Copy> Write<'_, T> {
    /// Hints that the value at `index` is about to be read and written.
    #[inline(always)]
    pub fn prefetch(&self, index: u32) {
        let address = self.data.wrapping_add(index as usize);
        #[cfg(target_arch = "x86_64")]
        // SAFETY: a hint: it reads nothing, and no address is wrong
        unsafe {
            core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(address.cast());
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = address;
    }

    /// The address of the first element, after a check of all `index`. Panics if one is out of range.
    #[inline(always)]
    #[track_caller]
    pub(crate) fn addresses_of<const N: usize>(&self, index: [u32; N], touch: Touch) -> *mut T {
        let largest = index.iter().fold(0, |a: u32, &b| if a > b { a } else { b });
        if largest as usize >= self.len {
            out_of_range(largest, self.len, self.name);
        }
        if let Some(monitor) = self.monitor {
            for index in index {
                monitored(monitor, self.name, index, touch);
            }
        }
        self.data
    }
}

impl Write<'_, u32> {
    /// The address of the first 64-bit integer, after a check of all `index`. The integer at `index` has the elements
    /// `2 index` and `2 index + 1`; the monitor only sees the latter. Panics if one is out of range.
    #[inline(always)]
    #[track_caller]
    pub(crate) fn wide_addresses<const N: usize>(&self, index: [u32; N], touch: Touch) -> *mut u64 {
        let first: *mut u64 = self.addresses_of(index.map(|index| 2 * index + 1), touch).cast();
        assert!(first.is_aligned(), "`{}` does not hold 64-bit integers", self.name);
        first
    }

    /// Like [`Self::wide_addresses`], for the 64-bit integers at `index` and `index + 1`, of several lanes.
    #[inline(always)]
    #[track_caller]
    pub(crate) fn two_wide_addresses<const N: usize, const M: usize>(
        &self,
        index: [[u32; N]; M],
        touch: Touch,
    ) -> *mut u64 {
        if self.monitor.is_some() {
            for index in index {
                self.wide_addresses(index, touch);
                self.wide_addresses(index.map(|index| index + 1), touch);
            }
        }
        let mut largest = [0; N];
        let mut i = 0;
        while i < M {
            let mut lane = 0;
            while lane < N {
                let at = index[i][lane];
                largest[lane] = if at > largest[lane] { at } else { largest[lane] };
                lane += 1;
            }
            i += 1;
        }
        let largest = 2 * largest_of(largest) as usize + 3;
        if largest >= self.len {
            out_of_range(largest as u32, self.len, self.name);
        }
        let first: *mut u64 = self.data.cast();
        assert!(first.is_aligned(), "`{}` does not hold 64-bit integers", self.name);
        first
    }
}

/// The largest of some indices.
#[inline(always)]
fn largest_of<const N: usize>(index: [u32; N]) -> u32 {
    let mut largest = 0;
    let mut i = 0;
    while i < N {
        largest = if index[i] > largest { index[i] } else { largest };
        i += 1;
    }
    largest
}

impl Read<'_, f32> {
    /// The values at `N` indices and those behind them. Panics if one is out of range.
    #[inline(always)]
    #[track_caller]
    pub(crate) fn gather_two<const N: usize>(&self, at: [u32; N]) -> [[f32; N]; 2] {
        let largest = largest_of(at);
        if largest as usize + 1 >= self.len {
            #[cfg(debug_assertions)]
            self.beyond(at, largest);
            self.beyond(at.map(|at| at + 1), largest + 1);
        }
        let words: [u64; N] = core::array::from_fn(
            #[inline(always)]
            // SAFETY: checked above
            |i| unsafe { self.data.add(at[i] as usize).cast::<u64>().read_unaligned() },
        );
        let half = |words: u64, half: u32| f32::from_bits((words >> (32 * half)) as u32);
        [
            core::array::from_fn(
                #[inline(always)]
                |i| half(words[i], 0),
            ),
            core::array::from_fn(
                #[inline(always)]
                |i| half(words[i], 1),
            ),
        ]
    }
}

impl<T: Copy + Into<u32>> Packed<'_, T> {
    /// Like [`Read::named`].
    #[inline(always)]
    #[must_use]
    pub const fn named(self, name: &'static str) -> Self {
        Self(self.0.named(name))
    }

    /// The value at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read(&self, index: u32) -> u32 {
        self.0.read(index).into()
    }
}

impl<'a, T: Copy, const N: usize> Shared<'a, T, N> {
    /// # Safety
    /// The same as for [`Write::from_raw`], with `N` values.
    pub const unsafe fn from_raw(data: *mut T) -> Self {
        // SAFETY: the caller's
        Self(unsafe { Write::from_raw(data, N) })
    }

    /// Like [`Write::named`].
    #[inline(always)]
    #[must_use]
    pub const fn named(self, name: &'static str) -> Self {
        Self(self.0.named(name))
    }

    /// Like [`Write::monitored`].
    #[inline(always)]
    #[must_use]
    pub const fn monitored(self, monitor: Option<&'a dyn AccessMonitor>) -> Self {
        Self(self.0.monitored(monitor))
    }

    /// Declares that a new round begins: everything written to the array before the last barrier counts as unwritten,
    /// and the CPU run refuses to read it. All invocations call it, after the barrier that ends the last round.
    #[inline(always)]
    pub fn begin_round(&self) {
        if let Some(monitor) = self.0.monitor {
            monitor.begin_round();
        }
    }

    /// The value at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn read(&self, index: u32) -> T {
        // debug builds look at what a pointer points to, and not at what a reference does
        #[cfg(debug_assertions)]
        #[expect(clippy::transmute_ptr_to_ref, reason = "it takes less")]
        // SAFETY: as in `Write::read`
        return *unsafe { core::mem::transmute::<*mut u8, &T>(self.0.element(index, Touch::Read)) };
        #[cfg(not(debug_assertions))]
        self.0.read(index)
    }

    /// Stores `value` at `index`. Panics if `index` is out of range.
    #[inline(always)]
    #[track_caller]
    pub fn write(&self, index: u32, value: T) {
        #[cfg(debug_assertions)]
        #[expect(clippy::transmute_ptr_to_ref, reason = "as in `read`")]
        // SAFETY: as in `Write::read`
        let element: &mut T = unsafe { core::mem::transmute(self.0.element(index, Touch::Write)) };
        #[cfg(debug_assertions)]
        return *element = value;
        #[cfg(not(debug_assertions))]
        self.0.write(index, value);
    }
}

impl<'a, T: Copy> From<&'a [T]> for Read<'a, T> {
    fn from(slice: &'a [T]) -> Self {
        // SAFETY: a slice that is borrowed as long as the view lives
        unsafe { Self::from_raw(slice.as_ptr(), slice.len()) }
    }
}

impl<'a, T: Copy> From<&'a [T]> for Packed<'a, T> {
    fn from(slice: &'a [T]) -> Self {
        Self(slice.into())
    }
}

impl<'a, T: Copy> From<&'a mut [T]> for Write<'a, T> {
    fn from(slice: &'a mut [T]) -> Self {
        // SAFETY: only the view has this slice, as long as it lives
        unsafe { Self::from_raw(slice.as_mut_ptr(), slice.len()) }
    }
}
