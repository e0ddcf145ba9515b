//! Stage A: the color of every pair.

use glam::Vec4;
use organza_shaders::color::{ColorHeadKernel, ColorInputsKernel, ColorInputsParams};
use organza_shaders::color_backward::{
    ColorHeadBackwardKernel, ColorHeadBackwardParams, MaterialBackwardKernel,
    MaterialBackwardParams,
};

use super::field::Inputs;
use super::field::backward::FieldBackward;
use super::field::samples::{Blocks, Chunks};
use super::pairs::{PairVectors, Pairs};
use super::tiles::TileBins;
use crate::gradient::SceneGradient;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Result};

/// Color of every pair.
#[derive(Debug)]
pub struct Color {
    /// `[pairs, 3]`
    pub color: Buffer<f32>,
    /// Positions, and the network's input.
    pub blocks: Blocks,
}

impl Color {
    /// With `keep`, the inputs of [`Color::backward`] stay in memory, as far as they fit.
    pub fn evaluate(scene: &DeviceScene, pairs: &Pairs, keep: bool) -> Result<Self> {
        let device = scene.device();
        let config = &scene.config;
        let field = &scene.color;
        let color = device.unwritten("color", pairs.count.upper_bound() as usize * 3)?;
        let ends = pairs.chunk_ends(keep);
        let blocks = Blocks::new(device, config.color_inputs(), pairs.count.clone(), keep, ends)?;
        let others = &|chunk: &Chunks<'_>| inputs(scene, pairs, chunk);
        let grid_row = config.sh_width() as u32;
        field.forward(device, Inputs { blocks: &blocks, grid_row, others }, |input, chunk| {
            let params = field.head_params(chunk);
            let kernel =
                ColorHeadKernel { params, parameters: &field.parameters, input, color: &color };
            device.run_all(&kernel.counted(&chunk.count()))
        })?;
        Ok(Self { color, blocks })
    }

    /// Backpropagates `pair_gradient [pairs, 3]` (see [`splat_backward`](organza_shaders::splat)). Adds to the gradient sums of
    /// the color field. Returns the gradient of each pair's material; `None` without pairs.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        bins: &TileBins,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<Option<PairVectors>> {
        let device = scene.device();
        let pairs = &bins.pairs;
        let capacity = pairs.count.upper_bound();
        if capacity == 0 {
            return Ok(None);
        }
        let config = &scene.config;
        let material = config.material;
        let pair_material =
            device.unwritten("gradient of the pairs' material", (capacity * material) as usize)?;
        let grid_row = config.sh_width() as u32;
        let others = &|chunk: &Chunks<'_>| inputs(scene, pairs, chunk);
        let backward = FieldBackward {
            scene,
            bins,
            field: &scene.color,
            inputs: Inputs { blocks: &self.blocks, grid_row, others },
            is_encoded: true,
            first_sample: None,
            gradient: &gradient.color,
        };
        backward.run(
            |scratch, chunk| {
                let params = ColorHeadBackwardParams {
                    samples: chunk.samples(),
                    first_pair: chunk.first(),
                    stride: chunk.stride(),
                };
                let logit_gradient = &scratch.logit_gradient;
                let color = &self.color;
                let kernel =
                    ColorHeadBackwardKernel { params, color, pair_gradient, logit_gradient };
                device.run_all(&kernel.counted(&chunk.count()))
            },
            |input_gradient, chunk| {
                if material == 0 {
                    return Ok(());
                }
                let params = MaterialBackwardParams {
                    samples: chunk.samples(),
                    first_pair: chunk.first(),
                    stride: chunk.stride(),
                    material,
                    material_row: grid_row + config.color_grid.width() as u32,
                };
                let pair_material = &pair_material;
                let kernel = MaterialBackwardKernel { params, input_gradient, pair_material };
                device.run_all(&kernel.counted(&chunk.count()))
            },
        )?;
        Ok(Some(PairVectors { values: pair_material, width: material }))
    }
}

/// The inputs that do not come from the hash grid, for a chunk of pairs: `point [6, stride]`, `input [rows, stride]`.
fn inputs(scene: &DeviceScene, pairs: &Pairs, chunk: &Chunks<'_>) -> Result<()> {
    let config = &scene.config;
    let kernel = ColorInputsKernel {
        params: ColorInputsParams {
            pairs: chunk.samples(),
            first_pair: chunk.first(),
            stride: chunk.stride(),
            gaussians: scene.gaussians,
            sh_degree: config.sh_degree,
            material: config.material,
            material_row: (config.sh_width() + config.color_grid.width()) as u32,
            contracted: config.contraction.for_kernels(),
        },
        pair: &pairs.pair,
        camera: &pairs.camera,
        scene_box: &scene.scene_box,
        position: &scene.tensors.gaussians.position,
        material: &scene.tensors.gaussians.material,
        point: &chunk.point(),
        input: &chunk.input(),
    };
    scene.device().run_all(&kernel.counted(&chunk.count()))
}
