//! A: the color of every pair.

use organza_kernels::color::{
    ColorHeadKernel, ColorHeadParams, ColorInputsKernel, ColorInputsParams,
};

use super::DeviceScene;
use super::bin::Pairs;
use super::field::Scratch;
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
        let inputs = ColorInputsKernel {
            params: ColorInputsParams {
                pairs: samples,
                first_pair,
                stride: scratch.stride,
                gaussians: scene.gaussians,
                sh_degree: config.sh_degree,
                material: config.material,
                material_row: grid_row + config.color_grid.width() as u32,
            },
            pair: &pairs.pair,
            camera: &pairs.camera,
            scene_box: &scene.scene_box,
            position: &scene.position,
            material: &scene.material,
            point: &scratch.point,
            input: &scratch.input,
        };
        device.run(&inputs, samples, 1)?;
        field.encode(device, &scratch, samples, grid_row)?;
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
