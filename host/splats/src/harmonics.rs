//! The harmonics of 3D Gaussian Splatting: as in Eq. 1, up to degree 3.

use glam::Vec3;
use muslin::prelude::Write;
use organza_shaders::spherical_harmonics::{spherical_harmonics, width};

/// Largest degree of a color. Files of other programs may have [more](FILE_DEGREE).
pub const DEGREE: u32 = 3;

/// Largest degree in files of other programs, of which [`DEGREE`] are read.
pub const FILE_DEGREE: u32 = 4;

/// Number of harmonics of a color.
pub const HARMONICS: usize = width(DEGREE) as usize;

/// The color if all coefficients are 0.
pub const MIDDLE: f32 = 0.5;

/// The first harmonic, which is the same in all directions: `sqrt(1 / 4 pi)`.
pub const FIRST: f32 = 0.282_094_79;

/// Weight of a coefficient's square in [`fit`], relative to the colors' weights: for the first harmonic, and for the
/// others. If a color is hardly known, its harmonics stay small.
const RIDGE: [f64; 2] = [1e-6, 1e-2];

/// The harmonics of the direction from an eye to a place; of z, if the two are equal.
pub fn harmonics(eye: Vec3, place: [f32; 3]) -> [f32; HARMONICS] {
    let direction = (Vec3::from(place) - eye).try_normalize().unwrap_or(Vec3::Z);
    let mut values = [0.0; HARMONICS];
    spherical_harmonics(direction, DEGREE, Write::from(values.as_mut_slice()), 0, 1);
    values
}

/// The color of coefficients, before it is clamped to at least 0.
pub fn color_of(coefficients: &[[f32; 3]; HARMONICS], basis: &[f32; HARMONICS]) -> [f32; 3] {
    std::array::from_fn(|channel| {
        let terms = coefficients.iter().zip(basis).map(|(value, basis)| value[channel] * basis);
        MIDDLE + terms.sum::<f32>()
    })
}

/// A color seen from some direction.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Harmonics of the direction.
    pub basis: [f32; HARMONICS],
    /// The color.
    pub color: [f32; 3],
    /// Weight in the fit.
    pub weight: f32,
}

/// Fits coefficients to samples by weighted least squares.
#[allow(clippy::needless_range_loop, reason = "several arrays have one index")]
pub fn fit(samples: &[Sample]) -> [[f32; 3]; HARMONICS] {
    let mut matrix = [[0.0_f64; HARMONICS]; HARMONICS];
    let mut right = [[0.0_f64; 3]; HARMONICS];
    let total: f64 = samples.iter().map(|sample| f64::from(sample.weight)).sum();
    for (index, row) in matrix.iter_mut().enumerate() {
        row[index] = total * RIDGE[index.min(1)] + 1e-9;
    }
    for Sample { basis, color, weight } in samples {
        for i in 0..HARMONICS {
            let scaled = f64::from(*weight) * f64::from(basis[i]);
            for j in 0..=i {
                matrix[i][j] += scaled * f64::from(basis[j]);
            }
            for channel in 0..3 {
                right[i][channel] += scaled * f64::from(color[channel] - MIDDLE);
            }
        }
    }
    solve(matrix, right).map(|row| row.map(|value| value as f32))
}

/// Solves a symmetric positive definite system, given by its lower triangle, by Cholesky factorization.
#[allow(clippy::needless_range_loop, reason = "several arrays have one index")]
pub fn solve<const N: usize>(
    mut l: [[f64; HARMONICS]; HARMONICS],
    mut x: [[f64; N]; HARMONICS],
) -> [[f64; N]; HARMONICS] {
    for i in 0..HARMONICS {
        for j in 0..=i {
            let rest = l[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
        for channel in 0..N {
            let sum: f64 = (0..i).map(|k| l[i][k] * x[k][channel]).sum();
            x[i][channel] = (x[i][channel] - sum) / l[i][i];
        }
    }
    for i in (0..HARMONICS).rev() {
        for channel in 0..N {
            let sum: f64 = (i + 1..HARMONICS).map(|k| l[k][i] * x[k][channel]).sum();
            x[i][channel] = (x[i][channel] - sum) / l[i][i];
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fit_finds_the_coefficients_that_colors_were_made_with() {
        let color = |[x, y, z]: [f32; 3]| [0.5 + 0.2 * x, 0.5 + 0.3 * y * y, 0.5 - 0.1 * z];
        let samples: Vec<_> = (0..400)
            .map(|index| {
                let z = 1.0 - (2 * index + 1) as f32 / 400.0;
                let (sin, cos) = (2.399_963_2 * index as f32).sin_cos();
                let r = (1.0 - z * z).sqrt();
                let direction = [r * cos, r * sin, z];
                let basis = harmonics(Vec3::ZERO, direction);
                Sample { basis, color: color(direction), weight: 1.0 }
            })
            .collect();
        let found = fit(&samples);
        // uniform samples separate the equations of all harmonics: their squares have the mean 1 / 4 pi
        let square = 0.25 / std::f32::consts::PI;
        let kept = RIDGE.map(|ridge| square / (square + ridge as f32));
        // x is harmonic 3, and z is harmonic 2; y^2 is 1/3 minus half the polynomial of 8 and a sixth of 6's
        let expected = [
            (0, 1, 0.1 / FIRST * kept[0]),
            (3, 0, -0.2 / 0.488_602_5 * kept[1]),
            (2, 2, -0.1 / 0.488_602_5 * kept[1]),
            (6, 1, -0.05 / 0.315_391_57 * kept[1]),
            (8, 1, -0.15 / 0.546_274_2 * kept[1]),
        ];
        for (harmonic, channel, value) in expected {
            let off = (found[harmonic][channel] - value).abs();
            assert!(off < 1e-4, "{harmonic}, {channel}: {} {value}", found[harmonic][channel]);
        }
    }
}
