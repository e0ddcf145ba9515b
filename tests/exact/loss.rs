//! The loss and its windows: sums as they are defined, slopes as differences.

use glam::Vec4;
use organza::parity::loss::{LossGradient, LossRows, LossTerms, Terms};
use organza::parity::ssim::{SsimColumns, SsimRows, SsimRowsBackward};
use organza_check::Rounding;

use super::hold::{hold, hold_to};

/// The Gaussian weight of a distance in pixels, none past five; all eleven have the sum 1.
fn weight(distance: usize) -> f64 {
    let gauss = |distance: i32| (-f64::from(distance * distance) / 4.5).exp();
    let all: f64 = (-5..=5).map(gauss).sum();
    if distance <= 5 { gauss(distance as i32) / all } else { 0.0 }
}

/// Tile, row and column.
fn place(pixel: usize, side: usize) -> (usize, usize, usize) {
    (pixel / side / side, pixel / side % side, pixel % side)
}

/// The weighted sum over a pixel's row or column: `step` pixels lie between two.
fn sum(pixel: usize, side: usize, is_row: bool, value: impl Fn(usize) -> f64) -> f64 {
    let (_, row, column) = place(pixel, side);
    let (at, step) = if is_row { (column, 1) } else { (row, side) };
    let first = pixel - at * step;
    (0..side).map(|tap| weight(tap.abs_diff(at)) * value(first + tap * step)).sum()
}

fn channel(values: &[Vec4], index: usize, channel: usize) -> f64 {
    f64::from(values[index][channel])
}

#[test]
fn terms_are_differences_and_sums() {
    hold::<LossTerms>(|set, output, index| {
        let (pixel, channel, area) = (index / 4, index % 4, (set.side * set.side) as usize);
        if *set.valid.get(pixel)? == 0.0 {
            return Some(0.0);
        }
        if channel == 3 {
            return Some(if output == "difference" { 1.0 } else { 0.0 });
        }
        let at = (pixel / area * 3 + channel) * area + pixel % area;
        let (x, y) = (f64::from(set.image[at]), f64::from(set.target[at]));
        Some(if output == "difference" { x - y } else { x + y - 1.0 })
    });
}

#[test]
fn moments_are_weighted_sums_of_rows() {
    // on a CPU, too, eleven roundings add up
    hold_to::<SsimRows>(Rounding::Regrouped, |set, _, index| {
        let Terms { side, difference, sum: sums } = &set.terms;
        let (pixel, moment, lane) = (index / 16, index / 4 % 4, index % 4);
        sums.get(pixel)?;
        let value = |at: usize| {
            let (d, s) = (channel(difference, at, lane), channel(sums, at, lane));
            [d, s, d * d, s * s][moment]
        };
        Some(sum(pixel, *side as usize, true, value))
    });
}

/// 1 - SSIM as it is written, from sums of d = x - y, s = x + y - 1, their squares, and weights.
fn dissimilarity([d, s, dd, ss, weight]: [f64; 5]) -> f64 {
    let [d, s, dd, ss] = [d, s, dd, ss].map(|sum| sum / weight);
    let (x, y) = ((s + 1.0 + d) / 2.0, (s + 1.0 - d) / 2.0);
    let (of_d, of_s) = (dd - d * d, ss - s * s);
    let (variances, covariance) = ((of_s + of_d) / 2.0, (of_s - of_d) / 4.0);
    let luminance = (2.0 * x * y + 1e-4) / (x * x + y * y + 1e-4);
    1.0 - luminance * (2.0 * covariance + 9e-4) / (variances + 9e-4)
}

/// Its derivative by one of the sums.
fn slope(sums: [f64; 5], by: usize) -> f64 {
    let step = 1e-6 * sums[4];
    let at = |step: f64| {
        let mut moved = sums;
        moved[by] += step;
        dissimilarity(moved)
    };
    (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step)
}

#[test]
fn similarities_are_those_of_the_windows() {
    hold::<SsimColumns>(|set, output, index| {
        let side = set.terms.side as usize;
        let values = if output == "slopes" { 12 } else { 1 };
        let (pixel, part, lane) = (index / values, index / 4 % 3, index % 4);
        if set.terms.difference.get(pixel)?.w == 0.0 || output == "slopes" && lane == 3 {
            return Some(0.0);
        }
        let sums = |lane: usize| {
            [(0, lane), (1, lane), (2, lane), (3, lane), (0, 3)].map(|(moment, lane)| {
                sum(pixel, side, false, |at| channel(&set.moments, 4 * at + moment, lane))
            })
        };
        if output == "dissimilarity" {
            return Some((0..3).map(|lane| dissimilarity(sums(lane))).sum());
        }
        // d by a pixel is w (by D + by S + 2 d by DD + 2 s by SS)
        let by = |sum: usize| slope(sums(lane), sum);
        Some(match part {
            0 => by(0) + by(1),
            1 => 2.0 * by(2),
            _ => 2.0 * by(3),
        })
    });
}

#[test]
fn slopes_are_summed_along_rows() {
    hold::<SsimRowsBackward>(|set, _, index| {
        let (pixel, part, lane) = (index / 12, index / 4 % 3, index % 4);
        set.slopes.get(3 * pixel)?;
        let value = |at: usize| channel(&set.slopes, 3 * at + part, lane);
        Some(sum(pixel, set.side as usize, true, value))
    });
}

#[test]
fn rows_are_summed() {
    hold::<LossRows>(|set, _, index| {
        let side = set.side as usize;
        let (row, part) = (index / 4, index % 4);
        let pixels = row * side..(row + 1) * side;
        let terms = set.difference.get(pixels.clone())?.iter().zip(&set.dissimilarity[pixels]);
        let term = |(d, &f): (&Vec4, &f32)| {
            let lanes = [d.x, d.y, d.z].map(f64::from);
            match part {
                0 => lanes.iter().map(|d| d.abs()).sum(),
                1 => f64::from(f),
                2 => lanes.iter().map(|d| d * d).sum(),
                _ => f64::from(d.w),
            }
        };
        Some(terms.map(term).sum::<f64>())
    });
}

#[test]
fn gradients_join_both_terms() {
    hold::<LossGradient>(|set, _, index| {
        let Terms { side, difference, sum: sums } = &set.terms;
        let side = *side as usize;
        let area = side * side;
        let (tile, lane, at) = (index / 3 / area, index / area % 3, index % area);
        let pixel = tile * area + at;
        if difference.get(pixel)?.w == 0.0 {
            return Some(0.0);
        }
        let slope = |part: usize| {
            sum(pixel, side, false, |at| channel(&set.row_slopes, 3 * at + part, lane))
        };
        let (d, s) = (channel(difference, pixel, lane), channel(sums, pixel, lane));
        let sign = if d.abs() < f64::from(f32::MIN_POSITIVE) { 0.0 } else { d.signum() };
        let [absolute, ssim] = set.scales.map(f64::from);
        Some(absolute * sign + ssim * (slope(0) + d * slope(1) + s * slope(2)))
    });
}
