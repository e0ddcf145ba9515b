//! Eq. 13 and 16: pixels, of their sums.

use organza::Device;
use organza::parity::inputs::Random;
use organza_shaders::resolve::{DIVIDE_ABOVE, ResolveBackwardKernel, ResolveParams};
use organza_shaders::tile::Tile;

use super::numeric::{central, everywhere, hold};

const BACKGROUND: [f32; 3] = [0.2, 0.9, 0.0];

/// Places in the batch of the tiles, which are not in its order.
const OUTPUTS: [usize; 3] = [1, 2, 0];

fn run(device: &Device, side: usize, sum: &[f32], image_gradient: &[f32]) -> Vec<f32> {
    let tile = |output: usize| Tile { camera: 0, origin: [7, -3], output: output as u32 };
    let tiles: Vec<_> = OUTPUTS.iter().flat_map(|&output| tile(output).pack()).collect();
    let sum_gradient = device.zeros("gradient", sum.len()).unwrap();
    let [background_r, background_g, background_b] = BACKGROUND;
    let side = side as u32;
    let kernel = ResolveBackwardKernel {
        params: ResolveParams {
            side,
            background_r,
            background_g,
            background_b,
            divide_above: DIVIDE_ABOVE,
        },
        tile: &device.upload("tiles", &tiles).unwrap(),
        sum: &device.upload("sums", sum).unwrap(),
        image_gradient: &device.upload("image gradient", image_gradient).unwrap(),
        sum_gradient: &sum_gradient,
    };
    device.run_over(&kernel, [side, side, OUTPUTS.len() as u32]).unwrap();
    device.read(&sum_gradient).unwrap()
}

/// Eq. 13, and the sum of all values times `gradient`.
fn loss(side: usize, sum: &[f64], gradient: &[f32]) -> f64 {
    let area = side * side;
    let mut loss = 0.0;
    for (tile, output) in OUTPUTS.into_iter().enumerate() {
        for at in 0..area {
            let weight = sum[(4 * tile + 3) * area + at];
            for channel in 0..3 {
                let color = sum[(4 * tile + channel) * area + at];
                let background = f64::from(BACKGROUND[channel]);
                let pixel =
                    if weight > 1.0 { color / weight } else { color + (1.0 - weight) * background };
                loss += pixel * f64::from(gradient[(3 * output + channel) * area + at]);
            }
        }
    }
    loss
}

#[test]
fn resolve_backward() {
    let mut random = Random::new(1);
    // lanes and what is left over
    for side in [1, 5, 16, 19] {
        let area = side * side;
        let mut sum = random.values(4 * OUTPUTS.len() * area, 0.0, 2.0);
        for (index, value) in sum.iter_mut().enumerate() {
            let is_weight = index / area % 4 == 3;
            // the differences must not cross the branch
            if is_weight && (*value - 1.0).abs() < 1e-3 {
                *value = 1.5;
            }
        }
        let gradient = random.values(3 * OUTPUTS.len() * area, -1.0, 1.0);
        let exact: Vec<_> = sum.iter().map(|&value| f64::from(value)).collect();
        let expected = central(&exact, 1e-5, |sum| loss(side, sum, &gradient));
        for (name, device) in everywhere() {
            let found = run(&device, side, &sum, &gradient);
            hold(&format!("{name}, side {side}"), &found, &expected);
        }
    }
}

/// Where S is 1, and where it is 0, the background's branch was taken.
#[test]
fn a_weight_of_one_is_over_the_background() {
    let gradient = [1.0, -2.0, 0.5].repeat(OUTPUTS.len());
    for weight in [0.0, 1.0] {
        let sum = [0.3, 0.4, 0.5, weight].repeat(OUTPUTS.len());
        for (name, device) in everywhere() {
            let found = run(&device, 1, &sum, &gradient);
            let by_weight = -(0.2 * 1.0 - 0.9 * 2.0);
            let expected = [1.0, -2.0, 0.5, by_weight].repeat(OUTPUTS.len());
            hold(&format!("{name}, weight {weight}"), &found, &expected);
        }
    }
}
