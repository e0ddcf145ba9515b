//! docs/adding-a-kernel.md: the files on that page are those in `tests/guide/`. They are built and run here, on the
//! CPU. `cargo xtask guide` compiles the kernel for GPUs.

use std::fs;
use std::path::Path;

#[path = "../guide/blend.rs"]
pub mod blend;

mod parity {
    use crate::guide::with_blend as organza_shaders;
    include!("../guide/parity.rs");
}

mod snapshot {
    use crate::guide::with_blend as organza_shaders;
    use crate::guide::with_cpu as organza_tests;
    include!("../guide/snapshot.rs");
}

/// `organza_shaders` with the additional kernel.
mod with_blend {
    pub use crate::guide::blend;
}

/// `organza_tests` with two CPUs in place of GPUs, because there is no SPIR-V of the kernel.
mod with_cpu {
    pub mod devices {
        pub fn all() -> Vec<(&'static str, organza::Device)> {
            let cpu = |threads| ("cpu", organza_tests::devices::cpu(threads));
            vec![cpu(None), cpu(Some(1))]
        }
    }
}

/// The page's blocks of Rust code.
fn blocks(page: &str) -> Vec<String> {
    let fenced = page.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.strip_prefix("rust\n")).map(str::to_owned).collect()
}

#[test]
fn the_page_shows_the_files() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |path: &str| fs::read_to_string(tests.join(path)).unwrap();
    let files = ["blend.rs", "parity.rs", "snapshot.rs"].map(|f| read(&format!("guide/{f}")));
    let blocks = blocks(&read("../docs/adding-a-kernel.md"));
    let missing: Vec<_> =
        blocks.iter().filter(|block| !files.iter().any(|file| file.contains(*block))).collect();
    assert!(missing.is_empty(), "these blocks of the page are in no file of guide/: {missing:#?}");
    for (name, file) in ["blend.rs", "parity.rs", "snapshot.rs"].iter().zip(&files) {
        let shown: String = blocks.iter().filter(|block| file.contains(*block)).cloned().collect();
        // blank lines may separate blocks
        let squeeze =
            |text: &str| text.lines().filter(|l| !l.is_empty()).collect::<Vec<_>>().join("\n");
        assert_eq!(squeeze(&shown), squeeze(file), "the page does not show all of guide/{name}");
    }
}

#[test]
fn the_parity_case_runs() {
    use organza_check::{Case, Rounding};
    let case = Case::of::<parity::Blend>();
    let one = organza_tests::devices::cpu(Some(1));
    let many = organza_tests::devices::cpu(None);
    let measure = case.measure(&one, &many, Rounding::AsWritten).unwrap();
    assert!(measure.is_ok());
    let measure = case.hold(&many, Rounding::AsWritten).unwrap();
    assert!(measure.is_ok() && measure.values > 2_000, "{measure:?}");
}
