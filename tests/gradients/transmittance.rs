//! Segments of Eq. 11, the scalar network's last layer (Eq. 10) and the extra vectors of Eq. 9.

use glam::Vec4;
use organza::Device;
use organza::parity::inputs::Random;
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::transmittance::TransmittanceHeadParams;
use organza_shaders::transmittance_backward::{
    ExtraBackwardKernel, ExtraBackwardParams, SegmentProductBackwardKernel,
    SegmentProductBackwardParams, TransmittanceHeadBackwardKernel,
};

use super::numeric::{central, everywhere, hold};

const INPUTS: usize = 9;

/// `L = sum over pairs of g T`, T of Eq. 11, the network's last layer reading random activations.
struct Segments {
    /// Samples of each pair.
    counts: Vec<usize>,
    /// `s_factor` of each sample.
    factor: Vec<f32>,
    /// `[samples, inputs]`
    input: Vec<f32>,
    /// Weights, then the bias.
    parameters: Vec<f32>,
    /// dL/dT of each pair.
    gradient: Vec<f32>,
}

fn log_sigmoid(x: f64) -> f64 {
    x.min(0.0) - (-x.abs()).exp().ln_1p()
}

impl Segments {
    fn new() -> Self {
        // long ones, empty ones next to each other, at the begin and at the end
        let counts = vec![0, 5, 0, 0, 70, 1, 1, 33, 17, 16, 0, 40, 0];
        let samples: usize = counts.iter().sum();
        let mut random = Random::new(4);
        let mut factor = random.values(samples, 0.1, 1.0);
        factor[3] = 0.0;
        let mut input = random.values(samples * INPUTS, -1.0, 1.0);
        // far out on both sides
        input[..INPUTS].fill(30.0);
        input[10 * INPUTS..11 * INPUTS].fill(-3.0);
        let mut parameters = random.values(INPUTS + 1, 0.0, 1.0);
        parameters[INPUTS] = 3.0;
        let gradient = random.values(counts.len(), -1.0, 1.0);
        Self { counts, factor, input, parameters, gradient }
    }

    fn first_sample(&self) -> Vec<u32> {
        let mut sum = 0;
        let sums = self.counts.iter().map(|&count| {
            sum += count as u32;
            sum
        });
        [0].into_iter().chain(sums).collect()
    }

    fn owner(&self, sample: usize) -> usize {
        self.first_sample().partition_point(|&first| first as usize <= sample) - 1
    }

    /// a_k of Eq. 10.
    fn logits(&self) -> Vec<f64> {
        let of = |input: &[f32]| {
            let products =
                input.iter().zip(&self.parameters).map(|(&x, &w)| f64::from(x) * f64::from(w));
            products.sum::<f64>() + f64::from(self.parameters[INPUTS])
        };
        self.input.chunks(INPUTS).map(of).collect()
    }

    fn transmittance(&self, logits: &[f64]) -> Vec<f64> {
        let mut log_rho =
            logits.iter().zip(&self.factor).map(|(&a, &f)| f64::from(f) * log_sigmoid(a));
        self.counts.iter().map(|&count| log_rho.by_ref().take(count).sum::<f64>().exp()).collect()
    }

    fn loss(&self, logits: &[f64]) -> f64 {
        let transmittance = self.transmittance(logits);
        transmittance.iter().zip(&self.gradient).map(|(&t, &g)| f64::from(g) * t).sum()
    }

