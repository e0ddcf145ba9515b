//! Reads vertices of PLY files (text, and binary of either byte order), and point clouds in nerfstudio's form.

use std::io::{self, Read, Take};
use std::path::Path;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};

use super::Point;
use organza_core::error::{Error, Result, invalid};
use organza_core::input::read_file;
use organza_core::{memory, write_inside};

/// Longest header in bytes. The header of a scan with all its comments has a few kilobytes.
const MAX_HEADER: u64 = 1 << 20;
const VERTEX: &str = "vertex";
const POSITION: [&str; 3] = ["x", "y", "z"];
const COLOR: [&str; 3] = ["red", "green", "blue"];

/// Reads the vertices of a PLY file.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] if the file is no PLY, was cut short, or has vertices without a finite
/// position.
pub(super) fn read(path: &Path) -> Result<Vec<Point>> {
    read_from(&read_file(path, u64::MAX, "a point cloud")?, path)
}

/// [`read`] from a file's bytes. Errors name `path`.
pub(super) fn read_from(bytes: &[u8], path: &Path) -> Result<Vec<Point>> {
    points(&Ply::open(bytes, path)?.vertices(&POSITION)?, path)
}

/// Writes points to a binary PLY file, with colors if all have one.
///
/// # Errors
/// [`Error::WriteFile`].
pub(super) fn write(path: &Path, points: &[Point]) -> Result<()> {
    let colored = points.iter().all(|point| point.color.is_some());
    let position = POSITION.map(|name| format!("property double {name}\n")).concat();
    let color = COLOR.map(|name| format!("property uchar {name}\n")).concat();
    write_inside(path, |writer| {
        let count = points.len();
        write!(writer, "ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{position}")?;
        writeln!(writer, "{}end_header", if colored { &color } else { "" })?;
        for Point { position, color } in points {
            position.iter().try_for_each(|value| writer.write_all(&value.to_le_bytes()))?;
            writer.write_all(color.as_ref().filter(|_| colored).map_or(&[], |color| color))?;
        }
        Ok(())
    })
}

/// A PLY file after its header.
pub struct Ply<'a> {
    reader: Reader<Take<&'a [u8]>>,
    header: Header,
    path: &'a Path,
}

impl<'a> Ply<'a> {
    /// Reads the header. Errors name `path`.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a file that is no PLY, or that is shorter than its header says.
    pub fn open(bytes: &'a [u8], path: &'a Path) -> Result<Self> {
        let length = bytes.len() as u64;
        let mut reader = Reader::new(bytes.take(MAX_HEADER));
        let header = Parser::<Skipped>::new().read_header(&mut reader);
        let source = reader.get_mut();
        if header.is_err() && length > MAX_HEADER && source.limit() == 0 {
            let reason = format!("the PLY file's header is longer than {MAX_HEADER} bytes");
            return invalid(path, reason);
        }
        let header = header.map_err(|error| broken(path, &error))?;
        source.set_limit(u64::MAX);
        check(&header, length, path)?;
        if header.encoding == Encoding::Ascii {
            // all of it may be one line, with its copy in the parser's message
            memory::check(length.saturating_mul(3), "the lines of a PLY file")?;
        }
        Ok(Self { reader, header, path })
    }

    /// The comments in the header, without spaces before them.
    pub fn comments(&self) -> &[String] {
        &self.header.comments
    }

    /// The names of the vertices' properties; none without vertices.
    pub fn properties(&self) -> impl Iterator<Item = &str> {
        let element = self.header.elements.get(VERTEX);
        element.into_iter().flat_map(|element| element.properties.keys().map(String::as_str))
    }

    /// Reads all vertices, which must have the `needed` properties.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a file without vertices or such properties, and for a truncated one;
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn vertices<V: PropertyAccess>(mut self, needed: &[&str]) -> Result<Vec<V>> {
        let path = self.path;
        let broken = |error: ParseError| broken(path, &error);
        let Some(place) = self.header.elements.keys().position(|found| found == VERTEX) else {
            return invalid(path, "the PLY file has no `vertex` element; is it a point cloud?");
        };
        let passed = self.header.elements.values().take(place);
        let element = &self.header.elements[VERTEX];
        check_properties(element, needed, path)?;
        // the elements as read, and the result
        let bytes = 2 * size_of::<V>() as u64;
        memory::check((element.count as u64).saturating_mul(bytes), "the elements of a PLY file")?;
        for skipped in passed {
            let parser = Parser::<Skipped>::new();
            let read = parser.read_payload_for_element(&mut self.reader, skipped, &self.header);
            read.map_err(broken)?;
        }
        let parser = Parser::<V>::new();
        parser.read_payload_for_element(&mut self.reader, element, &self.header).map_err(broken)
    }
}

/// An element that is not kept.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}

/// Checks the header against the file: it must not promise more than there is.
fn check(header: &Header, length: u64, path: &Path) -> Result<()> {
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
    }
    Ok(())
}

fn check_properties(element: &ElementDef, needed: &[&str], path: &Path) -> Result<()> {
    let has = |key: &str| element.properties.contains_key(key);
    let Some(key) = needed.iter().find(|key| !has(key)) else { return Ok(()) };
    let hint = match has("packed_position") {
        true => {
            "; it is compressed: PlayCanvas' splat-transform and SuperSplat write it as .ply or .sog"
        }
        false => "",
    };
    let needed = needed.join(", ");
    invalid(path, format!("vertices have no property `{key}`, expected {needed}{hint}"))
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
        (_, Some(line)) => format!("line {line} does not parse"),
        (_, None) => "a value does not parse".to_owned(),
    };
    let reason = format!("not a whole PLY file: {place}; copy it again, or write it again");
    Error::Invalid { origin: path.to_owned(), reason }
}
