//! Snapshots of A, B and C, each on its own and together: `docs/snapshots.md` says how to read and accept them.
//!
//! A snapshot locks a value and does not prove it, so that every scene is held to the equations, in f64, as well.

#[path = "../support/snapshot/stages.rs"]
mod stages;
#[path = "../support/snapshot/tiles.rs"]
mod tiles;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, LazyLock, Mutex};

use insta::{Settings, Snapshot};
use organza::Renderer;
use organza::image::to_8_bit;
use organza_tests::devices;

use crate::snapshot;
use crate::snapshot::compare::{Held, Mismatch, Rule, Tolerance};
use crate::snapshot::picture::{self, Montage};
use crate::snapshot::report;
use crate::snapshot::tensors::Tensors;

/// No snapshot may be larger: people look at them, and they stay in the history.
const MAX_FILE_BYTES: u64 = 64 << 10;
/// Nor may all of them together.
const MAX_BYTES: u64 = 1 << 20;

/// Every device, opened once.
static RENDERERS: LazyLock<Vec<(&str, Renderer)>> = LazyLock::new(|| {
    devices::all().into_iter().map(|(name, device)| (name, Renderer::new(device))).collect()
});

/// What is snapshotted.
struct Record<'a> {
    name: &'a str,
    /// What there is to see, for the review.
    description: &'a str,
    rule: Rule,
    content: Content,
}

enum Content {
    Text(String),
    Png(Vec<u8>),
}

/// Holds tensors to the snapshot `name`.
fn assert_tensors(
    [name, description]: [&str; 2],
    backend: &str,
    tensors: &Tensors,
    tolerance: Tolerance,
) {
    let content = Content::Text(tensors.to_string());
    assert_record(backend, &Record { name, description, rule: Rule::Tensors(tolerance), content });
}

/// Holds `[K, 3, S, S]` to the picture `name`.
fn assert_picture([name, description]: [&str; 2], backend: &str, data: &[f32], montage: Montage) {
    let content = Content::Png(picture::encode(
        &montage.draw(&data.iter().copied().map(to_8_bit).collect::<Vec<_>>()),
    ));
    assert_record(backend, &Record { name, description, rule: Rule::Picture(montage), content });
}

/// The CPU's record is the snapshot, and insta's to accept.  A GPU is held to the accepted file and never offers its own.
fn assert_record(backend: &str, record: &Record<'_>) {
    let picture = report::path(record.name, backend);
    let found = Arc::new(Mutex::new(None));
    let held = Held { rule: record.rule, found: found.clone() };
    let result = catch_unwind(AssertUnwindSafe(|| match backend {
        "cpu" => assert_accepted(record, held),
        _ => assert_same(record, &held),
    }));
    let mismatch: Option<Mismatch> = found.lock().expect("no test panics there").take();
    match (result, mismatch) {
        (Ok(()), None) => _ = std::fs::remove_file(&picture),
        (result, Some(mismatch)) => {
            report::save(&mismatch.panels, &picture);
            let text = report::message(record.name, backend, &mismatch, &picture);
            match result {
                // accepted by INSTA_UPDATE, or left to the review by INSTA_FORCE_PASS
                Ok(()) => println!("{text}"),
                Err(_) => panic!("{text}"),
            }
        }
        (Err(panic), None) => std::panic::resume_unwind(panic),
    }
}

fn assert_accepted(record: &Record<'_>, held: Held) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description(record.description);
    settings.set_comparator(Box::new(held));
    settings.bind(|| match &record.content {
        Content::Text(text) => insta::assert_snapshot!(record.name, text),
        Content::Png(png) => {
            insta::assert_binary_snapshot!(&format!("{}.png", record.name), png.clone());
        }
    });
}

fn assert_same(record: &Record<'_>, held: &Held) {
    use insta::internals::{SnapshotContents, TextSnapshotContents};

    let path = snapshot::folder().join(format!("{}.snap", record.name));
    let accepted = Snapshot::from_file(&path)
        .unwrap_or_else(|error| panic!("{}: {error}: accept the CPU's first", path.display()));
    let contents = match &record.content {
        Content::Text(text) => {
            TextSnapshotContents::new(text.clone(), insta::TextSnapshotKind::File).into()
        }
        Content::Png(png) => SnapshotContents::Binary(Some(std::rc::Rc::new(png.clone()))),
    };
    let same = held.allows(accepted.contents(), &contents);
    let force_pass = std::env::var_os("INSTA_FORCE_PASS").is_some_and(|value| value != "0");
    assert!(same || force_pass, "{} differs", record.name);
}

#[test]
fn snapshots_stay_small() {
    let (mut all, mut files) = (0, 0);
    for entry in std::fs::read_dir(snapshot::folder()).expect("tests/snapshots is there") {
        let entry = entry.expect("a folder's entry");
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.contains(".snap.new") {
            continue; // pending, and not in the repository
        }
        let bytes = entry.metadata().expect("a file").len();
        assert!(bytes <= MAX_FILE_BYTES, "{name} has {bytes} bytes, more than {MAX_FILE_BYTES}");
        (all, files) = (all + bytes, files + 1);
    }
    assert!(all <= MAX_BYTES, "the snapshots have {all} bytes, more than {MAX_BYTES}");
    println!("{files} files, {all} bytes");
}
