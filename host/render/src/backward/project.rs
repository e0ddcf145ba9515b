//! The projection's derivative and the statistics of growth, for the pairs of a part.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::project_backward::{ALL_BITS, ProjectBackwardKernel, ProjectBackwardParams};
use organza_shaders::statistics::{StatisticsKernel, StatisticsParams};

use super::gradient::SceneGradient;
use crate::batch::plan::words;
use crate::forward::bin::Bins;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Result};

/// Adds what `pair_gradient [pairs, 3]` makes of positions, rotations, scales and opacities to `gradient`, and the pairs to
/// its statistics: those of some of the part's cameras.
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
