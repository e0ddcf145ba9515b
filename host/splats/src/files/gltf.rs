//! Binary glTF 2.0 with `KHR_gaussian_splatting`, as the Khronos Group ratified it. Gaussians are points with the
//! extension's attributes, which are written as floats. Integers are read, too.

use std::collections::HashSet;
use std::io::{self, Write};
use std::path::Path;

use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3, Quat, Vec3};
use muslin::math::sigmoid;
use organza_core::memory;
use serde_json::{Map, Value, json};

use super::{
    PLACEMENT, Splat, SplatFile, ZEROS, base_color, byte, ends, log_of, omitted, stored_placement,
    turned,
};
use crate::harmonics::{DEGREE, HARMONICS};
use crate::placed::turn;
use organza_core::error::{Result, invalid};
use organza_core::input::parse_json;
use organza_core::scene::{Placement, logit};

const EXTENSION: &str = "KHR_gaussian_splatting";
/// The values of the extension that are known; others are read as these.
const KNOWN: [(&str, &str); 2] = [("kernel", "ellipse"), ("colorSpace", "srgb_rec709_display")];
/// Smallest distance of an opacity from 0 and 1: these have no finite logit.
const OPACITY_EDGE: f32 = 1e-6;
/// Largest difference of a node's axes from unit vectors at right angles.
const ORTHONORMAL: f64 = 1e-4;
/// glTF's code for components of type float.
pub(super) const FLOAT: u32 = 5126;
const BYTE: u32 = 5121;
/// A type of components: glTF's code, bytes, the value of the first bytes, and what is 1 in normalized values.
type Component = (u32, usize, fn(&[u8]) -> f32, f32);
const COMPONENTS: [Component; 5] = [
    (5120, 1, |bytes| f32::from(bytes[0].cast_signed()), 127.0),
    (BYTE, 1, |bytes| f32::from(bytes[0]), 255.0),
    (5122, 2, |bytes| f32::from(i16::from_le_bytes([bytes[0], bytes[1]])), 32_767.0),
    (5123, 2, |bytes| f32::from(u16::from_le_bytes([bytes[0], bytes[1]])), 65_535.0),
    (FLOAT, 4, |bytes| f32::from_le_bytes(std::array::from_fn(|at| bytes[at])), 1.0),
];
/// Extensions without which a file cannot be read, and which are: Gaussians, and integers as positions.
const READ: [&str; 2] = [EXTENSION, "KHR_mesh_quantization"];
/// Names of values with 1 to 4 components.
const KINDS: [&str; 4] = ["SCALAR", "VEC2", "VEC3", "VEC4"];
/// glTF's code for a buffer of vertex attributes.
pub(super) const VERTICES: u32 = 34962;

/// An attribute: its name, the type of a Gaussian's value, and the bytes of all values.
struct Attribute {
    name: String,
    kind: &'static str,
    component: u32,
    bytes: Vec<u8>,
}

impl Attribute {
    fn new<const N: usize>(name: &str, splats: &[Splat], of: impl Fn(&Splat) -> [f32; N]) -> Self {
        let kind = KINDS[N - 1];
        let bytes =
            splats.iter().flat_map(|splat| of(splat).into_iter().flat_map(f32::to_le_bytes));
        Self { name: name.to_owned(), kind, component: FLOAT, bytes: bytes.collect() }
    }

    fn accessor(&self, index: usize, count: usize) -> Value {
        let is_normalized = self.component == BYTE;
        json!({"bufferView": index, "componentType": self.component, "normalized": is_normalized, "count": count,
            "type": self.kind})
    }
}

