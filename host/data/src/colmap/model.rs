//! Converts COLMAP's camera models and poses to organza's.

use glam::{DMat3, DQuat, DVec3};

use crate::lens::{Lens, Projection};
use Parameter::{CenterX, CenterY, D, Focal, FocalX, FocalY, K, P};
use organza_core::camera::{Camera, MAX_IMAGE_SIDE};

/// A photograph in COLMAP's form.
pub struct Image {
    /// Rotation from world to camera: a quaternion, w first.
    pub rotation: [f64; 4],
    /// Translation from world to camera, applied after the rotation.
    pub translation: [f64; 3],
    pub camera: u32,
    pub name: String,
}

/// COLMAP's camera models; a model's id is its index here. Supported ones have their list of parameters, in COLMAP's
/// order.
const MODELS: [(&str, Option<&[Parameter]>); 16] = [
    ("SIMPLE_PINHOLE", Some(&[Focal, CenterX, CenterY])),
    ("PINHOLE", Some(&[FocalX, FocalY, CenterX, CenterY])),
    ("SIMPLE_RADIAL", Some(&[Focal, CenterX, CenterY, K(0)])),
    ("RADIAL", Some(&[Focal, CenterX, CenterY, K(0), K(1)])),
    ("OPENCV", Some(&[FocalX, FocalY, CenterX, CenterY, K(0), K(1), P(0), P(1)])),
    ("OPENCV_FISHEYE", Some(&[FocalX, FocalY, CenterX, CenterY, K(0), K(1), K(2), K(3)])),
    (
        "FULL_OPENCV",
        Some(&[FocalX, FocalY, CenterX, CenterY, K(0), K(1), P(0), P(1), K(2), D(0), D(1), D(2)]),
    ),
    ("FOV", None),
    ("SIMPLE_RADIAL_FISHEYE", Some(&[Focal, CenterX, CenterY, K(0)])),
    ("RADIAL_FISHEYE", Some(&[Focal, CenterX, CenterY, K(0), K(1)])),
    ("THIN_PRISM_FISHEYE", None),
    ("RAD_TAN_THIN_PRISM_FISHEYE", None),
    ("SIMPLE_DIVISION", None),
    ("DIVISION", None),
    ("SIMPLE_FISHEYE", Some(&[Focal, CenterX, CenterY])),
    ("FISHEYE", Some(&[FocalX, FocalY, CenterX, CenterY])),
];

/// A parameter of a camera model.
#[derive(Clone, Copy)]
enum Parameter {
    /// Both focal lengths.
    Focal,
    FocalX,
    FocalY,
    CenterX,
    CenterY,
    /// A radial coefficient; k1 is the first.
    K(usize),
    /// A radial coefficient of the denominator; k4 is the first.
    D(usize),
    /// A tangential coefficient; p1 is the first.
    P(usize),
}

/// A camera without its pose.
pub(crate) struct Intrinsics {
    focal: [f64; 2],
    center: [f64; 2],
    size: [u32; 2],
    pub lens: Lens,
}

/// A supported camera model.
#[derive(Clone, Copy)]
pub(super) struct Lenses {
    name: &'static str,
    parameters: &'static [Parameter],
}

impl Lenses {
    /// The model with a name, as in text files.
    pub fn from_name(name: &str) -> Result<Self, String> {
        match MODELS.iter().find(|(known, _)| *known == name) {
            Some(&(name, Some(parameters))) => Ok(Self { name, parameters }),
            _ => Err(refusal(name)),
        }
    }

    /// The model with an id, as in binary files.
    pub fn from_id(id: i32) -> Result<Self, String> {
        match usize::try_from(id).ok().and_then(|id| MODELS.get(id)) {
            Some((name, _)) => Self::from_name(name),
            None => Err(refusal(&format!("number {id}"))),
        }
    }

    /// The camera for an image size and the values of the model's parameters.
    pub fn intrinsics(self, size: [u64; 2], values: &[f64]) -> Result<Intrinsics, String> {
        let side = |side: u64| u32::try_from(side).ok().filter(|side| *side <= MAX_IMAGE_SIDE);
        let [Some(width), Some(height)] = size.map(side) else {
            let [width, height] = size;
            return Err(format!(
                "the camera has {width} x {height} pixels, expected 1 to {MAX_IMAGE_SIDE} each"
            ));
        };
        if values.len() != self.parameters.len() {
            let name = self.name;
            let parameters = self.parameters.len();
            return Err(format!("{name} has {parameters} parameters, not {}", values.len()));
        }
        let mut focal = [0.0; 2];
        let mut center = [0.0; 2];
        let is_fisheye = self.name.contains("FISHEYE");
        let projection = if is_fisheye { Projection::Fisheye } else { Projection::Plane };
        let mut lens = Lens { projection, ..Lens::default() };
        for (parameter, &value) in self.parameters.iter().zip(values) {
            match *parameter {
                Focal => focal = [value; 2],
                FocalX => focal[0] = value,
                FocalY => focal[1] = value,
                CenterX => center[0] = value,
                CenterY => center[1] = value,
                K(term) => lens.radial[term] = value,
                D(term) => lens.denominator[term] = value,
                P(term) => lens.tangential[term] = value,
            }
        }
        if let Some(value) = lens.coefficients().find(|value| !value.is_finite()) {
            return Err(format!("a distortion coefficient is {value}, expected a finite number"));
        }
        Ok(Intrinsics { focal, center, size: [width, height], lens })
    }

    /// Number of parameters, at most 12.
    pub fn parameters(self) -> usize {
        self.parameters.len()
    }
}

fn refusal(name: &str) -> String {
    let known = MODELS.iter().filter(|model| model.1.is_some());
    let known: Vec<_> = known.map(|model| model.0).collect();
    format!(
        "the camera model {name} is not supported; those that are read are {}: undistort the \
         photographs first, with `colmap image_undistorter`",
        known.join(", ")
    )
}

/// The camera of an image. COLMAP maps world to camera and has OpenCV axes. The result maps camera to world and has
/// OpenGL axes.
pub(super) fn camera(image: &Image, intrinsics: &Intrinsics) -> Result<Camera, String> {
    let [w, x, y, z] = image.rotation;
    let rotation = DQuat::from_xyzw(x, y, z, w);
    let length = rotation.length();
    if !(length.is_finite() && length > 1e-6) {
        return Err(format!("the rotation is {:?}, expected a quaternion", image.rotation));
    }
    let to_world = DMat3::from_quat(rotation.normalize()).transpose();
    let eye = -(to_world * DVec3::from_array(image.translation));
    let row = |axis: usize| {
        let [x, y, z] = to_world.row(axis).to_array();
        [x, -y, -z, eye[axis]]
    };
    let Intrinsics { focal, center, size, lens } = intrinsics;
    Ok(Camera {
        camera_to_world: [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]],
        fl_x: focal[0],
        fl_y: focal[1],
        cx: center[0],
        cy: center[1],
        width: size[0],
        height: size[1],
        file_path: Some(image.name.clone()),
        distorted: !lens.is_pinhole(),
    })
}
