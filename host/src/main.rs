//! The program `organza`: scenes, cameras and tiles in, images out.

mod cli;
mod last_resort;

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
