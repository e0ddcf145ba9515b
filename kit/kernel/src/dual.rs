//! Derivatives of kernels along a direction, on the CPU: a [`Dual`] is a [`Lane`], so a kernel with lanes has them without a change.
//!
//! A kernel is a function from its inputs to its outputs. Let J be its Jacobian, `v` a direction of the inputs and `u` one of the
//! outputs. Then `<J v, u> = <v, J^T u>`: the left side is a run with [`Dual`], and a backward kernel computes `J^T u`.
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! # use muslin::prelude::*;
//! # use muslin::dual::{Dual, Slopes};
//! # #[params] pub struct Params { pub count: u32 }
//! #[kernel(threads(64), lanes(count))]
//! pub fn square<L: Lane>(id: Invocation, params: &Params, input: Read<f32>, output: Write<f32>) {
//!     if id.index() < params.count {
//!         let x = L::read(input, id.index());
//!         (x * x).write(output, id.index());
//!     }
//! }
//!
//! # fn main() {
//! let (input, mut output) = ([1.0, 2.0, -3.0], [0.0; 3]);
//! let slopes = Slopes::new(&input, &[1.0, 0.5, 1.0]);
//! let (params, view) = (Params { count: 3 }, Write::from(&mut output[..]));
//! Workgroup::new([64, 1, 1]).run(|id| square::<Dual>(id, &params, Read::from(&input[..]), view));
//! assert_eq!(slopes.at(&output), [2.0, 2.0, -6.0]);
//! # }
//! ```
//!
//! Only what goes through lanes has a slope: [`Lane::read`], [`Lane::gather`] and [`Lane::read_written`] read it, and
//! [`Lane::write`] writes it. Sums in fixed point, 16-bit floats and [`Lane::sum`] have none.

extern crate std;

use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::collections::HashMap;
use std::vec::Vec;

use crate::lane::Lane;
use crate::memory::{Read, Write};

/// A number and its slope along a direction. The number is computed as a plain invocation does, the slope in f64.
#[derive(Clone, Copy, Debug)]
pub struct Dual {
    /// The number.
    pub value: f32,
    /// Derivative of the value.
    pub slope: f64,
}

std::thread_local! {
    /// The slopes of this thread's numbers, by their addresses.
    static SLOPES: RefCell<HashMap<usize, f64>> = RefCell::default();
}

/// The slopes of the numbers in buffers of this thread's tests. Others have the slope 0. It ends with this value.
#[derive(Debug)]
pub struct Slopes(());

impl Slopes {
    /// Gives the elements of a buffer their slopes, and no others any.
    #[must_use]
    pub fn new(buffer: &[f32], direction: &[f64]) -> Self {
        assert_eq!(buffer.len(), direction.len(), "a slope for each element");
        let addresses = buffer.iter().map(|element| core::ptr::from_ref(element).addr());
        SLOPES.set(addresses.zip(direction.iter().copied()).collect());
        Self(())
    }

    /// The slopes of a buffer's elements, such as those that a kernel has written.
    #[must_use]
    pub fn at(&self, buffer: &[f32]) -> Vec<f64> {
        buffer.iter().map(|element| slope(core::ptr::from_ref(element).addr())).collect()
    }
}

impl Drop for Slopes {
    fn drop(&mut self) {
        SLOPES.take();
    }
}

fn slope(address: usize) -> f64 {
    SLOPES.with_borrow(|slopes| slopes.get(&address).copied().unwrap_or(0.0))
}

impl Dual {
    /// A number that depends on this one.
    fn chain(self, value: f32, derivative: f64) -> Self {
        Self { value, slope: derivative * self.slope }
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
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let slope = self.slope * f64::from(other.value) + f64::from(self.value) * other.slope;
        Self { value: self.value * other.value, slope }
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = f64::from(self.value) / f64::from(other.value);
        let slope = (self.slope - quotient * other.slope) / f64::from(other.value);
        Self { value: self.value / other.value, slope }
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Lane for Dual {
    const WIDTH: u32 = 1;
    const ADDS_TWO: bool = f32::ADDS_TWO;
    const READS_FOUR: bool = false;
    const GATHERS_TWO: bool = false;
    type One = Self;
    type Mask = bool;
    type Index = u32;

    fn splat(value: f32) -> Self {
        Self { value, slope: 0.0 }
    }

    fn ramp() -> Self {
        Self::splat(0.0)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn min(self, other: Self) -> Self {
        if self.less(other) { self } else { other }
    }

    fn max(self, other: Self) -> Self {
        if other.less(self) { self } else { other }
    }

    fn less(self, other: Self) -> bool {
        self.value < other.value
    }

    fn less_equal(self, other: Self) -> bool {
        self.value <= other.value
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    fn both(a: bool, b: bool) -> bool {
        a && b
    }

    fn any(mask: bool) -> bool {
        mask
    }

    fn sqrt(self) -> Self {
        let root = Lane::sqrt(self.value);
        self.chain(root, 0.5 / f64::from(root))
    }

    fn exp(self) -> Self {
        let value = Lane::exp(self.value);
        self.chain(value, f64::from(value))
    }

    fn truncate(self) -> Self {
        Self::splat(Lane::truncate(self.value))
    }

    #[track_caller]
    fn index(self) -> u32 {
        Lane::index(self.value)
    }

    fn materialize(self) -> Self {
        self
    }

    fn sum(self) -> f32 {
        self.value
    }

    #[track_caller]
    fn read(buffer: Read<f32>, first: u32) -> Self {
        Self { value: buffer.read(first), slope: slope(buffer.place(first)) }
    }

    #[track_caller]
    fn read_written(buffer: Write<f32>, first: u32) -> Self {
        Self { value: buffer.read(first), slope: slope(buffer.place(first)) }
    }

    #[track_caller]
    fn gather(buffer: Read<f32>, at: u32) -> Self {
        Self::read(buffer, at)
    }

    #[track_caller]
    fn gather_two(buffer: Read<f32>, at: u32) -> [Self; 2] {
        [Self::read(buffer, at), Self::read(buffer, at + 1)]
    }

    #[track_caller]
    fn gather_halves(buffer: Read<u32>, at: u32) -> [Self; 2] {
        f32::gather_halves(buffer, at).map(Self::splat)
    }

    #[track_caller]
    fn write(self, buffer: Write<f32>, first: u32) {
        buffer.write(first, self.value);
        SLOPES.with_borrow_mut(|slopes| slopes.insert(buffer.place(first), self.slope));
    }

    #[track_caller]
    fn add_fixed(self, mask: bool, sum: Write<u32>, at: u32) {
        self.value.add_fixed(mask, sum, at);
    }

    #[track_caller]
    fn add_fixed_two<const M: usize>(
        values: [[Self; 2]; M],
        mask: bool,
        sum: Write<u32>,
        at: [u32; M],
    ) {
        f32::add_fixed_two(values.map(|two| two.map(|dual| dual.value)), mask, sum, at);
    }

    fn expect_fixed(_: Write<u32>, _: u32) {}

    #[track_caller]
    fn take_fixed(sum: Write<u32>, first: u32) -> Self {
        Self::splat(f32::take_fixed(sum, first))
    }

    #[track_caller]
    fn flag(mask: bool, flags: Write<u32>, at: u32, block: u32) {
        f32::flag(mask, flags, at, block);
    }
}
