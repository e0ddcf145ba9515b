//! The program `organza`: scenes, cameras and tiles in, images out.

mod cli;

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    silence_device_select();
    cli::main()
}

/// Disables Mesa's Vulkan layer `device_select`. Without a folder for a desktop's sockets, over ssh or in a
/// container, it still looks for a Wayland server, and libwayland writes an error to stderr. The layer sorts devices
/// for a desktop, but organza sorts them itself. The layer stays if the user asks it for a device.
fn silence_device_select() {
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let has_folder = std::env::var_os("XDG_RUNTIME_DIR")
        .is_some_and(|folder| std::path::Path::new(&folder).is_absolute());
    if !has_folder && !is_set("MESA_VK_DEVICE_SELECT") && !is_set("DRI_PRIME") {
        // SAFETY: the program has one thread so far, so nothing reads the environment meanwhile
        unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    }
}

// Ends the program with a message, not with an abort, if memory runs out where no code can handle it. Stable Rust has
// no other hook.

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
    let text = "choose a smaller `--size`, `--side` or `--downscale`, render fewer or smaller tiles at once, or use a smaller scene";
    let _ =
        writeln!(std::io::stderr(), "error: out of memory: {size} more bytes are needed; {text}");
    std::process::exit(2)
}
