//! Tensors of any file, and their ranges.

use std::fmt;
use std::path::Path;

use organza::Result;
use organza::error::format_bytes;
use organza::scene::read_tensors;
use serde::Serialize;

use crate::cli::summary::count;
use crate::cli::table::{Table, number};

/// One tensor's shape and range.
#[derive(Debug, Serialize)]
pub struct TensorInfo {
    pub name: String,
    pub shape: Vec<usize>,
    /// Smallest finite value; absent if there is none.
    min: Option<f32>,
    max: Option<f32>,
    mean: Option<f64>,
    /// Number of NaNs and infinities.
    not_finite: usize,
}

impl TensorInfo {
    pub fn new(name: &str, shape: &[usize], data: &[f32]) -> Self {
        let mut min = f32::INFINITY;
        let mut max = f32::NEG_INFINITY;
        let mut sum = 0.0;
        let mut finite = 0;
        for &value in data.iter().filter(|value| value.is_finite()) {
            min = min.min(value);
            max = max.max(value);
            sum += f64::from(value);
            finite += 1;
        }
        let known = finite > 0;
        Self {
            name: name.to_owned(),
            shape: shape.to_vec(),
            min: known.then_some(min),
            max: known.then_some(max),
            mean: known.then(|| sum / f64::from(finite)),
            not_finite: data.len() - finite as usize,
        }
    }
}

/// Tensors as a table.
pub fn table(tensors: &[TensorInfo]) -> Table {
    let mut table = Table::new(2, ["tensor", "shape", "min", "max", "mean", ""]);
    for tensor in tensors {
        let cell = |value: Option<f64>| value.map_or("-".to_owned(), number);
        table.row([
            tensor.name.clone(),
            format!("{:?}", tensor.shape),
            cell(tensor.min.map(f64::from)),
            cell(tensor.max.map(f64::from)),
            cell(tensor.mean),
            match tensor.not_finite {
                0 => String::new(),
                number => count(number as u64, "NaN or infinite value"),
            },
        ]);
    }
    table
}

/// A file of tensors that is no scene, such as a rendered batch.
#[derive(Debug, Serialize)]
pub struct TensorFile {
    kind: &'static str,
    file: String,
    file_bytes: u64,
    tensors: Vec<TensorInfo>,
}

impl TensorFile {
    pub fn load(path: &Path) -> Result<Self> {
        let tensors = read_tensors(path)?;
        let is_batch = |shape: &[usize]| matches!(shape, [_, 3, rows, columns] if rows == columns);
        let batch = tensors.get("tiles").is_some_and(|tensor| is_batch(&tensor.shape));
        let info = tensors.iter().map(|(name, t)| TensorInfo::new(name, &t.shape, &t.data));
        Ok(Self {
            kind: if batch { "rendered batch" } else { "tensors" },
            file: path.display().to_string(),
            file_bytes: super::file_bytes(path),
            tensors: info.collect(),
        })
    }
}

impl fmt::Display for TensorFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = self.kind;
        let file = &self.file;
        let size = format_bytes(self.file_bytes);
        writeln!(f, "{kind} {file}, {size}")?;
        let tiles = self.tensors.iter().find(|tensor| tensor.name == "tiles");
        if let (Some(tiles), "rendered batch") = (tiles, kind) {
            let side = tiles.shape[2];
            writeln!(f, "\n{} of {side} x {side}", count(tiles.shape[0] as u64, "tile"))?;
        }
        write!(f, "\n{}", table(&self.tensors))
    }
}
