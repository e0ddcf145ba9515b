//! Pinhole cameras from nerfstudio's `transforms.json`, and their paths.

mod moved;
mod orbit;
pub mod parse;
mod path;
mod target;
#[cfg(test)]
mod tests;

use std::path::Path;

pub use moved::{to_rotation_vector, turned};
pub use orbit::{Orbit, upward};
pub use path::CameraPath;
pub use target::{Target, median};

use glam::{DMat3, DVec3, Vec2};
use organza_shaders::camera::Camera as KernelCamera;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::atomic_file::write_atomic;
use crate::error::{Error, IN_MEMORY, Result, refuse};
use crate::input::read_json;

/// Largest width or height of an image, in pixels.
pub const MAX_IMAGE_SIDE: u32 = 65536;
/// Largest difference between `R^T R` and the identity. Files give poses with six or more digits, so a valid pose is
/// far below this. A scaled or sheared one is far above.
const ORTHONORMAL_TOLERANCE: f64 = 1e-3;

/// A camera: its pose and its projection.
///
/// ```
/// use organza_core::Camera;
///
/// // from (0, -4, 1) toward the origin, 0.8 radians wide, with z up in the image
/// let camera = Camera::look_at([0.0, -4.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], 0.8, [640, 480])?;
/// assert_eq!(camera.eye(), [0.0, -4.0, 1.0]);
/// assert_eq!([camera.cx, camera.cy], [320.0, 240.0]);
///
/// let folder = tempfile::tempdir().expect("a folder");
/// let path = folder.path().join("cameras.json");
/// Camera::save_all(&path, &[camera.clone()])?;
/// assert_eq!(Camera::load_all(&path)?, [camera]);
/// # Ok::<(), organza_core::Error>(())
/// ```
///
/// Serialized as in the JSON of the viewer's page. Deserializing checks nothing: call [`Self::validate`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Camera-to-world matrix as in the file, row-major. Axes are OpenGL's: x right, y up, looking along -z. The last
    /// column is the translation, in world units.
    pub camera_to_world: [[f64; 4]; 4],
    /// Focal length in x, in pixels.
    pub fl_x: f64,
    /// Focal length in y, in pixels.
    pub fl_y: f64,
    /// Principal point in x, in pixels from the image's left edge.
    pub cx: f64,
    /// Principal point in y, in pixels from the image's upper edge.
    pub cy: f64,
    /// Image width in pixels.
    #[serde(rename = "w")]
    pub width: u32,
    /// Image height in pixels.
    #[serde(rename = "h")]
    pub height: u32,
    /// Path of the frame's image, relative to the file. `None` if the file names none.
    #[serde(skip)]
    pub file_path: Option<String>,
    /// Whether the file describes a lens other than a pinhole. Organza renders the undistorted pinhole image in any
    /// case.
    #[serde(skip)]
    pub distorted: bool,
}

impl Camera {
    /// Reads the cameras of a `transforms.json`, in the order of its `frames`.
    ///
    /// A frame's intrinsics take precedence over the file's. Focal lengths may be missing if there is `camera_angle_x`
    /// (and `camera_angle_y`), in radians as in Blender's data sets. The principal point may then be missing, too: it is
    /// the image's center.
    ///
    /// # Errors
    /// [`Error::ReadFile`]; [`Error::BadJson`]; [`Error::Invalid`] if there are no frames, or for the
    /// first frame that describes no camera.
    pub fn load_all(path: impl AsRef<Path>) -> Result<Vec<Self>> {
        let path = path.as_ref();
        parse::cameras(&read_json(path)?, path)
    }

    /// The camera of a downscaled image, in which each square of `factor` x `factor` pixels became one. Intrinsics
    /// are measured from the image's corner, so they all shrink by the same factor.
    pub fn smaller(&self, factor: u32) -> Self {
        let scale = f64::from(factor);
        Self {
            fl_x: self.fl_x / scale,
            fl_y: self.fl_y / scale,
            cx: self.cx / scale,
            cy: self.cy / scale,
            width: self.width / factor,
            height: self.height / factor,
            ..self.clone()
        }
    }

    /// Writes a `transforms.json` that [`Self::load_all`] reads, atomically. It describes the rendered pinhole
    /// images, so `distorted` is not kept.
    ///
    /// # Errors
    /// [`Error::WriteFile`]; [`Error::Invalid`] without cameras, or for the first camera that is not
    /// valid.
    pub fn save_all(path: impl AsRef<Path>, cameras: &[Self]) -> Result<()> {
        let file = encode(cameras)?;
        write_atomic(path, |writer| writer.write_all(&file))
    }

