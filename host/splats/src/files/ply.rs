//! PLY in the form of the authors of 3D Gaussian Splatting: an element `vertex` whose properties are floats.

use std::io::{self, Write};
use std::path::Path;

use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use super::{DEGREE_4, PLACEMENT, Splat, SplatFile, ZEROS, log_of, omitted, turned};
use crate::harmonics::{FILE_DEGREE, HARMONICS};
use organza_core::error::{Result, invalid};
use organza_core::input::parse_json;
use organza_core::scene::Placement;
use organza_data::ply::{Ply, number};
use organza_shaders::spherical_harmonics::width;

/// Number of coefficients `f_rest_*`: all but the first harmonic, of red, then of green, then of blue.
const REST: usize = 3 * (HARMONICS - 1);
/// The same in files with harmonics of degree 4.
const LARGEST_REST: usize = 3 * (width(FILE_DEGREE) as usize - 1);
/// Numbered properties: the name, their largest number, and their index in a [`Vertex`]'s row.
const NUMBERED: [(&str, usize, usize); 4] = [
    ("f_dc_", 3, 0),
    ("f_rest_", LARGEST_REST, 3),
    ("scale_", 3, OPACITY + 1),
    ("rot_", 4, OPACITY + 4),
];
const OPACITY: usize = 3 + LARGEST_REST;
/// Properties that a Gaussian must have.
const NEEDED: [&str; 14] = [
    "x", "y", "z", "f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1", "scale_2",
    "rot_0", "rot_1", "rot_2", "rot_3",
];

/// Names of the properties, in the order of the file. Normals are zeros, which viewers expect and ignore.
fn names() -> impl Iterator<Item = String> {
    let numbered = |at: usize| {
        let (name, count, _) = NUMBERED[at];
        (0..count.min(REST)).map(move |index| format!("{name}{index}"))
    };
    let named = |names: &'static [&str]| names.iter().map(|name| (*name).to_owned());
    named(&["x", "y", "z", "nx", "ny", "nz"])
        .chain(numbered(0))
        .chain(numbered(1))
        .chain(named(&["opacity"]))
        .chain(numbered(2))
        .chain(numbered(3))
}

/// The placement in the comments of [`write`].
fn stored_placement(file: &Ply<'_>, path: &Path) -> Result<Option<Placement>> {
    let json =
        |comment: &String| comment.strip_prefix(PLACEMENT)?.strip_prefix(' ').map(str::to_owned);
    let json = file.comments().iter().find_map(json);
    let placement = |json: String| Placement::from_json(&parse_json(json.as_bytes(), path)?, path);
    json.map(placement).transpose()
}

/// Whether the last comment that says how Gaussians are drawn names antialiasing, as Brush or as Postshot writes it.
fn is_antialiased(file: &Ply<'_>) -> bool {
    let said = |comment: &String| {
        let comment = comment.to_ascii_lowercase();
        let brush =
            comment.trim().strip_prefix("splatrendermode:").map(|mode| mode.trim() == "mip");
        let postshot = comment.trim().strip_prefix("antialiased ").map(|flag| flag.trim() == "1");
        brush.or(postshot)
    };
    file.comments().iter().rev().find_map(said).unwrap_or(false)
}

pub fn write(splats: &[Splat], placement: &Placement, file: &mut dyn Write) -> io::Result<()> {
    writeln!(file, "ply\nformat binary_little_endian 1.0")?;
    writeln!(file, "comment written by organza {}", env!("CARGO_PKG_VERSION"))?;
    writeln!(file, "comment {PLACEMENT} {}", serde_json::to_string(placement)?)?;
    writeln!(file, "element vertex {}", splats.len())?;
    for name in names() {
        writeln!(file, "property float {name}")?;
    }
    writeln!(file, "end_header")?;
    for splat in splats {
        let [first, others @ ..] = &splat.color;
        let others = (0..3).flat_map(|channel| others.iter().map(move |value| value[channel]));
        let values = splat.position.into_iter().chain([0.0; 3]).chain(*first).chain(others);
        let values = values.chain([splat.opacity]).chain(splat.log_scale).chain(turned(splat));
        for value in values {
            file.write_all(&value.to_le_bytes())?;
        }
    }
    Ok(())
}

/// A vertex. A place on the Earth has more digits than an f32.
struct Vertex {
    position: [f64; 3],
    /// f_dc, f_rest, opacity, scale, rot.
    row: [f32; OPACITY + 8],
}

impl Vertex {
    fn is_zero(&self) -> bool {
        self.position == [0.0; 3] && self.row.iter().all(|value| *value == 0.0)
    }
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self { position: [0.0; 3], row: [0.0; OPACITY + 8] }
    }

    fn set_property(&mut self, key: &str, property: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|name| *name == key);
        let place = place(key);
        if axis.is_none() && place.is_none() {
            return PropertyAccessResult::Set;
        }
        let Some(value) = number(&property) else { return PropertyAccessResult::UnsupportedType };
        axis.into_iter().for_each(|axis| self.position[axis] = value);
        place.into_iter().for_each(|place| self.row[place] = value as f32);
        PropertyAccessResult::Set
    }
}

