//! Snapshots of A, B and C, alone and together: `docs/correctness.md` says how to read and accept them.
//!
//! A snapshot locks a value but does not prove it. Parity compares each stage with its equations in f64, `reference_cases` all of them
//! with another program, and every scene of tiles is compared with Eq. 12 and 13.

pub mod exact;
mod generator;
mod stages;
mod tiles;

use std::sync::LazyLock;

use muslin_check::snapshot::Snapshots;
use organza::Renderer;
use organza_tests::devices;

/// Largest size of a snapshot: people look at them, and they stay in the history.
const MAX_FILE_BYTES: u64 = 64 << 10;
/// Largest size of all snapshots together.
const MAX_BYTES: u64 = 1 << 20;

/// Every device, opened once.
pub static RENDERERS: LazyLock<Vec<(&str, Renderer)>> = LazyLock::new(|| {
    devices::all().into_iter().map(|(name, device)| (name, Renderer::new(device))).collect()
});

/// The accepted files.
pub const SNAPSHOTS: Snapshots = muslin_check::snapshots!("snapshots");

#[test]
fn snapshots_stay_small() {
    let mut all = 0;
    let mut files = 0;
    for entry in std::fs::read_dir(SNAPSHOTS.folder()).expect("tests/snapshots is there") {
        let entry = entry.expect("a folder's entry");
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.contains(".snap.new") {
            continue; // pending, and not in the repository
        }
        let bytes = entry.metadata().expect("a file").len();
        assert!(bytes <= MAX_FILE_BYTES, "{name} has {bytes} bytes, more than {MAX_FILE_BYTES}");
        all += bytes;
        files += 1;
    }
    assert!(all <= MAX_BYTES, "the snapshots have {all} bytes, more than {MAX_BYTES}");
    println!("{files} files, {all} bytes");
}