pub fn write(
    splats: &[Splat],
    up: Vec3,
    placement: &Placement,
    file: &mut dyn Write,
) -> io::Result<()> {
    let mut attributes = attributes(splats);
    let lengths = attributes.iter().map(|attribute| attribute.bytes.len());
    let mut views = Vec::new();
    let mut length = 0;
    for bytes in lengths {
        views.push(
            json!({"buffer": 0, "byteOffset": length, "byteLength": bytes, "target": VERTICES}),
        );
        length += bytes;
    }
    let mut accessors: Vec<_> = attributes
        .iter()
        .enumerate()
        .map(|(index, attribute)| attribute.accessor(index, splats.len()))
        .collect();
    let ranges = [0, 1, 2].map(|axis| ends(splats.iter().map(|splat| splat.position[axis])));
    accessors[0]["min"] = json!(ranges.map(|[low, _]| low));
    accessors[0]["max"] = json!(ranges.map(|[_, high]| high));
    let named =
        attributes.iter().enumerate().map(|(at, attribute)| (attribute.name.clone(), at.into()));
    let named: Map<String, Value> = named.collect();
    let mut extension = json!({"projection": "perspective", "sortingMethod": "cameraDistance"});
    KNOWN.into_iter().for_each(|(key, value)| extension[key] = json!(value));
    let primitive = json!({"attributes": named, "mode": 0, "extensions": {EXTENSION: extension}});
    let json = json!({
        "asset": asset(),
        "extensionsUsed": [EXTENSION],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "rotation": y_up(up), "extras": {PLACEMENT: placement}}],
        "meshes": [{"primitives": [primitive]}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": length}],
    });
    write_container(&json, length, file)?;
    // each attribute is freed after it is written
    attributes.drain(..).try_for_each(|attribute| file.write_all(&attribute.bytes))
}

/// The rotation of a node, x y z w, that turns `up` to y, which is up in glTF.
pub(super) fn y_up(up: Vec3) -> [f32; 4] {
    Quat::from_rotation_arc(up.try_normalize().unwrap_or(Vec3::Y), Vec3::Y).to_array()
}

/// What a file says of itself.
pub(super) fn asset() -> Value {
    json!({"version": "2.0", "generator": concat!("organza ", env!("CARGO_PKG_VERSION"))})
}

/// Writes all of a file but the bytes of its buffer, which follow.
pub(super) fn write_container(json: &Value, length: usize, file: &mut dyn Write) -> io::Result<()> {
    let mut json = serde_json::to_vec(json)?;
    json.resize(json.len().next_multiple_of(4), b' ');
    let whole = 12 + 8 + json.len() + 8 + length;
    let Ok(whole) = u32::try_from(whole) else {
        return Err(io::Error::other("a glTF file has at most 4 GiB; write a .ply"));
    };
    write_words(file, &[u32::from_le_bytes(*b"glTF"), 2, whole])?;
    write_words(file, &[json.len() as u32, u32::from_le_bytes(*b"JSON")])?;
    file.write_all(&json)?;
    write_words(file, &[length as u32, u32::from_le_bytes(*b"BIN\0")])
}

fn write_words(file: &mut dyn Write, words: &[u32]) -> io::Result<()> {
    words.iter().try_for_each(|word| file.write_all(&word.to_le_bytes()))
}

/// The attributes. Their lengths are multiples of 4.
fn attributes(splats: &[Splat]) -> Vec<Attribute> {
    let own = |name: &str| format!("{EXTENSION}:{name}");
    let mut attributes = vec![
        Attribute::new("POSITION", splats, |splat| splat.position),
        Attribute::new(&own("ROTATION"), splats, |splat| {
            let [w, x, y, z] = turned(splat);
            [x, y, z, w]
        }),
        Attribute::new(&own("SCALE"), splats, |splat| splat.log_scale.map(f32::exp)),
        Attribute::new(&own("OPACITY"), splats, |splat| [sigmoid(splat.opacity)]),
    ];
    for (harmonic, name) in harmonic_names().enumerate() {
        attributes.push(Attribute::new(&own(&name), splats, |splat| splat.color[harmonic]));
    }
    // for programs that only show points
    let color = splats.iter().flat_map(|splat| {
        let [r, g, b] = base_color(splat);
        [r, g, b, sigmoid(splat.opacity)].map(|value| byte(255.0 * value))
    });
    let name = "COLOR_0".to_owned();
    attributes.push(Attribute { name, kind: "VEC4", component: BYTE, bytes: color.collect() });
    attributes
}

/// The names of the attributes of harmonics, in their order.
fn harmonic_names() -> impl Iterator<Item = String> {
    let bands = (0..=DEGREE).flat_map(|degree| (0..=2 * degree).map(move |at| (degree, at)));
    bands.map(|(degree, at)| format!("SH_DEGREE_{degree}_COEF_{at}"))
}

