//! Eq. 1 and 9: the unit cube, spherical harmonics, the hash grid and the samples of a segment.

use organza::parity::color::ColorInputs;
use organza::parity::hash_grid::HashGrid;
use organza::parity::hash_grid_half::HashGridHalf;
use organza::parity::transmittance::TransmittanceInputs;
use organza::scene::Interpolation;
use organza_check::Canary;

use super::hold::hold;

/// The harmonic of band l and order m, from angles and Rodrigues' associated Legendre functions.
fn harmonic(l: i32, m: i32, [x, y, z]: [f64; 3]) -> f64 {
    let order = m.abs();
    let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
    let sine = (1.0 - z * z).max(0.0).sqrt();
    // P_m^m with the Condon-Shortley phase, then up to P_l^m
    let (mut below, mut legendre) =
        (0.0, (1..=order).map(|k| -f64::from(2 * k - 1) * sine).product::<f64>());
    for k in order + 1..=l {
        let next = f64::from(2 * k - 1) * z * legendre - f64::from(k + order - 1) * below;
        (below, legendre) = (legendre, next / f64::from(k - order));
    }
    let ratio = factorial(l - order) / factorial(l + order);
    let norm = (f64::from(2 * l + 1) / (4.0 * std::f64::consts::PI) * ratio).sqrt();
    let angle = f64::from(order) * y.atan2(x);
    let wave = match m {
        0 => 1.0,
        1.. => std::f64::consts::SQRT_2 * angle.cos(),
        _ => std::f64::consts::SQRT_2 * angle.sin(),
    };
    norm * legendre * wave
}

#[test]
fn inputs_are_harmonics_points_and_materials() {
    hold::<ColorInputs>(|set, output, index| {
        let (row, column) = (index / set.stride as usize, index % set.stride as usize);
        if column >= set.pairs as usize {
            return None;
        }
        let (camera, center, gaussian) = set.of(column);
        match output {
            "point" => {
                let (low, high) = (set.aabb[0][row], set.aabb[1][row]);
                Some(0.05 + 0.9 * (f64::from(center[row]) - low) / (high - low))
            }
            "input" if row < set.sh_rows() => {
                let v = center.as_dvec3() - camera.eye.as_dvec3();
                // nothing has no direction, and neither has what is so far away that its square is no f32
                let has_direction = (1e-15..1e18).contains(&v.length());
                let l = (row as f64).sqrt() as i32;
                let m = row as i32 - l * l - l;
                has_direction.then(|| harmonic(l, m, v.normalize().to_array()))
            }
            "input" if row == set.sh_rows() => Some(f64::from(f32::CANARY)),
            "input" => {
                let value = row.checked_sub(set.sh_rows() + 1).filter(|&value| value < 3)?;
                Some(f64::from(set.material[3 * gaussian + value]))
            }
            _ => None,
        }
    });
}

/// An interpolated feature.
fn feature(set: &HashGrid, index: usize) -> Option<f64> {
    let (level, feature, point) = set.place(index)?;
    // the level's place in the table
    let (mut first, mut scale, mut resolution, mut entries) = (0, 0.0, 0u64, 0);
    for l in 0..=level {
        first += entries;
        scale = set.grid.base_resolution * set.grid.growth.powf(l as f64) - 1.0;
        resolution = scale.ceil() as u64 + 1;
        entries = resolution.pow(3).next_multiple_of(8).min(1 << set.grid.log2_table);
    }
    let is_hashed = resolution.pow(3) > entries;
    let position = set.points[point]
        .map(|x| (f64::from(x.coarse) + f64::from(x.fine)).clamp(0.0, 1.0) * scale + 0.5);
    let weight = |axis: usize, upper: u64| {
        let t = position[axis] - position[axis].floor();
        let smooth = set.grid.interpolation == Interpolation::Smoothstep;
        let t = if smooth { t * t * (3.0 - 2.0 * t) } else { t };
        if upper == 1 { t } else { 1.0 - t }
    };
    let corner = |corner: u64| {
        let upper = [corner & 1, corner >> 1 & 1, corner >> 2];
        let [x, y, z] = [0, 1, 2].map(|axis| position[axis].floor() as u64 + upper[axis]);
        let wrap = |x: u64, prime: u64| (x * prime) & u64::from(u32::MAX);
        let hashed = x ^ wrap(y, 2_654_435_761) ^ wrap(z, 805_459_861);
        let dense = x + y * resolution + z * resolution * resolution;
        let entry = first + if is_hashed { hashed } else { dense } % entries;
        let value = set.table[entry as usize * set.grid.features as usize + feature];
        let weights: f64 = (0..3).map(|axis| weight(axis, upper[axis])).product();
        weights * f64::from(value)
    };
    Some((0..8).map(corner).sum())
}

#[test]
fn features_are_interpolated_between_corners() {
    hold::<HashGrid>(|set, _, index| feature(set, index));
    hold::<HashGridHalf>(|set, _, index| feature(&set.full, index));
}

#[test]
fn samples_lie_in_the_middle_of_their_steps() {
    hold::<TransmittanceInputs>(|set, output, index| {
        let (row, column) = (index / set.stride as usize, index % set.stride as usize);
        if column >= set.samples as usize || index >= 4 * set.stride as usize {
            return None;
        }
        let (pair, k) = set.owner(column);
        let count = set.first_sample[pair + 1] - set.first_sample[pair];
        let vector = |part: usize| set.segment[4 * pair + part].as_dvec4();
        let (s, w) = (vector(0) + vector(2), vector(1) + vector(3));
        let gaussian = (set.pair[pair] % set.gaussians) as usize;
        match output {
            "point" => Some(s[row] + (f64::from(k) + 0.5) / f64::from(count) * w[row]),
            "s_factor" if row == 0 => Some(s.w),
            "input" if (1..3).contains(&row) => Some(f64::from(set.extra[2 * gaussian + row - 1])),
            _ => None,
        }
    });
}
