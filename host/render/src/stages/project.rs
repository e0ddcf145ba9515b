//! The projection of Gaussians, its derivatives by Gaussians and by camera poses, and the statistics of densification.
//! [`organza_shaders::pose_backward`] has the equations of the poses.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::pose_backward::{BLOCK, PoseBackwardKernel, PoseBackwardParams};
use organza_shaders::project::{ProjectKernel, ProjectParams, WINDOW};
use organza_shaders::project_backward::{ALL_BITS, ProjectBackwardKernel, ProjectBackwardParams};
use organza_shaders::statistics::{StatisticsKernel, StatisticsParams};

use super::cut::words;
use super::pairs::Pairs;
use super::scan::Mask;
use crate::gradient::{BinnedGradient, SceneGradient};
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Device, Result};
use organza_core::camera::Camera;

/// Gaussians, projected into cameras.
#[derive(Debug)]
pub struct Projection {
    /// Packed cameras.
    pub camera: Buffer<f32>,
    /// `[cameras, gaussians, 2]`
    pub values: Buffer<Vec4>,
    /// `[1]`: Gaussians that could not be projected.
    pub degenerate: Buffer<u32>,
}

/// Projects every Gaussian into every camera. Culls Gaussians that end before the camera's window.
pub fn project(
    device: &Device,
    scene: &DeviceScene,
    cameras: &[&Camera],
    windows: &[[f32; WINDOW]],
) -> Result<Projection> {
    let camera = scene.cameras(cameras)?;
    let window = device.upload("windows", windows.as_flattened())?;
    let values = device.unwritten("projection", cameras.len() * scene.len() * 2)?;
    let degenerate = device.zeros("degenerate", 1)?;
    let kernel = ProjectKernel {
        params: ProjectParams { gaussians: scene.gaussians, blur: scene.config.blur as f32 },
        camera: &camera,
        window: &window,
        position: &scene.tensors.gaussians.position,
        rotation: &scene.tensors.gaussians.rotation,
        log_scale: &scene.tensors.gaussians.log_scale,
        projection: &values,
        degenerate: &degenerate,
    };
    device.run_all(&kernel)?;
    Ok(Projection { camera, values, degenerate })
}

/// Backpropagates `pair_gradient [pairs, 3]` for a range of the part's cameras. Adds the gradients of positions, rotations,
/// scales, opacities and shapes to `gradient`, and the pairs to its statistics.
pub fn project_backward(
    scene: &DeviceScene,
    pairs: &Pairs,
    mask: &Mask,
    pair_gradient: &Buffer<Vec4>,
    gradient: &SceneGradient,
    cameras: &Range<u32>,
) -> Result<()> {
    let device = scene.device();
    let tensors = &scene.tensors.gaussians;
    let pair_mask = &mask.bits;
    let first_pair = &mask.first;
    let gaussians = scene.gaussians;
    let words = words(scene.gaussians);
    let first_camera = cameras.start;
    let cameras = cameras.end - cameras.start;
    let blur = scene.config.blur as f32;
    let kernel = ProjectBackwardKernel {
        params: ProjectBackwardParams {
            gaussians,
            words,
            first_camera,
            cameras,
            blur,
            bits: ALL_BITS,
            shaped: scene.config.shape,
        },
        camera: &pairs.camera,
        position: &tensors.position,
        rotation: &tensors.rotation,
        log_scale: &tensors.log_scale,
        pair_mask,
        first_pair,
        pair_gradient,
        gradient: &gradient.geometry,
    };
    device.run_all(&kernel)?;
    let kernel = StatisticsKernel {
        params: StatisticsParams { gaussians, words, first_camera, cameras },
        projection: &pairs.projection,
        pair_mask,
        first_pair,
        pair_gradient,
        statistics: &gradient.statistics,
    };
    device.run_all(&kernel)
}

/// Backpropagates `pair_gradient [pairs, 3]` to the poses of a part's cameras. Adds to `gradient [cameras, 6]`, which has a
/// row for every camera that a batch may show.
pub fn pose_backward(
    scene: &DeviceScene,
    pairs: &Pairs,
    mask: &Mask,
    cameras: &[u32],
    pair_gradient: &Buffer<Vec4>,
    gradient: &BinnedGradient,
) -> Result<()> {
    let tensors = &scene.tensors.gaussians;
    let gaussians = scene.gaussians;
    let blocks = gaussians.div_ceil(BLOCK);
    cameras.iter().zip(0..).try_for_each(|(&place, camera)| {
        let kernel = PoseBackwardKernel {
            params: PoseBackwardParams {
                gaussians,
                words: words(gaussians),
                camera,
                place,
                blocks,
                values: gradient.values.len() as u32,
                blur: scene.config.blur as f32,
            },
            camera: &pairs.camera,
            position: &tensors.position,
            rotation: &tensors.rotation,
            log_scale: &tensors.log_scale,
            first_pair: &mask.first,
            pair: &pairs.pair,
            pair_gradient,
            sum: &gradient.sum,
        };
        scene.device().run_all(&kernel)
    })
}