    /// dL/da of all samples, a chunk at a time.
    fn logits_backward(&self, device: &Device, chunk: usize) -> Vec<f32> {
        let first_sample = self.first_sample();
        let samples = self.factor.len();
        let transmittance: Vec<_> =
            self.transmittance(&self.logits()).into_iter().map(|t| t as f32).collect();
        let pair_gradient: Vec<_> = self
            .gradient
            .iter()
            .flat_map(|&g| [Vec4::new(9.0, 9.0, 9.0, g), Vec4::splat(9.0), Vec4::splat(9.0)])
            .collect();
        let packed: Vec<_> = self.parameters.iter().map(|&w| Vec4::new(w, 0.0, 0.0, 0.0)).collect();
        let parameters = device.upload("parameters", &packed).unwrap();
        let stride = chunk + 2;
        (0..samples)
            .step_by(chunk)
            .flat_map(|first| {
                let count = chunk.min(samples - first);
                let [first_pair, pairs] = pairs_of(&first_sample, first, count);
                let log_rho = device.zeros::<f32>("gradient of log rho", stride).unwrap();
                let kernel = SegmentProductBackwardKernel {
                    params: SegmentProductBackwardParams {
                        pairs,
                        first_pair,
                        samples: count as u32,
                        first_sample: first as u32,
                    },
                    first_sample: &device.upload("first samples", &first_sample).unwrap(),
                    transmittance: &device.upload("transmittance", &transmittance).unwrap(),
                    pair_gradient: &device.upload("gradient", &pair_gradient).unwrap(),
                    log_rho_gradient: &log_rho,
                };
                device.run(&kernel, pairs, 1).unwrap();
                let mut point = vec![f32::NAN; (POINT_ROWS as usize + 1) * stride];
                point[POINT_ROWS as usize * stride..][..count]
                    .copy_from_slice(&self.factor[first..first + count]);
                let mut input = vec![f32::NAN; INPUTS * stride];
                for sample in 0..count {
                    for i in 0..INPUTS {
                        input[i * stride + sample] = self.input[(first + sample) * INPUTS + i];
                    }
                }
                let found = device.zeros::<f32>("logit gradient", stride).unwrap();
                let kernel = TransmittanceHeadBackwardKernel {
                    params: TransmittanceHeadParams {
                        samples: count as u32,
                        first_sample: first as u32,
                        stride: stride as u32,
                        inputs: INPUTS as u32,
                        weight: 0,
                        bias: INPUTS as u32,
                    },
                    parameters: &parameters,
                    point: &device.upload("point", &point).unwrap(),
                    input: &device.upload("input", &input).unwrap(),
                    log_rho_gradient: &log_rho,
                    logit_gradient: &found,
                };
                device.run(&kernel, count as u32, 1).unwrap();
                device.read_range(&found, 0, count).unwrap()
            })
            .collect()
    }
}

/// The first pair with samples in a chunk, and how many there are up to the last.
fn pairs_of(first_sample: &[u32], first: usize, count: usize) -> [u32; 2] {
    let begin = first_sample.partition_point(|&at| at as usize <= first) - 1;
    let end = first_sample.partition_point(|&at| (at as usize) < first + count);
    [begin as u32, (end - begin) as u32]
}

#[test]
fn logits_of_segments() {
    let segments = Segments::new();
    let logits = segments.logits();
    assert!(logits.iter().any(|&a| a > 40.0) && logits.iter().any(|&a| a < -4.0));
    let expected = central(&logits, 1e-6, |a| segments.loss(a));
    for (name, device) in everywhere() {
        // pairs lie within chunks, across two and across several of them
        for chunk in [1000, 64, 20, 7] {
            let found = segments.logits_backward(&device, chunk);
            hold(&format!("{name}, chunks of {chunk}"), &found, &expected);
        }
    }
}

/// `L = sum over samples of g sin(u of their pair)`.
#[test]
fn extra_vectors_of_pairs() {
    const EXTRA: usize = 3;
    let segments = Segments::new();
    let (samples, pairs) = (segments.factor.len(), segments.counts.len());
    let first_sample = segments.first_sample();
    let mut random = Random::new(5);
    let extra: Vec<f64> =
        random.values(pairs * EXTRA, -1.0, 1.0).into_iter().map(f64::from).collect();
    let weight: Vec<f64> =
        random.values(samples * EXTRA, -1.0, 1.0).into_iter().map(f64::from).collect();
    let at: Vec<_> = (0..samples * EXTRA)
        .map(|term| segments.owner(term / EXTRA) * EXTRA + term % EXTRA)
        .collect();
    let loss = |x: &[f64]| at.iter().zip(&weight).map(|(&at, &g)| g * x[at].sin()).sum();
    let expected = central(&extra, 1e-5, loss);
    for (name, device) in everywhere() {
        for chunk in [1000, 64, 20, 7] {
            let found = device.zeros::<f32>("pair extra", pairs * EXTRA).unwrap();
            let stride = chunk + 2;
            for first in (0..samples).step_by(chunk) {
                let count = chunk.min(samples - first);
                let mut gradient = vec![f32::NAN; (1 + EXTRA) * stride];
                for term in 0..count * EXTRA {
                    let of = first * EXTRA + term;
                    gradient[(1 + term % EXTRA) * stride + term / EXTRA] =
                        (weight[of] * extra[at[of]].cos()) as f32;
                }
                let [first_pair, pairs] = pairs_of(&first_sample, first, count);
                let kernel = ExtraBackwardKernel {
                    params: ExtraBackwardParams {
                        pairs,
                        first_pair,
                        samples: count as u32,
                        first_sample: first as u32,
                        stride: stride as u32,
                        extra: EXTRA as u32,
                        extra_row: 1,
                    },
                    first_sample: &device.upload("first samples", &first_sample).unwrap(),
                    input_gradient: &device.upload("gradient", &gradient).unwrap(),
                    pair_extra: &found,
                };
                device.run(&kernel, pairs, EXTRA as u32).unwrap();
            }
            let found = device.read(&found).unwrap();
            hold(&format!("{name}, chunks of {chunk}"), &found, &expected);
        }
    }
}
