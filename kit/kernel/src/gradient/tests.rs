//! Gradients beside the slopes of [`Dual`], which are f64, and beside differences.

extern crate std;

use std::vec::Vec;

use super::*;
use crate::dual::Dual;
use crate::math::{
    cos, cos_backward, cross, cross_backward, dot, dot_backward, length, length_backward, ln,
    ln_backward, log_sigmoid, log_sigmoid_backward, mix, mix_backward, normalize,
    normalize_backward, pow, pow_backward, sigmoid, sigmoid_backward, sin, sin_backward, tan,
    tan_backward,
};
use crate::prelude::gradient;

/// Holds a gradient to the slope along each parameter, at several places.
fn assert_slopes<const N: usize>(
    name: &str,
    function: impl Fn([Dual; N]) -> Dual,
    backward: impl Fn([f32; N]) -> [f32; N],
) {
    let mut seen = 0.0_f64;
    for place in 0..50 {
        // in [0.2, 1.9], away from steps
        let x = core::array::from_fn(|k| 0.2 + 1.7 * ((place * N + k) as f32 * 0.618_034).fract());
        let found = backward(x);
        for (along, &found) in found.iter().enumerate() {
            let lanes = core::array::from_fn(|k| Dual {
                value: x[k],
                slope: f64::from(u8::from(k == along)),
            });
            let exact = function(lanes).slope;
            seen = seen.max(exact.abs());
            let error = (f64::from(found) - exact).abs();
            assert!(
                error <= 4e-6 * (1.0 + exact.abs()),
                "{name}({x:?}): {found} along {along}, not {exact}"
            );
        }
    }
    assert!(seen > 0.0, "{name}: nothing has a slope");
}

#[gradient]
struct Pair<L> {
    first: L,
    second: L,
}

impl<L: Clone> Clone for Pair<L> {
    fn clone(&self) -> Self {
        Self { first: self.first.clone(), second: self.second.clone() }
    }
}

impl<L: Copy> Copy for Pair<L> {}

#[gradient]
fn arithmetic<L: Lane>(a: L, b: L, c: L) -> L {
    let number = L::splat;
    let sum = a * b - c / (a + number(2.0)) + number(1.0) / b;
    -(sum * sum) / (b - number(9.0)) - a
}

#[gradient]
fn lanes<L: Lane>(a: L, b: L) -> L {
    let small = a.min(b).sqrt() + a.max(b * b).exp();
    let chosen = L::select(a.less(b), small * a, b - small);
    chosen.mul_add(a, b) * (a * L::splat(3.0) - crate::math::floor(a)) + a.truncate()
}

#[gradient]
fn pair<L: Lane>(pair: Pair<L>, scale: L) -> Pair<L> {
    let Pair { first, .. } = pair;
    Pair { first: first * scale, second: pair.second / scale + first }
}

/// Calls, structs, arrays, tuples, blocks and a value that is used as a whole and in parts.
#[gradient]
fn structures<L: Lane>([a, b]: [L; 2], c: L) -> L {
    let values = (a * c, [b, a]);
    let both = pair(Pair { first: values.0, second: values.1[0] }, c);
    let again = pair(both, a);
    let (x, [y, _]) = values;
    let rest = {
        let inner = both.first * x;
        inner - y
    };
    again.first * again.second + mix(both.second, rest, c)
}

#[gradient]
fn functions<L: Lane>(a: L, b: L) -> L {
    sin(a) * cos(b) + tan(a * L::splat(0.5)) * sigmoid(b) + log_sigmoid(a - b)
}