    /// A camera at `eye` that looks at `target` and sees `angle_x` radians from left to right. `up` points upward in
    /// its image; pixels are square.
    ///
    /// # Errors
    /// [`Error::Invalid`] if `eye` is `target`, if `up` lies along the line of sight, or if the angle or the image
    /// size is out of range.
    pub fn look_at(
        eye: [f64; 3],
        target: [f64; 3],
        up: [f64; 3],
        angle_x: f64,
        [width, height]: [u32; 2],
    ) -> Result<Self> {
        let [eye, target, up] = [eye, target, up].map(DVec3::from);
        // `DVec3::normalize` multiplies by the reciprocal, which rounds once more
        let normalized = |vector: DVec3| vector / vector.length();
        let back = normalized(eye - target);
        let right = normalized(up.cross(back));
        let up = back.cross(right);
        let row = |axis: usize| [right[axis], up[axis], back[axis], eye[axis]];
        let focal = parse::focal_length(f64::from(width), angle_x)
            .map_err(|reason| camera_error(IN_MEMORY.as_ref(), 0, reason))?;
        let pose = [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]];
        let principal = [width, height].map(|side| 0.5 * f64::from(side));
        let camera = Self::pinhole(pose, [focal; 2], principal, [width, height]);
        camera.validate(0)?;
        Ok(camera)
    }

    /// A camera from its pose, focal lengths, principal point and image size, all in pixels. [`Self::validate`]
    /// checks it.
    pub fn pinhole(
        camera_to_world: [[f64; 4]; 4],
        [fl_x, fl_y]: [f64; 2],
        [cx, cy]: [f64; 2],
        [width, height]: [u32; 2],
    ) -> Self {
        let file_path = None;
        Self { camera_to_world, fl_x, fl_y, cx, cy, width, height, file_path, distorted: false }
    }

    /// The same view as an image of another size. It shows everything that the camera sees. If the shape differs, it
    /// shows more at the sides, or above and below.
    #[must_use]
    pub fn with_size(&self, [width, height]: [u32; 2]) -> Self {
        let [old, new] =
            [[self.width, self.height], [width, height]].map(|size| size.map(f64::from));
        let scale = (new[0] / old[0]).min(new[1] / old[1]);
        Self {
            fl_x: scale * self.fl_x,
            fl_y: scale * self.fl_y,
            cx: 0.5 * new[0] + scale * (self.cx - 0.5 * old[0]),
            cy: 0.5 * new[1] + scale * (self.cy - 0.5 * old[1]),
            width,
            height,
            ..self.clone()
        }
    }

    /// The same view with the image's sides divided by `factor` and rounded up: see [`Self::with_size`].
    #[must_use]
    pub fn shrunk(&self, factor: u32) -> Self {
        self.with_size([self.width, self.height].map(|side| side.div_ceil(factor)))
    }

    /// The same view, with at most `side` pixels on the image's longest side: see [`Self::with_size`].
    #[must_use]
    pub fn within(&self, side: u32) -> Self {
        let longest = self.width.max(self.height);
        if longest <= side {
            return self.clone();
        }
        let scale = f64::from(side) / f64::from(longest);
        let size = [self.width, self.height];
        self.with_size(size.map(|pixels| ((f64::from(pixels) * scale).round() as u32).max(1)))
    }

    /// The depth of a place along the camera's axis, in world units; negative behind the camera.
    pub fn depth(&self, place: [f64; 3]) -> f64 {
        self.axes()[2].dot(DVec3::from(place) - DVec3::from(self.eye()))
    }

    /// Where a place is in the camera's image: column, row, and depth as [`Self::depth`]. `None` if it is outside of the
    /// image.
    pub fn project(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        let offset = DVec3::from(place) - DVec3::from(self.eye());
        let [x, y, z] = self.axes().map(|axis| axis.dot(offset));
        let column = self.fl_x * x / z + self.cx;
        let row = self.fl_y * y / z + self.cy;
        let is_seen = z > 0.0
            && (0.0..f64::from(self.width)).contains(&column)
            && (0.0..f64::from(self.height)).contains(&row);
        is_seen.then_some([column, row, z])
    }

    /// The depth of a place in world units, as [`Self::depth`]; `None` if it is outside of the camera's image.
    pub fn depth_in_image(&self, place: [f64; 3]) -> Option<f64> {
        self.project(place).map(|[.., depth]| depth)
    }

    /// The camera in the form that kernels read: OpenCV axes, f32.
    pub fn for_kernels(&self) -> KernelCamera {
        KernelCamera {
            rotation: self.axes().map(|axis| axis.as_vec3()),
            eye: DVec3::from(self.eye()).as_vec3(),
            focal: Vec2::new(self.fl_x as f32, self.fl_y as f32),
            center: Vec2::new(self.cx as f32, self.cy as f32),
            size: Vec2::new(self.width as f32, self.height as f32),
        }
    }

    /// Right, down and forward in the world: the axes of OpenCV's camera, and the rows of the rotation from world to camera
    /// axes.
    pub fn axes(&self) -> [DVec3; 3] {
        // The pose is orthonormal, so its transpose is its inverse: columns become rows.
        [self.column(0), -self.column(1), -self.column(2)]
    }

    /// A column of the pose, in world space: an axis of OpenGL's camera, or for 3 the camera's center.
    pub(crate) fn column(&self, column: usize) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|row| self.camera_to_world[row][column]))
    }

    /// The direction of a place in the image, column and row, in the world; its depth is 1.
    pub fn ray(&self, [column, row]: [f64; 2]) -> DVec3 {
        let [x, y] = [(column - self.cx) / self.fl_x, (row - self.cy) / self.fl_y];
        self.to_world() * DVec3::new(x, y, 1.0)
    }

    /// The rotation from OpenCV's camera axes to world axes.
    pub fn to_world(&self) -> DMat3 {
        let [right, down, forward] = self.axes();
        DMat3::from_cols(right, down, forward)
    }

    /// The camera's center in world space.
    pub fn eye(&self) -> [f64; 3] {
        self.column(3).to_array()
    }

    /// Checks the pose and the intrinsics. Errors give the camera's index as `frame`.
    ///
    /// # Errors
    /// [`Error::Invalid`] for the first problem.
    pub fn validate(&self, frame: usize) -> Result<()> {
        self.check().map_err(|reason| camera_error(IN_MEMORY.as_ref(), frame, reason))
    }

    /// Like [`Self::validate`], for callers with their own names of cameras.
    pub fn check(&self) -> Result<(), String> {
        self.check_intrinsics().and_then(|()| self.check_pose())
    }

    fn check_intrinsics(&self) -> Result<(), String> {
        for (name, value) in [("fl_x", self.fl_x), ("fl_y", self.fl_y)] {
            // In f32, as the kernels see it.
            if !(value > 0.0 && (value as f32).is_normal()) {
                return Err(format!("`{name}` is {value}, expected a positive number of pixels"));
            }
        }
        for (name, value) in [("cx", self.cx), ("cy", self.cy)] {
            if !(value as f32).is_finite() {
                return Err(format!("`{name}` is {value}, expected a finite number of pixels"));
            }
        }
        for (name, value) in [("w", self.width), ("h", self.height)] {
            if !(1..=MAX_IMAGE_SIDE).contains(&value) {
                return Err(format!("`{name}` is {value}, expected 1 to {MAX_IMAGE_SIDE} pixels"));
            }
        }
        Ok(())
    }

    fn check_pose(&self) -> Result<(), String> {
        let pose = &self.camera_to_world;
        if let Some(value) = pose.iter().flatten().find(|value| !(**value as f32).is_finite()) {
            return Err(format!("`transform_matrix` holds {value}, expected finite numbers"));
        }
        let last = pose[3].iter().zip([0.0, 0.0, 0.0, 1.0]);
        if last.map(|(found, expected)| (found - expected).abs()).any(|off| off > 1e-6) {
            return Err(format!(
                "the last row of `transform_matrix` is {:?}, expected [0, 0, 0, 1]: is it \
                 transposed?",
                pose[3]
            ));
        }
        let axes = [0, 1, 2].map(|column| DVec3::from([0, 1, 2].map(|row| pose[row][column])));
        let determinant = axes[0].cross(axes[1]).dot(axes[2]);
        if determinant.abs() < 1e-9 {
            return Err(
                "`transform_matrix` is a singular pose: its 3x3 block has determinant 0".into()
            );
        }
        let mut off = 0.0_f64;
        for (i, a) in axes.iter().enumerate() {
            for (j, b) in axes.iter().enumerate() {
                off = off.max((a.dot(*b) - f64::from(u8::from(i == j))).abs());
            }
        }
        if off > ORTHONORMAL_TOLERANCE {
            return Err(format!(
                "the 3x3 block of `transform_matrix` is no rotation: its columns are {off:.3e} \
                 from orthonormal (limit {ORTHONORMAL_TOLERANCE:e}); take scale and shear out of it"
            ));
        }
        if determinant < 0.0 {
            return Err(
                "the 3x3 block of `transform_matrix` mirrors space (determinant -1); expected \
                        OpenGL axes: x right, y up, looking along -z"
                    .into(),
            );
        }
        Ok(())
    }
}

