//! Reads `cameras.txt`, `images.txt` and `points3D.txt`: one record per line, with values between spaces.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::str::FromStr;

use super::model::{Intrinsics, Lenses};
use super::{Cameras, Image, Points, add};
use crate::{Point, invalid};
use organza_core::error::{Error, Result};

/// Longest line of a record, in bytes. A point that 50,000 images see needs less.
const MAX_LINE: u64 = 1 << 20;

/// Reads `cameras.txt`.
pub(super) fn cameras(source: impl Read, path: &Path) -> Result<Cameras> {
    let mut lines = Lines::new(source, path);
    let mut cameras = Cameras::new();
    while lines.next_record()? {
        let (id, intrinsics) = lines.parse(camera)?;
        add(&mut cameras, id, intrinsics, path)?;
    }
    Ok(cameras)
}

/// Reads `images.txt`.
pub(super) fn images(source: impl Read, path: &Path) -> Result<Vec<Image>> {
    let mut lines = Lines::new(source, path);
    let mut images = Vec::new();
    while lines.next_record()? {
        images.push(lines.parse(image)?);
        // The second line has the image's observations, and may be empty.
        lines.skip()?;
    }
    Ok(images)
}

/// Reads `points3D.txt`.
pub(super) fn points(source: impl Read, path: &Path) -> Result<Points> {
    let mut lines = Lines::new(source, path);
    let mut points = Points::new();
    while lines.next_record()? {
        points.push(lines.parse(point)?);
    }
    Ok(points)
}

fn camera(mut line: &str) -> Result<(u32, Intrinsics), String> {
    let id = value(&mut line, "CAMERA_ID")?;
    let lenses = Lenses::from_name(word(&mut line))?;
    let size = [value(&mut line, "WIDTH")?, value(&mut line, "HEIGHT")?];
    let mut values = Vec::new();
    while !line.is_empty() {
        values.push(value(&mut line, "PARAMS[]")?);
    }
    Ok((id, lenses.intrinsics(size, &values)?))
}

fn image(mut line: &str) -> Result<Image, String> {
    let _id: u32 = value(&mut line, "IMAGE_ID")?;
    let mut next = |name| value(&mut line, name);
    let rotation = [next("QW")?, next("QX")?, next("QY")?, next("QZ")?];
    let translation = [next("TX")?, next("TY")?, next("TZ")?];
    let camera = value(&mut line, "CAMERA_ID")?;
    if line.is_empty() {
        return Err("NAME is missing".to_owned());
    }
    Ok(Image { rotation, translation, camera, name: line.to_owned() })
}

fn point(mut line: &str) -> Result<(u64, Point), String> {
    let id = value(&mut line, "POINT3D_ID")?;
    let mut next = |name| value(&mut line, name);
    let position = [next("X")?, next("Y")?, next("Z")?];
    let color = [value(&mut line, "R")?, value(&mut line, "G")?, value(&mut line, "B")?];
    Ok((id, Point { position, color: Some(color) }))
}

/// Removes the next word from a line.
fn word<'a>(line: &mut &'a str) -> &'a str {
    let (word, rest) = line.split_once(|c: char| c.is_whitespace()).unwrap_or((line, ""));
    *line = rest.trim_start();
    word
}

fn value<T: FromStr>(line: &mut &str, name: &str) -> Result<T, String> {
    match word(line) {
        "" => Err(format!("{name} is missing")),
        word => word.parse().map_err(|_| format!("{name} is `{word}`, expected a number")),
    }
}

/// The lines of a file, with the current position.
struct Lines<'a, R> {
    reader: BufReader<R>,
    path: &'a Path,
    line: String,
    number: u64,
}

impl<'a, R: Read> Lines<'a, R> {
    fn new(source: R, path: &'a Path) -> Self {
        Self { reader: BufReader::new(source), path, line: String::new(), number: 0 }
    }

    /// Moves to the next line, if there is one.
    fn advance(&mut self) -> Result<bool> {
        self.line.clear();
        self.number += 1;
        let read = self.reader.by_ref().take(MAX_LINE).read_line(&mut self.line);
        let read = read.map_err(|source| Error::read(self.path, source))?;
        if read as u64 == MAX_LINE && !self.line.ends_with('\n') {
            let number = self.number;
            let reason = format!("line {number} is longer than {MAX_LINE} bytes; is it damaged?");
            return invalid(self.path, reason);
        }
        Ok(read > 0)
    }

    /// Skips the next line, of any length.
    fn skip(&mut self) -> Result<()> {
        self.number += 1;
        self.reader.skip_until(b'\n').map_err(|source| Error::read(self.path, source))?;
        Ok(())
    }

    /// Moves to the next line that is neither empty nor a comment.
    fn next_record(&mut self) -> Result<bool> {
        while self.advance()? {
            let line = self.line.trim();
            if !line.is_empty() && !line.starts_with('#') {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn parse<T>(&self, parse: impl FnOnce(&str) -> Result<T, String>) -> Result<T> {
        parse(self.line.trim())
            .or_else(|reason| invalid(self.path, format!("line {}: {reason}", self.number)))
    }
}
