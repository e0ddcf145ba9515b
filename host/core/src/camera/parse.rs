//! Parses the JSON of a `transforms.json` into cameras. Errors name the frame and the field.

use std::path::Path;

use glam::{DMat3, DVec3};
use serde_json::Value;

use super::{Camera, MAX_IMAGE_SIDE, ORTHONORMAL_TOLERANCE, camera_error};
use crate::error::{Result, invalid};
use crate::input::{integer, kind};

/// Camera models that are pinholes if their coefficients are zero. A fisheye model is not.
pub const PERSPECTIVE_MODELS: [&str; 6] =
    ["PINHOLE", "SIMPLE_PINHOLE", "OPENCV", "SIMPLE_RADIAL", "RADIAL", "FULL_OPENCV"];
/// Models without coefficients; any that the file gives are ignored.
pub const PINHOLE_MODELS: [&str; 2] = ["PINHOLE", "SIMPLE_PINHOLE"];
/// Model of panoramas of 360 degrees. Their size says all about them.
pub const PANORAMA: &str = "EQUIRECTANGULAR";
/// Largest difference between `R^T R` and the identity for a rotation that was written with three digits: each number is
/// off by up to 0.0005.
const THREE_DIGITS: f64 = 2e-3;
const COEFFICIENTS: [&str; 8] = ["k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"];

/// Every camera of a file's JSON.
pub fn cameras(file: &Value, origin: &Path) -> Result<Vec<Camera>> {
    let parse = |(index, frame): (usize, &Value)| {
        let source = Source { file, frame, size: None };
        if source.is_panorama() {
            let reason = "is a panorama of 360 degrees, which a data set cuts into several views; name its folder instead";
            return Err(camera_error(origin, index, reason.to_owned()));
        }
        source.valid_camera(index, origin)
    };
    frames(file, origin)?.iter().enumerate().map(parse).collect()
}

/// The frames of a file's JSON, at least one.
pub fn frames<'a>(file: &'a Value, origin: &Path) -> Result<&'a [Value]> {
    let frames = match file.get("frames") {
        Some(Value::Array(frames)) => frames,
        Some(other) => {
            return invalid(origin, format!("`frames` is {}, expected an array", kind(other)));
        }
        None => {
            return invalid(
                origin,
                "`frames` is missing; expected nerfstudio's transforms.json with one frame per camera",
            );
        }
    };
    if frames.is_empty() {
        return invalid(origin, "`frames` is empty; there is no camera to render from");
    }
    Ok(frames)
}

/// The focal length in pixels of an image `side` pixels wide that spans `angle` radians.
pub(super) fn focal_length(side: f64, angle: f64) -> Result<f64, String> {
    if !(angle > 0.0 && angle < std::f64::consts::PI) {
        return Err(format!("the camera angle is {angle}, expected radians between 0 and pi"));
    }
    Ok(0.5 * side / (0.5 * angle).tan())
}

/// Repairs what other programs leave in a pose's rotation: a common scale of all axes, which means nothing for a camera, or
/// the rounding to three digits. Exact rotations, and all other matrices, stay unchanged.
fn straightened(mut pose: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
    let off = |axes: DMat3| {
        let off = axes.transpose() * axes - DMat3::IDENTITY;
        off.to_cols_array().into_iter().fold(0.0, |largest: f64, off| largest.max(off.abs()))
    };
    let column = |axis: usize| DVec3::new(pose[0][axis], pose[1][axis], pose[2][axis]);
    let found = DMat3::from_cols(column(0), column(1), column(2));
    let scale = found.determinant().cbrt();
    let mut axes = found * scale.recip();
    if off(found) <= ORTHONORMAL_TOLERANCE || !(scale > 0.0 && off(axes) <= THREE_DIGITS) {
        return pose;
    }
    // Newton's method for the nearest rotation: each step squares the error
    for _ in 0..4 {
        axes = (axes + axes.inverse().transpose()) * 0.5;
    }
    for (index, row) in pose.iter_mut().take(3).enumerate() {
        row[..3].copy_from_slice(&axes.row(index).to_array());
    }
    pose
}

/// A frame and its file. The file has the values that the frame lacks.
pub struct Source<'a> {
    /// The whole file.
    pub file: &'a Value,
    /// The frame.
    pub frame: &'a Value,
    /// Width and height of the photograph in pixels, used if neither gives a size.
    pub size: Option<[u32; 2]>,
}

