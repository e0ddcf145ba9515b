//! Eq. 2, 3, 10 and 11: layers, heads, and the product over a segment.

use organza::Device;
use organza::parity::color::ColorHead;
use organza::parity::dense::{Dense, Layer};
use organza::parity::dense_half::DenseHalf;
use organza::parity::transmittance::{SegmentProduct, TransmittanceHead};
use organza_check::{Bench, Parity, Rounding};

use organza_shaders::dense_half::{GROUP, UNIT};
use organza_tests::devices;

use super::hold::{hold, hold_to};

/// `W x + b`, from the layer's own definition: row `output` of W.
fn affine(layer: &Layer, output: usize, sample: usize) -> f64 {
    let at = |row: usize| {
        let vector = layer.parameters[3 + row * layer.columns as usize + output / 4];
        f64::from(vector[output % 4])
    };
    let inputs = layer.inputs as usize;
    let products = (0..inputs)
        .map(|input| at(input) * f64::from(layer.input[input * layer.stride as usize + sample]));
    products.sum::<f64>() + at(inputs)
}

#[test]
fn hidden_layers_are_rectified_sums() {
    hold::<Dense>(|set, _, index| {
        let (row, sample) = (index / set.layer.stride as usize, index % set.layer.stride as usize);
        let is_output = row < 4 * set.layer.columns as usize && sample < set.layer.samples as usize;
        is_output.then(|| affine(&set.layer, row, sample).max(0.0))
    });
}

#[test]
fn hidden_layers_of_halves_are_rectified_sums() {
    hold::<DenseHalf>(|set, _, index| {
        let layer = &set.rounded;
        let (row, sample) = (index / layer.stride as usize, index % layer.stride as usize);
        let is_output = row < 4 * layer.columns as usize && sample < layer.samples as usize;
        is_output.then(|| affine(layer, row, sample).max(0.0))
    });
}

/// What docs/numerics.md says of half networks, of the weights before they are rounded.
#[test]
fn hidden_layers_of_halves_are_within_the_bound() {
    for (name, device) in devices::all().into_iter().chain(devices::cpus()) {
        if device.computes_halves() {
            let worst = share_of_the_bound(&device);
            println!("{name}: {:.0}% of the bound", 100.0 * worst);
            assert!(worst <= 1.0, "{name}: {worst} of the bound");
            assert!(worst > 0.01, "{name}: nothing was rounded");
        }
    }
}

/// The most that an output takes of its bound.
fn share_of_the_bound(device: &Device) -> f64 {
    let growth = (1.0 + f64::from(UNIT)).powi(GROUP as i32 + 2) - 1.0;
    let mut worst: f64 = 0.0;
    for (_, set) in DenseHalf::sets() {
        let layer = &set.full;
        let outputs = set.run(&Bench::new(device, DenseHalf::KERNEL)).expect("the kernel runs");
        let found = outputs[0].floats();
        for (row, sample) in (0..4 * layer.columns)
            .flat_map(|row| (0..layer.samples).map(move |sample| (row, sample)))
        {
            let sizes = layer.bound(sample, row).scale;
            let terms = sizes - layer.bias(row).abs();
            let flushed: f64 = (0..layer.inputs)
                .map(|i| layer.weight(i, row).abs() + layer.value(i, sample).abs() + 2.0)
                .sum();
            let single = 2.0_f64.powi(-24) * f64::from(layer.inputs.div_ceil(GROUP) + 1) * sizes;
            let allowed = growth * terms + flushed / 16_384.0 + single;
            let expected = affine(layer, row as usize, sample as usize).max(0.0);
            let off = (found[(row * layer.stride + sample) as usize] - expected).abs();
            worst = worst.max(off / allowed);
        }
    }
    worst
}

#[test]
fn colors_are_sigmoids() {
    hold::<ColorHead>(|set, _, index| {
        let at = index.checked_sub(6)?;
        let (sample, channel) = (at / 3, at % 3);
        let is_color = sample < set.layer.samples as usize;
        is_color.then(|| 1.0 / (1.0 + (-affine(&set.layer, channel, sample)).exp()))
    });
}

#[test]
fn factors_are_powers_of_sigmoids() {
    hold::<TransmittanceHead>(|set, _, index| {
        let sample = index.checked_sub(3)?;
        if sample >= set.layer.samples as usize {
            return None;
        }
        let a = affine(&set.layer, 0, sample);
        let log_sigmoid = a.min(0.0) - (-a.abs()).exp().ln_1p();
        Some(f64::from(set.factor[sample]) * log_sigmoid)
    });
}

#[test]
fn transmittance_is_the_product() {
    // the sum of 16,384 logarithms in f32 is another one than in f64
    hold_to::<SegmentProduct>(Rounding::Regrouped, |set, _, pair| {
        let is_pair = pair + 1 < set.first_sample.len();
        is_pair.then(|| set.of(pair).iter().map(|&x| f64::from(x)).sum::<f64>().exp())
    });
}
