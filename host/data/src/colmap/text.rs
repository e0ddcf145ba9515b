//! Reads `cameras.txt`, `images.txt` and `points3D.txt`: one record per line, with values between spaces.

use std::iter::Enumerate;
use std::path::Path;
use std::str::FromStr;

use super::model::{Intrinsics, Lenses};
use super::{Cameras, Image, Points, Support, add};
use crate::Point;
use organza_core::error::{Result, invalid};

/// Longest line of an image's pose, in bytes.
const MAX_POSE: usize = 1 << 13;

/// Reads `cameras.txt`.
pub(super) fn cameras(text: &str, path: &Path) -> Result<Cameras> {
    let mut lines = Lines::new(text, path);
    let mut cameras = Cameras::new();
    while lines.next_record() {
        let (id, intrinsics) = lines.parse(camera)?;
        add(&mut cameras, id, intrinsics, path)?;
    }
    Ok(cameras)
}

/// Reads `images.txt`.
pub(super) fn images(text: &str, path: &Path) -> Result<Vec<Image>> {
    let mut lines = Lines::new(text, path);
    let mut images = Vec::new();
    let mut is_there = lines.next_record();
    while is_there {
        images.push(lines.parse(image)?);
        is_there = lines.next_image();
    }
    Ok(images)
}

/// Reads `points3D.txt`.
pub(super) fn points(text: &str, path: &Path) -> Result<Points> {
    let mut lines = Lines::new(text, path);
    let mut points = Points::new();
    let mut colors = Vec::new();
    while lines.next_record() {
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
struct Lines<'a> {
    rest: Enumerate<std::str::Lines<'a>>,
    path: &'a Path,
    line: &'a str,
    /// Number of the current line, from 1.
    number: usize,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str, path: &'a Path) -> Self {
        // some editors begin a file with a mark
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self { rest: text.lines().enumerate(), path, line: "", number: 0 }
    }

    /// Moves to the next line, if there is one.
    fn advance(&mut self) -> bool {
        let Some((index, line)) = self.rest.next() else { return false };
        self.line = line.trim();
        self.number = index + 1;
        true
    }

    /// Moves from an image to the next. The line between them has the image's observations, may be of any length or empty, and
    /// is missing in files that people write by hand.
    fn next_image(&mut self) -> bool {
        self.advance() && self.line.len() < MAX_POSE && is_pose(self.line) || self.next_record()
    }

    /// Moves to the next line that is neither empty nor a comment.
    fn next_record(&mut self) -> bool {
        while self.advance() {
            if !self.line.is_empty() && !self.line.starts_with('#') {
                return true;
            }
        }
        false
    }

    fn parse<T>(&self, parse: impl FnOnce(&str) -> Result<T, String>) -> Result<T> {
        parse(self.line)
            .or_else(|reason| invalid(self.path, format!("line {}: {reason}", self.number)))
    }
}
