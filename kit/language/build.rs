//! Embeds the compiled kernels of `compiled/`.

use std::path::Path;

fn main() {
    let language = Path::new(env!("CARGO_MANIFEST_DIR"));
    muslin_manifest::embed(&language.join("compiled"), &language.join("../.."));
}
