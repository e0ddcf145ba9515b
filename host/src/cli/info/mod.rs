//! `organza info`: describes a file: a scene, cameras, tiles, Gaussians of other programs, or other tensors.

mod scene;
mod splats;

use std::collections::BTreeSet;
use std::fmt;
use std::fs::Metadata;
use std::path::{Path, PathBuf};

use organza::data::{Pose, Poses};
use organza::error::format_bytes;
use organza::scene::{Placement, read_tensors};
use organza::{Camera, DatasetOptions, Error, Result, Scene, TileBatch};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::inputs::{FileKind, SceneSource, told_apart};
use crate::cli::summary::{Table, count, number};
use crate::cli::text_of;

/// Most rows of a table that could have as many rows as a data set has photographs.
const MAX_ROWS: usize = 24;

/// Describe a scene, cameras, tiles, a rendered batch, a data set, or a .ply, .spz, .sog, .glb or .splat
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("../help/info.txt"))]
pub struct Args {
    /// The file, which is recognized by its content, or by its ending. Or a folder: a training run's, or a data set
    file: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    match FileKind::from_path(&args.file) {
        Some(FileKind::DataSet) => return show(args, &CameraFile::from_data_set(&args.file)?),
        Some(FileKind::Splats) => return show(args, &splats::SplatInfo::load(&args.file)?),
        _ => {}
    }
    let source = SceneSource::find(&args.file)?;
    let path = source.file();
    console.detail(&format!("reading {}", path.display()));
    match FileKind::by_content(path)? {
        FileKind::Cameras => show(args, &CameraFile::new(path, &Camera::load_all(path)?)),
        FileKind::Tiles => show(args, &TileFile::new(path, &TileBatch::load(path)?)),
        _ => match Scene::load(path) {
            Ok(scene) => show(args, &scene::SceneInfo::new(path, &scene)?),
            // No program has named the file's content: it has just tensors.
            Err(Error::WrongFormat { found, .. }) if found == "missing" => {
                show(args, &TensorFile::load(path)?)
            }
            Err(error) => Err(told_apart(error, path, FileKind::Scene)),
        },
    }
}

fn show(args: &Args, info: &(impl Serialize + fmt::Display)) -> Result<()> {
    if args.json { print_json(info) } else { print(&info.to_string()) }
}

/// The number of rows that a table leaves out, as text.
fn and_more(all: usize) -> String {
    match all.saturating_sub(MAX_ROWS) {
        0 => String::new(),
        more => format!("... and {more} more (--json has all)\n"),
    }
}

/// What is described.
#[derive(Debug, Serialize)]
pub struct FileInfo {
    kind: &'static str,
    file: String,
    /// Size in bytes; `None` for a folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    file_bytes: Option<u64>,
}

impl FileInfo {
    pub fn new(kind: &'static str, path: &Path) -> Self {
        let found = std::fs::metadata(path).ok().filter(Metadata::is_file);
        Self { kind, file: text_of(path), file_bytes: found.map(|found| found.len()) }
    }
}

impl fmt::Display for FileInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.file_bytes.map(|bytes| format!(", {}", format_bytes(bytes)));
        write!(f, "{} {}{}", self.kind, self.file, size.unwrap_or_default())
    }
}

#[derive(Debug, Serialize)]
pub struct TileFile {
    #[serde(flatten)]
    file: FileInfo,
    side: u32,
    tiles: usize,
    output_shape: [usize; 4],
    output_bytes: u64,
}

impl TileFile {
    pub fn new(path: &Path, batch: &TileBatch) -> Self {
        let output_shape = batch.output_shape();
        Self {
            file: FileInfo::new("tiles", path),
            side: batch.side,
            tiles: batch.tiles.len(),
            output_shape,
            output_bytes: 4 * output_shape.iter().map(|&size| size as u64).product::<u64>(),
        }
    }
}

impl fmt::Display for TileFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.file)?;
        let side = self.side;
        let shape = self.output_shape;
        let bytes = format_bytes(self.output_bytes);
        let tiles = count(self.tiles as u64, "tile");
        writeln!(f, "{tiles} of {side} x {side}, rendered as {shape:?} ({bytes})")
    }
}

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

const BATCH: &str = "rendered batch";

/// A file of tensors that is no scene, such as a rendered batch.
#[derive(Debug, Serialize)]
pub struct TensorFile {
    #[serde(flatten)]
    file: FileInfo,
    tensors: Vec<TensorInfo>,
}

impl TensorFile {
    pub fn load(path: &Path) -> Result<Self> {
        let tensors = read_tensors(path)?;
        let is_batch = |shape: &[usize]| matches!(shape, [_, 3, rows, columns] if rows == columns);
        let batch = tensors.get("tiles").is_some_and(|tensor| is_batch(&tensor.shape));
        let info = tensors.iter().map(|(name, t)| TensorInfo::new(name, &t.shape, &t.data));
        let kind = if batch { BATCH } else { "tensors" };
        Ok(Self { file: FileInfo::new(kind, path), tensors: info.collect() })
    }
}

