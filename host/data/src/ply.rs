//! Reads vertices of PLY files (text, and binary of either byte order), and point clouds in nerfstudio's form.

use std::cell::Cell;
use std::io::{self, BufReader, Read};
use std::path::Path;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};

use super::{Point, invalid};
use muslin_device::memory;
use organza_core::error::{Error, Result};
use organza_core::input::open_regular;

/// Longest header and longest line of text, in bytes. The header of a scan with all its comments has a few kilobytes.
const MAX_LINE: u64 = 1 << 20;
const POSITION: [&str; 3] = ["x", "y", "z"];
const COLOR: [&str; 3] = ["red", "green", "blue"];

/// Reads the vertices of a PLY file.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] if the file is no PLY, was cut short, or has vertices without a finite
/// position.
pub(super) fn read(path: &Path) -> Result<Vec<Point>> {
    let (file, length) = open_regular(path)?;
    read_from(file, length, path)
}

/// [`read`] from a reader of `length` bytes. Errors name `path`.
pub(super) fn read_from(source: impl Read, length: u64, path: &Path) -> Result<Vec<Point>> {
    let (vertices, _) = vertices(source, length, path, &POSITION)?;
    points(&vertices, path)
}

/// Reads the vertices of a PLY file of `length` bytes, and the names of their properties, some of which are required.
/// Errors name `path`.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] for a file that is no PLY or is truncated; [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
pub fn vertices<V: PropertyAccess>(
    source: impl Read,
    length: u64,
    path: &Path,
    needed: &[&str],
) -> Result<(Vec<V>, Vec<String>)> {
    let limit = Cell::new(Some(Limit::Header));
    let since = Cell::new(0);
    let limited = Limited { source, limit: &limit, since: &since };
    let mut reader = Reader::new(BufReader::new(limited));
    let parser = Parser::<V>::new();
    let broken = |error: ParseError| broken(path, &error);
    let header = parser.read_header(&mut reader).map_err(broken)?;
    limit.set((header.encoding == Encoding::Ascii).then_some(Limit::Line));
    since.set(0);
    check(&header, length, path, needed, size_of::<V>())?;
    for element in header.elements.values() {
        // Elements are stored one after the other, so those before the vertices must be read, too.
        let vertices =
            parser.read_payload_for_element(&mut reader, element, &header).map_err(broken)?;
        if element.name == "vertex" {
            return Ok((vertices, element.properties.keys().cloned().collect()));
        }
    }
    invalid(path, "the PLY file has no `vertex` element; is it a point cloud?".to_owned())
}

/// The bytes that a reader counts. A line or a header without an end would otherwise fill the memory.
#[derive(Clone, Copy)]
enum Limit {
    /// Bytes since the start of the file.
    Header,
    /// Bytes since the last line break.
    Line,
}

/// Reads at most [`MAX_LINE`] bytes, counted according to `limit`.
struct Limited<'a, R> {
    source: R,
    limit: &'a Cell<Option<Limit>>,
    since: &'a Cell<u64>,
}

impl<R: Read> Read for Limited<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.source.read(buffer)?;
        let Some(limit) = self.limit.get() else { return Ok(read) };
        let end = buffer[..read].iter().rposition(|&byte| byte == b'\n');
        let since = match (limit, end) {
            (Limit::Line, Some(end)) => (read - end) as u64,
            _ => self.since.get() + read as u64,
        };
        self.since.set(since);
        match since > MAX_LINE {
            true => Err(io::Error::other(TOO_LONG)),
            false => Ok(read),
        }
    }
}

/// Message of the error. [`broken`] recognizes it by this text, too.
const TOO_LONG: &str = "a line is too long";

