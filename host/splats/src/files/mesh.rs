//! Writes meshes: PLY, OBJ with colors at vertices, and binary glTF.

use std::io::{self, Write};
use std::path::Path;

use glam::{DVec3, Vec3};
use organza_core::error::refuse;
use organza_core::input::has_extension;
use organza_core::scene::Placement;
use organza_core::{Result, write_atomic};
use serde_json::json;

use super::PLACEMENT;
use super::gltf::{FLOAT, VERTICES, asset, write_container, y_up};
use crate::Mesh;
use crate::placed::{in_file, left_out};

/// glTF's codes for indices.
const UNSIGNED_INT: u32 = 5125;
const INDICES: u32 = 34963;

/// A file format of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Binary PLY.
    Ply,
    /// Wavefront OBJ, with red, green and blue behind each position.
    Obj,
    /// Binary glTF, with y up.
    Glb,
}

impl MeshFormat {
    /// The format that a file's extension names.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::Error::Invalid) for any other extension.
    pub fn from_path(path: &Path) -> Result<Self> {
        let known = [("ply", Self::Ply), ("obj", Self::Obj), ("glb", Self::Glb)];
        let found = known.into_iter().find(|(extension, _)| has_extension(path, &[*extension]));
        found.map(|(_, format)| format).map_or_else(
            || refuse(format!("{} should end in .glb, .ply or .obj", path.display())),
            Ok,
        )
    }
}

/// Writes a mesh, atomically: in the world, and in meters if these are known. `up` is a direction of the scene. Returns the offset that
/// positions leave out, because 32 bits could not hold it. The file says where it lies, as files of Gaussians do.
///
/// # Errors
/// [`Error::WriteFile`](organza_core::Error::WriteFile).
pub fn save_mesh(
    mesh: &Mesh,
    path: impl AsRef<Path>,
    format: MeshFormat,
    up: [f64; 3],
    placement: &Placement,
) -> Result<Option<[f64; 3]>> {
    let path = path.as_ref();
    let (in_file, stored) = in_file(placement);
    let place = |place: &[f64; 3]| in_file.world(*place).map(|x| x as f32);
    let places: Vec<_> = mesh.position.iter().map(place).collect();
    let up = DVec3::from(placement.world_direction(up)).as_vec3();
    write_atomic(path, |file| match format {
        MeshFormat::Ply => write_ply(mesh, &places, &stored, file),
        MeshFormat::Obj => write_obj(mesh, &places, &stored, file),
        MeshFormat::Glb => write_glb(mesh, &places, (up, &stored), file),
    })?;
    Ok(left_out(placement, &in_file))
}

fn write_ply(
    mesh: &Mesh,
    places: &[[f32; 3]],
    stored: &Placement,
    file: &mut dyn Write,
) -> io::Result<()> {
    writeln!(file, "ply\nformat binary_little_endian 1.0")?;
    writeln!(file, "comment {PLACEMENT} {}", serde_json::to_string(stored)?)?;
    writeln!(file, "element vertex {}", places.len())?;
    writeln!(file, "property float x\nproperty float y\nproperty float z")?;
    writeln!(file, "property uchar red\nproperty uchar green\nproperty uchar blue")?;
    writeln!(file, "element face {}", mesh.face.len())?;
    writeln!(file, "property list uchar uint vertex_indices\nend_header")?;
    for (place, color) in places.iter().zip(&mesh.color) {
        file.write_all(bytemuck::bytes_of(place))?;
        file.write_all(color)?;
    }
    mesh.face.iter().try_for_each(|face| {
        file.write_all(&[3])?;
        file.write_all(bytemuck::bytes_of(face))
    })
}

