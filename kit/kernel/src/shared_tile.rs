//! Workgroup memory as a cache.
//!
//! A kernel with a parameter `near: &mut impl SharedTile<Vec4, 192>` has two entry points of one body.  In the plain one, and on
//! the CPU, the stage is [`Unshared`]: it holds nothing, and reads go to where its [`Source`] says.  In the one named
//! `_shared` it is workgroup memory: an invocation copies its share of what all of them will read, and reads go there.

use crate::prelude::*;

/// What a stage holds: items of several elements each, from anywhere.
pub trait Source<T>: Copy {
    /// Elements of an item.
    const ELEMENTS: u32;

    /// Where the first element of an item lies; the others follow.
    fn offset(self, item: u32) -> u32;

    /// The element at a place.
    fn element(self, offset: u32) -> T;
}

/// Up to `N` elements that all invocations of a workgroup read.
pub trait SharedTile<T: Copy, const N: usize> {
    /// Whether invocations without an item of their own must come along: they copy, and the others wait for them.
    fn is_shared(&self) -> bool;

    /// How many of the next `items` are taken at once: as many as there is room for, and all of them where nothing is
    /// copied.
    fn capacity<S: Source<T>>(&self, source: S, items: u32) -> u32;

    /// Waits for the workgroup: before a stage is filled, until nobody reads it any more, and afterwards, until it is
    /// full.  One wait does for all stages of a kernel.
    fn wait(&self, id: Invocation);

    /// Copies the first `items`, each element by one invocation.
    fn fill<S: Source<T>>(&mut self, id: Invocation, items: u32, source: S);

    /// Where the first element of an item lies, here or at the source; the others follow.
    fn offset<S: Source<T>>(&self, item: u32, source: S) -> u32;

    /// The element at a place.
    fn element<S: Source<T>>(&self, offset: u32, source: S) -> T;
}

/// A stage that holds nothing.
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
}

/// Workgroup memory.
#[cfg(target_arch = "spirv")]
impl<T: Copy, const N: usize> SharedTile<T, N> for [T; N] {
    #[inline(always)]
    fn is_shared(&self) -> bool {
        true
    }

    #[inline(always)]
    fn capacity<S: Source<T>>(&self, _: S, items: u32) -> u32 {
        let most = N as u32 / S::ELEMENTS;
        if items < most { items } else { most }
    }

    #[inline(always)]
    fn wait(&self, id: Invocation) {
        id.barrier();
    }

    #[inline(always)]
    fn fill<S: Source<T>>(&mut self, id: Invocation, items: u32, source: S) {
        let mut at = id.local_index();
        while at < items * S::ELEMENTS {
            let offset = source.offset(at / S::ELEMENTS) + at % S::ELEMENTS;
            self.write(at, source.element(offset));
            at += id.size.x * id.size.y * id.size.z;
        }
    }

    #[inline(always)]
    fn offset<S: Source<T>>(&self, item: u32, _: S) -> u32 {
        item * S::ELEMENTS
    }

    #[inline(always)]
    fn element<S: Source<T>>(&self, offset: u32, _: S) -> T {
        self.read(offset)
    }
}
