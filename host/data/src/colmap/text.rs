//! Reads `cameras.txt`, `images.txt` and `points3D.txt`: one record per line, with values between spaces.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::str::FromStr;

use super::model::{Intrinsics, Lenses};
use super::{Cameras, Image, Points, Support, add};
use crate::Point;
use organza_core::error::{Error, Result, invalid};

/// Longest line of a record, in bytes. A point that 50,000 images see needs less.
const MAX_LINE: u64 = 1 << 20;

/// Longest line of an image's pose, in bytes.
const MAX_POSE: u64 = 1 << 13;

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
    let mut is_there = lines.next_record()?;
    while is_there {
        images.push(lines.parse(image)?);
        is_there = lines.next_image()?;
    }
    Ok(images)
}

/// Reads `points3D.txt`.
pub(super) fn points(source: impl Read, path: &Path) -> Result<Points> {
    let mut lines = Lines::new(source, path);
    let mut points = Points::new();
    let mut colors = Vec::new();
    while lines.next_record()? {
        let (id, position, color, support) = lines.parse(point)?;
        points.push((id, Point { position, color: None }, support));
        colors.push(color);
    }
    // some programs write 0 to 1
    let is_part = |value: &f64| *value <= 1.0;
    let values = colors.as_flattened();
    let is_parts = values.iter().all(is_part) && values.iter().any(|value| value.fract() > 0.0);
    let max = if is_parts { 255.0 } else { 1.0 };
    for ((_, point, _), color) in points.iter_mut().zip(colors) {
        point.color = Some(color.map(|value| (max * value).round() as u8));
    }
    Ok(points)
}

fn camera(mut line: &str) -> Result<(u32, Intrinsics), String> {
    let id = value(&mut line, "CAMERA_ID")?;
    let lenses = Lenses::from_name(word(&mut line))?;
    let size = [whole(&mut line, "WIDTH")?, whole(&mut line, "HEIGHT")?];
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

/// Whether a line is an image's pose. Lines of observations are triples of numbers.
fn is_pose(line: &str) -> bool {
    let numbers = || line.split_whitespace().map(str::parse::<f64>);
    let is_triples = numbers().count().is_multiple_of(3) && numbers().all(|number| number.is_ok());
    !is_triples && image(line).is_ok()
}

/// A point's id, position, color and support.
type Row = (u64, [f64; 3], [f64; 3], Support);

fn point(mut line: &str) -> Result<Row, String> {
    let id = whole(&mut line, "POINT3D_ID").map_err(|reason| {
        format!("{reason}; a line begins with the point's id: is it left out?")
    })?;
    let mut next = |name| value(&mut line, name);
    let position = [next("X")?, next("Y")?, next("Z")?];
    let color = [channel(&mut line, "R")?, channel(&mut line, "G")?, channel(&mut line, "B")?];
    // Files that people write by hand may end here.
    let error = word(&mut line).parse().unwrap_or(-1.0);
    let images = line.split_whitespace().count() as u64 / 2;
    Ok((id, position, color, Support { error, images }))
}

/// A part of a color, also as `45.0`.
fn channel(line: &mut &str, name: &str) -> Result<f64, String> {
    let channel: f64 = value(line, name)?;
    match (0.0..=255.0).contains(&channel) {
        true => Ok(channel),
        false => Err(format!("{name} is `{channel}`, expected 0 to 255")),
    }
}

/// A number of pixels or of a point, also as `96.0`.
fn whole(line: &mut &str, name: &str) -> Result<u64, String> {
    let number: f64 = value(line, name)?;
    match number >= 0.0 && number.fract() == 0.0 {
        true => Ok(number as u64),
        false => Err(format!("{name} is `{number}`, expected a whole number")),
    }
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

    /// Moves from an image to the next. The line between them has the image's observations, may be of any length or empty, and
    /// is missing in files that people write by hand.
    fn next_image(&mut self) -> Result<bool> {
        self.number += 1;
        let cannot_read = |source| Error::read(self.path, source);
        let mut start = Vec::new();
        let begin = &mut self.reader.by_ref().take(MAX_POSE);
        begin.read_until(b'\n', &mut start).map_err(cannot_read)?;
        if start.len() as u64 == MAX_POSE && !start.ends_with(b"\n") {
            self.reader.skip_until(b'\n').map_err(cannot_read)?;
        } else if let Ok(line) = String::from_utf8(start)
            && is_pose(line.trim())
        {
            self.line = line;
            return Ok(true);
        }
        self.next_record()
    }

    /// Moves to the next line that is neither empty nor a comment.
    fn next_record(&mut self) -> Result<bool> {
        while self.advance()? {
            // some editors begin a file with a mark
            if self.number == 1 && self.line.starts_with('\u{feff}') {
                self.line.remove(0);
            }
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