fn write_obj(
    mesh: &Mesh,
    places: &[[f32; 3]],
    stored: &Placement,
    file: &mut dyn Write,
) -> io::Result<()> {
    writeln!(file, "# {PLACEMENT} {}", serde_json::to_string(stored)?)?;
    for ([x, y, z], color) in places.iter().zip(&mesh.color) {
        let [red, green, blue] = color.map(|level| f32::from(level) / 255.0);
        writeln!(file, "v {x} {y} {z} {red:.4} {green:.4} {blue:.4}")?;
    }
    // vertices count from 1
    mesh.face.iter().try_for_each(|&[a, b, c]| writeln!(file, "f {} {} {}", a + 1, b + 1, c + 1))
}

fn write_glb(
    mesh: &Mesh,
    places: &[[f32; 3]],
    (up, stored): (Vec3, &Placement),
    file: &mut dyn Write,
) -> io::Result<()> {
    // glTF's colors are linear
    let linear = |level: u8| {
        let level = f32::from(level) / 255.0;
        if level <= 0.040_45 { level / 12.92 } else { ((level + 0.055) / 1.055).powf(2.4) }
    };
    let color: Vec<_> = mesh.color.iter().map(|color| color.map(linear)).collect();
    let parts: [&[u8]; 3] = [
        bytemuck::cast_slice(places),
        bytemuck::cast_slice(&color),
        bytemuck::cast_slice(&mesh.face),
    ];
    let view = |part: usize, target: u32| {
        let before: usize = parts[..part].iter().map(|bytes| bytes.len()).sum();
        json!({"buffer": 0, "byteOffset": before, "byteLength": parts[part].len(), "target": target})
    };
    let vectors = |view: usize| json!({"bufferView": view, "componentType": FLOAT, "count": places.len(), "type": "VEC3"});
    let mut position = vectors(0);
    let ends = |pick: fn(Vec3, Vec3) -> Vec3| {
        places.iter().map(|place| Vec3::from(*place)).reduce(pick).unwrap_or_default().to_array()
    };
    position["min"] = json!(ends(Vec3::min));
    position["max"] = json!(ends(Vec3::max));
    let length = parts.iter().map(|bytes| bytes.len()).sum();
    let json = json!({
        "asset": asset(),
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "rotation": y_up(up), "extras": {PLACEMENT: stored}}],
        "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2, "material": 0}
        ]}],
        "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0.0}}],
        "accessors": [position, vectors(1), {"bufferView": 2, "componentType": UNSIGNED_INT,
            "count": 3 * mesh.face.len(), "type": "SCALAR"}],
        "bufferViews": [view(0, VERTICES), view(1, VERTICES), view(2, INDICES)],
        "buffers": [{"byteLength": length}],
    });
    write_container(&json, length, file)?;
    parts.iter().try_for_each(|bytes| file.write_all(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In UTM coordinates and meters, positions are relative to an offset, which each file has.
    #[test]
    fn files_say_what_positions_leave_out() {
        let position = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = Mesh { position, color: vec![[255; 3]; 3], face: vec![[0, 1, 2]] };
        let offset = [500_000.0, 4_600_000.5, 300.0];
        let placement = Placement { offset, meters: Some(0.5), ..Placement::default() };
        let folder = tempfile::tempdir().unwrap();
        for (name, format) in
            [("a.ply", MeshFormat::Ply), ("a.obj", MeshFormat::Obj), ("a.glb", MeshFormat::Glb)]
        {
            let path = folder.path().join(name);
            let left_out = save_mesh(&mesh, &path, format, [0.0, 0.0, 1.0], &placement).unwrap();
            assert_eq!(left_out, Some(offset.map(|x| 0.5 * x)));
            let file = std::fs::read(path).unwrap();
            let text = String::from_utf8_lossy(&file);
            let begin = text.find("{\"offset\":").expect(name);
            let json = serde_json::Deserializer::from_str(&text[begin..]).into_iter().next();
            let stored: Placement = json.unwrap().unwrap();
            assert_eq!((stored.offset, stored.scale), (offset, 2.0), "{name}");
        }
    }
}
