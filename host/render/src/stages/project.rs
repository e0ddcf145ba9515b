//! The projection of Gaussians, its derivatives by them and by the cameras' poses, and the statistics of growth.
//! [`organza_shaders::pose_backward`] has the equations of the poses.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::pose_backward::{BLOCK, PoseBackwardKernel, PoseBackwardParams, VALUES};
use organza_shaders::project::{ProjectKernel, ProjectParams, WINDOW};
use organza_shaders::project_backward::{ALL_BITS, ProjectBackwardKernel, ProjectBackwardParams};
use organza_shaders::statistics::{StatisticsKernel, StatisticsParams};

use super::cut::words;
use super::gradient::{BinnedGradient, SceneGradient};
use super::tiles::Bins;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Device, Result};
use organza_core::camera::Camera;

/// Projects every Gaussian into every camera, and leaves out those that certainly end before the camera's window: packed
/// cameras, projections, and the count of degenerate ones.
pub fn project(
    device: &Device,
    scene: &DeviceScene,
    cameras: &[&Camera],
    windows: &[[f32; WINDOW]],
) -> Result<(Buffer<f32>, Buffer<Vec4>, Buffer<u32>)> {
    let packed: Vec<_> = cameras.iter().flat_map(|camera| camera.for_kernels().pack()).collect();
    let camera = device.upload("cameras", &packed)?;
    let window = device.upload("windows", windows.as_flattened())?;
    let projection = device.unwritten("projection", cameras.len() * scene.len() * 2)?;
    let degenerate = device.zeros("degenerate", 1)?;
    let kernel = ProjectKernel {
        params: ProjectParams { gaussians: scene.gaussians, blur: scene.config.blur as f32 },
        camera: &camera,
        window: &window,
        position: &scene.tensors.gaussians.position,
        rotation: &scene.tensors.gaussians.rotation,
        log_scale: &scene.tensors.gaussians.log_scale,
        projection: &projection,
        degenerate: &degenerate,
    };
    device.run(&kernel, scene.gaussians, cameras.len() as u32)?;
    Ok((camera, projection, degenerate))
}

/// Adds the gradients of positions, rotations, scales and opacities, from `pair_gradient [pairs, 3]`, to `gradient`, and the
/// pairs to its statistics: those of some of the part's cameras.
pub fn project_backward(
    scene: &DeviceScene,
    bins: &Bins,
    pair_gradient: &Buffer<Vec4>,
    gradient: &SceneGradient,
    cameras: &Range<u32>,
) -> Result<()> {
    let device = scene.device();
    let pairs = &bins.pairs;
    let tensors = &scene.tensors.gaussians;
    let pair_mask = &bins.pair_mask.bits;
    let first_pair = &bins.pair_mask.first;
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
    device.run(&kernel, gaussians, 1)?;
    let kernel = StatisticsKernel {
        params: StatisticsParams { gaussians, words, first_camera, cameras },
        projection: &pairs.projection,
        pair_mask,
        first_pair,
        pair_gradient,
        statistics: &gradient.statistics,
    };
    device.run(&kernel, gaussians, 1)
}

/// Numbers of a pose: a rotation vector and a shift. [`Camera::moved`](organza_core::Camera::moved) says what they mean.
pub const POSE: usize = VALUES as usize;

/// Adds the gradients of the poses of a part's cameras, from `pair_gradient [pairs, 3]`, to `gradient [cameras, 6]`, of all
/// cameras that a batch may show.
pub fn pose_backward(
    scene: &DeviceScene,
    bins: &Bins,
    pair_gradient: &Buffer<Vec4>,
    gradient: &BinnedGradient,
) -> Result<()> {
    let pairs = &bins.pairs;
    let tensors = &scene.tensors.gaussians;
    let gaussians = scene.gaussians;
    let blocks = gaussians.div_ceil(BLOCK);
    bins.cameras.iter().zip(0..).try_for_each(|(&place, camera)| {
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
            first_pair: &bins.pair_mask.first,
            pair: &pairs.pair,
            pair_gradient,
            sum: &gradient.sum,
        };
        scene.device().run(&kernel, blocks, 1)
    })
}
