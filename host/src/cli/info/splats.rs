//! Describes a file of Gaussians for viewers that sort.

use std::fmt;
use std::path::Path;

use organza::Result;
use organza::scene::Placement;
use organza::splats::{self, Splat, SplatFile};
use serde::Serialize;

use super::{FileInfo, TensorInfo, table};
use crate::cli::summary::grouped;

#[derive(Debug, Serialize)]
pub struct SplatInfo {
    #[serde(flatten)]
    file: FileInfo,
    format: &'static str,
    gaussians: usize,
    /// The largest degree of harmonics that are not all 0.
    degree: usize,
    /// Whether opacities make up for a viewer's blur.
    antialiased: bool,
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
        let file = splats::load(path)?;
        let SplatFile { format, splats, placement, is_placed, is_antialiased, notes, .. } = file;
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
            file: FileInfo::new("Gaussians", path),
            format,
            gaussians: splats.len(),
            degree: (1..=3).rev().find(is_used).unwrap_or(0),
            antialiased: is_antialiased,
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
        writeln!(f, "{}, {}\n", self.file, self.format)?;
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
            ("antialiased", if self.antialiased { "yes" } else { "no" }.to_owned()),
            ("corners in the world", format!("{lo:?} and {hi:?}")),
            ("its own origin", placed),
        ] {
            writeln!(f, "{label:<21}  {value}")?;
        }
        write!(f, "\n{}", table(&self.tensors))?;
        self.notes.iter().try_for_each(|note| writeln!(f, "\nwarning: {note}"))
    }
}
