//! Rows of the [table](super::table) for images and their loss: what moves, what the forward kernel makes of it, and
//! where both gradients lie.

use glam::Vec4;
use muslin_check::prelude::*;
use muslin_device::Device;
use organza_shaders::exposure::ExposeInputs;
use organza_shaders::loss::{LossParams, LossRowsInputs, LossTermsInputs};
use organza_shaders::ssim::{
    SsimColumnsInputs, SsimParams, SsimRowsBackwardInputs, SsimRowsInputs,
};

use super::table::{Row, flat, output, vectors, wide};
use crate::composite_backward::CompositeBackward;
use crate::exposure::{Expose, ExposeBackward};
use crate::loss::{LossGradient, LossRows, LossTerms, TILES};
use crate::ssim::{SsimColumns, SsimRows, SsimRowsBackward};

/// The image, and then gain and offset of each plane.
impl Row for ExposeBackward {
    fn point(&self) -> Vec<f32> {
        [&self.image[..], &self.exposure].concat()
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let (image, exposure) = point.split_at(self.image.len());
        let image = image.to_vec();
        let exposure = exposure.to_vec();
        let exposed = unwritten(image.len());
        let set = Expose(ExposeInputs { params: self.params, image, exposure, exposed });
        output(cpu, &set, "exposed").split_at(self.image.len()).0.to_vec()
    }

    fn slopes(&self) -> Vec<f64> {
        wide(self.gradient.iter().copied())
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let mut gradient = output(cpu, self, "gradient");
        let rows = output(cpu, self, "row_sum");
        let of_plane = |rows: &[f64]| -> [f64; 2] {
            [0, 1].map(|part| rows.iter().skip(part).step_by(2).sum())
        };
        gradient.truncate(self.image.len());
        let planes = rows.chunks_exact(2 * self.params.side as usize).map(of_plane);
        gradient.extend(planes.flatten().take(self.exposure.len()));
        gradient
    }
}

/// The splats: a support's extent has no gradient, and a needle's conic none that a difference finds.
impl Row for CompositeBackward {
    const STEP: f64 = 1.0 / 512.0;
    const ALLOWED: f64 = 1e-3;

    fn is_usual(&self, name: &str) -> bool {
        // one pixel may have a jump, at the end of a support
        self.forward.side > 1 && (name.starts_with("random") || name.starts_with("few"))
    }

    fn point(&self) -> Vec<f32> {
        flat(self.forward.splat.as_flattened()).collect()
    }

    fn reach(&self, index: usize) -> f64 {
        let [_, conic, _] = self.forward.splat[index / 12];
        let is_needle = conic.y * conic.y > 0.9 * conic.x * conic.z;
        match index % 12 {
            4..7 if is_needle => 0.0,
            4..7 => 0.1 * f64::from(conic.x.min(conic.z)),
            // the extents, and what is padding
            3 | 7 | 11 => 0.0,
            _ => 1.0,
        }
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let mut set = self.forward.clone();
        set.splat = vectors(point).as_chunks::<3>().0.to_vec();
        output(cpu, &set, "sum").split_at(4 * set.sum.len()).0.to_vec()
    }

    fn slopes(&self) -> Vec<f64> {
        (0..self.sum_gradient.len())
            .map(|at| f64::from(self.sum_gradient[self.plane(at)]))
            .collect()
    }

    fn leave_out(&mut self, output: usize) {
        let at = self.plane(output);
        self.sum_gradient[at] = 0.0;
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let mut gradient = vec![0.0; 12 * self.forward.splat.len()];
        let found = output(cpu, self, "member_gradient");
        let before = flat(&self.member_gradient);
        for (index, (found, before)) in found.into_iter().zip(before).enumerate() {
            let splat = self.forward.member[index / 12] as usize;
            gradient[12 * splat + index % 12] += found - f64::from(before);
        }
        gradient
    }
}

impl CompositeBackward {
    /// Where the case has the gradient of a pixel's channel.
    fn plane(&self, index: usize) -> usize {
        let area = (self.forward.side * self.forward.side) as usize;
        let tile = index / 4 / area;
        let at = index / 4 % area;
        let channel = index % 4;
        (4 * tile + channel) * area + at
    }
}

/// Three images, each the sums of its rows' windows: one of each kind of slope.
impl Row for SsimRowsBackward {
    fn point(&self) -> Vec<f32> {
        Random::new(9).values(4 * self.slopes.len(), -1.0, 1.0)
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let images = vectors(point);
        let image =
            |part: usize| -> Vec<Vec4> { images.iter().skip(part).step_by(3).copied().collect() };
        let sums = |part: usize| {
            let set = SsimRows(SsimRowsInputs {
                params: self.params,
                window: self.window.clone(),
                difference: image(part),
                sum: image(part),
                moments: unwritten(4 * self.slopes.len() / 3),
            });
            output(cpu, &set, "moments")
        };
        let parts = [0, 1, 2].map(sums);
        // the first moment is the weighted sum
        let pixel = |at: usize| parts.iter().flat_map(move |sums| sums[16 * at..][..4].to_vec());
        (0..self.slopes.len() / 3).flat_map(pixel).collect()
    }

