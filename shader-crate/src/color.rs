//! A. Color: the input of the color network (Eq. 1) and its head (Eq. 3).

use glam::Vec4;

use crate::camera::{Camera, read3};
use crate::dense::{HeadParams, column};
use crate::hash_grid::write_point;
use crate::limits::{MAX_HIDDEN_WIDTH, MAX_VECTOR};
use crate::spherical_harmonics::{ITERATIONS as SH_ITERATIONS, spherical_harmonics};
use crate::unit_cube::{SceneBox, contract, from_center};
use muslin::math::{normalize, sigmoid};
use muslin::prelude::*;

/// Parameters of [`color_inputs`].
#[params]
pub struct ColorInputsParams {
    /// Pairs of the chunk.
    pub pairs: u32,
    /// First pair of the chunk.
    pub first_pair: u32,
    /// Distance of two rows in `point` and `input`.
    pub stride: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Degree of the harmonics.
    pub sh_degree: u32,
    /// Values of a Gaussian's material.
    pub material: u32,
    /// Row of the material in `input`.
    pub material_row: u32,
    /// 1 where what lies outside the scene's box is contracted.
    pub contracted: u32,
}

/// Writes what does not come from the hash grid: the point to encode, the harmonics of the view direction and
/// the material (Eq. 1). `point [7, stride]`, `input [rows, stride]`.
#[kernel(threads(64), over(params.pairs), iterations = SH_ITERATIONS + MAX_VECTOR, counts(pairs))]
pub fn color_inputs(
    id: Invocation,
    params: &ColorInputsParams,
    pair: Read<u32>,
    camera: Read<f32>,
    scene_box: Read<f32>,
    position: Read<f32>,
    material: Read<f32>,
    point: Write<f32>,
    input: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(params.first_pair + index);
        let gaussian = slot % params.gaussians;
        let eye = Camera::read(camera, slot / params.gaussians).eye;
        let center = read3(position, gaussian * 3);
        let stride = params.stride;

        let place = SceneBox::read(scene_box).split(center.to_array());
        if params.contracted != 0 {
            write_point(point, stride, index, contract(from_center(place)));
        } else {
            write_point(point, stride, index, place);
        }

        // v points from the camera to the Gaussian
        spherical_harmonics(normalize(center - eye), params.sh_degree, input, index, stride);

        let mut m = 0;
        while m < params.material {
            let value = material.read(gaussian * params.material + m);
            input.write((params.material_row + m) * stride + index, value);
            m += 1;
        }
    }
}

/// The last layer of the color network and its sigmoid (Eq. 3): `color [pairs, 3]`.
#[kernel(threads(64), over(params.samples), iterations = MAX_HIDDEN_WIDTH, fused, counts(samples))]
pub fn color_head(
    id: Invocation,
    params: &HeadParams,
    parameters: Read<Vec4>,
    input: Read<f32>,
    color: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let logits = column::<f32>(&params.layer(), parameters, input, sample);
        let first = (params.first + sample) * 3;
        color.write(first, sigmoid(logits.x));
        color.write(first + 1, sigmoid(logits.y));
        color.write(first + 2, sigmoid(logits.z));
    }
}
