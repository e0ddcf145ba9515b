//! A: the color of every pair.

use std::sync::Mutex;

use glam::Vec4;
use organza_shaders::color::{ColorHeadKernel, ColorInputsKernel, ColorInputsParams};
use organza_shaders::color_backward::{
    ColorHeadBackwardKernel, ColorHeadBackwardParams, MaterialBackwardKernel,
    MaterialBackwardParams,
};

use super::field::Scratch;
use super::field::backward::{CameraSamples, ChunkScratch, GroupScratch};
use super::field::samples::{BlockOf, Blocks, Chunk};
use super::pairs::{PairVectors, Pairs};
use super::tiles::Bins;
use crate::gradient::SceneGradient;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Device, Result};

/// Color of every pair.
#[derive(Debug)]
pub struct Color {
    /// `[pairs, 3]`
    pub color: Buffer<f32>,
    /// Positions, and the network's input.
    blocks: Blocks,
}

impl Color {
    /// `keep` says whether [`Color::backward`] will be called: its inputs are kept then, as far as they fit.
    pub fn evaluate(scene: &DeviceScene, pairs: &Pairs, keep: bool) -> Result<Self> {
        Self::evaluate_with(scene, pairs, keep, &mut |_| Ok(()))
    }

    /// Like [`Color::evaluate`]; shows `visit` each chunk with the network's input.
    pub fn evaluate_with(
        scene: &DeviceScene,
        pairs: &Pairs,
        keep: bool,
        visit: &mut dyn FnMut(&Chunk) -> Result<()>,
    ) -> Result<Self> {
        let device = scene.device();
        let config = &scene.config;
        let field = &scene.color;
        let color = device.unwritten("color", pairs.count.upper_bound() as usize * 3)?;
        let ends = pairs.chunk_ends(keep);
        let blocks = Blocks::new(device, config.color_inputs(), pairs.count.clone(), keep, ends)?;
        let scratches = Mutex::default();
        for block in blocks.iter() {
            encode(scene, pairs, &block)?;
            block.chunks().try_for_each(|chunk| visit(&chunk))?;
            let new = || Scratch::new(device, field, blocks.layout());
            device.parallel_for_with(block.chunks(), &scratches, new, |scratch, chunk| {
                let kernel = ColorHeadKernel {
                    params: field.head_params(&chunk),
                    parameters: &field.parameters,
                    input: field.hidden(device, scratch, &chunk)?,
                    color: &color,
                };
                device.run(&kernel.counted(&chunk.count), chunk.samples, 1)
            })?;
        }
        Ok(Self { color, blocks })
    }
}

/// The network's input, for a block of pairs.
fn encode(scene: &DeviceScene, pairs: &Pairs, block: &BlockOf<'_>) -> Result<()> {
    scene.device().parallel_for(block.chunks(), |chunk| inputs(scene, pairs, &chunk))?;
    scene.color.encode(scene.device(), block, scene.config.sh_width() as u32)
}

/// The inputs that do not come from the hash grid, for a chunk of pairs: `point [6, stride]`, `input [rows, stride]`.
fn inputs(scene: &DeviceScene, pairs: &Pairs, chunk: &Chunk) -> Result<()> {
    let config = &scene.config;
    let kernel = ColorInputsKernel {
        params: ColorInputsParams {
            pairs: chunk.samples,
            first_pair: chunk.first,
            stride: chunk.stride,
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
        point: &chunk.point,
        input: &chunk.input,
    };
    scene.device().run(&kernel.counted(&chunk.count), chunk.samples, 1)
}

impl Color {
    /// Adds the gradients of the color field to their sums, of `pair_gradient [pairs, 3]` (see
    /// [`splat_backward`](organza_shaders::splat)); returns those of the pairs' materials, unless there are no pairs.
    pub fn backward(
        &self,
        scene: &DeviceScene,
        bins: &Bins,
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
        let field = &scene.color;
        let grid_row = config.sh_width() as u32;
        let material = config.material;
        let layout = self.blocks.layout();
        let samples = CameraSamples::new(scene, bins, None);
        let group_scratch = GroupScratch::new(device, field, &self.blocks, samples)?;
        let of_field = &gradient.color;
        let scratches = Mutex::default();
        let pair_material =
            device.unwritten("gradient of the pairs' material", (capacity * material) as usize)?;
        for block in self.blocks.iter() {
            if !block.is_kept {
                encode(scene, pairs, &block)?;
            }
            for group in block.groups() {
                let new = || ChunkScratch::new(device, field, layout);
                device.parallel_for_with(group.chunks(), &scratches, new, |scratch, chunk| {
                    field.activate(device, scratch, &chunk)?;
                    self.head_backward(device, scratch, &chunk, pair_gradient)?;
                    field.backward(device, &group_scratch, scratch, &chunk, grid_row, of_field)?;
                    let inputs = group_scratch.input_gradient(field, &chunk);
                    material_backward(scene, &inputs, &chunk, &pair_material)
                })?;
                field.grid_backward(device, &group_scratch, &group, grid_row, of_field)?;
            }
        }
        Ok(Some(PairVectors { values: pair_material, width: material }))
    }

    /// The gradient of the network's outputs for a chunk of pairs.
    fn head_backward(
        &self,
        device: &Device,
        scratch: &ChunkScratch,
        chunk: &Chunk,
        pair_gradient: &Buffer<Vec4>,
    ) -> Result<()> {
        let kernel = ColorHeadBackwardKernel {
            params: ColorHeadBackwardParams {
                samples: chunk.samples,
                first_pair: chunk.first,
                stride: chunk.stride,
            },
            color: &self.color,
            pair_gradient,
            logit_gradient: &scratch.logit_gradient,
        };
        device.run(&kernel.counted(&chunk.count), chunk.samples, 1)
    }
}

/// The gradients of the pairs' materials, for a chunk of pairs.
fn material_backward(
    scene: &DeviceScene,
    input_gradient: &Buffer<f32>,
    chunk: &Chunk,
    pair_material: &Buffer<f32>,
) -> Result<()> {
    let config = &scene.config;
    if config.material == 0 {
        return Ok(());
    }
    let kernel = MaterialBackwardKernel {
        params: MaterialBackwardParams {
            samples: chunk.samples,
            first_pair: chunk.first,
            stride: chunk.stride,
            material: config.material,
            material_row: (config.sh_width() + config.color_grid.width()) as u32,
        },
        input_gradient,
        pair_material,
    };
    scene.device().run(&kernel.counted(&chunk.count), chunk.samples, 1)
}
