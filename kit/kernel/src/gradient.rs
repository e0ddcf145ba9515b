//! Gradients that nobody derives by hand.
//!
//! [`gradient`](macro@crate::prelude::gradient) of a function `f` writes `f_backward`. It takes the parameters of `f` and dL/df, the
//! derivative of a loss with respect to the value of `f`, and gives the derivatives with respect to the parameters: a value, or a
//! tuple with an entry for each.
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin::math::{sigmoid, sigmoid_backward};
//! use muslin::prelude::*;
//!
//! /// A neuron with one input.
//! #[gradient]
//! fn neuron<L: Lane>(weight: L, bias: L, #[constant] input: L) -> L {
//!     let sum = weight * input + bias;
//!     sigmoid(sum)
//! }
//!
//! # fn main() {
//! let (by_weight, by_bias, ()) = neuron_backward(0.5, -1.0, 2.0, 1.0);
//! // at 0 the slope of the sigmoid is 1/4
//! assert_eq!((by_weight, by_bias), (0.5, 0.25));
//! # }
//! ```
//!
//! It is reverse mode: the values once more, then their gradients in reverse. There is no tape and no memory, so it compiles to SPIR-V
//! as the function does.
//!
//! - Parameters that are references, integers or `bool`, and those marked `#[constant]`, take no gradient: their entry is `()`.
//! - A function has `let`s, `+ - * /`, fields, structs, tuples, arrays, vectors, `if .. else ..` and calls. What does not depend on a
//!   parameter with a gradient can be any expression. Loops, assignments and early returns are errors that say what to do.
//! - A call of `f` goes back through `f_backward`, which must be in scope: the attribute's, or one written by hand. `#[gradient(by = g)]`
//!   makes `g` the backward function where numbers demand a better one than the rules give.
//! - `sqrt`, `exp`, `min`, `max`, `mul_add`, `select` and `materialize`, as functions or methods, are those of every [`Lane`].
//! - Comparisons, casts, `truncate`, `floor`, `round` and `ceil` have the derivative 0, and so has [`constant`].
//! - The attribute sees names, not definitions. So give none of the names in the last two lines to a function of your own.
//! - `if` goes back through the branch that was taken. `select` computes both: where the other one is infinite, so is its derivative,
//!   and 0 times that is NaN.
//! - A struct in such a function has the attribute, too. It makes sums of it: [`Adjoint`].

use core::ops::Mul;

use glam::{Vec2, Vec3, Vec4};

use crate::lane::Lane;

/// A type with a gradient: a number, or several of them.
pub trait Adjoint: Copy {
    /// The gradient of what has no influence on the loss.
    #[must_use]
    fn zero(self) -> Self;
    /// `self + other`
    #[must_use]
    fn plus(self, other: Self) -> Self;
    /// `self - other`
    #[must_use]
    fn minus(self, other: Self) -> Self;
}

/// Sums and differences, where the operators are those of each part.
macro_rules! sums {
    () => {
        #[inline(always)]
        fn plus(self, other: Self) -> Self {
            self + other
        }

        #[inline(always)]
        fn minus(self, other: Self) -> Self {
            self - other
        }
    };
}

/// The gradients of a product of two values of one type, part by part.
macro_rules! products {
    () => {
        #[inline(always)]
        fn by_left(self, other: Self, gradient: Self) -> Self {
            gradient * other
        }

        #[inline(always)]
        fn by_right(self, _: Self, gradient: Self) -> Self {
            gradient * self
        }
    };
}

impl<L: Lane> Adjoint for L {
    #[inline(always)]
    fn zero(self) -> Self {
        L::splat(0.0)
    }

    sums!();
}

macro_rules! sum {
    ($first:expr $(, $next:expr)*) => { $first $(+ $next)* };
}

/// Vectors: their sums, and the gradients of their products.
macro_rules! vectors {
    ($($vector:ty { $($field:ident)* };)*) => {$(
        impl Adjoint for $vector {
            #[inline(always)]
            fn zero(self) -> Self {
                Self::ZERO
            }

            sums!();
        }

        impl Product<f32> for $vector {
            #[inline(always)]
            fn by_left(self, other: f32, gradient: Self) -> Self {
                gradient * other
            }

            #[inline(always)]
            fn by_right(self, _: f32, gradient: Self) -> f32 {
                sum!($(gradient.$field * self.$field),*)
            }
        }

        impl Product<$vector> for f32 {
            #[inline(always)]
            fn by_left(self, other: $vector, gradient: $vector) -> f32 {
                sum!($(gradient.$field * other.$field),*)
            }

            #[inline(always)]
            fn by_right(self, _: $vector, gradient: $vector) -> $vector {
                gradient * self
            }
        }

        impl Product<Self> for $vector {
            products!();
        }
    )*};
}

