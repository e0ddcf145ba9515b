//! The case of `transmittance_network`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::network::{TransmittanceNetworkInputs, TransmittanceNetworkParams};

use super::exact::transmittance::log_rho;
use super::transmittance::FIRST_SAMPLE;

case!(pub TransmittanceNetwork(TransmittanceNetworkInputs));

impl TransmittanceNetwork {
    /// `columns` of the first of two hidden layers, whose outputs are `last_inputs`; none if `columns` is 0.
    fn new(samples: u32, columns: u32, last_inputs: u32, random: &mut Random) -> Self {
        let inputs = if columns == 0 { last_inputs } else { 7 };
        let last_columns = 8;
        let last_outputs = 27;
        let stride = (samples + 5).next_multiple_of(4);
        // a layer's outputs behind its last are 0
        let mut layer = |inputs: u32, outputs: u32, columns: u32| -> Vec<f32> {
            let of_row = |_| {
                let row = random.values(4 * columns as usize, -0.5, 0.5);
                let row = row.into_iter().enumerate();
                row.map(|(at, x)| if at < outputs as usize { x } else { 0.0 }).collect::<Vec<_>>()
            };
            (0..=inputs).flat_map(of_row).collect()
        };
        let mut numbers =
            if columns == 0 { Vec::new() } else { layer(inputs, last_inputs, columns) };
        numbers.extend(layer(last_inputs, last_outputs, last_columns));
        numbers.extend(layer(last_outputs, 1, 1));
        let mut point = vec![f32::NAN; (POINT_ROWS * stride) as usize];
        point.extend(random.values(stride as usize, 0.0, 1.0));
        Self(TransmittanceNetworkInputs {
            params: TransmittanceNetworkParams {
                samples,
                first_sample: FIRST_SAMPLE,
                stride,
                inputs,
                columns,
                last_inputs,
                last_columns,
                last_outputs,
            },
            parameters: numbers.chunks_exact(4).map(Vec4::from_slice).collect(),
            point,
            input: random.values((inputs * stride) as usize, -1.0, 1.0),
            log_rho: unwritten((FIRST_SAMPLE + samples) as usize),
        })
    }

    /// The logit, and the sum of its terms' sizes.
    fn logit(&self, sample: u32) -> [f64; 2] {
        let params = self.params;
        let input = |row| f64::from(self.input[(row * params.stride + sample) as usize]);
        let mut values: Vec<_> =
            (0..params.inputs).map(|row| [input(row), input(row).abs()]).collect();
        let mut first = 0;
        let shapes = [
            (params.inputs, params.columns, params.last_inputs),
            (params.last_inputs, params.last_columns, params.last_outputs),
            (params.last_outputs, 1, 1),
        ];
        for (inputs, columns, outputs) in shapes.into_iter().filter(|shape| shape.1 > 0) {
            let weight = |input: u32, output: u32| {
                let vector = self.parameters[(first + input * columns + output / 4) as usize];
                f64::from(vector[output as usize % 4])
            };
            let sum = |output: u32| {
                let bias = weight(inputs, output);
                let mut sum = [bias, bias.abs()];
                for (input, [x, size]) in (0..).zip(&values) {
                    sum[0] += weight(input, output) * x;
                    sum[1] += weight(input, output).abs() * size;
                }
                // the last layer has no activation
                if columns > 1 { [sum[0].max(0.0), sum[1]] } else { sum }
            };
            values = (0..outputs).map(sum).collect();
            first += (inputs + 1) * columns;
        }
        values[0]
    }
}

impl Parity for TransmittanceNetwork {
    const KERNEL: &'static str = "transmittance_network";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each input of each layer, of the terms' sizes: drivers may fuse \
        and regroup";

    fn sets() -> Vec<(String, Self)> {
        let mut random = Random::new(7);
        let shapes = [(1, 8, 20), (65, 16, 64), (200, 8, 32), (130, 0, 70), (1000, 4, 3)];
        let set = |(samples, columns, inputs)| {
            let name = format!("{samples} samples, {columns} columns, {inputs} inputs");
            (name, Self::new(samples, columns, inputs, &mut random))
        };
        shapes.map(set).into()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.samples, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let Some(sample) = index.checked_sub(FIRST_SAMPLE as usize) else { return Bound::EXACT };
        let [_, size] = self.logit(sample as u32);
        let params = self.params;
        let roundings = params.inputs + params.last_inputs + params.last_outputs + 10;
        Bound { scale: (1.0 + size) * f64::from(roundings), floor: f64::from(TINY) }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let sample = index.checked_sub(FIRST_SAMPLE as usize)?;
        let row = (POINT_ROWS * self.params.stride) as usize;
        Some(log_rho(self.logit(sample as u32)[0], f64::from(self.point[row + sample])))
    }
}