#[test]
fn gradients_are_the_slopes_of_duals() {
    let dual = |x, y| pair(Pair { first: x, second: y }, y).second;
    assert_slopes(
        "arithmetic",
        |[a, b, c]| arithmetic(a, b, c),
        |[a, b, c]| arithmetic_backward(a, b, c, 1.0).into(),
    );
    // the slope of e^(b^2) is 70 here, and so are the roundings
    assert_slopes("lanes", |[a, b]| lanes(a, b), |[a, b]| lanes_backward(a, b, 1.0).into());
    assert_slopes(
        "pair",
        |[x, y]| dual(x, y),
        |[x, y]| {
            let seed = Pair { first: 0.0, second: 1.0 };
            let (pair, scale) = pair_backward(Pair { first: x, second: y }, y, seed);
            [pair.first, pair.second + scale]
        },
    );
    assert_slopes(
        "structures",
        |[a, b, c]| structures([a, b], c),
        |[a, b, c]| {
            let ([a, b], c) = structures_backward([a, b], c, 1.0);
            [a, b, c]
        },
    );
    assert_slopes(
        "functions",
        |[a, b]| functions(a, b),
        |[a, b]| functions_backward(a, b, 1.0).into(),
    );
}

/// A gradient is a function with lanes, too: duals through it are second derivatives.
#[test]
fn a_gradient_has_slopes() {
    let x = Dual { value: 0.7, slope: 1.0 };
    let one = Dual { value: 1.0, slope: 0.0 };
    let second = sigmoid_backward(x, one).slope;
    let s = 1.0 / (1.0 + libm::exp(-0.7));
    assert!((second - s * (1.0 - s) * (1.0 - 2.0 * s)).abs() < 1e-7, "{second}");
}

#[gradient]
fn branches(x: f32, y: f32) -> f32 {
    let z = if x < y {
        let part = y - x;
        crate::math::sqrt(part) * y
    } else if y < 0.0 {
        x * x
    } else {
        y
    };
    z * x
}

/// Only the branch that was taken goes back: the other one's root is of a negative number.
#[test]
fn the_other_branch_has_no_gradient() {
    assert_eq!([branches(3.0, 2.0), branches(3.0, -2.0), branches(1.0, 5.0)], [6.0, 27.0, 10.0]);
    assert_eq!(branches_backward(3.0, 2.0, 1.0), (2.0, 3.0));
    assert_eq!(branches_backward(3.0, -2.0, 1.0), (27.0, 0.0));
    assert_eq!(branches_backward(1.0, 5.0, 1.0), (10.0 - 5.0 / 4.0, 2.0 + 5.0 / 4.0));
}

#[gradient]
fn vectors(a: Vec3, b: Vec3, #[constant] s: f32) -> f32 {
    let normal = cross(a, b) * dot(a, b) / length(a);
    let unit = normalize(b * s + normal);
    let flat = Vec2::new(unit.x, a.y) * 2.0 - Vec2::new(b.z, 1.0);
    dot(unit * normal, a) + flat.x * flat.y + ln(pow(length(b), a.x) + 1.0)
}

#[test]
fn gradients_of_vectors_are_differences() {
    let at = [0.3, -0.8, 1.1, 0.9, 0.4, -0.6_f32];
    let of = |x: [f32; 6]| vectors(Vec3::new(x[0], x[1], x[2]), Vec3::new(x[3], x[4], x[5]), 0.7);
    let (a, b, ()) =
        vectors_backward(Vec3::new(at[0], at[1], at[2]), Vec3::new(at[3], at[4], at[5]), 0.7, 1.0);
    let found: Vec<f32> = a.to_array().into_iter().chain(b.to_array()).collect();
    for (along, found) in found.into_iter().enumerate() {
        let difference = |step: f32| {
            let moved = |step: f32| {
                let mut x = at;
                x[along] += step;
                of(x)
            };
            (moved(step) - moved(-step)) / (2.0 * step)
        };
        // the error of the fourth order is left
        let exact = (4.0 * difference(0.01) - difference(0.02)) / 3.0;
        assert!(
            (found - exact).abs() < 2e-4 * (1.0 + exact.abs()),
            "{along}: {found}, not {exact}"
        );
    }
}

#[gradient(by = by_hand)]
fn better(x: f32) -> f32 {
    (x * x + x) - x * x
}

fn by_hand(_: f32, gradient: f32) -> f32 {
    gradient
}

#[test]
fn a_better_gradient_is_taken() {
    // the rules would lose the 1 beside 2e8
    assert_eq!((better(2.0), better_backward(1e8, 1.0)), (2.0, 1.0));
}
