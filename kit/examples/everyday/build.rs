//! Embeds the compiled kernels of `compiled/`.

use std::path::Path;

fn main() {
    let everyday = Path::new(env!("CARGO_MANIFEST_DIR"));
    muslin_manifest::embed(&everyday.join("compiled"), &everyday.join("../../.."));
}
