//! Describes a cameras file.

use std::collections::BTreeSet;
use std::fmt;
use std::path::{Path, PathBuf};

use organza::data::{Pose, Poses};
use organza::error::format_bytes;
use organza::scene::Placement;
use organza::{Camera, DatasetOptions, Result};
use serde::Serialize;

use super::{MOST_ROWS, and_more, file_bytes};
use crate::cli::summary::count;
use crate::cli::table::{Table, number};

#[derive(Debug, Serialize)]
pub struct CameraFile {
    kind: &'static str,
    file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    file_bytes: Option<u64>,
    /// The format of a data set; `None` for other files.
    #[serde(skip_serializing_if = "Option::is_none")]
    format: Option<String>,
    /// Photographs of a data set that do not exist, and what else it does not use.
    #[serde(skip_serializing_if = "Option::is_none")]
    missing: Option<Vec<PathBuf>>,
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
            kind: "cameras",
            file: path.display().to_string(),
            file_bytes: Some(file_bytes(path)),
            format: None,
            missing: None,
            notes: None,
            cameras: cameras.iter().map(CameraInfo::from).collect(),
        }
    }

    /// Reads a data set's cameras as training has them, unless an option says otherwise, but in the world.
    pub fn from_data_set(path: &Path) -> Result<Self> {
        let options = DatasetOptions::default().placement(Placement::default());
        let poses = Poses::load(path, &options)?;
        let info = |pose: Pose| CameraInfo {
            held_out: Some(pose.held_out),
            distorted: pose.distorted,
            ..CameraInfo::from(&pose.camera)
        };
        let cameras = poses.cameras()?.into_iter().map(info).collect();
        Ok(Self {
            kind: "data set",
            file: path.display().to_string(),
            file_bytes: None,
            format: Some(poses.kind.to_string()),
            missing: Some(poses.missing),
            notes: Some(poses.notes),
            cameras,
        })
    }
}

impl fmt::Display for CameraFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.file_bytes.map(format_bytes);
        let what = size.iter().chain(&self.format).cloned().collect::<Vec<_>>().join(", ");
        writeln!(f, "{} {}, {what}\n", self.kind, self.file)?;
        let sizes: BTreeSet<_> = self.cameras.iter().map(|c| (c.width, c.height)).collect();
        let sizes: Vec<_> = sizes.iter().take(4).map(|(w, h)| format!("{w} x {h}")).collect();
        writeln!(f, "{} of {}", count(self.cameras.len() as u64, "view"), sizes.join(", "))?;
        let distorted = self.cameras.iter().filter(|camera| camera.distorted).count();
        if distorted > 0 {
            writeln!(f, "{distorted} through a distorting lens; rendered undistorted")?;
        }
        if let Some([first, others @ ..]) = self.missing.as_deref() {
            let files = count(1 + others.len() as u64, "photograph");
            writeln!(f, "{files} missing, the first is {}", first.display())?;
        }
        self.notes.iter().flatten().try_for_each(|note| writeln!(f, "note: {note}"))?;
        let held_out = self.cameras.iter().filter(|camera| camera.held_out == Some(true)).count();
        if self.format.is_some() {
            writeln!(f, "{held_out} held out")?;
        }
        let titles = ["view", "image", "size", "fl_x", "fl_y", "cx", "cy", "x", "y", "z", ""];
        let mut table = Table::new(3, titles);
        for (index, camera) in self.cameras.iter().take(MOST_ROWS).enumerate() {
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