/// The index of a property in a [`Vertex`]'s row.
fn place(key: &str) -> Option<usize> {
    match key {
        "opacity" => Some(OPACITY),
        _ => NUMBERED.iter().find_map(|(name, count, first)| {
            let index: usize = key.strip_prefix(name)?.parse().ok()?;
            (index < *count).then(|| first + index)
        }),
    }
}

pub fn read(bytes: &[u8], path: &Path) -> Result<SplatFile> {
    let file = Ply::open(bytes, path)?;
    let rest = file.properties().filter(|name| name.starts_with("f_rest_")).count();
    let stored = stored_placement(&file, path)?;
    let is_antialiased = is_antialiased(&file);
    let mut vertices: Vec<Vertex> = file.vertices(&NEEDED)?;
    if ![0, 9, 24, 45, LARGEST_REST].contains(&rest) {
        return invalid(
            path,
            format!(
                "vertices have {rest} properties `f_rest_*`, expected 0, 9, 24, 45 or 72: harmonics of degree 0 to 4"
            ),
        );
    }
    let mut notes = Vec::new();
    if rest > REST {
        notes.push(DEGREE_4.to_owned());
    }
    let all = vertices.len();
    vertices.retain(|vertex| !vertex.is_zero());
    notes.extend(omitted(all - vertices.len(), all, ZEROS));
    let others = rest / 3;
    let splat = |Vertex { row, .. }: &Vertex| {
        let values = |first: usize| std::array::from_fn(|at| row[first + at]);
        Splat {
            position: [0.0; 3],
            rotation: std::array::from_fn(|at| row[OPACITY + 4 + at]),
            // some programs write a scale of 0 and an opacity of 1, whose logarithm and logit are infinite
            log_scale: values(OPACITY + 1).map(|log: f32| log.clamp(log_of(0.0), f32::INFINITY)),
            opacity: row[OPACITY].clamp(-100.0, 100.0),
            color: std::array::from_fn(|harmonic| match harmonic {
                0 => values(0),
                _ if harmonic > others => [0.0; 3],
                _ => std::array::from_fn(|channel| row[3 + channel * others + harmonic - 1]),
            }),
        }
    };
    let splats = vertices.iter().map(splat).collect();
    let positions: Vec<_> = vertices.iter().map(|vertex| vertex.position).collect();
    let file = SplatFile { is_antialiased, notes, ..SplatFile::new(path, "PLY", splats) };
    Ok(file.placed(stored).with_positions(&positions))
}

#[cfg(test)]
mod tests {
    use super::super::read_from;
    use super::super::tests::{assert_refused, read_bytes, splats};
    use super::*;

    /// One Gaussian with harmonics of degree 1, as text.
    fn text() -> String {
        let mut text = "ply\nformat ascii 1.0\nelement vertex 1\n".to_owned();
        let names = NEEDED.into_iter().map(str::to_owned);
        let names: Vec<_> = names.chain((0..9).map(|i| format!("f_rest_{i}"))).collect();
        names.iter().for_each(|name| text += &format!("property float {name}\n"));
        text += "end_header\n1 2 3 0.1 0.2 0.3 -1.5 -3 -4 -5 1 0 0 0 ";
        text + "10 11 12 20 21 22 30 31 32\n"
    }

    fn read_text(text: &str) -> Result<Vec<Splat>> {
        read_bytes(text.as_bytes())
    }

    #[test]
    fn harmonics_of_a_lower_degree_are_read_channel_by_channel() {
        let [splat] = read_text(&text()).unwrap()[..] else { panic!("one Gaussian") };
        assert_eq!((splat.position, splat.opacity), ([1.0, 2.0, 3.0], -1.5));
        assert_eq!((splat.log_scale, splat.rotation), ([-3.0, -4.0, -5.0], [1.0, 0.0, 0.0, 0.0]));
        let expected =
            [[0.1, 0.2, 0.3], [10.0, 20.0, 30.0], [11.0, 21.0, 31.0], [12.0, 22.0, 32.0]];
        assert_eq!(splat.color[..4], expected);
        assert_eq!(splat.color[4..], [[0.0; 3]; 12]);
    }

    #[test]
    fn harmonics_of_degree_4_are_left_out() {
        let names: String = (9..72).map(|i| format!("property float f_rest_{i}\n")).collect();
        let values: Vec<_> = (0..72).map(|i| i.to_string()).collect();
        let text = text().replace("end_header", &format!("{names}end_header"));
        let text = text.replace("10 11 12 20 21 22 30 31 32", &values.join(" "));
        let file = read_from(text.as_bytes(), Path::new("a.ply")).unwrap();
        assert_eq!(file.notes, [DEGREE_4]);
        assert_eq!(file.splats[0].color[15], [14.0, 38.0, 62.0]);
    }

