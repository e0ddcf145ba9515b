//! The color's head of Eq. 3 and the material of Eq. 1.

use glam::Vec4;
use organza::parity::inputs::Random;
use organza_shaders::color_backward::{
    ColorHeadBackwardKernel, ColorHeadBackwardParams, MaterialBackwardKernel,
    MaterialBackwardParams,
};

use super::numeric::{central, everywhere, hold};

fn sigmoid(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

/// `L = sum g sigmoid(c~)`, of a chunk behind three other pairs.
#[test]
fn logits_of_a_color() {
    let (samples, stride, first_pair) = (70, 75, 3);
    let mut random = Random::new(1);
    let mut logits: Vec<f64> =
        random.values(3 * samples, -8.0, 8.0).into_iter().map(f64::from).collect();
    (logits[0], logits[1], logits[2]) = (0.0, 40.0, -40.0);
    let mut color = vec![0.5; 9];
    color.extend(logits.iter().map(|&x| sigmoid(x) as f32));
    let numbers = random.values(12 * (samples + first_pair), -1.0, 1.0);
    let gradient: Vec<_> = numbers.chunks(4).map(Vec4::from_slice).collect();
    let of = |at: usize| f64::from(gradient[3 * (first_pair + at / 3) + 2][at % 3]);
    let loss = |x: &[f64]| x.iter().enumerate().map(|(at, &x)| of(at) * sigmoid(x)).sum();
    let expected = central(&logits, 1e-5, loss);
    for (name, device) in everywhere() {
        let found = device.zeros::<f32>("logit gradient", 4 * stride).unwrap();
        let kernel = ColorHeadBackwardKernel {
            params: ColorHeadBackwardParams {
                samples: samples as u32,
                first_pair: first_pair as u32,
                stride: stride as u32,
            },
            color: &device.upload("color", &color).unwrap(),
            pair_gradient: &device.upload("gradient", &gradient).unwrap(),
            logit_gradient: &found,
        };
        device.run(&kernel, samples as u32, 1).unwrap();
        let rows = device.read(&found).unwrap();
        let found: Vec<_> = (0..3 * samples).map(|at| rows[at % 3 * stride + at / 3]).collect();
        hold(name, &found, &expected);
        assert!(rows[3 * stride..].iter().all(|&x| x == 0.0), "a row that is no output");
    }
}

/// `L = sum g sin(m)`: each pair has its own copy of the material.
#[test]
fn materials_of_pairs() {
    let (samples, stride, material) = (70, 71, 5);
    let mut random = Random::new(2);
    let values: Vec<f64> =
        random.values(material * samples, -1.0, 1.0).into_iter().map(f64::from).collect();
    let weight = random.values(material * samples, -1.0, 1.0);
    let loss = |x: &[f64]| x.iter().zip(&weight).map(|(&x, &g)| f64::from(g) * x.sin()).sum();
    let expected = central(&values, 1e-5, loss);
    // rows of the network's input, the materials behind two others
    let mut gradient = vec![f32::NAN; (2 + material) * stride];
    for (at, (&x, &g)) in values.iter().zip(&weight).enumerate() {
        let (sample, m) = (at / material, at % material);
        gradient[(2 + m) * stride + sample] = (f64::from(g) * x.cos()) as f32;
    }
    for (name, device) in everywhere() {
        let found = device.zeros::<f32>("pair material", material * (samples + 1)).unwrap();
        let kernel = MaterialBackwardKernel {
            params: MaterialBackwardParams {
                samples: samples as u32,
                first_pair: 1,
                stride: stride as u32,
                material: material as u32,
                material_row: 2,
            },
            input_gradient: &device.upload("gradient", &gradient).unwrap(),
            pair_material: &found,
        };
        device.run(&kernel, samples as u32, 1).unwrap();
        hold(name, &device.read(&found).unwrap()[material..], &expected);
    }
}
