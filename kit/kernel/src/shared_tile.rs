//! Workgroup memory as a cache.
//!
//! A kernel with a parameter `near: &mut impl SharedTile<Vec4, 192>` has two entry points with the same body. In the
//! plain one the tile is [`Unshared`]: it is empty, and reads go to its [`Source`]. In the one with the suffix
//! `_shared`, the tile is workgroup memory: each invocation copies a part of what all of them will read, and reads go
//! there. The CPU runs the plain one, and the other if a test asks for it.

use crate::invocation::Invocation;
#[cfg(not(target_arch = "spirv"))]
use crate::memory::Shared;
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, SharedBuffer, WriteBuffer};

/// The source of a tile's elements: items of several elements each.
pub trait Source<T>: Copy {
    /// Number of elements in an item.
    const ELEMENTS: u32;

    /// Index of an item's first element; the others follow.
    fn offset(self, item: u32) -> u32;

    /// The element at an offset.
    fn element(self, offset: u32) -> T;
}

/// Up to `N` elements that all invocations of a workgroup read.
pub trait SharedTile<T: Copy, const N: usize> {
    /// Whether invocations without an item must take part: they copy, and wait at barriers.
    fn is_shared(&self) -> bool;

    /// Number of the next `items` that fit at once; all of them if nothing is copied.
    fn capacity<S: Source<T>>(&self, source: S, items: u32) -> u32;

    /// Waits for the workgroup. Call it before filling, so that all invocations have read the last items, and again after,
    /// so that the tile is full. One wait is enough for all tiles of a kernel.
    fn wait(&self, id: Invocation);

    /// Copies the first `items`. One invocation copies each element.
    fn fill<S: Source<T>>(&mut self, id: Invocation, items: u32, source: S);

    /// Index of an item's first element, in workgroup memory or at the source; the others follow.
    fn offset<S: Source<T>>(&self, item: u32, source: S) -> u32;

    /// The element at an offset.
    fn element<S: Source<T>>(&self, offset: u32, source: S) -> T;

    /// Begins to fill a tile by [`store`](Self::store): for what [`fill`](Self::fill) cannot lay out.
    fn begin_stores(&self);

    /// Stores an element in workgroup memory, where there is any.
    fn store(&mut self, index: u32, value: T);

    /// An element that was [stored](Self::store); without workgroup memory, nothing.
    fn load(&self, index: u32) -> T
    where
        T: Default;
}

/// An empty tile: reads go to the source.
pub struct Unshared;

impl<T: Copy, const N: usize> SharedTile<T, N> for Unshared {
    #[inline(always)]
    fn is_shared(&self) -> bool {
        false
    }

    #[inline(always)]
    fn capacity<S: Source<T>>(&self, _: S, items: u32) -> u32 {
        items
    }

    #[inline(always)]
    fn wait(&self, _: Invocation) {}

    #[inline(always)]
    fn fill<S: Source<T>>(&mut self, _: Invocation, _: u32, _: S) {}

    #[inline(always)]
    fn offset<S: Source<T>>(&self, item: u32, source: S) -> u32 {
        source.offset(item)
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn element<S: Source<T>>(&self, offset: u32, source: S) -> T {
        source.element(offset)
    }

    #[inline(always)]
    fn begin_stores(&self) {}

    #[inline(always)]
    fn store(&mut self, _: u32, _: T) {}

    #[inline(always)]
    fn load(&self, _: u32) -> T
    where
        T: Default,
    {
        T::default()
    }
}

/// Implements a tile in workgroup memory, for `Shared` on the CPU and on a GPU.
macro_rules! impl_shared_tile {
    ([$($generics:tt)*] $shared:ty) => {
        impl<$($generics)*> SharedTile<T, N> for $shared {
            #[inline(always)]
            fn is_shared(&self) -> bool {
                true
            }

            #[inline(always)]
            fn capacity<S: Source<T>>(&self, _: S, items: u32) -> u32 {
                let max = N as u32 / S::ELEMENTS;
                if items < max { items } else { max }
            }

            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            fn wait(&self, id: Invocation) {
                id.barrier();
            }

            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            fn fill<S: Source<T>>(&mut self, id: Invocation, items: u32, source: S) {
                self.begin_round();
                let mut at = id.local_index();
                while at < items * S::ELEMENTS {
                    #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
                    crate::running::iterate();
                    let offset = source.offset(at / S::ELEMENTS) + at % S::ELEMENTS;
                    self.write(at, source.element(offset));
                    at += id.size.x * id.size.y * id.size.z;
                }
            }

            #[inline(always)]
            fn offset<S: Source<T>>(&self, item: u32, _: S) -> u32 {
                // The mask changes nothing. With it, compilers know that sums with the offset do not overflow, so that they become a
                // part of the instruction that reads.
                let max = const { (N as u32 / S::ELEMENTS).next_power_of_two() };
                (item & (max - 1)) * S::ELEMENTS
            }

            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            fn element<S: Source<T>>(&self, offset: u32, _: S) -> T {
                self.read(offset)
            }

            #[inline(always)]
            fn begin_stores(&self) {
                self.begin_round();
            }

            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            fn store(&mut self, index: u32, value: T) {
                self.write(index, value);
            }

            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            fn load(&self, index: u32) -> T
            where
                T: Default,
            {
                self.read(index)
            }
        }
    };
}

#[cfg(target_arch = "spirv")]
impl_shared_tile!([T: Copy, const N: usize] [T; N]);
#[cfg(not(target_arch = "spirv"))]
impl_shared_tile!(['a, T: Copy, const N: usize] Shared<'a, T, N>);