/// A file that is read: its description, and the bytes that this points into.
struct File<'a> {
    json: Value,
    data: &'a [u8],
    path: &'a Path,
}

/// What the nodes of a file hold.
#[derive(Default)]
struct NodeContents {
    splats: Vec<Splat>,
    /// Their positions in the world.
    positions: Vec<[f64; 3]>,
    /// Whether nodes have a placement that organza wrote.
    is_placed: bool,
    notes: Vec<String>,
}

/// Reads the Gaussians of all nodes, in the world of the file. A node that organza wrote has a placement. The rotation beside it
/// is for other programs.
pub fn read(bytes: &[u8], path: &Path) -> Result<SplatFile> {
    // after 12 bytes, chunks: a length, a name, and as many bytes
    let chunk = |bytes: &[u8]| -> Option<(usize, [u8; 4])> {
        let [a, b, c, d, ref name @ ..] = *bytes.first_chunk::<8>()?;
        Some((u32::from_le_bytes([a, b, c, d]) as usize, *name))
    };
    let first = bytes.get(12..).and_then(|rest| {
        let (length, name) = chunk(rest)?;
        Some((name, rest.get(8..)?.split_at_checked(length)?))
    });
    let Some((name, (text, rest))) = first else { return damaged(path, "it was cut short") };
    if &name != b"JSON" || bytes[4..8] != [2, 0, 0, 0] {
        return damaged(path, "it is no binary glTF of version 2");
    }
    let length = chunk(rest).map_or(0, |(length, _)| length);
    let data = rest.get(8..).unwrap_or_default();
    let Some(data) = data.get(..length) else { return damaged(path, "it was cut short") };
    let file = File { json: parse_json(text, path)?, data, path };
    let mut required = file.json["extensionsRequired"].as_array().into_iter().flatten();
    if let Some(name) = required.find(|name| !READ.iter().any(|read| **name == *read)) {
        let reason = format!(
            "the extension {name} is not read; write the Gaussians without it, or as a .ply"
        );
        return invalid(path, reason);
    }
    let mut found = NodeContents::default();
    let count = file.json["nodes"].as_array().map_or(0, Vec::len);
    let mut seen = vec![false; count];
    // nodes may be nested deeper than the stack is
    let mut left = vec![(file.roots(), DMat4::IDENTITY)];
    while let Some((nodes, parent)) = left.pop() {
        for index in nodes {
            let to_world = file.add_node(index, parent, &mut seen, &mut found)?;
            left.push((indices(&file.json["nodes"][index]["children"]).collect(), to_world));
        }
    }
    let NodeContents { splats, positions, is_placed, notes } = found;
    if splats.is_empty() {
        let reason =
            format!("it has no Gaussians of {EXTENSION}; write them as these, or as a .ply");
        return invalid(path, reason);
    }
    let file = SplatFile { is_placed, notes, ..SplatFile::new(path, "glTF", splats) };
    Ok(file.with_positions(&positions))
}

fn damaged<T>(path: &Path, reason: &str) -> Result<T> {
    invalid(path, format!("not a whole glTF file: {reason}; copy it again, or write it again"))
}

/// The numbers of an array in JSON; `None` if it has others.
fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let values: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    values?.try_into().ok()
}

fn indices(value: &Value) -> impl Iterator<Item = usize> {
    value.as_array().into_iter().flatten().filter_map(Value::as_u64).map(|index| index as usize)
}

