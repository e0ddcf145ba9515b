//! A network's parameters as [`organza_shaders::dense`] reads them: each layer transposed, its outputs padded.

use std::ops::Range;

use organza_shaders::dense::OUTPUTS_PER_INVOCATION;

use organza_core::scene::Network;

/// Where a layer lies in the buffer of a network's parameters, in vectors of four values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LayerPlace {
    pub inputs: u32,
    pub columns: u32,
    pub weight: u32,
    pub bias: u32,
}

impl LayerPlace {
    /// The places of a network's layers.
    pub fn from_network(network: &Network) -> Vec<Self> {
        let last = network.layers.len().saturating_sub(1);
        let mut end = 0;
        let place = |(index, layer): (usize, &organza_core::scene::Layer)| {
            let block = if index < last { OUTPUTS_PER_INVOCATION } else { 4 };
            let inputs = layer.inputs as u32;
            let columns = (layer.outputs as u32).next_multiple_of(block) / 4;
            let weight = end;
            let bias = end + inputs * columns;
            end = bias + columns;
            Self { inputs, columns, weight, bias }
        };
        network.layers.iter().enumerate().map(place).collect()
    }

    /// The index in the parameters' values of element `at` of the layer's weight `[outputs, inputs]`.
    fn weight_value(&self, at: usize) -> usize {
        let output = at / self.inputs as usize;
        let input = at % self.inputs as usize;
        4 * (self.weight as usize + input * self.columns as usize) + output
    }

    /// The range of the layer's weight in the parameters' values, with the padding.
    pub fn weight_values(&self) -> Range<usize> {
        4 * self.weight as usize..self.bias_value()
    }

    /// The index of the layer's bias in the parameters' values.
    pub fn bias_value(&self) -> usize {
        4 * self.bias as usize
    }

    /// Writes the layer's weight `[outputs, inputs]` to its range of parameters, [`LayerPlace::weight_values`].
    pub fn pack_weight(&self, weight: &[f32], parameters: &mut [f32]) {
        let first = self.weight_values().start;
        for (at, &weight) in weight.iter().enumerate() {
            parameters[self.weight_value(at) - first] = weight;
        }
    }
}

/// Values of a network's parameters, with the padding.
pub fn packed_len(network: &Network) -> usize {
    let vectors =
        LayerPlace::from_network(network).last().map_or(0, |last| last.bias + last.columns);
    4 * vectors as usize
}

/// A network's parameters, four values a vector. Outputs past a layer's last are zero, and nothing reads them.
pub fn pack_network(network: &Network) -> Vec<f32> {
    let mut parameters = vec![0.0; packed_len(network)];
    for (layer, place) in network.layers.iter().zip(LayerPlace::from_network(network)) {
        place.pack_weight(&layer.weight, &mut parameters[place.weight_values()]);
        parameters[place.bias_value()..][..layer.outputs].copy_from_slice(&layer.bias);
    }
    parameters
}

/// The inverse of [`pack_network`]. It leaves out the padding of the outputs.
pub fn unpack_network(parameters: &[f32], network: &mut Network) {
    let places = LayerPlace::from_network(network);
    for (layer, place) in network.layers.iter_mut().zip(places) {
        for (at, weight) in layer.weight.iter_mut().enumerate() {
            *weight = parameters[place.weight_value(at)];
        }
        layer.bias.copy_from_slice(&parameters[place.bias_value()..][..layer.outputs]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::scene::Layer;

    fn network() -> Network {
        let layer = |inputs: usize, outputs: usize| Layer {
            weight: (0..inputs * outputs).map(|i| 1.0 + i as f32).collect(),
            bias: (0..outputs).map(|i| -1.0 - i as f32).collect(),
            inputs,
            outputs,
        };
        Network { layers: vec![layer(2, 5), layer(5, 3)] }
    }

    #[test]
    fn a_packed_network_is_the_transpose_padded() {
        let places = LayerPlace::from_network(&network());
        assert_eq!(places[0], LayerPlace { inputs: 2, columns: 4, weight: 0, bias: 8 });
        assert_eq!(places[1], LayerPlace { inputs: 5, columns: 1, weight: 12, bias: 17 });
        let parameters = pack_network(&network());
        let (vectors, rest) = parameters.as_chunks::<4>();
        assert_eq!((vectors.len(), rest.len()), (18, 0));
        // weights of input 1: the second column of [5, 2]
        assert_eq!(vectors[4], [2.0, 4.0, 6.0, 8.0]);
        assert_eq!(vectors[5], [10.0, 0.0, 0.0, 0.0]);
        assert_eq!(vectors[17], [-1.0, -2.0, -3.0, 0.0]);
    }

    #[test]
    fn a_network_is_unpacked_as_it_was_packed() {
        let mut found = Network::zeros(&network().widths());
        unpack_network(&pack_network(&network()), &mut found);
        assert_eq!(found, network());
    }
}
