//! Describes a file of Gaussians for viewers that sort.

use std::fmt;
use std::path::Path;

use organza::Result;
use organza::error::format_bytes;
use organza::scene::Placement;
use organza::splats::{self, Splat, SplatFile};
use serde::Serialize;

use super::{TensorInfo, table};
use crate::cli::summary::grouped;
use crate::cli::text_of;

#[derive(Debug, Serialize)]
pub struct SplatInfo {
    kind: &'static str,
    file: String,
    /// `None` for a folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    file_bytes: Option<u64>,
    format: &'static str,
    gaussians: usize,
    /// The largest degree of harmonics that are not all 0.
    degree: usize,
    /// Two opposite corners of the box of nearly all of the opacity, in the world.
    corners: [[f64; 3]; 2],
    /// Where the file says that it lies.
    #[serde(skip_serializing_if = "Option::is_none")]
    placement: Option<Placement>,
    tensors: Vec<TensorInfo>,
    notes: Vec<String>,
}

impl SplatInfo {
    pub fn load(path: &Path) -> Result<Self> {
        let SplatFile { format, splats, placement, is_placed, notes, .. } = splats::load(path)?;
        let tensor = |name: &str, width: usize, of: fn(&Splat) -> &[f32]| {
            let data: Vec<_> = splats.iter().flat_map(of).copied().collect();
            TensorInfo::new(name, &[splats.len(), width][..if width > 1 { 2 } else { 1 }], &data)
        };
        let is_used = |degree: &usize| {
            let harmonics = degree * degree..(degree + 1) * (degree + 1);
            splats.iter().any(|splat| {
                splat.color[harmonics.clone()].as_flattened().iter().any(|x| *x != 0.0)
            })
        };
        Ok(Self {
            kind: "Gaussians",
            file: text_of(path),
            file_bytes: path.is_file().then(|| super::file_bytes(path)),
            format,
            gaussians: splats.len(),
            degree: (1..=3).rev().find(is_used).unwrap_or(0),
            corners: splats::bounds(&splats).map(|corner| placement.world(corner)),
            placement: is_placed.then_some(placement),
            tensors: vec![
                tensor("position", 3, |splat| &splat.position),
                tensor("rotation", 4, |splat| &splat.rotation),
                tensor("log_scale", 3, |splat| &splat.log_scale),
                tensor("opacity", 1, |splat| std::slice::from_ref(&splat.opacity)),
                tensor("color", 48, |splat| splat.color.as_flattened()),
            ],
            notes,
        })
    }
}

impl fmt::Display for SplatInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size =
            self.file_bytes.map_or(String::new(), |bytes| format!(", {}", format_bytes(bytes)));
        writeln!(f, "{} {}, {}{size}\n", self.kind, self.file, self.format)?;
        let [lo, hi] = self.corners;
        let placed = self.placement.map_or_else(
            || "not said by the file".to_owned(),
            |Placement { offset, scale, up, .. }| {
                format!("{offset:?} in the world, up is {up:?}, and a unit is {scale}")
            },
        );
        for (label, value) in [
            ("Gaussians", grouped(self.gaussians as u64)),
            ("harmonics", format!("degree {}", self.degree)),
            ("corners in the world", format!("{lo:?} and {hi:?}")),
            ("its own origin", placed),
        ] {
            writeln!(f, "{label:<21}  {value}")?;
        }
        write!(f, "\n{}", table(&self.tensors))?;
        self.notes.iter().try_for_each(|note| writeln!(f, "\nwarning: {note}"))
    }
}
