//! Compares a record with the accepted one, and describes the difference.

use std::path::Path;
use std::sync::{Arc, Mutex};

use image::RgbImage;
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot};

use super::picture::{self, Montage};
use super::report::{self, Panels};
use super::tensors::{Tensor, Tensors};

/// The error allowed for a value of a tensor: `absolute + relative * |expected|`.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// Absolute part, in the tensor's own unit.
    pub absolute: f64,
    /// Part relative to the expected value.
    pub relative: f64,
}

/// Two records that differ.
#[derive(Clone, Debug)]
pub struct Mismatch {
    /// Size and place of the difference.
    pub message: String,
    /// Pictures to show.
    pub panels: Panels,
}

impl Mismatch {
    /// The message of a failing test.
    pub fn report(&self, name: &str, backend: &str, picture: &Path) -> String {
        let picture = picture.canonicalize().unwrap_or_else(|_| picture.to_owned());
        let what = &self.message;
        let path = picture.display();
        let amplification = self.panels.amplification;
        format!(
            "snapshot `{name}` on {backend}: {what}\n  expected | actual | difference x {amplification}: {path}\n  \
             `cargo insta review` or INSTA_UPDATE=always accepts it"
        )
    }
}

impl Tolerance {
    fn allows(&self, tensor: &Tensor, expected: f64, actual: f64) -> bool {
        // NaN is never right. An infinity is right only where it is expected.
        let allowed =
            if tensor.exact { 0.0 } else { self.absolute + self.relative * expected.abs() };
        actual == expected || (expected.is_finite() && (actual - expected).abs() <= allowed)
    }

    /// Compares tensors with the accepted ones. Names, their order and shapes must be the same.
    pub fn compare(&self, expected: &Tensors, actual: &Tensors) -> Result<(), Mismatch> {
        let accepted = heads(expected);
        let found = heads(actual);
        if let Some(at) =
            (0..accepted.len().max(found.len())).find(|&i| accepted.get(i) != found.get(i))
        {
            let of = |heads: &[String]| heads.get(at).cloned().unwrap_or("nothing".to_owned());
            let message = format!("shapes differ: {} for {}", of(&found), of(&accepted));
            let panels = report::tensor_panels(expected.0.get(at), actual.0.get(at));
            return Err(Mismatch { message, panels });
        }
        let pairs = expected.0.iter().zip(&actual.0);
        let differing = pairs.filter_map(|(e, a)| Some((&e.name, self.worst(e, a)?)));
        let mut differing = differing.collect::<Vec<_>>().into_iter();
        // Report the first one: tensors are in the order of the stages, and later differences follow from it.
        let Some((_, mut mismatch)) = differing.next() else { return Ok(()) };
        let others: Vec<String> = differing.map(|(name, _)| format!("`{name}`")).collect();
        if !others.is_empty() {
            mismatch.message += &format!("; differing after it: {}", others.join(", "));
        }
        Err(mismatch)
    }

    fn worst(&self, expected: &Tensor, actual: &Tensor) -> Option<Mismatch> {
        let values = || expected.values.iter().zip(&actual.values).enumerate();
        let beyond = values().filter(|(_, (e, a))| !self.allows(expected, **e, **a)).count();
        if beyond == 0 {
            return None;
        }
        let failing = values().filter(|(_, (e, a))| !self.allows(expected, **e, **a));
        let (index, (&e, &a)) =
            failing.max_by(|x, y| apart(*x.1.0, *x.1.1).total_cmp(&apart(*y.1.0, *y.1.1)))?;
        let allowed = match expected.exact {
            true => "it must be equal".to_owned(),
            false => format!("allowed is {:.1e} + {:.1e} |expected|", self.absolute, self.relative),
        };
        let message = format!(
            "`{}` {:?} is {:.3e} apart at {}: {a} for {e}; {allowed}; {beyond} of {} values are beyond",
            expected.name,
            expected.shape,
            apart(e, a),
            place(&expected.shape, index),
            expected.values.len(),
        );
        Some(Mismatch { message, panels: report::tensor_panels(Some(expected), Some(actual)) })
    }
}

/// The difference of two values; infinite if it is NaN.
fn apart(e: f64, a: f64) -> f64 {
    if (a - e).is_nan() { f64::INFINITY } else { (a - e).abs() }
}

/// Name and shape of each tensor.
fn heads(tensors: &Tensors) -> Vec<String> {
    let head = |tensor: &Tensor| format!("{} {:?}", tensor.name, tensor.shape);
    tensors.0.iter().map(head).collect()
}

