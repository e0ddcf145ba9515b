//! Binary glTF 2.0 with `KHR_gaussian_splatting`, as the Khronos Group ratified it. Gaussians are points with the
//! extension's attributes, all of them floats.

use std::io::{self, Write};

use glam::{Quat, Vec3};
use muslin::math::sigmoid;
use serde_json::{Map, Value, json};

use super::{Splat, base_color, byte, turned};

const EXTENSION: &str = "KHR_gaussian_splatting";
/// glTF's code for components of type float.
const FLOAT: u32 = 5126;
const BYTE: u32 = 5121;
/// glTF's code for a buffer of vertex attributes.
const VERTICES: u32 = 34962;

/// An attribute: its name, the type of a Gaussian's value, and the bytes of all values.
struct Attribute {
    name: String,
    kind: &'static str,
    component: u32,
    bytes: Vec<u8>,
}

impl Attribute {
    fn new<const N: usize>(name: &str, splats: &[Splat], of: impl Fn(&Splat) -> [f32; N]) -> Self {
        let kind = ["SCALAR", "VEC2", "VEC3", "VEC4"][N - 1];
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

pub fn write(splats: &[Splat], up: Vec3, file: &mut dyn Write) -> io::Result<()> {
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
    let limit = |start: f32, pick: fn(f32, f32) -> f32| -> [f32; 3] {
        std::array::from_fn(|axis| {
            splats.iter().map(|splat| splat.position[axis]).fold(start, pick)
        })
    };
    accessors[0]["min"] = json!(limit(f32::MAX, f32::min));
    accessors[0]["max"] = json!(limit(f32::MIN, f32::max));
    let named =
        attributes.iter().enumerate().map(|(at, attribute)| (attribute.name.clone(), at.into()));
    let named: Map<String, Value> = named.collect();
    // in glTF, y points up
    let turn = Quat::from_rotation_arc(up.try_normalize().unwrap_or(Vec3::Y), Vec3::Y);
    let primitive = json!({"attributes": named, "mode": 0, "extensions": {EXTENSION: {"kernel": "ellipse",
        "colorSpace": "srgb_rec709_display", "projection": "perspective", "sortingMethod": "cameraDistance"}}});
    let json = json!({
        "asset": {"version": "2.0", "generator": concat!("organza ", env!("CARGO_PKG_VERSION"))},
        "extensionsUsed": [EXTENSION],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "rotation": turn.to_array()}],
        "meshes": [{"primitives": [primitive]}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": length}],
    });
    let mut json = serde_json::to_vec(&json)?;
    json.resize(json.len().next_multiple_of(4), b' ');
    let whole = 12 + 8 + json.len() + 8 + length;
    let Ok(whole) = u32::try_from(whole) else {
        return Err(io::Error::other("a glTF file has at most 4 GiB; write a .ply"));
    };
    write_words(file, &[u32::from_le_bytes(*b"glTF"), 2, whole])?;
    write_words(file, &[json.len() as u32, u32::from_le_bytes(*b"JSON")])?;
    file.write_all(&json)?;
    write_words(file, &[length as u32, u32::from_le_bytes(*b"BIN\0")])?;
    // each attribute is freed after it is written
    attributes.drain(..).try_for_each(|attribute| file.write_all(&attribute.bytes))
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
    let bands = (0..4_usize).flat_map(|degree| (0..=2 * degree).map(move |at| (degree, at)));
    for (harmonic, (degree, at)) in bands.enumerate() {
        let name = own(&format!("SH_DEGREE_{degree}_COEF_{at}"));
        attributes.push(Attribute::new(&name, splats, |splat| splat.color[harmonic]));
    }
    // for programs that only show points
    let color = splats.iter().flat_map(|splat| {
        let [r, g, b] = base_color(splat);
        [r, g, b, sigmoid(splat.opacity)].map(|value| byte(255.0 * value))
    });
    let name = "COLOR_0".to_owned();
    let bytes = color.collect();
    attributes.push(Attribute { name, kind: "VEC4", component: BYTE, bytes });
    attributes
}
