//! Compares the loss kernels with the loss's definition in f64.

use muslin_check::inputs::Random;
use organza::render::{LossInputs, TileLoss, image_loss};
use organza::{Device, Result, metrics};
use organza_tests::devices;

use crate::batch::Batch;

/// The content of a batch.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Look {
    /// Noise compared with other noise.
    Noise,
    /// A smooth photograph, and a rendered image that differs by about `0.05`.
    Near,
    /// Like `Near`, but close to white, where f32 cancels.
    Bright,
}

/// Four tiles: entirely valid, the right and lower edge of a photograph, with holes, and without valid pixels.
fn batch(side: usize, look: Look) -> Batch {
    let area = side * side;
    let noise = Random::new(1).values(2 * 4 * 3 * area, 0.0, 1.0);
    let value = |index: usize| {
        let tile = index / area / 3;
        let channel = index / area % 3;
        let row = index / side % side;
        let column = index % side;
        let wave =
            |period: f32| ((row * (tile + 2) + column * (channel + 1)) as f32 / period).sin();
        let smooth = 0.5 + 0.3 * wave(7.0) + 0.1 * wave(2.5);
        let a = noise[2 * index];
        let b = noise[2 * index + 1];
        match look {
            Look::Noise => (a, b),
            Look::Near => (smooth + 0.1 * (a - 0.5), smooth + 0.02 * (b - 0.5)),
            Look::Bright => (0.95 + 0.02 * (smooth + a), 0.95 + 0.02 * (smooth + b)),
        }
    };
    let (image, target) = (0..4 * 3 * area).map(value).unzip();
    let valid = (0..4 * area).map(|index| {
        let tile = index / area;
        let row = index / side % side;
        let column = index % side;
        let is_valid = match tile {
            0 => true,
            1 => row < side.div_ceil(2) && column < side - side / 3,
            2 => noise[index] < 0.7 && !(side > 11 && row > 3 && column > 3 && column < 12),
            _ => false,
        };
        f32::from(u8::from(is_valid))
    });
    Batch { side, image, target, valid: valid.collect() }
}

/// The gradient and the sums of a batch.
fn evaluate(device: &Device, batch: &Batch, ssim_weight: f32) -> Result<(Vec<f32>, Vec<TileLoss>)> {
    let inputs = LossInputs {
        image: &device.upload("image", &batch.image)?,
        target: &device.upload("target", &batch.target)?,
        valid: &device.upload("valid", &batch.valid)?,
        valid_pixels: batch.valid_pixels(),
        ssim_weight,
    };
    let output = image_loss(device, batch.side as u32, &inputs)?;
    Ok((device.read(&output.grad_tiles)?, output.sums(device)?))
}

/// The largest relative difference of the sums and of the loss.
fn apart(batch: &Batch, sums: &[TileLoss], ssim_weight: f32) -> f64 {
    let mut worst: f64 = 0.0;
    let relative = |found: f64, exact: f64| (found - exact).abs() / exact.abs().max(1e-9);
    let mut absolute = 0.0;
    let mut dissimilarity = 0.0;
    for (tile, found) in sums.iter().enumerate() {
        let sums = batch.sums(tile);
        assert!((found.valid - sums[3]).abs() < 1e-6, "{} for {}", found.valid, sums[3]);
        let found = [found.absolute, found.dissimilarity, found.squared];
        worst = found.into_iter().zip(sums).map(|(x, y)| relative(x, y)).fold(worst, f64::max);
        absolute += sums[0];
        dissimilarity += sums[1];
    }
    // (1 - w) |x - y| + w (1 - SSIM), the mean over the valid pixels' three channels
    let weight = f64::from(ssim_weight);
    let sum = (1.0 - weight) * absolute + weight * dissimilarity;
    let loss = sum / (3.0 * batch.valid_pixels());
    worst.max(relative(TileLoss::total(sums).value(ssim_weight), loss))
}

const SIDES: [usize; 6] = [1, 8, 11, 16, 33, 64];
const LOOKS: [Look; 3] = [Look::Noise, Look::Near, Look::Bright];

#[test]
fn sums_match_the_definition() {
    for (name, device) in devices::all() {
        for look in LOOKS {
            let mut worst: f64 = 0.0;
            for side in SIDES {
                let batch = batch(side, look);
                let (_, sums) = evaluate(&device, &batch, 0.2).expect("it runs");
                assert_eq!(sums[3], TileLoss::default(), "a tile without valid pixels");
                worst = worst.max(apart(&batch, &sums, 0.2));
            }
            println!("{name} {look:?}: sums {worst:.1e} relative");
            // near white, a variance is the small rest of 1 - 1
            let tolerance = if look == Look::Bright { 1e-3 } else { 1e-4 };
            assert!(worst < tolerance, "{name} {look:?}: {worst:.1e} relative");
        }
    }
}

/// Central differences at some pixels of a batch: the index, and the derivatives of both terms of the loss.
fn differences(batch: &Batch) -> Vec<(usize, [f64; 2])> {
    let area = batch.side * batch.side;
    let share = 1.0 / (3.0 * batch.valid_pixels());
    let every = (area / 100).max(1) | 1;
    let mut found = Vec::new();
    for tile in 0..batch.tiles() {
        for channel in 0..3 {
            let plane = batch.plane(tile, channel);
            for at in (0..area).step_by(every) {
                // |x - y| has a kink
                if (plane.x[at] - plane.y[at]).abs() > 1e-4 {
                    let slopes = plane.slopes(at).map(|slope| share * slope);
                    found.push(((tile * 3 + channel) * area + at, slopes));
                }
            }
        }
    }
    found
}