vectors! {
    Vec2 { x y };
    Vec3 { x y z };
    Vec4 { x y z w };
}

/// Arrays and tuples: part by part, as not every compiler for GPUs has loops over arrays.
macro_rules! several {
    ($([$($generic:ident)*] $several:ty: |$a:ident, $b:ident| $zero:expr, $plus:expr, $minus:expr;)*) => {$(
        impl<$($generic: Adjoint),*> Adjoint for $several {
            #[inline(always)]
            fn zero(self) -> Self {
                let $a = self;
                $zero
            }

            #[inline(always)]
            fn plus(self, $b: Self) -> Self {
                let $a = self;
                $plus
            }

            #[inline(always)]
            fn minus(self, $b: Self) -> Self {
                let $a = self;
                $minus
            }
        }
    )*};
}

macro_rules! arrays {
    ($($len:literal { $($at:literal)* };)*) => {$(
        several! {
            [A] [A; $len]: |a, b| [$(a[$at].zero()),*], [$(a[$at].plus(b[$at])),*], [$(a[$at].minus(b[$at])),*];
        }
    )*};
}

arrays! {
    2 { 0 1 };
    3 { 0 1 2 };
    4 { 0 1 2 3 };
}

macro_rules! tuples {
    ($({ $($generic:ident $at:tt)* };)*) => {$(
        several! {
            [$($generic)*] ($($generic,)*): |a, b| ($(a.$at.zero(),)*), ($(a.$at.plus(b.$at),)*), ($(a.$at.minus(b.$at),)*);
        }
    )*};
}

tuples! {
    { A 0 B 1 };
    { A 0 B 1 C 2 };
    { A 0 B 1 C 2 D 3 };
}

/// The gradient of a product: of dL/d(a b) those of a and b.
pub trait Product<B>: Mul<B> + Sized {
    /// Of `self`.
    fn by_left(self, other: B, gradient: Self::Output) -> Self;
    /// Of `other`.
    fn by_right(self, other: B, gradient: Self::Output) -> B;
}

impl<L: Lane> Product<L> for L {
    products!();
}

/// `x`, as if it did not depend on anything.
#[inline(always)]
pub fn constant<T>(x: T) -> T {
    x
}

/// Of a square root and dL/d of it.
#[inline(always)]
pub fn sqrt_backward<L: Lane>(root: L, gradient: L) -> L {
    gradient * L::splat(0.5) / root
}

/// Of e^x and dL/d of it.
#[inline(always)]
pub fn exp_backward<L: Lane>(power: L, gradient: L) -> L {
    gradient * power
}

/// Of [`Lane::truncate`]: 0. A vector's method of this name has another gradient, so it is no lane's.
#[inline(always)]
pub fn truncate_backward<L: Lane>(whole: L, _: L) -> L {
    whole.zero()
}

/// Of [`Lane::materialize`].
#[inline(always)]
pub fn materialize_backward<L: Lane>(_: L, gradient: L) -> L {
    gradient
}

/// Of the smaller of two: all of it, or of two equal ones the second's.
#[inline(always)]
pub fn min_backward<L: Lane>(a: L, b: L, gradient: L) -> (L, L) {
    let is_first = a.less(b);
    let none = L::splat(0.0);
    (L::select(is_first, gradient, none), L::select(is_first, none, gradient))
}

/// Of the larger of two: all of it, or of two equal ones the second's.
#[inline(always)]
pub fn max_backward<L: Lane>(a: L, b: L, gradient: L) -> (L, L) {
    let is_first = b.less(a);
    let none = L::splat(0.0);
    (L::select(is_first, gradient, none), L::select(is_first, none, gradient))
}

/// Of `a b + c`.
#[inline(always)]
pub fn mul_add_backward<L: Lane>(a: L, b: L, _: L, gradient: L) -> (L, L, L) {
    (gradient * b, gradient * a, gradient)
}

/// Of [`Lane::select`].
#[inline(always)]
pub fn select_backward<L: Lane>(mask: L::Mask, _: L, _: L, gradient: L) -> ((), L, L) {
    let none = L::splat(0.0);
    ((), L::select(mask, gradient, none), L::select(mask, none, gradient))
}

#[cfg(test)]
mod tests;
