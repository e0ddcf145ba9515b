//! A: the color of every pair.

use glam::Vec4;
use organza_kernels::color::{
    ColorHeadKernel, ColorHeadParams, ColorInputsKernel, ColorInputsParams,
};
use organza_kernels::color_backward::{
    ColorHeadBackwardKernel, ColorHeadBackwardParams, MaterialBackwardKernel,
    MaterialBackwardParams,
};

use super::DeviceScene;
use super::bin::{Mask, Pairs};
use super::field::{Rows, Scratch};
use super::field_backward::BackwardScratch;
use super::gradient::SceneGradient;
use super::pair::sum_pairs;
use crate::backend::{Buffer, Device};
use crate::error::Result;

/// `[pairs, 3]`
pub fn evaluate(device: &Device, scene: &DeviceScene, pairs: &Pairs) -> Result<Buffer<f32>> {
    evaluate_with(device, scene, pairs, &mut |_, _, _| Ok(()))
}

/// As [`evaluate`]; shows `visit` the network's input of each chunk: first pair, pairs, and the scratch memory.
pub fn evaluate_with(
    device: &Device,
    scene: &DeviceScene,
    pairs: &Pairs,
    visit: &mut dyn FnMut(u32, u32, &Scratch) -> Result<()>,
) -> Result<Buffer<f32>> {
    let (config, field) = (&scene.config, &scene.color);
    let color = device.zeros("color", pairs.count as usize * 3)?;
    let scratch = Scratch::new(device, field, config.color_inputs(), pairs.count)?;
    let grid_row = config.sh_width() as u32;
    let head = field.head();
    for (first_pair, samples) in scratch.chunks(pairs.count) {
        inputs(device, scene, pairs, first_pair, samples, scratch.rows())?;
        field.encode(device, scratch.rows(), samples, grid_row)?;
        visit(first_pair, samples, &scratch)?;
        let kernel = ColorHeadKernel {
            params: ColorHeadParams {
                samples,
                first_pair,
                stride: scratch.stride,
                inputs: head.inputs,
                weight: head.weight,
                bias: head.bias,
            },
            parameters: &field.parameters,
            input: field.hidden(device, &scratch, samples)?,
            color: &color,
        };
        device.run(&kernel, samples, 1)?;
    }
    Ok(color)
}

/// What does not come from the hash grid, for a chunk of pairs: `point [6, stride]`, `input [rows, stride]`.
fn inputs(
    device: &Device,
    scene: &DeviceScene,
    pairs: &Pairs,
    first_pair: u32,
    samples: u32,
    rows: Rows<'_>,
) -> Result<()> {
    let config = &scene.config;
    let kernel = ColorInputsKernel {
        params: ColorInputsParams {
            pairs: samples,
            first_pair,
            stride: rows.stride,
            gaussians: scene.gaussians,
            sh_degree: config.sh_degree,
            material: config.material,
            material_row: (config.sh_width() + config.color_grid.width()) as u32,
        },
        pair: &pairs.pair,
        camera: &pairs.camera,
        scene_box: &scene.scene_box,
        position: &scene.position,
        material: &scene.material,
        point: rows.point,
        input: rows.input,
    };
    device.run(&kernel, samples, 1)
}

/// Adds the gradients of the color field and of the materials, of `pair_gradient [pairs, 3]` (see
/// [`splat_backward`](organza_kernels::splat)); `color [pairs, 3]` is what [`evaluate`] returned, `mask` says which
/// pairs there are.
pub fn backward(
    device: &Device,
    scene: &DeviceScene,
    pairs: &Pairs,
    mask: &Mask,
    color: &Buffer<f32>,
    pair_gradient: &Buffer<Vec4>,
    gradient: &SceneGradient,
) -> Result<()> {
    if pairs.count == 0 {
        return Ok(());
    }
    let (config, field) = (&scene.config, &scene.color);
    let (grid_row, material) = (config.sh_width() as u32, config.material);
    let material_row = grid_row + config.color_grid.width() as u32;
    let scratch = BackwardScratch::new(device, field, pairs.count)?;
    let stride = scratch.stride;
    let pair_material =
        device.zeros("gradient of the pairs' material", (pairs.count * material) as usize)?;
    let table = &gradient.color.table;
    table.set_scale(device, field, pair_gradient, None, pairs.count, pairs.count)?;
    for (first_pair, samples) in scratch.chunks(pairs.count) {
        inputs(device, scene, pairs, first_pair, samples, scratch.rows())?;
        field.activate(device, &scratch, samples, grid_row)?;
        let head = ColorHeadBackwardKernel {
            params: ColorHeadBackwardParams { samples, first_pair, stride },
            color,
            pair_gradient,
            logit_gradient: &scratch.logit_gradient,
        };
        device.run(&head, samples, 1)?;
        field.backward(device, &scratch, samples, grid_row, &gradient.color)?;
        if material > 0 {
            let params =
                MaterialBackwardParams { samples, first_pair, stride, material, material_row };
            let kernel = MaterialBackwardKernel {
                params,
                input_gradient: &scratch.input_gradient,
                pair_material: &pair_material,
            };
            device.run(&kernel, samples, 1)?;
        }
    }
    table.finish(device)?;
    sum_pairs(device, scene, mask, material, &pair_material, &gradient.material)
}
