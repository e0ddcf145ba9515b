//! The numbers of equations: f64, a [`Rounded`] with the error allowed to a kernel, and a [`Dual`] with a derivative.

use std::ops::{Add, Div, Mul, Neg, Sub};

use muslin_kernel::math::TINY;

/// The number type of an equation.
///
/// With f64 it is the equation's value, with [`Rounded`] the value and the error allowed, and with a [`Dual`] of either the derivative.
pub trait Number:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number itself.
    fn value(self) -> f64;
    /// `e^x`
    fn exp(self) -> Self;
    /// The square root.
    fn sqrt(self) -> Self;
    /// `1 / (1 + e^-x)`
    fn sigmoid(self) -> Self;
    /// `ln(1 / (1 + e^-x))`
    fn log_sigmoid(self) -> Self;
    /// The least integer that is not below the number.
    fn ceil(self) -> Self;
    /// `yes` if the number is above a limit, else `no`. If rounding decides, any value between the two is allowed.
    fn above(self, limit: f64, yes: Self, no: Self) -> Self;

    /// A number that lies in a range, whatever rounding does.
    fn between(self, low: f64, high: f64) -> Self {
        let _ = (low, high);
        self
    }

    /// The larger of two numbers.
    fn max(self, other: Self) -> Self {
        (self - other).above(0.0, self, other)
    }

    /// The smaller of two numbers.
    fn min(self, other: Self) -> Self {
        -(-self).max(-other)
    }

    /// The size of a number, without its sign.
    fn abs(self) -> Self {
        self.above(0.0, self, -self)
    }

    /// The sum of numbers.
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        terms.into_iter().fold(Self::from(0.0), |sum, term| sum + term)
    }
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

    fn sigmoid(self) -> Self {
        if self < 0.0 { self.exp() / (1.0 + self.exp()) } else { 1.0 / (1.0 + (-self).exp()) }
    }

    fn log_sigmoid(self) -> Self {
        self.min(0.0) - (-self.abs()).exp().ln_1p()
    }

    fn ceil(self) -> Self {
        self.ceil()
    }

    fn above(self, limit: f64, yes: Self, no: Self) -> Self {
        if self > limit { yes } else { no }
    }
}

/// Half a unit in the last place of 1: the error of an f32 that is rounded to the nearest.
const UNIT: f64 = 1.0 / 16_777_216.0;

/// Roundings of an addition or a product: one, and two more for a kernel that computes the same in another way.
const ARITHMETIC: f64 = 3.0;

/// Roundings of a division or a square root: 3 ulp.
const DIVISION: f64 = 6.0;

/// Roundings of `e^x`: 3 + 2 abs(x) ulp. Beyond 200 it is 0 or infinite.
fn exp_roundings(x: f64) -> f64 {
    2.0 * (3.0 + 2.0 * x.abs().min(200.0))
}

/// A number in f64, and the error of an f32 that a kernel computes in the same way.
///
/// Each operation adds its own rounding error. A sum's error is relative to the sizes of all its terms, so drivers may regroup
/// them, in any order. A denormal may count as 0.
///
/// ```
/// use muslin_check::number::{Number, Rounded};
///
/// let [x, y] = [1.0, 0.999].map(Rounded::from);
/// let difference = x * x - y * y;
/// assert!((difference.value - 0.001_999).abs() < 1e-12);
/// assert!(difference.error < 1e-6 && difference.error > 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounded {
    /// The value in f64.
    pub value: f64,
    /// The size of the terms that add up to the value: at least the value's own size.
    pub terms: f64,
    /// The error allowed to a device. Infinite if rounding decides the value.
    pub error: f64,
}

impl Rounded {
    /// An unknown value: rounding decides it.
    pub const UNKNOWN: Self = Self { value: 0.0, terms: 0.0, error: f64::INFINITY };

    /// A value that devices have exactly.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self::within(value, 0.0)
    }

    /// A value with an error that was derived by hand. A denormal may count as 0.
    #[must_use]
    pub fn within(value: f64, error: f64) -> Self {
        Self { value, terms: value.abs(), error }
    }

    /// The number as a kernel has it after `count` roundings.
    #[must_use]
    pub fn rounded(mut self, count: f64) -> Self {
        self.error += count * UNIT * self.terms;
        let size = self.value.abs();
        let tiny = f64::from(TINY);
        if size - self.error < tiny {
            // and so may the numbers that it is computed from
            self.error += 2.0 * tiny.min(size + self.error);
        }
        if self.error.is_nan() {
            self.error = f64::INFINITY;
        }
        self
    }

    /// Whether the number is above a limit; `None` if rounding decides.
    #[must_use]
    pub fn is_above(self, limit: f64) -> Option<bool> {
        let apart = self.value - limit;
        // infinity is above or below any limit
        let is_decided = self.error == 0.0 || apart.abs() > self.error || apart.is_infinite();
        is_decided.then_some(apart > 0.0)
    }

    /// An increasing function of the number.
    fn increasing(self, function: impl Fn(f64) -> f64) -> Self {
        let value = function(self.value);
        let below = value - function(self.value - self.error);
        Self::within(value, below.max(function(self.value + self.error) - value))
    }

    fn is_zero(self) -> bool {
        self.value == 0.0 && self.error == 0.0
    }
}