/// Norm of the differences, divided by the norm of the expected values.
fn relative(found: &[f32], expected: &[(usize, [f64; 2])], ssim_weight: f32) -> f64 {
    let weight = f64::from(ssim_weight);
    let mut apart = 0.0;
    let mut norm = 0.0;
    for &(at, [absolute, ssim]) in expected {
        let slope = (1.0 - weight) * absolute + weight * ssim;
        apart += (f64::from(found[at]) - slope).powi(2);
        norm += slope * slope;
    }
    (apart / norm).sqrt()
}

#[test]
fn gradients_match_central_differences() {
    let devices = devices::all();
    for look in LOOKS {
        let mut worst = vec![[0.0_f64; 2]; devices.len()];
        for side in SIDES {
            let batch = batch(side, look);
            let expected = differences(&batch);
            for ((name, device), worst) in devices.iter().zip(&mut worst) {
                for (worst, ssim_weight) in worst.iter_mut().zip([0.2, 1.0]) {
                    let (found, _) = evaluate(device, &batch, ssim_weight).expect("it runs");
                    let apart = relative(&found, &expected, ssim_weight);
                    assert!(apart < 1e-3, "{name} {look:?}, side {side}: {apart:.1e} relative");
                    *worst = worst.max(apart);
                    let is_masked = |index: usize| batch.valid[batch.pixel(index)] == 0.0;
                    let mut slopes = found.iter().enumerate();
                    assert!(
                        slopes.all(|(at, slope)| *slope == 0.0 || !is_masked(at)),
                        "{name}: a gradient at a masked pixel"
                    );
                }
            }
        }
        for ((name, _), [usual, ssim]) in devices.iter().zip(worst) {
            println!("{name} {look:?}: gradients {usual:.1e} relative, of SSIM alone {ssim:.1e}");
        }
    }
}

/// Equal images have no loss and no gradient, also at borders and holes. The derivative of |x| at 0 is 0.
#[test]
fn equal_images_lose_nothing() {
    for (name, device) in devices::all() {
        let mut batch = batch(16, Look::Near);
        batch.image = batch.target.clone();
        let (gradient, sums) = evaluate(&device, &batch, 0.2).expect("it runs");
        assert!(gradient.iter().all(|&slope| slope == 0.0), "{name}: a gradient");
        assert_eq!(TileLoss::total(&sums).value(0.2), 0.0, "{name}");
    }
}

/// Pixels under the mask have no influence, even if they are NaN or infinite.
#[test]
fn masked_pixels_have_no_influence() {
    for (name, device) in devices::all() {
        let batch = batch(33, Look::Near);
        let expected = evaluate(&device, &batch, 0.2).expect("it runs");
        let mut other = Batch { valid: batch.valid.clone(), ..batch };
        for index in 0..other.image.len() {
            if other.valid[other.pixel(index)] == 0.0 {
                other.image[index] = f32::NAN;
                other.target[index] = f32::INFINITY;
            }
        }
        assert!(evaluate(&device, &other, 0.2).expect("it runs") == expected, "{name}");
    }
}

/// For windows inside the image, SSIM equals the evaluation's.
#[test]
fn windows_inside_match_the_metric() {
    const SIDE: usize = 33;
    let area = SIDE * SIDE;
    for look in LOOKS {
        let batch = batch(SIDE, look);
        let pixels = |values: &[f32]| -> Vec<[f32; 3]> {
            (0..area).map(|at| [0, 1, 2].map(|channel| values[channel * area + at])).collect()
        };
        let image = pixels(&batch.image);
        let truth = pixels(&batch.target);
        let expected = metrics::ssim([SIDE, SIDE], &image, &truth, None).expect("windows");
        let inside = |at: &usize| {
            let range = 5..SIDE - 5;
            range.contains(&(at / SIDE)) && range.contains(&(at % SIDE))
        };
        let mut sum = 0.0;
        let mut count = 0.0;
        for channel in 0..3 {
            let plane = batch.plane(0, channel);
            for at in (0..area).filter(inside) {
                sum += plane.similarity(at);
                count += 1.0;
            }
        }
        assert!((sum / count - expected).abs() < 1e-10, "{} for {expected}", sum / count);
    }
}

#[test]
fn buffers_of_another_batch_are_refused() {
    let device = devices::cpu(Some(1));
    let run = |side: u32, image: usize, target: usize, valid: usize| {
        let zeros = |label, len| device.zeros::<f32>(label, len).expect("memory");
        let inputs = LossInputs {
            image: &zeros("image", image),
            target: &zeros("target", target),
            valid: &zeros("valid", valid),
            valid_pixels: 0.0,
            ssim_weight: 0.2,
        };
        let output = image_loss(&device, side, &inputs)?;
        Ok::<_, organza::Error>((device.read(&output.grad_tiles)?, output.sums(&device)?))
    };
    assert!(run(8, 192, 384, 64).is_err() && run(8, 384, 192, 64).is_err());
    assert!(run(8, 192, 192, 65).is_err());
    // no tile is valid; without valid pixels there is no loss
    let (gradient, sums) = run(8, 192, 192, 64).expect("one tile");
    assert!(gradient.iter().all(|&slope| slope == 0.0) && sums == [TileLoss::default()]);
    assert!(run(8, 0, 0, 0).expect("no tile").1.is_empty());
    for (side, pixels) in [(0, 1), (4097, 1), (1, 65_536)] {
        let refused = run(side, 3 * pixels, 3 * pixels, pixels);
        assert!(refused.is_err(), "{pixels} pixels in tiles of side {side}");
    }
}
