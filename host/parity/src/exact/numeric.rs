//! Numbers in f64, and derivatives.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The number type of the equations: an f64, or a [`Dual`] where their derivatives are wanted.
pub trait Number:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number itself: branches look at it.
    fn value(self) -> f64;
    /// `e^x`
    fn exp(self) -> Self;
    /// The square root.
    fn sqrt(self) -> Self;
    /// `ln(1 + x)`
    fn ln_1p(self) -> Self;
}

impl Number for f64 {
    fn value(self) -> f64 {
        self
    }

    fn exp(self) -> Self {
        self.exp()
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn ln_1p(self) -> Self {
        self.ln_1p()
    }
}

/// A number, and how fast it changes with the one that [`gradient`] looks at.
///
/// The derivatives have the precision of f64, even if a function's terms cancel. A difference of two values would lose
/// a Gaussian of 1e-9 pixels beside a blur of 0.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    value: f64,
    slope: f64,
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self { value: self.value * other.value, slope }
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Number for Dual {
    fn value(self) -> f64 {
        self.value
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        Self { value, slope: value * self.slope }
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Self { value, slope: self.slope / (2.0 * value) }
    }

    fn ln_1p(self) -> Self {
        Self { value: self.value.ln_1p(), slope: self.slope / (1.0 + self.value) }
    }
}

/// The gradient of `loss`, of the branches that it takes at `values`.
pub fn gradient<const N: usize>(values: [f64; N], loss: impl Fn([Dual; N]) -> Dual) -> [f64; N] {
    std::array::from_fn(|index| {
        let mut seeded = values.map(Dual::from);
        seeded[index].slope = 1.0;
        loss(seeded).slope
    })
}

/// `a . b`
pub fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `1 / (1 + e^-x)`, without an infinity.
pub fn sigmoid<N: Number>(x: N) -> N {
    let one = N::from(1.0);
    if x.value() < 0.0 { x.exp() / (one + x.exp()) } else { one / (one + (-x).exp()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duals_have_the_derivatives() {
        let values = [0.7, -1.3];
        let [x, y] = values;
        let expected = [
            2.0 * x * y.exp() - y / (x * x) + 1.0 / (1.0 + x),
            x * x * y.exp() + 1.0 / x - 0.5 / (1.0 - y).sqrt(),
        ];
        let found = gradient(values, |[x, y]| {
            x * x * y.exp() + y / x + (Dual::from(1.0) - y).sqrt() + x.ln_1p()
        });
        for (found, exact) in found.iter().zip(expected) {
            assert!((found / exact - 1.0).abs() < 1e-15, "{found} for {exact}");
        }
    }

    #[test]
    fn a_sigmoid_ends_at_0_and_1() {
        let at = |x: f64| {
            let slope = gradient([x], |[x]| sigmoid(x));
            (sigmoid(x), slope[0])
        };
        assert_eq!((at(-3e38), at(0.0), at(3e38)), ((0.0, 0.0), (0.5, 0.25), (1.0, 0.0)));
    }
}