/// An input, or a constant. It need not be an f32, and a denormal may count as 0.
impl From<f64> for Rounded {
    fn from(value: f64) -> Self {
        let size = value.abs();
        let error = match size < f64::from(TINY) {
            true => size,
            false if f64::from(value as f32) == value => 0.0,
            false => UNIT * size,
        };
        Self::within(value, error)
    }
}

impl From<f32> for Rounded {
    fn from(value: f32) -> Self {
        f64::from(value).into()
    }
}

impl From<u32> for Rounded {
    fn from(value: u32) -> Self {
        Self::exact(value.into())
    }
}

/// The values of an output with only known values.
pub fn listed(values: impl IntoIterator<Item = impl Into<Rounded>>) -> Vec<Option<Rounded>> {
    values.into_iter().map(|value| Some(value.into())).collect()
}

impl Add for Rounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let terms = self.terms + other.terms;
        let error = self.error + other.error;
        Self { value: self.value + other.value, terms, error }.rounded(ARITHMETIC)
    }
}

impl Sub for Rounded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Rounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::exact(self.value * other.value);
        }
        let [a, b] = [self.value, other.value].map(f64::abs);
        let error = self.error * (b + other.error) + other.error * a;
        Self::within(self.value * other.value, error).rounded(ARITHMETIC)
    }
}

impl Div for Rounded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if self.is_zero() && other.value.abs() > other.error {
            return self;
        }
        let value = self.value / other.value;
        let smallest = other.value.abs() - other.error;
        let error = match smallest > 0.0 {
            true => (self.error + value.abs() * other.error) / smallest,
            false => f64::INFINITY,
        };
        Self::within(value, error).rounded(DIVISION)
    }
}

impl Neg for Rounded {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Number for Rounded {
    fn value(self) -> f64 {
        self.value
    }

    fn exp(self) -> Self {
        self.increasing(f64::exp).rounded(exp_roundings(self.value))
    }

    fn sqrt(self) -> Self {
        self.increasing(|x| x.max(0.0).sqrt()).rounded(DIVISION)
    }

    fn sigmoid(self) -> Self {
        let of_exp = exp_roundings(self.value) * (-self.value).sigmoid();
        self.increasing(f64::sigmoid).rounded(of_exp + ARITHMETIC + DIVISION)
    }

    fn log_sigmoid(self) -> Self {
        // relative to the logarithm of 1 + e^-|x|: all of it where x is not negative
        let negative = self.value.min(0.0);
        let share = (-negative).log_sigmoid() / negative.log_sigmoid();
        let of_exp = (exp_roundings(self.value) + DIVISION) * share;
        self.increasing(f64::log_sigmoid).rounded(of_exp + ARITHMETIC)
    }

    fn ceil(self) -> Self {
        self.increasing(f64::ceil)
    }

    fn between(self, low: f64, high: f64) -> Self {
        Self { error: self.error.min((self.value - low).max(high - self.value)), ..self }
    }

    fn above(self, limit: f64, yes: Self, no: Self) -> Self {
        let [taken, other] = if self.value > limit { [yes, no] } else { [no, yes] };
        if self.is_above(limit).is_some() {
            return taken;
        }
        let apart = (taken.value - other.value).abs() + other.error;
        let error = if apart.is_nan() { f64::INFINITY } else { taken.error.max(apart) };
        Self { error, terms: taken.terms.max(other.terms), ..taken }
    }
}

/// A number, and its derivative by the variable that [`gradient`] moves.
///
/// The derivatives have the precision of the number, even if a function's terms cancel. A difference of two values would lose
/// a Gaussian of 1e-9 pixels beside a blur of 0.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<N = f64> {
    value: N,
    slope: N,
}

impl<N: Number> Dual<N> {
    /// A number that does not move.
    pub fn constant(value: N) -> Self {
        Self { value, slope: N::from(0.0) }
    }
}

