//! What a cameras file holds.

use std::collections::BTreeSet;
use std::fmt;
use std::path::Path;

use organza::Camera;
use organza::error::format_bytes;
use serde::Serialize;

use super::{MOST_ROWS, and_more, file_bytes};
use crate::cli::summary::count;
use crate::cli::table::{Table, number};

#[derive(Debug, Serialize)]
pub struct CameraFile {
    kind: &'static str,
    file: String,
    file_bytes: u64,
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
}

impl CameraFile {
    pub fn new(path: &Path, cameras: &[Camera]) -> Self {
        let info = |camera: &Camera| CameraInfo {
            file_path: camera.file_path.clone(),
            width: camera.width,
            height: camera.height,
            fl_x: camera.fl_x,
            fl_y: camera.fl_y,
            cx: camera.cx,
            cy: camera.cy,
            eye: camera.eye(),
            distorted: camera.distorted,
        };
        Self {
            kind: "cameras",
            file: path.display().to_string(),
            file_bytes: file_bytes(path),
            cameras: cameras.iter().map(info).collect(),
        }
    }
}

impl fmt::Display for CameraFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "cameras {}, {}\n", self.file, format_bytes(self.file_bytes))?;
        let sizes: BTreeSet<_> = self.cameras.iter().map(|c| (c.width, c.height)).collect();
        let sizes: Vec<_> = sizes.iter().take(4).map(|(w, h)| format!("{w} x {h}")).collect();
        writeln!(f, "{} of {}", count(self.cameras.len() as u64, "view"), sizes.join(", "))?;
        let distorted = self.cameras.iter().filter(|camera| camera.distorted).count();
        if distorted > 0 {
            writeln!(f, "{distorted} through a distorting lens; rendered undistorted")?;
        }
        let titles = ["view", "image", "size", "fl_x", "fl_y", "cx", "cy", "x", "y", "z"];
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
            ]);
        }
        write!(f, "\n{table}{}", and_more(self.cameras.len()))
    }
}