/// Checks the header against the file: it must not promise more than there is.
fn check(
    header: &Header,
    length: u64,
    path: &Path,
    needed: &[&str],
    vertex_bytes: usize,
) -> Result<()> {
    for element in header.elements.values() {
        let count = element.count as u64;
        let name = &element.name;
        if count > 0 && element.properties.is_empty() {
            let reason = format!(
                "the header has {count} of `{name}`, which has no properties; is the file damaged?"
            );
            return invalid(path, reason);
        }
        if count.saturating_mul(fewest_bytes(element, header.encoding)) > length {
            let reason = format!(
                "the header has {count} of `{name}`, more than {length} bytes can hold; the file \
                 was cut short or is damaged"
            );
            return invalid(path, reason);
        }
        // the vertices as read, and the result
        memory::check(count.saturating_mul(2 * vertex_bytes as u64), "the vertices")?;
    }
    let vertex = header.elements.get("vertex");
    let missing =
        vertex.and_then(|vertex| needed.iter().find(|key| !vertex.properties.contains_key(**key)));
    if let Some(key) = missing {
        let is_packed = vertex.is_some_and(|v| v.properties.contains_key("packed_position"));
        let hint =
            if is_packed { "; it is packed, as SuperSplat does: write it unpacked" } else { "" };
        let needed = needed.join(", ");
        let reason = format!("vertices have no property `{key}`, expected {needed}{hint}");
        return invalid(path, reason);
    }
    Ok(())
}

/// Least number of bytes of one element in a file.
fn fewest_bytes(element: &ElementDef, encoding: Encoding) -> u64 {
    let size = |scalar: &ScalarType| match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    };
    let properties = element.properties.values();
    match encoding {
        // a digit and a separator, except at the end of the last line
        Encoding::Ascii => (2 * properties.count() as u64).saturating_sub(1),
        _ => properties
            .map(|property| match &property.data_type {
                PropertyType::Scalar(scalar) | PropertyType::List(scalar, _) => size(scalar),
            })
            .sum(),
    }
}

fn points(vertices: &[Vertex], path: &Path) -> Result<Vec<Point>> {
    let point = |(index, vertex): (usize, &Vertex)| {
        let position = vertex.position;
        if !position.iter().all(|&value| (value as f32).is_finite()) {
            let reason = format!("vertex {index} is at {position:?}, expected finite coordinates");
            return invalid(path, reason);
        }
        let [red, green, blue] = vertex.color;
        let color = red.zip(green).zip(blue).map(|((red, green), blue)| [red, green, blue]);
        Ok(Point { position, color })
    };
    vertices.iter().enumerate().map(point).collect()
}

/// The parts of an element that are kept: a vertex's position, and its color if it has 8 bits.
#[derive(Clone, Copy)]
struct Vertex {
    position: [f64; 3],
    color: [Option<u8>; 3],
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self { position: [f64::NAN; 3], color: [None; 3] }
    }

    fn set_property(&mut self, key: &str, property: Property) -> PropertyAccessResult {
        let find = |keys: [&str; 3]| keys.iter().position(|name| *name == key);
        if let Some(axis) = find(POSITION) {
            let Some(value) = number(&property) else {
                return PropertyAccessResult::UnsupportedType;
            };
            self.position[axis] = value;
        } else if let (Some(channel), Property::UChar(value)) = (find(COLOR), property) {
            self.color[channel] = Some(value);
        }
        PropertyAccessResult::Set
    }
}

/// The value of a property, if it is a single number.
pub fn number(property: &Property) -> Option<f64> {
    Some(match *property {
        Property::Char(value) => value.into(),
        Property::UChar(value) => value.into(),
        Property::Short(value) => value.into(),
        Property::UShort(value) => value.into(),
        Property::Int(value) => value.into(),
        Property::UInt(value) => value.into(),
        Property::Float(value) => value.into(),
        Property::Double(value) => value,
        _ => return None,
    })
}

/// The parser's own message quotes the text that it could not read. That could be any file, so it is not shown.
fn broken(path: &Path, error: &ParseError) -> Error {
    let place = match (error.kind(), error.line()) {
        (io::ErrorKind::UnexpectedEof, _) => "it was cut short".to_owned(),
        _ if error.to_string().contains(TOO_LONG) => {
            format!("its header, or a line of it, is longer than {MAX_LINE} bytes")
        }
        (_, Some(line)) => format!("line {line} does not parse"),
        (_, None) => "a value does not parse".to_owned(),
    };
    let reason = format!("not a whole PLY file: {place}; copy it again, or write it again");
    Error::Invalid { origin: path.to_owned(), reason }
}
