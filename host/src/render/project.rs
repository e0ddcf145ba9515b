//! The projection's derivative and the statistics of growth, for the pairs of a part.

use glam::Vec4;
use organza_shaders::camera::Camera;
use organza_shaders::project_backward::{ProjectBackwardKernel, ProjectBackwardParams};
use organza_shaders::statistics::{StatisticsKernel, StatisticsParams};

use super::bin::Bins;
use super::gradient::SceneGradient;
use super::plan::words;
use super::scene::DeviceScene;
use organza_device::{Buffer, Device, Result};

/// Adds what `pair_gradient [pairs, 3]` makes of positions, rotations, scales and opacities to `gradient`.
pub fn project_backward(
    device: &Device,
    scene: &DeviceScene,
    bins: &Bins,
    pair_gradient: &Buffer<Vec4>,
    gradient: &SceneGradient,
) -> Result<()> {
    let pairs = &bins.pairs;
    let params = ProjectBackwardParams {
        gaussians: scene.gaussians,
        words: words(scene.gaussians),
        cameras: (pairs.camera.len() / Camera::FLOATS) as u32,
        blur: scene.config.blur as f32,
    };
    let kernel = ProjectBackwardKernel {
        params,
        camera: &pairs.camera,
        position: &scene.tensors.gaussians.position,
        rotation: &scene.tensors.gaussians.rotation,
        log_scale: &scene.tensors.gaussians.log_scale,
        pair_mask: &bins.pair_mask.bits,
        first_pair: &bins.pair_mask.first,
        pair_gradient,
        gradient: &gradient.geometry,
    };
    device.run(&kernel, scene.gaussians, 1)
}

/// Adds the pairs of the part's cameras to the statistics of `gradient`.
pub fn add_statistics(
    device: &Device,
    scene: &DeviceScene,
    bins: &Bins,
    pair_gradient: &Buffer<Vec4>,
    gradient: &SceneGradient,
) -> Result<()> {
    let pairs = &bins.pairs;
    let params = StatisticsParams {
        gaussians: scene.gaussians,
        words: words(scene.gaussians),
        cameras: (pairs.camera.len() / Camera::FLOATS) as u32,
    };
    let kernel = StatisticsKernel {
        params,
        projection: &pairs.projection,
        pair_mask: &bins.pair_mask.bits,
        first_pair: &bins.pair_mask.first,
        pair_gradient,
        statistics: &gradient.statistics,
    };
    device.run(&kernel, scene.gaussians, 1)
}
