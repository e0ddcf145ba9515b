//! Several samples per invocation, for the layers of networks.
//!
//! For one sample, a layer reads sixteen weights for sixteen multiply-adds. For four samples, the same weights serve
//! sixty-four. So a kernel can be generic over [`Samples`] instead of [`Lane`]. A GPU runs it with [`Four`]: an
//! invocation handles four consecutive samples. The CPU runs it with lanes, like other kernels.

use crate::lane::Lane;
use crate::memory::{Read, Write};
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};

/// One `f32` for each of several samples.
pub trait Samples: Copy {
    /// Number of samples.
    const WIDTH: u32;
    /// Same as [`Lane::COLUMNS`].
    const COLUMNS: u32;
    /// The same value for every sample.
    fn splat(value: f32) -> Self;
    /// `self * a + b`, see [`Lane::mul_add`].
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// The larger of two values.
    fn max(self, other: Self) -> Self;
    /// `self` where `x` is greater than 0, and 0 elsewhere.
    fn where_positive(self, x: Self) -> Self;
    /// Reads consecutive values, starting at `first`. All of them must be in the buffer: each row has room for three
    /// values after its last sample.
    fn read(buffer: Read<f32>, first: u32) -> Self;
    /// Stores consecutive values of the first `count` samples, at least 1, starting at `first`.
    fn write(self, buffer: Write<f32>, first: u32, count: u32);
}

/// If lanes are samples, the rest has one lane each, so there are never fewer than [`Lane::WIDTH`].
impl<L: Lane> Samples for L {
    const WIDTH: u32 = L::WIDTH;
    const COLUMNS: u32 = L::COLUMNS;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        L::splat(value)
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        L::mul_add(self, a, b)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        L::max(self, other)
    }

    #[inline(always)]
    fn where_positive(self, x: Self) -> Self {
        let zero = L::splat(0.0);
        L::select(zero.less(x), self, zero)
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn read(buffer: Read<f32>, first: u32) -> Self {
        L::read(buffer, first)
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn write(self, buffer: Write<f32>, first: u32, count: u32) {
        #[cfg(not(target_arch = "spirv"))]
        debug_assert!(count >= L::WIDTH, "{count} samples for {} lanes", L::WIDTH);
        let _ = count;
        L::write(self, buffer, first);
    }
}

/// The samples of a GPU's invocation: enough for arithmetic to outweigh reading, and few enough for its registers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Four {
    x: f32,
    y: f32,
    z: f32,
    w: f32,
}

impl Samples for Four {
    const WIDTH: u32 = 4;
    const COLUMNS: u32 = 4;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self { x: value, y: value, z: value, w: value }
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self {
            x: self.x * a.x + b.x,
            y: self.y * a.y + b.y,
            z: self.z * a.z + b.z,
            w: self.w * a.w + b.w,
        }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self {
            x: Lane::max(self.x, other.x),
            y: Lane::max(self.y, other.y),
            z: Lane::max(self.z, other.z),
            w: Lane::max(self.w, other.w),
        }
    }

    #[inline(always)]
    fn where_positive(self, x: Self) -> Self {
        Self {
            x: self.x.where_positive(x.x),
            y: self.y.where_positive(x.y),
            z: self.z.where_positive(x.z),
            w: self.w.where_positive(x.w),
        }
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn read(buffer: Read<f32>, first: u32) -> Self {
        Self {
            x: buffer.read(first),
            y: buffer.read(first + 1),
            z: buffer.read(first + 2),
            w: buffer.read(first + 3),
        }
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn write(self, buffer: Write<f32>, first: u32, count: u32) {
        buffer.write(first, self.x);
        if count > 1 {
            buffer.write(first + 1, self.y);
        }
        if count > 2 {
            buffer.write(first + 2, self.z);
        }
        if count > 3 {
            buffer.write(first + 3, self.w);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A few steps of a layer, with samples.
    fn layer<S: Samples>(input: &[f32], output: &mut [f32], first: u32, count: u32) {
        let a = S::read(Read::from(input), first);
        let b = S::read(Read::from(input), first + 1);
        let sum = a.mul_add(S::splat(-1.5), S::splat(0.25)).max(b);
        sum.where_positive(a).write(Write::from(output), first, count);
    }

    #[test]
    fn four_samples_are_those_of_one() {
        let input = [0.5, -2.0, 0.0, 3.0, -0.25, 7.0, f32::MIN_POSITIVE, -1.0, 2.0, 1.0, 4.0];
        for count in 1..=4 {
            for first in 0..6 {
                let mut four = [9.0; 12];
                let mut one = [9.0; 12];
                layer::<Four>(&input, &mut four, first, count);
                (first..first + count).for_each(|at| layer::<f32>(&input, &mut one, at, 1));
                assert_eq!(four, one, "{count} from {first}");
            }
        }
    }
}
