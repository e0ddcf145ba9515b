//! Workgroup memory as a cache.
//!
//! A kernel with a parameter `weights: &mut impl Stage<Vec4, 256>` has two entry points of one body.  In the plain one, and
//! on the CPU, the stage is [`InPlace`]: it holds nothing, and reads go to the buffer.  In the one named `_staged` it
//! is workgroup memory: an invocation copies its share of what all of them will read, and reads go there.

use crate::prelude::*;

/// Where a stage's elements come from.
pub trait Source<T>: Copy {
    /// Element `k` of the stage.
    fn element(self, k: u32) -> T;
}

/// Up to `N` elements that all invocations of a workgroup read.
pub trait Stage<T: Copy, const N: usize> {
    /// Whether invocations without an item must come along: they copy, and the others wait for them.
    fn is_shared(&self) -> bool;

    /// Where a pass ends that begins at `begin`, of `end` items of `size` elements each: as many as there is room for,
    /// and all of them where nothing is copied.
    fn end(&self, begin: u32, end: u32, size: u32) -> u32;

    /// Waits for the workgroup: before a stage is filled, until nobody reads it any more, and afterwards, until it is
    /// full.  One wait does for all stages of a kernel.
    fn wait(&self, id: Invocation);

    /// Copies the first `count` elements, each of them by one invocation.
    fn fill(&mut self, id: Invocation, count: u32, source: impl Source<T>);

    /// Element `k`, which is that of `buffer` at `index`.
    fn at(&self, k: u32, buffer: Read<T>, index: u32) -> T;
}

/// A stage that holds nothing.
pub struct InPlace;

impl<T: Copy, const N: usize> Stage<T, N> for InPlace {
    #[inline(always)]
    fn is_shared(&self) -> bool {
        false
    }

    #[inline(always)]
    fn end(&self, _: u32, end: u32, _: u32) -> u32 {
        end
    }

    #[inline(always)]
    fn wait(&self, _: Invocation) {}

    #[inline(always)]
    fn fill(&mut self, _: Invocation, _: u32, _: impl Source<T>) {}

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn at(&self, _: u32, buffer: Read<T>, index: u32) -> T {
        buffer.read(index)
    }
}

/// Workgroup memory.
#[cfg(target_arch = "spirv")]
impl<T: Copy, const N: usize> Stage<T, N> for [T; N] {
    #[inline(always)]
    fn is_shared(&self) -> bool {
        true
    }

    #[inline(always)]
    fn end(&self, begin: u32, end: u32, size: u32) -> u32 {
        let full = begin + N as u32 / size;
        if full < end { full } else { end }
    }

    #[inline(always)]
    fn wait(&self, id: Invocation) {
        id.barrier();
    }

    #[inline(always)]
    fn fill(&mut self, id: Invocation, count: u32, source: impl Source<T>) {
        let mut k = id.local_index();
        while k < count {
            self.write(k, source.element(k));
            k += id.size.x * id.size.y * id.size.z;
        }
    }

    #[inline(always)]
    fn at(&self, k: u32, _: Read<T>, _: u32) -> T {
        self.read(k)
    }
}