    fn slopes(&self) -> Vec<f64> {
        wide(flat(&self.slopes))
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        output(cpu, self, "row_slopes")[..4 * self.slopes.len()].to_vec()
    }
}

/// The image, through all kernels of the loss and back. Where it hardly differs from the photograph, its difference has a kink.
impl Row for LossGradient {
    const STEP: f64 = 1.0 / 256.0;

    fn point(&self) -> Vec<f32> {
        self.colors(1.0)
    }

    fn reach(&self, index: usize) -> f64 {
        let (pixel, channel) = self.pixel(index);
        f64::from(u8::from(self.difference[pixel][channel].abs() > 0.02))
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let terms = self.terms(point.to_vec());
        let (difference, sum) = loss_terms(cpu, &terms);
        let columns = self.columns(cpu, &difference, &sum);
        let dissimilarity = output(cpu, &columns, "dissimilarity");
        let rows = LossRows(LossRowsInputs {
            params: terms.params,
            dissimilarity: dissimilarity[..difference.len()].iter().map(|&x| x as f32).collect(),
            difference,
            row_sum: unwritten((TILES * self.params.side) as usize),
        });
        let rows = output(cpu, &rows, "row_sum");
        rows.chunks_exact(4)
            .take((TILES * self.params.side) as usize)
            .flat_map(|row| [row[0], row[1]])
            .collect()
    }

    fn slopes(&self) -> Vec<f64> {
        wide(
            [self.params.absolute_scale, self.params.ssim_scale]
                .repeat((TILES * self.params.side) as usize),
        )
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let (difference, sum) = loss_terms(cpu, &self.terms(self.point()));
        let slopes = output(cpu, &self.columns(cpu, &difference, &sum), "slopes");
        let rows = SsimRowsBackward(SsimRowsBackwardInputs {
            params: SsimParams { side: self.params.side },
            window: self.window.clone(),
            slopes: vectors_of(&slopes, 3 * difference.len()),
            row_slopes: unwritten(3 * difference.len()),
        });
        let mut set = self.clone();
        set.row_slopes = vectors_of(&output(cpu, &rows, "row_slopes"), 3 * difference.len());
        set.difference = difference;
        set.sum = sum;
        output(cpu, &set, "grad_image")[..self.grad_image.len()].to_vec()
    }
}

/// The first of an output's vectors.
fn vectors_of(output: &[f64], count: usize) -> Vec<Vec4> {
    let numbers: Vec<_> = output[..4 * count].iter().map(|&x| x as f32).collect();
    vectors(&numbers)
}

/// The outputs of `loss_terms`: d and s.
fn loss_terms(cpu: &Device, terms: &LossTerms) -> (Vec<Vec4>, Vec<Vec4>) {
    let of = |name| vectors_of(&output(cpu, terms, name), terms.valid.len());
    (of("difference"), of("sum"))
}

impl LossGradient {
    /// Pixel and channel of a value of an image.
    fn pixel(&self, index: usize) -> (usize, usize) {
        let area = (self.params.side * self.params.side) as usize;
        (index / 3 / area * area + index % area, index / area % 3)
    }

    /// The image, for a sign of 1, or the photograph, for -1: what the case has are their difference and their sum.
    fn colors(&self, sign: f32) -> Vec<f32> {
        let color = |index| {
            let (pixel, channel) = self.pixel(index);
            0.5 * (self.sum[pixel][channel] + 1.0 + sign * self.difference[pixel][channel])
        };
        (0..self.grad_image.len()).map(color).collect()
    }

    fn terms(&self, image: Vec<f32>) -> LossTerms {
        LossTerms(LossTermsInputs {
            params: LossParams { side: self.params.side, tiles: TILES },
            image,
            target: self.colors(-1.0),
            valid: self.difference.iter().map(|d| d.w).collect(),
            difference: unwritten(self.difference.len()),
            sum: unwritten(self.difference.len()),
        })
    }

    /// The windows of both images, along rows, and ready to be completed along columns.
    fn columns(&self, cpu: &Device, difference: &[Vec4], sum: &[Vec4]) -> SsimColumns {
        let params = SsimParams { side: self.params.side };
        let rows = SsimRows(SsimRowsInputs {
            params,
            window: self.window.clone(),
            difference: difference.to_vec(),
            sum: sum.to_vec(),
            moments: unwritten(4 * sum.len()),
        });
        SsimColumns(SsimColumnsInputs {
            params,
            window: self.window.clone(),
            difference: difference.to_vec(),
            moments: vectors_of(&output(cpu, &rows, "moments"), 4 * sum.len()),
            dissimilarity: unwritten(sum.len()),
            slopes: unwritten(3 * sum.len()),
        })
    }
}