impl File<'_> {
    /// The nodes of the scene that the file shows, or else the nodes that are in no other.
    fn roots(&self) -> Vec<usize> {
        let scene = self.json["scene"].as_u64().unwrap_or_default() as usize;
        if let Some(scene) = self.json["scenes"].get(scene) {
            return indices(&scene["nodes"]).collect();
        }
        let nodes = self.json["nodes"].as_array().map(Vec::as_slice).unwrap_or_default();
        let inner: HashSet<_> = nodes.iter().flat_map(|node| indices(&node["children"])).collect();
        (0..nodes.len()).filter(|node| !inner.contains(node)).collect()
    }

    /// Adds the Gaussians of a node, and returns the matrix from its space to the world. `parent` maps the space around the node.
    /// A node is in one other at most, so `seen` must not have it.
    fn add_node(
        &self,
        index: usize,
        parent: DMat4,
        seen: &mut [bool],
        found: &mut NodeContents,
    ) -> Result<DMat4> {
        if seen.get(index) != Some(&false) {
            return damaged(self.path, "a node is missing, or is there twice");
        }
        seen[index] = true;
        let node = &self.json["nodes"][index];
        let stored = stored_placement(&node["extras"], self.path)?;
        let to_world = parent * stored.map_or_else(|| local(node), |stored| matrix(&stored));
        let mesh = node["mesh"].as_u64().map(|mesh| &self.json["meshes"][mesh as usize]);
        for primitive in mesh.and_then(|mesh| mesh["primitives"].as_array()).into_iter().flatten() {
            if primitive["extensions"].get(EXTENSION).is_none() {
                continue;
            }
            let bytes = (found.splats.len() * (size_of::<Splat>() + size_of::<[f64; 3]>())) as u64;
            memory::check(bytes, "the Gaussians of a glTF file")?;
            let mut splats = self.primitive(primitive, &mut found.notes)?;
            let place =
                |splat: &Splat| to_world.transform_point3(Vec3::from(splat.position).as_dvec3());
            found.positions.extend(splats.iter().map(|splat| place(splat).to_array()));
            self.turn(&mut splats, to_world)?;
            found.splats.append(&mut splats);
            found.is_placed |= stored.is_some();
        }
        Ok(to_world)
    }

    /// Turns Gaussians as a node does, and makes them larger.
    fn turn(&self, splats: &mut [Splat], to_world: DMat4) -> Result<()> {
        let axes = DMat3::from_mat4(to_world);
        let scale = axes.determinant().abs().cbrt();
        let axes = axes * scale.recip();
        let off = axes.transpose() * axes - DMat3::IDENTITY;
        // also fails for NaN
        if !off.to_cols_array().iter().all(|off| off.abs() < ORTHONORMAL) {
            let reason = "a node scales its axes differently, and Gaussians have no such shapes; apply the scale in the \
                          program that wrote the file";
            return invalid(self.path, reason);
        }
        if DMat3::from_mat4(to_world) != DMat3::IDENTITY {
            turn(splats, axes, scale, |place| place);
        }
        Ok(())
    }

    /// Refuses an extension whose Gaussians would look wrong, and notes what is unknown.
    fn check_extension(&self, extension: &Value, notes: &mut Vec<String>) -> Result<()> {
        let inner = extension["extensions"].as_object().and_then(|inner| inner.keys().next());
        if let Some(name) = inner {
            let reason = format!(
                "its Gaussians need {name}; write them without this extension, or as a .ply"
            );
            return invalid(self.path, reason);
        }
        if extension["colorSpace"] == "lin_rec709_display" {
            let reason = "its colors are linear (lin_rec709_display), and sRGB is read: write them as \
                          srgb_rec709_display";
            return invalid(self.path, reason);
        }
        for (key, known) in KNOWN {
            let value = extension.get(key).filter(|value| **value != known);
            let note =
                value.map(|value| format!("its {key} {value} is unknown, and read as {known}"));
            notes.extend(note.filter(|note| !notes.contains(note)));
        }
        Ok(())
    }

    /// The Gaussians of a primitive.
    fn primitive(&self, primitive: &Value, notes: &mut Vec<String>) -> Result<Vec<Splat>> {
        self.check_extension(&primitive["extensions"][EXTENSION], notes)?;
        let attributes = &primitive["attributes"];
        let own = |name: &str| attributes[format!("{EXTENSION}:{name}")].as_u64();
        let positions: Vec<[f32; 3]> = self.values("POSITION", attributes["POSITION"].as_u64())?;
        let rotations: Vec<[f32; 4]> = self.values("ROTATION", own("ROTATION"))?;
        let scales: Vec<[f32; 3]> = self.values("SCALE", own("SCALE"))?;
        let opacities: Vec<[f32; 1]> = self.values("OPACITY", own("OPACITY"))?;
        let count = positions.len();
        let mut splats: Vec<Splat> = memory::zeros(count, "the Gaussians of a glTF file")?;
        if [rotations.len(), scales.len(), opacities.len()] != [count; 3] {
            return damaged(self.path, "its attributes have different lengths");
        }
        for (at, splat) in splats.iter_mut().enumerate() {
            let [x, y, z, w] = rotations[at];
            splat.position = positions[at];
            splat.rotation = [w, x, y, z];
            splat.log_scale = scales[at].map(log_of);
            splat.opacity = logit(opacities[at][0].clamp(OPACITY_EDGE, 1.0 - OPACITY_EDGE));
        }
        for (harmonic, name) in harmonic_names().take(HARMONICS).enumerate() {
            let index = own(&name);
            if index.is_none() && harmonic > 0 {
                break;
            }
            let values: Vec<[f32; 3]> = self.values(&name, index)?;
            if values.len() != count {
                return damaged(self.path, "its attributes have different lengths");
            }
            splats.iter_mut().zip(values).for_each(|(splat, value)| splat.color[harmonic] = value);
        }
        let is_zero = |splat: &Splat| {
            let rest = splat.color[0].iter().chain(&splat.position);
            splat.rotation.iter().chain(rest).all(|value| *value == 0.0)
        };
        splats.retain(|splat| !is_zero(splat));
        notes.extend(omitted(count - splats.len(), count, ZEROS));
        Ok(splats)
    }

    /// The values of an accessor. Normalized integers are parts of 1.
    fn values<const N: usize>(&self, name: &str, accessor: Option<u64>) -> Result<Vec<[f32; N]>> {
        let Some(index) = accessor else {
            return invalid(self.path, format!("its Gaussians have no attribute {name}"));
        };
        let broken =
            || damaged(self.path, &format!("the attribute {name} is not where it should be"));
        let accessor = &self.json["accessors"][index as usize];
        let number = |value: &Value| value.as_u64().map(|number| number as usize);
        let Some(view) =
            number(&accessor["bufferView"]).filter(|_| accessor.get("sparse").is_none())
        else {
            return invalid(
                self.path,
                format!("the attribute {name} is sparse, which is not read"),
            );
        };
        let view = &self.json["bufferViews"][view];
        let buffer = number(&view["buffer"]).unwrap_or_default();
        if buffer != 0 || self.json["buffers"][0].get("uri").is_some() {
            let reason = "its values are in another file; write one .glb with everything in it";
            return invalid(self.path, reason);
        }
        let component = COMPONENTS.iter().find(|(code, ..)| accessor["componentType"] == *code);
        let kind = KINDS[N - 1];
        let Some(&(_, bytes, value, one)) = component.filter(|_| accessor["type"] == kind) else {
            let reason = format!("the attribute {name} is no {kind} of floats or short integers");
            return invalid(self.path, reason);
        };
        let one = if accessor["normalized"] == true { one } else { 1.0 };
        let size = N * bytes;
        let stride = number(&view["byteStride"]).unwrap_or(size);
        let offset = |value: &Value| number(&value["byteOffset"]).unwrap_or_default();
        let data = self.data.get(offset(view)..).and_then(|data| data.get(offset(accessor)..));
        let (Some(data), Some(count)) = (data, number(&accessor["count"])) else { return broken() };
        if count > 0 && (stride < size || data.len() < size) {
            return broken();
        }
        if count > 0 && count - 1 > (data.len() - size) / stride {
            return broken();
        }
        let mut values = memory::zeros::<[f32; N]>(count, "an attribute of a glTF file")?;
        let least = if one == 1.0 { f32::NEG_INFINITY } else { -1.0 };
        for (row, out) in data.chunks(stride).zip(&mut values) {
            // the lowest integer is -1, as the one above it
            *out = std::array::from_fn(|at| (value(&row[at * bytes..]) / one).max(least));
        }
        Ok(values)
    }
}