    /// NaN, infinite values, and any number of zeros.
    #[test]
    fn gaussians_that_are_none_are_left_out() {
        let whole = splats().repeat(3);
        let written = |splats: &[Splat]| {
            let mut bytes = Vec::new();
            write(splats, &Placement::default(), &mut bytes).unwrap();
            bytes
        };
        let [mut nan, mut infinite] = [whole.clone(), whole.clone()];
        nan[5].color[1][2] = f32::NAN;
        infinite[5].position[0] = f32::INFINITY;
        let rest = [&whole[..5], &whole[6..]].concat();
        let mut filled = written(&rest);
        let count = filled.windows(9).position(|word| word == b"vertex 26").unwrap();
        filled.splice(count..count + 9, *b"vertex 426");
        filled.resize(filled.len() + 400 * 4 * names().count(), 0);
        for (bytes, note) in [
            (written(&nan), "1 of 27 Gaussians have NaN"),
            (written(&infinite), "1 of 27 Gaussians have NaN or infinity"),
            (filled, "400 of 426 Gaussians have only zeros"),
        ] {
            let file = read_from(&bytes, Path::new("a.ply")).unwrap();
            let positions = |splats: &[Splat]| splats.iter().map(|splat| splat.position).collect();
            let read: Vec<_> = positions(&file.splats);
            assert_eq!(read, positions(&rest));
            assert!(file.notes[0].contains(note), "{:?}", file.notes);
        }
    }

    /// As Brush and Postshot write it; the last word counts.
    #[test]
    fn comments_tell_antialiasing() {
        for (comments, expected) in [
            ("", false),
            ("comment SplatRenderMode: mip\n", true),
            ("comment SplatRenderMode: default\n", false),
            ("comment antialiased 1\n", true),
            ("comment SplatRenderMode: mip\ncomment antialiased 0\n", false),
        ] {
            let text = text().replace("element", &format!("{comments}element"));
            let file = read_from(text.as_bytes(), Path::new("a.ply")).unwrap();
            assert_eq!(file.is_antialiased, expected, "{comments}");
        }
    }

    /// A place on the Earth is relative to the scene before it is rounded.
    #[test]
    fn doubles_keep_their_digits() {
        let text = text().replace("property float", "property double");
        let text = text.replace("1 2 3 0.1", "512345.125001 4612345.250002 312.3 0.1");
        let file = read_from(text.as_bytes(), Path::new("a.ply")).unwrap();
        let offset = [512_345.0, 4_612_345.0, 312.0];
        let placement = Placement { offset, ..Placement::default() };
        let [splat] = file.into_own(&placement).unwrap()[..] else { panic!("one Gaussian") };
        let expected = [0.125_001, 0.250_002, 0.3];
        let apart = splat.position.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f32::max) < 1e-7, "{splat:?}");
    }

    #[test]
    fn a_round_trip_keeps_the_splats() {
        let mut splats = splats();
        let mut bytes = Vec::new();
        // a scale of 0 becomes one that is too small to see
        splats[3].log_scale[1] = f32::NEG_INFINITY;
        write(&splats, &Placement::default(), &mut bytes).unwrap();
        splats[3].log_scale[1] = log_of(0.0);
        for (found, expected) in read_bytes(&bytes).unwrap().iter().zip(&splats) {
            assert_eq!(Splat { rotation: expected.rotation, ..*found }, *expected);
            assert_eq!(found.rotation, turned(expected));
        }
        for length in (0..bytes.len()).step_by(7) {
            assert_refused(&bytes[..length], &[]);
        }
    }

    #[test]
    fn bad_files_are_refused_with_a_reason() {
        let text = text();
        let with = |from: &str, to: &str| text.replace(from, to);
        assert_refused(with("opacity", "alpha").as_bytes(), &["no property `opacity`", "rot_3"]);
        assert_refused(with("f_rest_8", "other").as_bytes(), &["8 properties `f_rest_*`"]);
        assert_refused(with("-1.5", "nan").as_bytes(), &["does not parse"]);
        // a number that has no successor names no coefficient
        read_text(&with("f_rest_8", &format!("f_rest_{}", usize::MAX))).expect("one Gaussian");
        let mut splats = splats();
        let mut bytes = Vec::new();
        splats[3].opacity = f32::NAN;
        write(&splats, &Placement::default(), &mut bytes).unwrap();
        assert_refused(&bytes, &["Gaussian 3", "not finite"]);
        assert_refused(with(" -4 ", " 1e30 ").as_bytes(), &["Gaussian 0", "scale"]);
        assert_refused(with("1 2 3", "1 1e39 3").as_bytes(), &["Gaussian 0", "inf"]);
        assert_refused(with("vertex 1", "vertex 0").as_bytes(), &["no Gaussians"]);
        let packed = with("property float x", "property float packed_position");
        assert_refused(packed.as_bytes(), &["no property `x`", "splat-transform"]);
        assert_refused(b"solid cube", &["no file of Gaussians"]);
    }
}
