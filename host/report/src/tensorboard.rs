//! TensorBoard's event file: a copy of the log in TensorBoard's format, with pictures of held-out views.
//!
//! The file is a sequence of records: the length as u64, its checksum, the bytes, and their checksum. The bytes are
//! an `Event` of `tensorflow/core/util/event.proto`.

#[cfg(test)]
mod tests;

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use prost::Message;

use organza_core::error::{Error, Result};
use organza_core::image::Image;
use organza_core::input::read_file;
use organza_core::write_inside;
use organza_train::TENSORBOARD;

/// Name of the file in it. TensorBoard reads every file with `tfevents` in its name.
const FILE: &str = "events.out.tfevents.0.organza";
/// Largest file, in bytes. No run writes as much.
const MAX_BYTES: u64 = 4 << 30;
/// Number of held-out views whose pictures are written.
pub(super) const MAX_VIEWS: usize = 8;
/// Longer side of a picture, in pixels. Larger pictures are shrunk by an integer factor.
const MAX_SIDE: u32 = 512;

#[derive(Clone, PartialEq, Message)]
struct Event {
    #[prost(double, tag = "1")]
    wall_time: f64,
    #[prost(int64, tag = "2")]
    step: i64,
    #[prost(string, optional, tag = "3")]
    file_version: Option<String>,
    #[prost(message, optional, tag = "5")]
    summary: Option<Summary>,
}

#[derive(Clone, PartialEq, Message)]
struct Summary {
    #[prost(message, repeated, tag = "1")]
    value: Vec<Value>,
}

#[derive(Clone, PartialEq, Message)]
struct Value {
    #[prost(string, tag = "1")]
    tag: String,
    #[prost(float, optional, tag = "2")]
    simple_value: Option<f32>,
    #[prost(message, optional, tag = "4")]
    image: Option<Picture>,
}

#[derive(Clone, PartialEq, Message)]
struct Picture {
    #[prost(int32, tag = "1")]
    height: i32,
    #[prost(int32, tag = "2")]
    width: i32,
    /// Color space; 3 is RGB.
    #[prost(int32, tag = "3")]
    colorspace: i32,
    #[prost(bytes = "vec", tag = "4")]
    encoded_image_string: Vec<u8>,
}

/// An event file that is open for writing.
#[derive(Debug)]
pub(super) struct EventLog {
    path: PathBuf,
    file: File,
}

impl EventLog {
    /// Starts a file in a run's folder, and replaces an old one.
    pub fn create(run: &Path) -> Result<Self> {
        Self::begin(run, Vec::new())
    }

    /// Continues a file after `step`. Later events are dropped, and so is an incomplete one. If there is no file, a
    /// new one is started.
    pub fn resume(run: &Path, step: u64) -> Result<Self> {
        let path = run.join(TENSORBOARD).join(FILE);
        if !path.exists() {
            return Self::create(run);
        }
        let bytes = read_file(&path, MAX_BYTES, "a TensorBoard event file")?;
        let mut kept = Vec::new();
        for event in events(&bytes) {
            let is_kept =
                event.summary.is_some() && u64::try_from(event.step).is_ok_and(|s| s <= step);
            if is_kept {
                kept.extend(record(&event));
            }
        }
        Self::begin(run, kept)
    }

    fn begin(run: &Path, kept: Vec<u8>) -> Result<Self> {
        let folder = run.join(TENSORBOARD);
        fs::create_dir_all(&folder).map_err(|source| Error::write(&folder, source))?;
        let path = folder.join(FILE);
        let file_version = Some("brain.Event:2".to_owned());
        let version = Event { wall_time: now(), file_version, ..Event::default() };
        write_inside(&path, |writer| {
            writer.write_all(&record(&version))?;
            writer.write_all(&kept)
        })?;
        let file = File::options().append(true).open(&path);
        let file = file.map_err(|source| Error::write(&path, source))?;
        Ok(Self { path, file })
    }

    /// Writes the numbers of a step; `None` is left out.
    pub fn scalars(
        &mut self,
        step: u64,
        scalars: impl IntoIterator<Item = (String, Option<f64>)>,
    ) -> Result<()> {
        let value = |(tag, value): (String, Option<f64>)| {
            Some(Value { tag, simple_value: Some(value? as f32), image: None })
        };
        self.append(step, scalars.into_iter().filter_map(value).collect())
    }

    /// Writes a picture of a step.
    pub fn picture(&mut self, step: u64, tag: String, image: &Image) -> Result<()> {
        let [width, height] = image.size();
        let small = image.shrink(width.max(height).div_ceil(MAX_SIDE))?;
        let encoded = small.encode_png().map_err(|source| Error::write(&self.path, source))?;
        let [width, height] = small.size().map(|size| size as i32);
        let image = Picture { height, width, colorspace: 3, encoded_image_string: encoded };
        self.append(step, vec![Value { tag, simple_value: None, image: Some(image) }])
    }

    fn append(&mut self, step: u64, value: Vec<Value>) -> Result<()> {
        let summary = Some(Summary { value });
        let event = Event { wall_time: now(), step: step as i64, file_version: None, summary };
        // written in one call, so that only a crash can leave half an event
        let written = self.file.write_all(&record(&event)).and_then(|()| self.file.flush());
        written.map_err(|source| Error::write(&self.path, source))
    }
}

/// Seconds since 1970, now.
fn now() -> f64 {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0.0, |time| time.as_secs_f64())
}

/// CRC-32C, rotated and shifted as in TensorFlow.
fn checksum(bytes: &[u8]) -> [u8; 4] {
    let crc = crc32c::crc32c(bytes);
    crc.rotate_right(15).wrapping_add(0xa282_ead8).to_le_bytes()
}

fn record(event: &Event) -> Vec<u8> {
    let bytes = event.encode_to_vec();
    let length = (bytes.len() as u64).to_le_bytes();
    [&length[..], &checksum(&length), &bytes, &checksum(&bytes)].concat()
}

/// The events of a file, up to the first incomplete one.
fn events(mut bytes: &[u8]) -> impl Iterator<Item = Event> {
    std::iter::from_fn(move || {
        let (length, rest) = bytes.split_first_chunk::<8>()?;
        let (check, rest) = rest.split_first_chunk::<4>()?;
        let event = rest.get(..usize::try_from(u64::from_le_bytes(*length)).ok()?)?;
        let (event_check, next) = rest[event.len()..].split_first_chunk::<4>()?;
        if *check != checksum(length) || *event_check != checksum(event) {
            return None;
        }
        bytes = next;
        Event::decode(event).ok()
    })
}
