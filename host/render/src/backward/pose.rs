//! The gradient of the cameras' poses, for the pairs of a part. [`organza_shaders::pose_backward`] has the equations.

use glam::Vec4;
use organza_shaders::pose_backward::{BLOCK, PoseBackwardKernel, PoseBackwardParams, VALUES};

use super::binned::BinnedGradient;
use crate::batch::plan::words;
use crate::forward::bin::Bins;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Result};

/// Numbers of a pose: a rotation vector and a shift. [`Camera::moved`](organza_core::Camera::moved) says what they mean.
pub const POSE: usize = VALUES as usize;

/// Adds what `pair_gradient [pairs, 3]` makes of the poses of a part's cameras to the sums of `gradient [cameras, 6]`, of all
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
