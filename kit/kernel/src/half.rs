//! Arithmetic with 16-bit floats (halves), four numbers at once: native on GPUs, and a twin in `f32` on the CPU.
//!
//! The twin is exact. A half has 11 bits, so the product of two has 22, and an `f32` holds that. A sum can be rounded to the 24
//! bits of an `f32` first and to 11 then: the result is the same as with one rounding, because 24 is at least 2 x 11 + 2
//! (S. Figueroa, "When is double rounding innocuous?", 1995). So both are the half nearest to the exact result. A GPU can
//! round a product and its sum at once, and can flush a half below 2^-14 to zero.

use crate::lane_vec4::LaneVec4;

#[cfg(target_arch = "spirv")]
pub use device::HalfVector;
#[cfg(not(target_arch = "spirv"))]
pub use host::{HalfVector, Rounded, round_to_half};

/// The value of a half, from its 16 bits. It must be 0 or at least 2^-14: drivers flush smaller ones to zero.
#[inline(always)]
pub fn half_value(bits: u32) -> f32 {
    // the exponent moves to where a float has it, short of the biases' difference
    let moved = f32::from_bits((bits & 0x8000) << 16 | (bits & 0x7fff) << 13);
    moved * TWO_TO_112
}

/// 2^112, the ratio of the biases: 127 - 15 = 112.
const TWO_TO_112: f32 = f32::from_bits((127 + 112) << 23);

/// Four halves for each of several invocations: sums of four outputs.
pub trait Halves<L>: Copy {
    /// A half for each of several invocations.
    type Factor: Copy;

    /// Four zeros.
    fn zero() -> Self;
    /// The half nearest to a value, which must be below 65,520 in size.
    fn factor(value: L) -> Self::Factor;
    /// `self + weights x`, the same four weights for all invocations.
    fn add_product(self, weights: HalfVector, x: Self::Factor) -> Self;
    /// The same numbers.
    fn column(self) -> LaneVec4<L>;
}

#[cfg(target_arch = "spirv")]
mod device {
    use core::arch::asm;

    use super::Halves;
    use crate::lane_vec4::LaneVec4;

    /// Four halves: a vector. Some hardware computes two of them at once.
    #[derive(Clone, Copy)]
    #[rust_gpu::vector::v1]
    #[repr(C)]
    pub struct HalfVector {
        x: f16,
        y: f16,
        z: f16,
        w: f16,
    }

    impl Halves<f32> for HalfVector {
        type Factor = f16;

        #[inline(always)]
        fn zero() -> Self {
            Self { x: 0.0, y: 0.0, z: 0.0, w: 0.0 }
        }

        #[inline(always)]
        fn factor(value: f32) -> f16 {
            value as f16
        }

        #[inline(always)]
        fn add_product(self, weights: HalfVector, x: f16) -> Self {
            let mut sum = self;
            // Rust has no operators for vectors of halves, and one by one it is for the driver to find the vectors
            // again; an operand can be no `f16`, so all are pointers, which the optimizer removes
            // SAFETY: reads and writes the variables that it is given
            unsafe {
                asm!(
                    "%weights = OpLoad _ {weights}",
                    "%x = OpLoad _ {x}",
                    "%sum = OpLoad _ {sum}",
                    "%product = OpVectorTimesScalar typeof*{weights} %weights %x",
                    "%result = OpFAdd typeof*{weights} %sum %product",
                    "OpStore {sum} %result",
                    weights = in(reg) &weights,
                    x = in(reg) &x,
                    sum = in(reg) &mut sum,
                );
            }
            sum
        }

        #[inline(always)]
        fn column(self) -> LaneVec4<f32> {
            LaneVec4 { x: self.x as f32, y: self.y as f32, z: self.z as f32, w: self.w as f32 }
        }
    }
}

#[cfg(not(target_arch = "spirv"))]
mod host {
    use bytemuck::{Pod, Zeroable};

    use super::Halves;
    use super::half_value;
    use crate::lane::Lane;
    use crate::lane_vec4::LaneVec4;

    /// Four halves, of their 16 bits; none below 2^-14 but 0, for drivers may make zero of it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
    #[repr(C, align(8))]
    pub struct HalfVector(pub [u16; 4]);

    impl HalfVector {
        /// The four numbers.
        #[inline(always)]
        #[must_use]
        pub fn values(self) -> [f32; 4] {
            self.0.map(
                #[inline(always)]
                |bits| half_value(bits.into()),
            )
        }
    }

    /// The half nearest to each lane's value, which must be below 65,520 in size; of two as near, the even one.
    #[inline(always)]
    #[must_use]
    pub fn round_to_half<L: Lane>(value: L) -> L {
        /// 2^13 + 1: an `f32` has 13 bits more than a half.
        const SPLIT: f32 = 8_193.0;
        /// The smallest half with all its digits, 2^-14.
        const NORMAL: f32 = 1.0 / 16_384.0;
        /// Numbers around it are multiples of 2^-24, as halves below 2^-14 are.
        const COARSE: f32 = 0.75;
        // Veltkamp's splitting: the leading 11 bits
        let product = value * L::splat(SPLIT);
        let normal = product - (product - value);
        let small = (value + L::splat(COARSE)) - L::splat(COARSE);
        let is_small = value.max(-value).less(L::splat(NORMAL));
        L::select(is_small, small, normal)
    }

    /// Four halves for each lane, each as an `f32`.
    #[derive(Clone, Copy)]
    pub struct Rounded<L>(LaneVec4<L>);

    impl<L: Lane> Halves<L> for Rounded<L> {
        type Factor = L;

        #[inline(always)]
        fn zero() -> Self {
            let zero = L::splat(0.0);
            Self(LaneVec4 { x: zero, y: zero, z: zero, w: zero })
        }

        #[inline(always)]
        fn factor(value: L) -> L {
            round_to_half(value)
        }

        #[inline(always)]
        fn add_product(self, weights: HalfVector, x: L) -> Self {
            let [a, b, c, d] = weights.values();
            Self(LaneVec4 {
                x: add_product(self.0.x, a, x),
                y: add_product(self.0.y, b, x),
                z: add_product(self.0.z, c, x),
                w: add_product(self.0.w, d, x),
            })
        }

        #[inline(always)]
        fn column(self) -> LaneVec4<L> {
            self.0
        }
    }

    #[inline(always)]
    fn add_product<L: Lane>(sum: L, weight: f32, x: L) -> L {
        round_to_half(sum + round_to_half(L::splat(weight) * x))
    }
}
