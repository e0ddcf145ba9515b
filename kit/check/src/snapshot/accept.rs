//! Compares the results of devices with accepted files.

use std::fs;
use std::path::PathBuf;

use image::RgbImage;
use insta::internals::SnapshotContents;
use insta::{Settings, Snapshot};

use super::compare::{Tolerance, compare_pictures};
use super::picture::{self, Montage};
use super::tensors::Tensors;

/// A folder of accepted snapshots; [`snapshots`](crate::snapshots!) makes one.
///
/// The snapshot is the CPU's output. Insta accepts it: `INSTA_UPDATE=always cargo test`, or `cargo insta review`. A
/// GPU's output is compared with the accepted file, and is never accepted itself.
#[derive(Clone, Copy, Debug)]
pub struct Snapshots {
    /// Path of the folder in the package.
    folder: &'static str,
    package: &'static str,
    text: fn(&str, &str),
    png: fn(&str, Vec<u8>),
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
    /// If they differ by more than the tolerance, or if a value is NaN.
    pub fn assert_tensors(
        &self,
        name: [&str; 2],
        device: &str,
        tensors: &Tensors,
        tolerance: Tolerance,
    ) {
        let has_nan = tensors.0.iter().any(|tensor| tensor.values.iter().any(|x| x.is_nan()));
        assert!(!has_nan, "NaN in the snapshot `{}` on {device}", name[0]);
        let text = tensors.to_string();
        let compare = |accepted: &SnapshotContents| match accepted {
            // as far as the text has digits
            SnapshotContents::Text(accepted) => {
                tolerance.compare(&Tensors::parse(&accepted.to_string())?, &Tensors::parse(&text)?)
            }
            SnapshotContents::Binary(_) => Err("the accepted snapshot is a picture".to_owned()),
        };
        self.assert(name, device, compare, || (self.text)(name[0], &text));
    }

    /// Compares tiles `[K, 3, S, S]`, with colors from 0 to 1, with the picture `name`. A picture of the difference is left in
    /// cargo's target folder: `snapshot-failures/NAME-DEVICE.png`.
    ///
    /// # Panics
    /// If a pixel differs by more than rounding explains.
    pub fn assert_picture(&self, name: [&str; 2], device: &str, colors: &[f32], montage: Montage) {
        let level = |value: &f32| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
        let levels: Vec<u8> = colors.iter().map(level).collect();
        let found: RgbImage = montage.draw(&levels);
        let failure = failure(name[0], device);
        _ = fs::remove_file(&failure);
        let compare = |accepted: &SnapshotContents| match accepted {
            SnapshotContents::Binary(Some(png)) => {
                let expected = picture::decode(png)?;
                compare_pictures(&montage, &expected, &found).map_err(|message| {
                    let panels = picture::encode(&picture::difference(&expected, &found));
                    let folder = failure.parent().expect("it has a folder");
                    let written =
                        fs::create_dir_all(folder).and_then(|()| fs::write(&failure, panels));
                    written.unwrap_or_else(|error| panic!("{}: {error}", failure.display()));
                    format!("{message}; {} shows it", failure.display())
                })
            }
            _ => Err("the accepted snapshot is no picture, or its PNG is missing".to_owned()),
        };
        self.assert(name, device, compare, || (self.png)(name[0], picture::encode(&found)));
    }

    /// Compares a result with the accepted file. `ask` lets insta fail, or accept the result of the CPU.
    fn assert(
        &self,
        [name, description]: [&str; 2],
        device: &str,
        compare: impl Fn(&SnapshotContents) -> Result<(), String>,
        ask: impl FnOnce(),
    ) {
        let path = self.folder().join(format!("{name}.snap"));
        let found = match Snapshot::from_file(&path) {
            Ok(accepted) => compare(accepted.contents()),
            Err(error) => Err(format!("{}: {error}", path.display())),
        };
        let Err(difference) = found else { return };
        let message = format!("snapshot `{name}` on {device}: {difference}");
        assert!(device == "cpu", "{message}");
        println!("{message}");
        let mut settings = Settings::clone_current();
        settings.set_snapshot_path(self.folder());
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.set_description(description);
        settings.bind(ask);
    }
}

/// The file that shows the difference of a picture.
///
/// # Panics
/// If the test is not run by cargo.
fn failure(name: &str, device: &str) -> PathBuf {
    let test = std::env::current_exe().expect("a test has a program");
    // target/debug/deps/test
    let target = test.ancestors().nth(3).expect("it lies in cargo's target folder");
    target.join(format!("snapshot-failures/{name}-{}.png", device.replace(' ', "-")))
}
