//! An allocator that counts, and a limit for the memory of parsers.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// Most bytes that a parser may hold at once, besides an amount that grows with its input.
const MAX_BYTES: usize = 96 << 20;
/// Additional bytes for each byte of the input.
const MAX_PER_BYTE: usize = 256;

#[global_allocator]
static ALLOCATOR: Counted = Counted;

/// Counts the bytes that each thread holds.
struct Counted;

thread_local! {
    static HELD: Cell<usize> = const { Cell::new(0) };
    static PEAK: Cell<usize> = const { Cell::new(0) };
}

fn count(more: usize, less: usize) {
    // A thread that has ended frees bytes that are no longer counted.
    let _ = HELD.try_with(|held| {
        // Memory of other threads is freed here, too.
        held.set(held.get().saturating_add(more).saturating_sub(less));
        let _ = PEAK.try_with(|peak| peak.set(peak.get().max(held.get())));
    });
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size(), 0);
        // SAFETY: the caller's promise
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size(), 0);
        // SAFETY: the caller's promise
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size, layout.size());
        // SAFETY: the caller's promise
        unsafe { System.realloc(memory, layout, size) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count(0, layout.size());
        // SAFETY: the caller's promise
        unsafe { System.dealloc(memory, layout) }
    }
}

/// Runs a parser on bytes. Panics if it held too much memory.
pub fn run(target: fn(&[u8]), bytes: &[u8], what: &str) {
    let before = HELD.get();
    PEAK.set(before);
    target(bytes);
    let took = PEAK.get().saturating_sub(before);
    assert!(took <= MAX_BYTES + MAX_PER_BYTE * bytes.len(), "{what} took {took} bytes of memory");
}
