//! Embeds the compiled kernels of `kernels/`.

use std::path::Path;

fn main() {
    let host = Path::new(env!("CARGO_MANIFEST_DIR"));
    organza_manifest::embed(&host.join("kernels"), &host.join(".."));
}
