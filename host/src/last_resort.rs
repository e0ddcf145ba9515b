//! Ends the program with a message, not with an abort, if memory runs out where no code can handle it. Stable Rust has
//! no other hook.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;

#[global_allocator]
static ALLOCATOR: LastResort = LastResort;

struct LastResort;

// SAFETY: every call goes to the system's allocator unchanged, and asks the same of its caller. A null that it returns
// is passed on or ends the program.
unsafe impl GlobalAlloc for LastResort {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise
        checked(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise
        checked(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller's promise
        checked(unsafe { System.realloc(memory, layout, size) }, size)
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise
        unsafe { System.dealloc(memory, layout) }
    }
}

#[inline]
fn checked(memory: *mut u8, size: usize) -> *mut u8 {
    // The library's tensors and buffers handle a failure, and report their purpose.
    if memory.is_null() && !muslin_device::memory::may_fail() { give_up(size) } else { memory }
}

#[cold]
fn give_up(size: usize) -> ! {
    // Standard error is not buffered, and formatting integers allocates nothing.
    let text = "render fewer or smaller tiles at once, or use a smaller scene";
    let _ =
        writeln!(std::io::stderr(), "error: out of memory: {size} more bytes are needed; {text}");
    std::process::exit(2)
}
