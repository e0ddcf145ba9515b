//! Identifies a data set, so that a run and its scores are only taken with the data that it was trained on.

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::Point;
use super::lens::{Lens, Reprojection};
use organza_core::Camera;

/// The first digits of the SHA-256 of a photograph's file and of its mask, if it has one.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Digest(String);

impl Digest {
    /// Number of digits.
    const DIGITS: usize = 16;

    pub fn new(photograph: &[u8], mask: Option<&[u8]>) -> Self {
        let hash = Sha256::new().chain_update(photograph);
        Self(digits(hash.chain_update(mask.unwrap_or_default()), Self::DIGITS))
    }
}

/// Hashes of a data set. Two data sets with the same fingerprint have the same content.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fingerprint {
    /// Each frame's name, camera and lens, and whether it is held out.
    frames: String,
    /// The digests of the frames' photographs; empty if none was read.
    photographs: String,
    /// The points from which training may start.
    points: String,
}

impl Fingerprint {
    /// Describes the difference to `earlier`; `None` if there is none. Photographs that were not read are not compared.
    pub fn difference(&self, earlier: &Self) -> Option<&'static str> {
        let parts = [
            (
                &self.frames,
                &earlier.frames,
                "frames (their number, order, names, cameras or held-out ones)",
            ),
            (&self.photographs, &earlier.photographs, "photographs"),
            (&self.points, &earlier.points, "starting points"),
        ];
        // without photographs, there are no digits
        let differs = |(now, then): (&String, &String)| now != then && now.len() == then.len();
        parts.into_iter().find(|(now, then, _)| differs((now, then))).map(|(_, _, what)| what)
    }

    pub(super) fn new<'a>(
        frames: impl Iterator<Item = (&'a str, &'a Camera, Lens, bool)>,
        points: &[Point],
    ) -> Self {
        let mut hash = Sha256::new();
        for (name, camera, lens, held_out) in frames {
            hash.update((name.len() as u64).to_le_bytes());
            hash.update(name);
            let Camera { fl_x, fl_y, cx, cy, width, height, .. } = *camera;
            let intrinsics = [fl_x, fl_y, cx, cy, f64::from(width), f64::from(height)];
            let pose = camera.camera_to_world.as_flattened();
            for value in pose.iter().copied().chain(intrinsics).chain(lens.coefficients()) {
                hash.update(value.to_bits().to_le_bytes());
            }
            hash.update([lens.projection as u8, held_out.into()]);
            if let Some(Reprojection { axes, focal, center, size }) = lens.cut {
                let axes = axes.into_iter().flat_map(|axis| axis.to_array());
                for value in axes.chain(focal).chain(center).chain(size.map(f64::from)) {
                    hash.update(value.to_bits().to_le_bytes());
                }
            }
        }
        let frames = digits(hash, 32);
        let mut hash = Sha256::new();
        for Point { position, color } in points {
            position.iter().for_each(|value| hash.update(value.to_bits().to_le_bytes()));
            hash.update([u8::from(color.is_some())]);
            hash.update(color.unwrap_or_default());
        }
        Self { frames, photographs: String::new(), points: digits(hash, 32) }
    }

    pub(super) fn with_photographs(self, photographs: &[Digest]) -> Self {
        Self { photographs: photographs.iter().map(|digest| &*digest.0).collect(), ..self }
    }

    /// The digest of each frame's photograph.
    pub(super) fn photographs(&self) -> impl ExactSizeIterator<Item = Digest> {
        let (digests, _) = self.photographs.as_bytes().as_chunks::<{ Digest::DIGITS }>();
        digests.iter().map(|digest| Digest(String::from_utf8_lossy(digest).into_owned()))
    }
}

/// The first digits of a hash. A few are enough: no one searches for a collision.
pub(super) fn digits(hash: Sha256, count: usize) -> String {
    let mut digits = format!("{:x}", hash.finalize());
    digits.truncate(count);
    digits
}
