//! Rows of the [table](super::table) for networks and their inputs: what moves, what the forward kernel makes of it, and where both
//! gradients lie.

use glam::Vec4;
use muslin_check::prelude::*;
use muslin_device::Device;
use organza_shaders::transmittance::{SegmentProductInputs, SegmentProductParams};

use super::table::{Row, flat, output, vectors, wide};
use crate::color::{BOXES, ColorHead, ColorInputs};
use crate::color_backward::{ColorHeadBackward, MaterialBackward};
use crate::dense::{Dense, Layer};
use crate::dense_backward::DenseWeightBackward;
use crate::exact::color::logit;
use crate::pair::PairSum;
use crate::project;
use crate::transmittance::{SegmentProduct, TransmittanceInputs};
use crate::transmittance_backward::{ExtraBackward, SegmentProductBackward};

/// The logits: a head of three inputs, each of which is a logit.
impl Row for ColorHeadBackward {
    fn point(&self) -> Vec<f32> {
        let samples = self.params.samples as usize;
        let first = self.params.first_pair as usize;
        let of =
            |at: usize| logit(f64::from(self.color[3 * (first + at % samples) + at / samples]));
        // where the color is 0 or 1 in an f32, nothing depends on the logit
        (0..3 * samples).map(|at| of(at).clamp(-30.0, 30.0) as f32).collect()
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let samples = self.params.samples;
        let mut layer = Layer::with_stride(samples, samples, 3, 1, Fill::Zero, &mut Random::new(0));
        let weight = layer.params().weight as usize;
        layer.parameters[weight..weight + 3].copy_from_slice(&[Vec4::X, Vec4::Y, Vec4::Z]);
        layer.input = point.to_vec();
        let first = 3 * self.params.first_pair as usize;
        output(cpu, &ColorHead { layer }, "color")[first..][..point.len()].to_vec()
    }

    fn slopes(&self) -> Vec<f64> {
        let pairs = self.pair_gradient.chunks_exact(3).skip(self.params.first_pair as usize);
        pairs.flat_map(|pair| wide(pair[2].truncate().to_array())).collect()
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let rows = output(cpu, self, "logit_gradient");
        let rows = rows.chunks_exact(self.params.stride as usize).take(3);
        rows.flat_map(|row| row[..self.params.samples as usize].to_vec()).collect()
    }
}

/// The materials, one for each pair.
impl Row for MaterialBackward {
    fn point(&self) -> Vec<f32> {
        let pairs = self.params.first_pair + self.params.samples;
        Random::new(3).values((3 * pairs) as usize, -1.0, 1.0)
    }

    fn reach(&self, index: usize) -> f64 {
        f64::from(u8::from(index >= 3 * self.params.first_pair as usize))
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let pairs = point.len() as u32 / 3;
        let mut random = Random::new(4);
        let set = ColorInputs {
            pairs: self.params.samples,
            pair: (0..pairs).collect(),
            gaussians: pairs,
            cameras: project::cameras(&mut random),
            aabb: BOXES[0],
            is_contracted: false,
            position: random.values(point.len(), -1.0, 1.0),
            material: point.to_vec(),
            degree: 1,
            stride: self.params.stride,
        };
        let stride = self.params.stride as usize;
        let rows = output(cpu, &set, "input");
        let rows = rows.chunks_exact(stride).skip(set.sh_rows() + 1).take(3);
        rows.flat_map(|row| row[..self.params.samples as usize].to_vec()).collect()
    }

    fn slopes(&self) -> Vec<f64> {
        let rows = self.input_gradient.chunks_exact(self.params.stride as usize).skip(1);
        rows.flat_map(|row| wide(row[..self.params.samples as usize].to_vec())).collect()
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        output(cpu, self, "pair_material")[..self.point().len()].to_vec()
    }

    fn is_usual(&self, name: &str) -> bool {
        name.starts_with("random") && self.params.material == 3 && self.params.samples > 0
    }
}

/// The logarithms of a chunk's factors: those of a pair share what its transmittance is.
impl Row for SegmentProductBackward {
    fn is_usual(&self, name: &str) -> bool {
        let is_random = name.starts_with("random") && !name.contains(" 0 items");
        is_random || name.starts_with("steps")
    }

    fn point(&self) -> Vec<f32> {
        let owner = |sample: usize| self.chunk.owner(sample);
        let of = |sample: usize| {
            let pair = owner(sample);
            let count = self.chunk.first_sample[pair + 1] - self.chunk.first_sample[pair];
            (f64::from(self.transmittance[pair]).ln() / f64::from(count)) as f32 / self.power
        };
        (0..self.chunk.samples as usize).map(of).collect()
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let still = self.point();
        let all = *self.chunk.first_sample.last().expect("it ends") as usize;
        let first = crate::transmittance_backward::FIRST_SAMPLE as usize;
        // samples outside of the chunk are as their pair's others
        let log_rho = (0..all).map(|sample| {
            let inside = sample.checked_sub(first).filter(|&at| at < point.len());
            let of_pair = |pair: usize| (0..still.len()).find(|&at| self.chunk.owner(at) == pair);
            let pair = self.chunk.first_sample.partition_point(|&at| at as usize <= sample) - 1;
            inside.map_or_else(|| of_pair(pair).map_or(0.0, |at| still[at]), |at| point[at])
        });
        let set = SegmentProduct(SegmentProductInputs {
            params: SegmentProductParams {
                pairs: self.transmittance.len() as u32,
                power: self.power,
            },
            first_sample: self.chunk.first_sample.clone(),
            log_rho: log_rho.collect(),
            transmittance: unwritten(self.transmittance.len()),
        });
        output(cpu, &set, "transmittance")[..self.transmittance.len()].to_vec()
    }

