//! Networks with hidden layers in 16-bit floats.

use glam::Vec4;
use half::f16;
use organza_kernel::half::HalfVector;
use organza_shaders::dense::{DenseParams, OUTPUTS_PER_INVOCATION};
use organza_shaders::dense_half::{DenseHalfKernel, MAX_WEIGHTS, PRODUCTS_PER_SUM};

use super::halves::halves;
use super::network::{LayerPlace, pack_network};
use crate::error::{Error, IN_MEMORY, Result};
use crate::scene::{Layer, Network};
use organza_device::{Buffer, Count, Device};

/// Weights as [`organza_shaders::dense_half`] reads them: each rounded to the nearest half, or to zero below 2^-14.
/// Four of them are a vector.
pub fn half_vectors(weights: &[f32]) -> Vec<HalfVector> {
    let halves = halves(weights);
    let (vectors, _) = halves.as_chunks::<4>();
    vectors.iter().map(|vector| HalfVector(vector.map(f16::to_bits))).collect()
}

/// The weights of a network's hidden layers as halves, at their [places](LayerPlace); there are none at those of the biases.
///
/// # Errors
/// [`Error::Invalid`] where sums of a layer, whose tensor has a name that begins with `name`, could pass the halves.
pub(super) fn half_weights(network: &Network, name: &str) -> Result<Vec<HalfVector>> {
    let (parameters, places) = (pack_network(network), LayerPlace::of(network));
    let hidden = &places[..places.len() - 1];
    for (index, layer) in network.layers[..hidden.len()].iter().enumerate() {
        require_small(layer, &format!("{name}.mlp.{index}.weight"))?;
    }
    let mut weights = Vec::new();
    for place in hidden {
        weights.resize(place.weight as usize, HalfVector([0; 4]));
        weights
            .extend(half_vectors(&parameters[4 * place.weight as usize..4 * place.bias as usize]));
    }
    Ok(weights)
}

/// Fails where the weights of an output and of a group of inputs add up to more than [`MAX_WEIGHTS`].
fn require_small(layer: &Layer, tensor: &str) -> Result<()> {
    let rows = layer.weight.chunks(layer.inputs.max(1));
    let groups = rows.flat_map(|row| row.chunks(PRODUCTS_PER_SUM as usize));
    let sum = |group: &[f32]| group.iter().map(|weight| weight.abs()).sum::<f32>();
    let largest = groups.map(sum).fold(0.0, f32::max);
    if largest <= MAX_WEIGHTS {
        return Ok(());
    }
    Err(Error::Invalid {
        origin: IN_MEMORY.into(),
        reason: format!(
            "`{tensor}` has {PRODUCTS_PER_SUM} weights of an output whose sizes add up to {largest}; above {MAX_WEIGHTS}, sums may \
             overflow halves: leave out `--half-networks`"
        ),
    })
}

/// A layer in half precision; the biases are those of `parameters`.
pub fn half_layer(
    device: &Device,
    params: DenseParams,
    samples: &Count,
    (parameters, weights): (&Buffer<Vec4>, &Buffer<HalfVector>),
    [input, output]: [&Buffer<f32>; 2],
) -> organza_device::Result<()> {
    let kernel = DenseHalfKernel { params, parameters, weights, input, output };
    let outputs = params.columns * 4;
    device.run(&kernel.counted(samples), params.samples, outputs / OUTPUTS_PER_INVOCATION)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(inputs: usize, outputs: usize, weight: impl Fn(usize) -> f32) -> Layer {
        Layer {
            weight: (0..inputs * outputs).map(weight).collect(),
            bias: vec![9.0; outputs],
            inputs,
            outputs,
        }
    }

    #[test]
    fn weights_keep_their_places() {
        let (first, second) = (|i| 1.0 + i as f32 / 8.0, |i| -0.5 - i as f32 / 64.0);
        let layers = vec![layer(3, 5, first), layer(5, 20, second), layer(20, 3, |_| 1e6)];
        let network = Network { layers };
        let places = LayerPlace::of(&network);
        let packed = half_weights(&network, "color").unwrap();
        for (place, layer) in places.iter().zip(&network.layers[..2]) {
            for (at, &weight) in layer.weight.iter().enumerate() {
                let (output, input) = (at / layer.inputs, at % layer.inputs);
                let vector = place.weight as usize + input * place.columns as usize + output / 4;
                assert_eq!(packed[vector].values()[output % 4], weight, "{output} of {input}");
            }
        }
        assert_eq!(packed.len() as u32, places[1].bias);
    }

    #[test]
    fn weights_whose_sums_halves_do_not_hold_are_refused() {
        // of an output, each group of sixteen inputs adds up to 60 at most
        let just = |i: usize| if i % 20 < 16 { 3.75_f32 } else { -15.0 };
        for (weight, refused) in [(&just as &dyn Fn(usize) -> f32, false), (&|_| -8.0, true)] {
            let network = Network { layers: vec![layer(20, 4, weight), layer(4, 1, |_| 1.0)] };
            match half_weights(&network, "color") {
                Ok(_) => assert!(!refused),
                Err(error) => {
                    let text = error.to_string();
                    assert!(refused, "{text}");
                    for part in ["color.mlp.0.weight", "128", "leave out `--half-networks`"] {
                        assert!(text.contains(part), "{text}");
                    }
                }
            }
        }
    }
}