/// A placement as the transformation of a node.
fn matrix(placement: &Placement) -> DMat4 {
    let axes = placement.rotation() * placement.scale;
    DAffine3::from_mat3_translation(axes, placement.offset.into()).into()
}

/// The transformation of a node: a matrix, or a translation, a rotation and a scale.
fn local(node: &Value) -> DMat4 {
    if let Some(matrix) = numbers(&node["matrix"]) {
        return DMat4::from_cols_array(&matrix);
    }
    let three = |key, default| numbers(&node[key]).map_or(default, DVec3::from_array);
    DMat4::from_scale_rotation_translation(
        three("scale", DVec3::ONE),
        numbers(&node["rotation"]).map_or(DQuat::IDENTITY, DQuat::from_array),
        three("translation", DVec3::ZERO),
    )
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_close, assert_refused, read_bytes, splats};
    use super::*;

    fn written() -> Vec<u8> {
        let mut bytes = Vec::new();
        write(&splats(), Vec3::Z, &Placement::default(), &mut bytes).unwrap();
        bytes
    }

    /// A file with another description.
    fn with(edit: impl FnOnce(&mut Value)) -> Vec<u8> {
        let bytes = written();
        let length = u32::from_le_bytes([bytes[12], bytes[13], bytes[14], bytes[15]]) as usize;
        let (head, rest) = bytes[20..].split_at(length);
        let mut json: Value = serde_json::from_slice(head).unwrap();
        json["nodes"][0].as_object_mut().unwrap().remove("extras");
        edit(&mut json);
        let json = serde_json::to_vec(&json).unwrap();
        let mut bytes = bytes[..12].to_vec();
        bytes.extend((json.len() as u32).to_le_bytes());
        bytes.extend(b"JSON");
        bytes.extend(json);
        bytes.extend(rest);
        bytes
    }

    #[test]
    fn own_files_keep_the_axes_of_the_scene() {
        assert_close(&read_bytes(&written()).unwrap(), &splats(), [0.0, 1e-5, 0.0, 0.0, 1e-6]);
        for length in (4..written().len()).step_by(97) {
            assert_refused(&written()[..length], &[]);
        }
    }

    /// glTF: the world is the product of the nodes' transformations.
    #[test]
    fn nodes_transform_files_of_other_programs() {
        // z of the scene is y of the file: (x, y, z) becomes (x, z, -y)
        let upright = read_bytes(&with(|_| ())).unwrap();
        // a child, half as large and moved, in a node that is a mirror
        let mirrored = with(|json| {
            json["nodes"] = json!([
                {"children": [1], "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
                {"mesh": 0, "scale": [0.5, 0.5, 0.5], "translation": [1, 2, 3]},
            ]);
        });
        let mirrored = read_bytes(&mirrored).unwrap();
        for ((splat, upright), mirrored) in splats().iter().zip(upright).zip(mirrored) {
            let [x, y, z] = splat.position;
            let near = |a: [f32; 3], b: [f32; 3]| Vec3::from(a).distance(Vec3::from(b)) < 1e-5;
            assert!(near(upright.position, [x, z, -y]), "{upright:?}");
            let expected = [-1.0 - 0.5 * x, 2.0 + 0.5 * y, 3.0 + 0.5 * z];
            assert!(near(mirrored.position, expected), "{mirrored:?}");
            let logs = splat.log_scale.map(|log| log - 2_f32.ln());
            assert!(near(mirrored.log_scale, logs), "{mirrored:?}");
            // of degree 1, the harmonics are -y, z and -x
            let color = mirrored.color;
            assert!(near(color[1], splat.color[1]) && near(color[3], splat.color[3].map(|c| -c)));
        }
    }

    /// A node may hold a place on the Earth, which an f32 cannot.
    #[test]
    fn nodes_place_before_positions_are_rounded() {
        let offset = [3_782_000.25, 902_000.5, 5_038_000.125];
        let bytes = with(|json| {
            json["nodes"] = json!([
                {"children": [1], "translation": offset},
                {"mesh": 0, "scale": [0.5, 0.5, 0.5]},
            ]);
        });
        let file = super::super::read_from(&bytes, Path::new("a.glb"));
        let placement = Placement { offset, scale: 0.5, ..Placement::default() };
        let found = file.unwrap().into_own(&placement).unwrap();
        assert_close(&found, &splats(), [1e-6, 1e-5, 0.0, 0.0, 1e-6]);
    }

    /// The table of glTF: a component's code, its bytes, and the value that they stand for.
    #[test]
    fn integers_are_read_and_normalized() {
        for (code, bytes, normalized, plain) in [
            (5120, vec![0x81], -1.0, -127.0),
            (5120, vec![0x80], -1.0, -128.0),
            (5121, vec![51], 0.2, 51.0),
            (5122, vec![0xff, 0x7f], 1.0, 32_767.0),
            (5122, vec![0x00, 0x80], -1.0, -32_768.0),
            (5123, vec![0x33, 0x33], 0.2, 13_107.0),
        ] {
            for (is_normalized, expected) in [(true, normalized), (false, plain)] {
                let json = json!({
                    "accessors": [{"bufferView": 0, "byteOffset": 4, "componentType": code, "count": 2,
                        "type": "VEC2", "normalized": is_normalized}],
                    "bufferViews": [{"buffer": 0, "byteStride": 8}],
                    "buffers": [{}],
                });
                let row = [&[9; 4], &bytes[..], &bytes, &[9; 4]].concat();
                let data: Vec<u8> = row[..8].iter().chain(&row).copied().collect();
                let file = File { json, data: &data, path: Path::new("a.glb") };
                let found: Vec<[f32; 2]> = file.values("X", Some(0)).unwrap();
                assert_eq!(found, [[expected; 2]; 2], "{code} {is_normalized}");
            }
        }
    }

    #[test]
    fn a_long_chain_of_nodes_is_read() {
        let bytes = with(|json| {
            let chain = (1..200_000).map(|child| json!({"children": [child]}));
            json["nodes"] = chain.chain([json!({"mesh": 0})]).collect();
            json["scenes"] = json!([]);
        });
        assert_eq!(read_bytes(&bytes).unwrap().len(), splats().len());
    }

    #[test]
    fn unknown_values_are_noted() {
        let bytes = with(|json| {
            json["meshes"][0]["primitives"][0]["extensions"][EXTENSION]["kernel"] = json!("disk");
        });
        let file = super::super::read_from(&bytes, Path::new("a.glb"));
        assert_eq!(file.unwrap().notes, ["its kernel \"disk\" is unknown, and read as ellipse"]);
    }

    #[test]
    fn bad_files_are_refused_with_a_reason() {
        let refused = |edit: fn(&mut Value), facts: &[&str]| assert_refused(&with(edit), facts);
        refused(|json| json["nodes"][0]["scale"] = json!([1, 2, 1]), &["axes differently"]);
        refused(|json| json["nodes"][0]["scale"] = json!([0, 0, 0]), &["axes differently"]);
        refused(|json| json["nodes"][0]["children"] = json!([0]), &["there twice"]);
        refused(|json| json["scenes"][0]["nodes"] = json!([9]), &["node is missing"]);
        refused(|json| json["nodes"][0]["mesh"] = json!(9), &["no Gaussians of KHR"]);
        refused(|json| json["extensionsRequired"] = json!(["EXT_x"]), &["EXT_x"]);
        refused(|json| json["buffers"][0]["uri"] = json!("a.bin"), &["another file"]);
        refused(|json| json["accessors"][1]["count"] = json!(u64::MAX), &["where it should be"]);
        refused(|json| json["accessors"][1]["count"] = json!(2), &["different lengths"]);
        refused(
            |json| json["accessors"][1]["componentType"] = json!(5125),
            &["ROTATION", "floats or short integers"],
        );
        refused(|json| json["bufferViews"][1]["byteStride"] = json!(0), &["where it should be"]);
        refused(|json| json["bufferViews"][1]["byteOffset"] = json!(u64::MAX), &["ROTATION"]);
        let extension = |json: &mut Value, key: &str, value: Value| {
            json["meshes"][0]["primitives"][0]["extensions"][EXTENSION][key] = value;
        };
        let bytes = with(|json| extension(json, "colorSpace", json!("lin_rec709_display")));
        assert_refused(&bytes, &["linear"]);
        let bytes = with(|json| extension(json, "extensions", json!({"KHR_spz": {}})));
        assert_refused(&bytes, &["KHR_spz"]);
        let attributes = "KHR_gaussian_splatting:SCALE";
        let bytes = with(|json| {
            let all = &mut json["meshes"][0]["primitives"][0]["attributes"];
            all.as_object_mut().unwrap().remove(attributes);
        });
        assert_refused(&bytes, &["no attribute SCALE"]);
    }
}
