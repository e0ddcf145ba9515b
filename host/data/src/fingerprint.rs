//! Identifies a data set, so that a run only resumes with the data that it began with.

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::Point;
use super::lens::Lens;
use organza_core::{Camera, hex};

/// SHA-256 of a photograph's file, and of its mask if it has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Digest([u8; 32]);

impl Digest {
    pub fn new(photograph: &[u8], mask: Option<&[u8]>) -> Self {
        let hash = Sha256::new().chain_update(photograph);
        Self(hash.chain_update(mask.unwrap_or_default()).finalize().into())
    }
}

/// Hashes of a data set. Two data sets with the same fingerprint have the same content.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fingerprint {
    /// Each frame's name, camera and lens, and whether it is held out.
    frames: String,
    /// The photographs' files; empty if there are none, because frames were rendered.
    photographs: String,
    /// The points from which training may start.
    points: String,
}

impl Fingerprint {
    /// Describes the difference to `earlier`; `None` if there is none.
    pub fn difference(&self, earlier: &Self) -> Option<&'static str> {
        let parts = [
            (
                &self.frames,
                &earlier.frames,
                "frames (their number, names, cameras or held-out ones)",
            ),
            (&self.photographs, &earlier.photographs, "photographs"),
            (&self.points, &earlier.points, "starting points"),
        ];
        parts.into_iter().find(|(now, then, _)| now != then).map(|(_, _, what)| what)
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
            hash.update([lens.fisheye, held_out].map(u8::from));
            if let Some(cut) = lens.cut {
                hash.update(format!("{cut:?} {}", lens.panorama));
            }
        }
        let frames = digits(hash);
        let mut hash = Sha256::new();
        for Point { position, color } in points {
            position.iter().for_each(|value| hash.update(value.to_bits().to_le_bytes()));
            hash.update([u8::from(color.is_some())]);
            hash.update(color.unwrap_or_default());
        }
        Self { frames, photographs: String::new(), points: digits(hash) }
    }

    pub(super) fn with_photographs(self, photographs: &[Digest]) -> Self {
        let mut hash = Sha256::new();
        photographs.iter().for_each(|digest| hash.update(digest.0));
        let photographs = if photographs.is_empty() { String::new() } else { digits(hash) };
        Self { photographs, ..self }
    }
}

/// 32 digits are enough: no one searches for a collision.
fn digits(hash: Sha256) -> String {
    let mut digits = hex(hash);
    digits.truncate(32);
    digits
}
