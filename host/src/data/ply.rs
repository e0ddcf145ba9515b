//! Point clouds from PLY files, as nerfstudio writes them: text, and binary of either byte order.

use std::io::BufReader;
use std::path::Path;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Header, Property, PropertyAccess, PropertyAccessResult};

use super::{Point, invalid};
use crate::error::{Error, Result};
use crate::input::open_regular;

/// More of a parser's words than a message needs: it quotes whole lines of what it could not read.
const MAX_REASON: usize = 240;
const POSITION: [&str; 3] = ["x", "y", "z"];
const COLOR: [&str; 3] = ["red", "green", "blue"];

/// The vertices of a PLY file.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] for a file that is no PLY, was cut short, or has
/// vertices without a finite position.
pub(super) fn read(path: &Path) -> Result<Vec<Point>> {
    let (file, length) = open_regular(path)?;
    let mut reader = Reader::new(BufReader::new(file));
    let parser = Parser::<Vertex>::new();
    let broken = |error: ParseError| broken(path, &error);
    let header = parser.read_header(&mut reader).map_err(broken)?;
    check(&header, length, path)?;
    for element in header.elements.values() {
        // Elements lie one after the other, so those in front must be read too.
        let vertices =
            parser.read_payload_for_element(&mut reader, element, &header).map_err(broken)?;
        if element.name == "vertex" {
            return points(&vertices, path);
        }
    }
    invalid(path, "the PLY file has no `vertex` element; is it a point cloud?".to_owned())
}

/// Holds the header to the file: what it claims must be no more than what there is.
fn check(header: &Header, length: u64, path: &Path) -> Result<()> {
    for element in header.elements.values() {
        if element.count as u64 > length {
            let (count, name) = (element.count, &element.name);
            let reason = format!(
                "the header has {count} of `{name}`, more than {length} bytes can hold; the file \
                 was cut short or is damaged"
            );
            return invalid(path, reason);
        }
    }
    let vertex = header.elements.get("vertex");
    let missing = vertex
        .and_then(|vertex| POSITION.iter().find(|key| !vertex.properties.contains_key(**key)));
    if let Some(key) = missing {
        return invalid(
            path,
            format!("vertices have no property `{key}`; a point needs x, y and z"),
        );
    }
    Ok(())
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

/// What is kept of an element: a vertex's position, and its color where that has 8 bits.
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

fn number(property: &Property) -> Option<f64> {
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

fn broken(path: &Path, error: &ParseError) -> Error {
    let words = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    let reason: String = words.chars().take(MAX_REASON).collect();
    let reason = format!("not a whole PLY file: {reason}");
    Error::Invalid { origin: path.to_owned(), reason }
}