    fn slopes(&self) -> Vec<f64> {
        wide(self.gradient.iter().step_by(3).map(|pair| pair.w))
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        output(cpu, self, "log_rho_gradient")[..self.chunk.samples as usize].to_vec()
    }
}

/// Two values of the extra vectors, one vector for each pair.
impl Row for ExtraBackward {
    fn point(&self) -> Vec<f32> {
        Random::new(5).values(2 * (self.chunk.first_sample.len() - 1), -1.0, 1.0)
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let samples = self.chunk.samples;
        extra_inputs(cpu, samples, self.chunk.first_sample.clone(), None, point)
    }

    fn slopes(&self) -> Vec<f64> {
        let rows = self.gradient.chunks_exact(self.stride as usize).skip(1).take(2);
        rows.flat_map(|row| wide(row[..self.chunk.samples as usize].to_vec())).collect()
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let found = output(cpu, self, "pair_extra");
        let added = found.iter().zip(&self.pair_extra).map(|(found, &x)| found - f64::from(x));
        added.collect::<Vec<_>>().chunks_exact(3).flat_map(|of| [of[0], of[1]]).collect()
    }
}

/// The rows of `transmittance_inputs` that are copies of extra vectors of two values. Without a list of pairs, each has a Gaussian.
fn extra_inputs(
    cpu: &Device,
    samples: u32,
    first_sample: Vec<u32>,
    pair: Option<Vec<u32>>,
    extra: &[f32],
) -> Vec<f64> {
    let pairs = first_sample.len() as u32 - 1;
    let set = TransmittanceInputs {
        samples,
        stride: samples + 5,
        gaussians: extra.len() as u32 / 2,
        pair: pair.unwrap_or_else(|| (0..pairs).collect()),
        first_sample,
        segment: vec![Vec4::splat(0.25); 4 * pairs as usize],
        is_contracted: false,
        extra: extra.to_vec(),
    };
    let rows = output(cpu, &set, "input");
    let rows = rows.chunks_exact(samples as usize + 5).skip(1).take(2);
    rows.flat_map(|row| row[..samples as usize].to_vec()).collect()
}

/// A Gaussian's extra vector, of which `transmittance_inputs` gives each pair a copy. Three pairs lie before its chunk.
impl Row for PairSum {
    fn is_usual(&self, name: &str) -> bool {
        name.starts_with("Random bits") && (1..2000).contains(&self.params.gaussians)
    }

    fn point(&self) -> Vec<f32> {
        Random::new(6).values(self.vector.len(), -1.0, 1.0)
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let words = self.params.words;
        let bits = (0..32 * self.mask.len() as u32)
            .filter(|&at| self.mask[(at / 32) as usize] >> (at % 32) & 1 == 1);
        // some bits stand for no Gaussian: their pairs take a vector that nobody moves
        let gaussian = bits.map(|at| at % (32 * words));
        let pair: Vec<_> = [0; 3].into_iter().chain(gaussian).collect();
        let mut extra = point.to_vec();
        extra.resize(64 * words as usize, 0.0);
        let pairs = pair.len() as u32;
        let rows = extra_inputs(cpu, pairs - 3, (0..=pairs).collect(), Some(pair), &extra);
        let (first, second) = rows.split_at(rows.len() / 2);
        first.iter().zip(second).flat_map(|(&a, &b)| [a, b]).collect()
    }

    fn slopes(&self) -> Vec<f64> {
        wide(self.pair_vector.iter().copied())
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let found = output(cpu, self, "vector");
        found.iter().zip(&self.vector).map(|(found, &before)| found - f64::from(before)).collect()
    }
}

/// Weights and biases of a layer that is linear, because its biases are large. One chunk has all samples.
impl Row for DenseWeightBackward {
    const STEP: f64 = 1.0;

    fn is_usual(&self, name: &str) -> bool {
        let is_whole = self.first_sample == 0 && self.first.len() == 2;
        name.starts_with("random") && is_whole && self.layer.columns.is_multiple_of(4)
    }

    fn point(&self) -> Vec<f32> {
        let mut layer = self.layer.clone();
        let bias = layer.params().bias as usize;
        layer.parameters[bias..].fill(Vec4::splat(32.0));
        flat(&layer.parameters).collect()
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let layer = Layer { parameters: vectors(point), ..self.layer.clone() };
        let mut values = output(cpu, &Dense { layer: layer.clone() }, "output");
        values.truncate(self.gradient.len());
        // what is padding has no slope
        values
            .iter_mut()
            .enumerate()
            .filter(|(at, _)| layer.output(*at).is_none())
            .for_each(|(_, x)| *x = 0.0);
        values
    }

    fn slopes(&self) -> Vec<f64> {
        wide(self.gradient.iter().copied())
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let found = output(cpu, self, "sum");
        found.iter().zip(&self.before).map(|(found, &before)| found - f64::from(before)).collect()
    }
}
