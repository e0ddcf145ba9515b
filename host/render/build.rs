//! Embeds the compiled kernels of `kernels/`.

use std::path::Path;

fn main() {
    let render = Path::new(env!("CARGO_MANIFEST_DIR"));
    muslin_manifest::embed(&render.join("kernels"), &render.join("../.."));
}