/// The bytes of a `transforms.json`: see [`Camera::save_all`].
pub fn encode(cameras: &[Camera]) -> Result<Vec<u8>> {
    let Some(first) = cameras.first() else { return refuse("there are no cameras to write") };
    for (frame, camera) in cameras.iter().enumerate() {
        camera.validate(frame)?;
    }
    let intrinsics = |camera: &Camera| {
        let mut values = json!(camera);
        values.as_object_mut().and_then(|values| values.remove("camera_to_world"));
        values
    };
    let shared = intrinsics(first);
    let same = cameras.iter().all(|camera| intrinsics(camera) == shared);
    let frame = |camera: &Camera| {
        let mut frame = if same { json!({}) } else { intrinsics(camera) };
        if let Some(path) = &camera.file_path {
            frame["file_path"] = json!(path);
        }
        frame["transform_matrix"] = json!(camera.camera_to_world);
        frame
    };
    let mut file = if same { shared.clone() } else { json!({}) };
    file["camera_model"] = json!("PINHOLE");
    file["frames"] = cameras.iter().map(frame).collect();
    let mut bytes = serde_json::to_vec_pretty(&file).or_else(|error| refuse(error.to_string()))?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// The error of the camera in frame `frame` of the file `origin`.
pub fn camera_error(origin: &Path, frame: usize, reason: String) -> Error {
    Error::Invalid { origin: origin.to_owned(), reason: format!("camera frame {frame}: {reason}") }
}
