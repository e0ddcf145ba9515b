//! Reads `cameras.bin`, `images.bin` and `points3D.bin`: little endian, a count followed by as many records.

use std::ffi::CStr;
use std::path::Path;

use super::model::Lenses;
use super::{Cameras, Image, Points, Support, add};
use crate::Point;
use organza_core::error::{Result, invalid};

/// Bytes of an image's observation: two coordinates and a point's id.
const OBSERVATION: u64 = 24;
/// Bytes of an entry in a point's track: an image's id and an index.
const TRACK_ENTRY: u64 = 8;

/// Reads `cameras.bin`.
pub(super) fn cameras(bytes: &[u8], path: &Path) -> Result<Cameras> {
    let mut records = Records::new(bytes, path, "camera", 24)?;
    let mut cameras = Cameras::new();
    while records.next() {
        let id = records.u32()?;
        let known = Lenses::from_id(records.u32()?.cast_signed());
        let lenses = known.or_else(|reason| invalid(path, format!("camera {id}: {reason}")))?;
        let size = [records.u64()?, records.u64()?];
        let values = (0..lenses.parameters()).map(|_| records.f64()).collect::<Result<Vec<_>>>()?;
        let intrinsics = lenses.intrinsics(size, &values);
        let intrinsics =
            intrinsics.or_else(|reason| invalid(path, format!("camera {id}: {reason}")))?;
        add(&mut cameras, id, intrinsics, path)?;
    }
    records.finish()?;
    Ok(cameras)
}

/// Reads `images.bin`.
pub(super) fn images(bytes: &[u8], path: &Path) -> Result<Vec<Image>> {
    let mut records = Records::new(bytes, path, "image", 73)?;
    let mut images = Vec::new();
    while records.next() {
        let _id = records.u32()?;
        let rotation = [records.f64()?, records.f64()?, records.f64()?, records.f64()?];
        let translation = [records.f64()?, records.f64()?, records.f64()?];
        let camera = records.u32()?;
        let name = records.name()?;
        let observations = records.u64()?;
        records.skip(observations, OBSERVATION)?;
        images.push(Image { rotation, translation, camera, name });
    }
    records.finish()?;
    Ok(images)
}

/// Reads `points3D.bin`.
pub(super) fn points(bytes: &[u8], path: &Path) -> Result<Points> {
    let mut records = Records::new(bytes, path, "point", 51)?;
    let mut points = Points::new();
    while records.next() {
        let id = records.u64()?;
        let position = [records.f64()?, records.f64()?, records.f64()?];
        let color = Some(records.take::<3>()?);
        let support = Support { error: records.f64()?, images: records.u64()? };
        records.skip(support.images, TRACK_ENTRY)?;
        points.push((id, Point { position, color }, support));
    }
    records.finish()?;
    Ok(points)
}

/// A file of records. A count in it is never trusted beyond the file's length.
struct Records<'a> {
    /// Bytes not read yet.
    rest: &'a [u8],
    path: &'a Path,
    what: &'static str,
    count: u64,
    /// Number of the current record, from 1.
    current: u64,
}

impl<'a> Records<'a> {
    /// Begins to read a file. Each record has at least `smallest` bytes.
    fn new(bytes: &'a [u8], path: &'a Path, what: &'static str, smallest: u64) -> Result<Self> {
        let mut records = Self { rest: bytes, path, what, count: 0, current: 0 };
        let count = records.u64()?;
        if count.saturating_mul(smallest) > records.rest.len() as u64 {
            let reason = format!(
                "the file has room for fewer than the {count} {what}s it says it holds; it was cut \
                 short or is no COLMAP model: copy it again"
            );
            return invalid(path, reason);
        }
        Ok(Self { count, ..records })
    }

    /// Moves to the next record, if there is one.
    fn next(&mut self) -> bool {
        self.current += 1;
        self.current <= self.count
    }

    fn cut_short<T>(&self) -> Result<T> {
        let Self { what, current, count, .. } = self;
        let place = match current {
            0 => "before its first number".to_owned(),
            _ => format!("inside {what} {current} of {count}"),
        };
        invalid(self.path, format!("the file ends {place}; it was cut short: copy it again"))
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        let Some((bytes, rest)) = self.rest.split_first_chunk() else { return self.cut_short() };
        self.rest = rest;
        Ok(*bytes)
    }

    fn u32(&mut self) -> Result<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64> {
        self.take().map(u64::from_le_bytes)
    }

    fn f64(&mut self) -> Result<f64> {
        self.take().map(f64::from_le_bytes)
    }

    /// Reads text up to a zero byte.
    fn name(&mut self) -> Result<String> {
        let Ok(text) = CStr::from_bytes_until_nul(self.rest) else { return self.cut_short() };
        self.rest = &self.rest[text.count_bytes() + 1..];
        text.to_str().map(str::to_owned).or_else(|_| {
            let what = self.what;
            let current = self.current;
            invalid(self.path, format!("the name of {what} {current} is not UTF-8; rename it"))
        })
    }

    fn skip(&mut self, count: u64, size: u64) -> Result<()> {
        let bytes = usize::try_from(count.saturating_mul(size)).unwrap_or(usize::MAX);
        let Some(rest) = self.rest.get(bytes..) else { return self.cut_short() };
        self.rest = rest;
        Ok(())
    }

    fn finish(self) -> Result<()> {
        let Self { rest, path, what, count, .. } = self;
        if rest.is_empty() {
            return Ok(());
        }
        let reason = format!(
            "{} bytes follow the last of {count} {what}s; is it a COLMAP model that this \
             program knows?",
            rest.len()
        );
        invalid(path, reason)
    }
}