/// Describes an index: tile, channel, row and column if the shape is one of tiles.
fn place(shape: &[usize], mut index: usize) -> String {
    let mut at = vec![0; shape.len()];
    for (place, &size) in at.iter_mut().zip(shape).rev() {
        *place = index % size;
        index /= size;
    }
    match (shape, at.as_slice()) {
        ([_, 3, height, width], &[tile, channel, row, column]) if height == width => {
            let channel = ["red", "green", "blue"][channel];
            format!("tile {tile}, channel {channel}, row {row}, column {column}")
        }
        _ => format!("{at:?}"),
    }
}

/// Allowed difference of every channel of a picture, in steps of 255: a value near the middle of two steps is rounded
/// to either.
pub const STEPS: u8 = 1;
/// At the edge of a Gaussian's support the falloff jumps from 1/255 to 0, and rounding decides on which side a pixel
/// lies. One pixel among this many may therefore differ by one step more.
pub const EDGE_PIXELS: usize = 500;
/// Allowed difference of such a pixel, in steps.
pub const EDGE_STEPS: u8 = STEPS + 1;

/// Compares a picture with the accepted one.
pub fn compare_pictures(
    montage: &Montage,
    expected: &RgbImage,
    actual: &RgbImage,
) -> Result<(), Mismatch> {
    let panels = || report::picture_panels(expected, actual);
    if expected.dimensions() != actual.dimensions() {
        let found = actual.dimensions();
        let accepted = expected.dimensions();
        let message = format!("sizes differ: {found:?} pixels for {accepted:?}");
        return Err(Mismatch { message, panels: panels() });
    }
    let mut beyond = 0;
    let mut largest = 0;
    let mut at = (0, 0, 0);
    for ((x, y, e), a) in expected.enumerate_pixels().zip(actual.pixels()) {
        let apart = [0, 1, 2].map(|channel| e.0[channel].abs_diff(a.0[channel]));
        beyond += usize::from(apart.iter().any(|&steps| steps > STEPS));
        for (channel, steps) in apart.into_iter().enumerate() {
            if steps > largest {
                largest = steps;
                at = (x, y, channel);
            }
        }
    }
    // Count each enlarged pixel once.
    let beyond = beyond / (montage.scale * montage.scale);
    let pixels = montage.pixels();
    if largest <= STEPS || (largest <= EDGE_STEPS && beyond * EDGE_PIXELS <= pixels) {
        return Ok(());
    }
    let (x, y, channel) = at;
    let message = format!(
        "{largest} of 255 steps apart at {}: {} for {}; allowed is {STEPS}, and {EDGE_STEPS} for one pixel in \
         {EDGE_PIXELS}; {beyond} of {pixels} pixels are beyond {STEPS}",
        montage.describe([x, y], channel),
        actual.get_pixel(x, y).0[channel],
        expected.get_pixel(x, y).0[channel],
    );
    Err(Mismatch { message, panels: panels() })
}

/// The way in which a record is compared.
#[derive(Clone, Copy, Debug)]
pub enum Rule {
    /// Text of [`Tensors`].
    Tensors(Tolerance),
    /// A PNG of a montage.
    Picture(Montage),
}

impl Rule {
    /// Compares the contents of two snapshots.
    fn compare(
        &self,
        reference: &SnapshotContents,
        test: &SnapshotContents,
    ) -> Result<(), Mismatch> {
        let result = match (self, (reference, test)) {
            (Self::Tensors(tolerance), (SnapshotContents::Text(e), SnapshotContents::Text(a))) => {
                let both = (Tensors::parse(&e.to_string()), Tensors::parse(&a.to_string()));
                match both {
                    (Ok(e), Ok(a)) => return tolerance.compare(&e, &a),
                    (Err(reason), _) | (_, Err(reason)) => Err(reason),
                }
            }
            (
                Self::Picture(montage),
                (SnapshotContents::Binary(Some(e)), SnapshotContents::Binary(Some(a))),
            ) => match (picture::decode(e), picture::decode(a)) {
                (Ok(e), Ok(a)) => return compare_pictures(montage, &e, &a),
                (Err(reason), _) | (_, Err(reason)) => Err(reason),
            },
            _ => Err("the accepted snapshot is of another kind, or its PNG is missing".to_owned()),
        };
        result.map_err(|message| Mismatch { message, panels: report::no_panels() })
    }
}

/// A [`Rule`] in the form that insta wants. It keeps the mismatch for the message.
#[derive(Clone, Debug)]
pub struct RecordedRule {
    /// The rule for the comparison.
    pub rule: Rule,
    /// The mismatch, if there was one.
    pub found: Arc<Mutex<Option<Mismatch>>>,
}

impl RecordedRule {
    /// Whether the rule accepts the content of `test` in place of `reference`.
    pub fn allows(&self, reference: &SnapshotContents, test: &SnapshotContents) -> bool {
        let found = self.rule.compare(reference, test).err();
        let matches = found.is_none();
        *self.found.lock().expect("no test panics here") = found;
        matches
    }
}

impl Comparator for RecordedRule {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        self.allows(reference.contents(), test.contents())
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}
