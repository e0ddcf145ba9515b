//! The unit of the hash grids' gradient: the bound that it follows from, and the extremes of its range.

use glam::Vec4;
use organza::Device;
use organza::scene::Interpolation;
use organza_shaders::hash_grid_scale::{
    HashGridNormKernel, HashGridNormParams, HashGridPeakKernel, HashGridPeakParams,
    HashGridScaleKernel, HashGridScaleParams, LIMIT, SCALE, STATUS_NOT_FINITE,
};

use super::hash_grid::{Inputs, all, grid};

/// `scale` and the status for gradients of pairs and layers `[inputs, 4 columns]`; run twice, as the bounds are cleared.
fn scale_of(
    device: &Device,
    pairs: &[Vec4],
    transmittance: Option<&[f32]>,
    layers: &[(u32, Vec<Vec4>)],
    samples: u32,
) -> (Vec<f32>, u32) {
    let bound = device.zeros("bound", 1 + layers.len()).unwrap();
    let scale = device.zeros("scale", 3).unwrap();
    let status = device.zeros("status", 1).unwrap();
    let count = pairs.len() as u32 / 3;
    for _ in 0..2 {
        let kernel = HashGridPeakKernel {
            params: HashGridPeakParams { pairs: count, color: u32::from(transmittance.is_none()) },
            pair_gradient: &device.upload("pairs", pairs).unwrap(),
            transmittance: &device.upload("t", transmittance.unwrap_or(&[0.0])).unwrap(),
            bound: &bound,
        };
        device.run(&kernel, count, 1).unwrap();
        for ((inputs, weights), slot) in layers.iter().zip(1..) {
            let columns = weights.len() as u32 / inputs;
            let kernel = HashGridNormKernel {
                params: HashGridNormParams { inputs: *inputs, columns, weight: 0, slot },
                parameters: &device.upload("weights", weights).unwrap(),
                bound: &bound,
            };
            device.run(&kernel, *inputs, 1).unwrap();
        }
        let kernel = HashGridScaleKernel {
            params: HashGridScaleParams { layers: layers.len() as u32, samples },
            bound: &bound,
            scale: &scale,
            status: &status,
        };
        device.run(&kernel, 1, 1).unwrap();
    }
    (device.read(&scale).unwrap(), device.read(&status).unwrap()[0])
}

/// Pairs of which the second has the largest gradients.
fn pairs(color: f32, transmittance: f32) -> Vec<Vec4> {
    let pair = |share: f32| {
        let geometry = Vec4::new(1e30, 1e30, 1e30, -share * transmittance);
        [geometry, Vec4::splat(1e30), Vec4::new(0.0, -share * color, share * color, 0.0)]
    };
    [0.3, 1.0, 0.0].into_iter().flat_map(pair).collect()
}

/// Layers whose norms are 7 `size` and 2 / `size`.
fn layers(size: f32) -> Vec<(u32, Vec<Vec4>)> {
    let first = [1.0, -2.0, 4.0, 0.0, 1.0, 1.0, 1.0, 1.0].map(|weight| weight * size);
    let first = first.chunks(4).map(Vec4::from_slice).collect();
    let second = [0.5, 1.0, -2.0].map(|weight| Vec4::X * weight / size).to_vec();
    vec![(2, first), (3, second)]
}

#[test]
fn the_scale_is_the_largest_that_is_safe() {
    for (name, device) in all() {
        for (color, size, bits) in [
            (8.0, 1.0, 0),
            (8.0, 1.0, 32),
            (1e-30, 1.0, 20),
            (1e30, 1.0, 20),
            // partial products that no f32 holds
            (1e-30, 1e-20, 10),
            (1e30, 1e20, 10),
            (0.0, 1.0, 10),
        ] {
            let layers = layers(size);
            // the most that these bits hold, and with one more than half of them as well
            let (most, half) =
                (((1_u64 << bits) - u64::from(bits == 32)) as u32, (1_u64 << bits) / 2);
            let (scale, status) = scale_of(&device, &pairs(color, 1e20), None, &layers, most);
            let samples = if bits > 1 { half as u32 + 1 } else { most };
            let (other, _) =
                scale_of(&device, &pairs(1e20, color), Some(&[0.5, 0.25, 0.5]), &layers, samples);
            // 0.25 color and 0.25 dL/dT
            assert_eq!(scale, other, "{name}: {color:e}");
            assert_eq!(status, 0, "{name}: {color:e}");
            let bound = f64::from(color) * 0.25 * 14.0;
            let (unit, limit) =
                (f64::from(scale[SCALE as usize]), f64::from(scale[LIMIT as usize]));
            assert_eq!(unit.log2().fract(), 0.0);
            assert_eq!(unit * f64::from(scale[1]), 1.0);
            assert!(limit >= 1.005 * bound, "{name}: {limit:e} for {bound:e}");
            let most = unit * limit * 2_f64.powi(bits);
            assert!(most <= 2_f64.powi(62), "{name}: {color:e}, {bits}: {most:e}");
            let expected = unit >= 2_f64.powi(126) || most >= 2_f64.powi(61);
            assert!(expected || bound == 0.0, "{name}: {color:e}, {bits}: {most:e}");
        }
    }
}

#[test]
fn a_bound_that_is_no_number_is_told() {
    for (name, device) in all() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let mut broken = layers(1.0);
            broken[0].1[1].y = bad;
            for (pairs, layers) in [(pairs(bad, 0.0), layers(1.0)), (pairs(1.0, 0.0), broken)] {
                let (scale, status) = scale_of(&device, &pairs, None, &layers, 16);
                assert_eq!(status, STATUS_NOT_FINITE, "{name}: {bad}");
                assert_eq!(scale[LIMIT as usize], 0.0, "{name}: {bad}");
                assert!(scale.iter().all(|value| value.is_finite()), "{name}: {bad}");
            }
        }
    }
}

/// As many samples as the scale is for, all as large as the limit, in one entry with all their weight.
#[test]
fn the_largest_sums_do_not_overflow() {
    const BITS: u32 = 12;
    for (name, device) in all() {
        for color in [1e-33, 3.7, 3e35] {
            let (scale, _) = scale_of(&device, &pairs(color, 0.0), None, &layers(1.0), 1 << BITS);
            let mut config = grid(1, Interpolation::Linear);
            config.levels = 1;
            let mut inputs = Inputs::random(config, 1 << BITS);
            // scale 3: a grid point
            inputs.points.fill([0.5, 0.5, 0.5]);
            inputs.limit = scale[LIMIT as usize];
            inputs.exponent = scale[SCALE as usize].log2() as i32;
            for sign in [1.0, -1.0] {
                inputs.gradient.fill(sign * inputs.limit);
                let found = inputs.run(&device);
                let one = f64::from(inputs.limit) * f64::from(scale[SCALE as usize]) * sign as f64;
                let total = i128::from(one.round() as i64) << BITS;
                let sums: Vec<_> = found.sum.iter().filter(|sum| **sum != 0).collect();
                assert_eq!(sums.len(), 1, "{name}");
                assert_eq!(i128::from(*sums[0]), total, "{name}: {color:e}");
                assert_eq!(found.status, 0);
            }
        }
    }
}
