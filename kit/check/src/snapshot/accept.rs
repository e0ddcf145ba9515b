//! Compares the results of devices with accepted files.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::{Arc, Mutex};

use insta::internals::{SnapshotContents, TextSnapshotContents};
use insta::{Settings, Snapshot, TextSnapshotKind};

use super::compare::{Mismatch, RecordedRule, Rule, Tolerance};
use super::picture::{self, Montage};
use super::report;
use super::tensors::Tensors;

/// A folder of accepted snapshots; [`snapshots`](crate::snapshots!) makes one.
///
/// The snapshot is the CPU's output. Insta accepts it: `INSTA_UPDATE=always cargo test`, or `cargo insta review`. A
/// GPU's output is compared with the accepted file, within a tolerance, and is never accepted itself.
#[derive(Clone, Copy, Debug)]
pub struct Snapshots {
    /// Path of the folder in the package.
    folder: &'static str,
    package: &'static str,
    text: fn(&str, &str),
    png: fn(&str, Vec<u8>),
}

/// A result that is compared with a snapshot.
struct Record<'a> {
    name: &'a str,
    /// A description of the picture, for the review.
    description: &'a str,
    rule: Rule,
    content: Content,
}

enum Content {
    Text(String),
    Png(Vec<u8>),
}

/// Makes the [`Snapshots`](crate::snapshot::Snapshots) of a folder of the package, such as `"tests/snapshots"`.
#[macro_export]
macro_rules! snapshots {
    ($folder:literal) => {
        // insta's macros use the place of their call
        $crate::snapshot::Snapshots::new(
            $folder,
            env!("CARGO_MANIFEST_DIR"),
            |name, text| $crate::snapshot::insta::assert_snapshot!(name, text),
            |name, png| {
                $crate::snapshot::insta::assert_binary_snapshot!(&format!("{name}.png"), png);
            },
        )
    };
}

impl Snapshots {
    #[doc(hidden)]
    #[must_use]
    pub const fn new(
        folder: &'static str,
        package: &'static str,
        text: fn(&str, &str),
        png: fn(&str, Vec<u8>),
    ) -> Self {
        Self { folder, package, text, png }
    }

    /// The folder of the accepted files.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        PathBuf::from(self.package).join(self.folder)
    }

    /// Compares tensors with the snapshot `name`. `device` is one of [`devices`](crate::devices).
    ///
    /// # Panics
    /// If they differ by more than the tolerance.
    pub fn assert_tensors(
        &self,
        [name, description]: [&str; 2],
        device: &str,
        tensors: &Tensors,
        tolerance: Tolerance,
    ) {
        let rule = Rule::Tensors(tolerance);
        let content = Content::Text(tensors.to_string());
        self.assert(device, &Record { name, description, rule, content });
    }

    /// Compares tiles `[K, 3, S, S]`, with colors from 0 to 1, with the picture `name`.
    ///
    /// # Panics
    /// If a pixel differs by more than rounding explains.
    pub fn assert_picture(
        &self,
        [name, description]: [&str; 2],
        device: &str,
        colors: &[f32],
        montage: Montage,
    ) {
        let level = |value: &f32| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
        let levels: Vec<u8> = colors.iter().map(level).collect();
        let content = Content::Png(picture::encode(&montage.draw(&levels)));
        self.assert(device, &Record { name, description, rule: Rule::Picture(montage), content });
    }

    fn assert(&self, device: &str, record: &Record<'_>) {
        let picture = report::path(record.name, device);
        let found = Arc::new(Mutex::new(None));
        let held = RecordedRule { rule: record.rule, found: found.clone() };
        let result = catch_unwind(AssertUnwindSafe(|| match device {
            "cpu" => self.assert_accepted(record, held),
            _ => self.assert_same(record, &held),
        }));
        let mismatch: Option<Mismatch> = found.lock().expect("no test panics there").take();
        match (result, mismatch) {
            (Ok(()), None) => _ = std::fs::remove_file(&picture),
            (result, Some(mismatch)) => {
                report::save(&mismatch.panels, &picture);
                let text = mismatch.report(record.name, device, &picture);
                match result {
                    // INSTA_UPDATE has accepted it, or INSTA_FORCE_PASS has left it for review
                    Ok(()) => println!("{text}"),
                    Err(_) => panic!("{text}"),
                }
            }
            (Err(panic), None) => std::panic::resume_unwind(panic),
        }
    }

    fn assert_accepted(&self, record: &Record<'_>, held: RecordedRule) {
        let mut settings = Settings::clone_current();
        settings.set_snapshot_path(self.folder());
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.set_description(record.description);
        settings.set_comparator(Box::new(held));
        settings.bind(|| match &record.content {
            Content::Text(text) => (self.text)(record.name, text),
            Content::Png(png) => (self.png)(record.name, png.clone()),
        });
    }

    fn assert_same(&self, record: &Record<'_>, held: &RecordedRule) {
        let path = self.folder().join(format!("{}.snap", record.name));
        let accepted = Snapshot::from_file(&path)
            .unwrap_or_else(|error| panic!("{}: {error}: accept the CPU's first", path.display()));
        let contents = match &record.content {
            Content::Text(text) => {
                TextSnapshotContents::new(text.clone(), TextSnapshotKind::File).into()
            }
            Content::Png(png) => SnapshotContents::Binary(Some(Rc::new(png.clone()))),
        };
        let same = held.allows(accepted.contents(), &contents);
        let force_pass = std::env::var_os("INSTA_FORCE_PASS").is_some_and(|value| value != "0");
        assert!(same || force_pass, "{} differs", record.name);
    }
}