impl fmt::Display for TensorFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.file)?;
        let tiles = self.tensors.iter().find(|tensor| tensor.name == "tiles");
        if let Some(tiles) = tiles.filter(|_| self.file.kind == BATCH) {
            let side = tiles.shape[2];
            writeln!(f, "\n{} of {side} x {side}", count(tiles.shape[0] as u64, "tile"))?;
        }
        write!(f, "\n{}", table(&self.tensors))
    }
}

#[derive(Debug, Serialize)]
pub struct CameraFile {
    #[serde(flatten)]
    file: FileInfo,
    /// The format of a data set; `None` for other files.
    #[serde(skip_serializing_if = "Option::is_none")]
    format: Option<String>,
    /// Photographs of a data set that do not exist, and what else it does not use.
    #[serde(skip_serializing_if = "Option::is_none")]
    missing: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    notes: Option<Vec<String>>,
    cameras: Vec<CameraInfo>,
}

#[derive(Debug, Serialize)]
struct CameraInfo {
    file_path: Option<String>,
    width: u32,
    height: u32,
    fl_x: f64,
    fl_y: f64,
    cx: f64,
    cy: f64,
    eye: [f64; 3],
    distorted: bool,
    /// In a data set: whether training does not see the frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    held_out: Option<bool>,
}

impl From<&Camera> for CameraInfo {
    fn from(camera: &Camera) -> Self {
        Self {
            file_path: camera.file_path.clone(),
            width: camera.width,
            height: camera.height,
            fl_x: camera.fl_x,
            fl_y: camera.fl_y,
            cx: camera.cx,
            cy: camera.cy,
            eye: camera.eye(),
            distorted: camera.distorted,
            held_out: None,
        }
    }
}

impl CameraFile {
    pub fn new(path: &Path, cameras: &[Camera]) -> Self {
        Self {
            file: FileInfo::new("cameras", path),
            format: None,
            missing: None,
            notes: None,
            cameras: cameras.iter().map(CameraInfo::from).collect(),
        }
    }

    /// Reads a data set's cameras as training has them, unless an option says otherwise, but in the world.
    pub fn from_data_set(path: &Path) -> Result<Self> {
        let placement = Some(Placement::default());
        let options = DatasetOptions { placement, ..Default::default() };
        let poses = Poses::load(path, &options)?;
        let info = |pose: Pose| CameraInfo {
            held_out: Some(pose.held_out),
            distorted: pose.distorted,
            ..CameraInfo::from(&pose.camera)
        };
        let cameras = poses.cameras()?.into_iter().map(info).collect();
        Ok(Self {
            file: FileInfo::new("data set", path),
            format: Some(poses.dataset.kind.to_string()),
            missing: Some(poses.dataset.missing.iter().map(|file| text_of(file)).collect()),
            notes: Some(poses.dataset.notes),
            cameras,
        })
    }
}

impl fmt::Display for CameraFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let format = self.format.as_ref().map(|format| format!(", {format}"));
        writeln!(f, "{}{}\n", self.file, format.unwrap_or_default())?;
        let sizes: BTreeSet<_> = self.cameras.iter().map(|c| (c.width, c.height)).collect();
        let sizes: Vec<_> = sizes.iter().take(4).map(|(w, h)| format!("{w} x {h}")).collect();
        writeln!(f, "{} of {}", count(self.cameras.len() as u64, "view"), sizes.join(", "))?;
        let distorted = self.cameras.iter().filter(|camera| camera.distorted).count();
        if distorted > 0 {
            writeln!(f, "{distorted} through a distorting lens; rendered undistorted")?;
        }
        if let Some([first, others @ ..]) = self.missing.as_deref() {
            let files = count(1 + others.len() as u64, "photograph");
            writeln!(f, "{files} missing, the first is {first}")?;
        }
        self.notes.iter().flatten().try_for_each(|note| writeln!(f, "note: {note}"))?;
        let held_out = self.cameras.iter().filter(|camera| camera.held_out == Some(true)).count();
        if self.format.is_some() {
            writeln!(f, "{held_out} held out")?;
        }
        let titles = ["view", "image", "size", "fl_x", "fl_y", "cx", "cy", "x", "y", "z", ""];
        let mut table = Table::new(3, titles);
        for (index, camera) in self.cameras.iter().take(MAX_ROWS).enumerate() {
            table.row([
                index.to_string(),
                camera.file_path.clone().unwrap_or_else(|| "-".to_owned()),
                format!("{} x {}", camera.width, camera.height),
                number(camera.fl_x),
                number(camera.fl_y),
                number(camera.cx),
                number(camera.cy),
                number(camera.eye[0]),
                number(camera.eye[1]),
                number(camera.eye[2]),
                if camera.held_out == Some(true) { "held out" } else { "" }.to_owned(),
            ]);
        }
        write!(f, "\n{table}{}", and_more(self.cameras.len()))
    }
}