impl Source<'_> {
    /// The frame's camera. Errors name `index` and `origin`.
    pub fn valid_camera(&self, index: usize, origin: &Path) -> Result<Camera> {
        let valid = self.camera().and_then(|camera| camera.check().map(|()| camera));
        valid.map_err(|reason| camera_error(origin, index, reason))
    }

    fn camera(&self) -> Result<Camera, String> {
        if !self.frame.is_object() {
            return Err(format!("is {}, expected an object", kind(self.frame)));
        }
        let camera_to_world = self.pose()?;
        let width = self.side("w")?;
        let height = self.side("h")?;
        let [w, h] = [width, height].map(f64::from);
        let angle_x = self.number("camera_angle_x")?;
        let angle_y = self.number("camera_angle_y")?.map(|angle| (h, angle));
        let angle_x = angle_x.map(|angle| (w, angle));
        let focal = |key, angle: Option<(f64, f64)>| match (self.number(key)?, angle) {
            (Some(focal), _) => Ok(Some(focal)),
            (None, Some((side, angle))) => focal_length(side, angle).map(Some),
            (None, None) => Ok::<_, String>(None),
        };
        // like instant-ngp: square pixels, and the principal point in the middle
        let fl_x = match self.is_panorama() {
            true => w / std::f64::consts::TAU,
            false => focal("fl_x", angle_x)?.ok_or_else(|| self.missing("fl_x"))?,
        };
        let fl_y = focal("fl_y", angle_y.or(angle_x))?.unwrap_or(fl_x);
        let point = |key, side: f64| Ok::<_, String>(self.number(key)?.unwrap_or(0.5 * side));
        Ok(Camera {
            camera_to_world,
            fl_x,
            fl_y,
            cx: point("cx", w)?,
            cy: point("cy", h)?,
            width,
            height,
            file_path: self.frame.get("file_path").and_then(Value::as_str).map(str::to_owned),
            distorted: self.distorted()?,
        })
    }

    /// The value of a key, from the frame or else from the file; null counts as absent.
    pub fn get(&self, key: &str) -> Option<&Value> {
        let present = |source: &'_ &Value| source.get(key).is_some_and(|value| !value.is_null());
        [self.frame, self.file].into_iter().find(present)?.get(key)
    }

    fn is_panorama(&self) -> bool {
        self.get("camera_model").and_then(Value::as_str) == Some(PANORAMA)
    }

    /// The number of a key; `None` if the file has none.
    pub fn number(&self, key: &str) -> Result<Option<f64>, String> {
        match self.get(key) {
            None => Ok(None),
            Some(value) => match value.as_f64() {
                Some(number) => Ok(Some(number)),
                None => Err(format!("`{key}` is {}, expected a number", kind(value))),
            },
        }
    }

    fn missing(&self, key: &str) -> String {
        let hint = if matches!(key, "w" | "h") { "" } else { ", or camera_angle_x with w and h" };
        format!(
            "`{key}` is missing from the frame and from the file; a camera needs \
             fl_x, w and h{hint}; fl_y, cx and cy may be missing"
        )
    }

    fn side(&self, key: &str) -> Result<u32, String> {
        let Some(value) = self.get(key) else {
            let side = self.size.map(|[width, height]| if key == "w" { width } else { height });
            return side.ok_or_else(|| self.missing(key));
        };
        let side = integer(value).and_then(|side| u32::try_from(side).ok());
        match side {
            Some(side) if (1..=MAX_IMAGE_SIDE).contains(&side) => Ok(side),
            _ => Err(format!(
                "`{key}` is {value}, expected a whole number of 1 to {MAX_IMAGE_SIDE} pixels"
            )),
        }
    }

    fn pose(&self) -> Result<[[f64; 4]; 4], String> {
        const EXPECTED: &str = "expected a 4x4 (or 3x4) array of numbers, camera to world";
        let Some(matrix) = self.frame.get("transform_matrix") else {
            return Err(format!("`transform_matrix` is missing; {EXPECTED}"));
        };
        let rows = matrix.as_array().map(Vec::as_slice).unwrap_or_default();
        if !matches!(rows.len(), 3 | 4) {
            return Err(format!("`transform_matrix` has {} rows; {EXPECTED}", rows.len()));
        }
        let mut pose = [[0.0, 0.0, 0.0, 1.0]; 4];
        for (index, (row, into)) in rows.iter().zip(&mut pose).enumerate() {
            let numbers: Option<Vec<f64>> =
                row.as_array().and_then(|row| row.iter().map(Value::as_f64).collect());
            *into = numbers.and_then(|numbers| numbers.try_into().ok()).ok_or_else(|| {
                format!("row {index} of `transform_matrix` is not four numbers; {EXPECTED}")
            })?;
        }
        // a homogeneous matrix may have any common factor
        let last = pose[3][3];
        if last.is_normal() && last != 1.0 {
            pose.as_flattened_mut().iter_mut().for_each(|value| *value /= last);
        }
        Ok(straightened(pose))
    }

    fn distorted(&self) -> Result<bool, String> {
        let model = self.get("camera_model").and_then(Value::as_str);
        if model.is_some_and(|model| PINHOLE_MODELS.contains(&model)) {
            return Ok(false);
        }
        let mut distorted = model.is_some_and(|model| !PERSPECTIVE_MODELS.contains(&model));
        for key in COEFFICIENTS {
            distorted |= self.number(key)?.is_some_and(|coefficient| coefficient != 0.0);
        }
        Ok(distorted)
    }
}