impl<N: Number> From<f64> for Dual<N> {
    fn from(value: f64) -> Self {
        Self::constant(value.into())
    }
}

impl<N: Number> Add for Dual<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl<N: Number> Sub for Dual<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<N: Number> Mul for Dual<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self { value: self.value * other.value, slope }
    }
}

impl<N: Number> Div for Dual<N> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl<N: Number> Neg for Dual<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl<N: Number> Number for Dual<N> {
    fn value(self) -> f64 {
        self.value.value()
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        Self { value, slope: value * self.slope }
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Self { value, slope: self.slope / (N::from(2.0) * value) }
    }

    fn sigmoid(self) -> Self {
        let value = self.value.sigmoid();
        // 1 - sigmoid(x), without its cancellation
        Self { value, slope: value * (-self.value).sigmoid() * self.slope }
    }

    fn log_sigmoid(self) -> Self {
        Self { value: self.value.log_sigmoid(), slope: (-self.value).sigmoid() * self.slope }
    }

    fn ceil(self) -> Self {
        Self::constant(self.value.ceil())
    }

    fn between(self, low: f64, high: f64) -> Self {
        Self { value: self.value.between(low, high), ..self }
    }

    fn above(self, limit: f64, yes: Self, no: Self) -> Self {
        Self {
            value: self.value.above(limit, yes.value, no.value),
            slope: self.value.above(limit, yes.slope, no.slope),
        }
    }
}

/// The gradient of `loss` at `values`.
pub fn gradient<N: Number, const LEN: usize>(
    values: [N; LEN],
    loss: impl Fn([Dual<N>; LEN]) -> Dual<N>,
) -> [N; LEN] {
    std::array::from_fn(|index| {
        let mut seeded = values.map(Dual::constant);
        seeded[index].slope = N::from(1.0);
        loss(seeded).slope
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duals_have_the_derivatives() {
        let values = [0.7, -1.3];
        let [x, y] = values;
        let expected = [
            2.0 * x * y.exp() - y / (x * x) + 1.0 / (1.0 + x.exp()),
            x * x * y.exp() + 1.0 / x - 0.5 / (1.0 - y).sqrt(),
        ];
        let found = gradient(values, |[x, y]| {
            x * x * y.exp() + y / x + (Dual::from(1.0) - y).sqrt() + x.log_sigmoid()
        });
        for (found, exact) in found.iter().zip(expected) {
            assert!((found / exact - 1.0).abs() < 1e-15, "{found} for {exact}");
        }
    }

    #[test]
    fn a_sigmoid_ends_at_0_and_1() {
        let at = |x: f64| (x.sigmoid(), gradient([x], |[x]| x.sigmoid())[0]);
        assert_eq!((at(-3e38), at(0.0), at(3e38)), ((0.0, 0.0), (0.5, 0.25), (1.0, 0.0)));
        let lost = Rounded::within(0.0, 1e9).sigmoid();
        assert!((0.5..0.501).contains(&lost.error), "{lost:?}");
    }

    /// Of random expressions in f32, in several orders.
    #[test]
    fn an_f32_is_within_its_error() {
        let mut random = crate::inputs::Random::new(1);
        for _ in 0..10_000 {
            let [a, b, c] = [(); 3].map(|()| random.between(-3.0, 3.0));
            let [x, y, z] = [a, b, c].map(Rounded::from);
            let cases = [
                (a * b + c, x * y + z),
                (a.mul_add(b, c), x * y + z),
                (a * c + b * c, (x + y) * z),
                ((a - b) * (a + b), x * x - y * y),
                (a / (b * b + 0.1), x / (y * y + Rounded::from(0.1))),
                ((a * a + b * b).sqrt().exp(), (x * x + y * y).sqrt().exp()),
            ];
            for (found, Rounded { value, error, .. }) in cases {
                let off = (f64::from(found) - value).abs();
                assert!(off <= error, "{found} for {value}, which is within {error}");
            }
        }
    }

    #[test]
    fn a_comparison_that_rounding_decides_says_so() {
        let sum = Rounded::from(0.1) + Rounded::from(0.2);
        assert_eq!(sum.is_above(0.3), None);
        assert_eq!(sum.is_above(0.29), Some(true));
        assert!(sum.above(0.3, 7.0.into(), 5.0.into()).error >= 2.0);
        assert_eq!(sum.above(0.29, 7.0.into(), 5.0.into()), Rounded::exact(7.0));
        assert_eq!(Rounded::from(1e-40).is_above(0.0), None, "a GPU may flush it");
    }
}
