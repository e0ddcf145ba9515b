//! Several samples per invocation, for the layers of networks.
//!
//! For one sample, a layer reads sixteen weights for sixteen multiply-adds. For four samples, the same weights serve
//! sixty-four. So a kernel can be generic over [`Samples`] instead of [`Lane`]. A GPU runs it with [`Four`]: an
//! invocation handles four consecutive samples. The CPU runs it with several vectors of lanes, and with one vector where
//! fewer samples are left.
//!
//! Rows of samples are [`ReadFours`] and [`WriteFours`]: on a GPU, buffers of vectors. So four samples are one load. Some
//! drivers would make four loads of four numbers. A row begins at a multiple of four, and on the CPU the buffers
//! are buffers of single numbers. A kernel reads up to three values after the last sample of a row, and does not write
//! them.

use crate::lane::Lane;
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};
use crate::memory::{ReadFours, WriteFours};
#[cfg(target_arch = "spirv")]
use glam::Vec4;
#[cfg(target_arch = "spirv")]
use spirv_std::arch::IndexUnchecked;

#[cfg(not(target_arch = "spirv"))]
pub use wide::Vectors;

#[cfg(not(target_arch = "spirv"))]
mod wide;

/// Largest number of samples in a [`Samples`]: workgroups are multiples of it.
pub const MAX_WIDTH: u32 = 4 * crate::lane::MAX_WIDTH;

/// One `f32` for each of several samples.
pub trait Samples: Copy {
    /// Number of samples.
    const WIDTH: u32;
    /// Number of columns of four sums that fit in the registers, together with the terms: 1 or 4.
    const COLUMNS: u32;
    /// The same value for every sample.
    fn splat(value: f32) -> Self;
    /// `self * a + b`, see [`Lane::mul_add`].
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// The larger of two values.
    fn max(self, other: Self) -> Self;
    /// `self` where `x` is greater than 0, and 0 elsewhere.
    fn where_positive(self, x: Self) -> Self;
    /// Reads consecutive values, starting at `first`: for [`Four`], a multiple of four. All of them must be in the buffer:
    /// each row has room for three values after its last sample.
    fn read(buffer: ReadFours<f32>, first: u32) -> Self;
    /// Stores consecutive values of the first `count` samples, at least 1, starting at `first`, as in
    /// [`read`](Samples::read).
    fn write(self, buffer: WriteFours<f32>, first: u32, count: u32);
}

/// If lanes are samples, the rest has one lane each, so there are never fewer than [`Lane::WIDTH`].
impl<L: Lane> Samples for L {
    const WIDTH: u32 = L::WIDTH;
    const COLUMNS: u32 = 4;

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
    fn read(buffer: ReadFours<f32>, first: u32) -> Self {
        #[cfg(not(target_arch = "spirv"))]
        return L::read(buffer, first);
        #[cfg(target_arch = "spirv")]
        {
            let four = Four::read(buffer, first / 4 * 4).each::<L>();
            let low = if first % 2 == 0 { [four[0], four[2]] } else { [four[1], four[3]] };
            if first % 4 < 2 { low[0] } else { low[1] }
        }
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn write(self, buffer: WriteFours<f32>, first: u32, count: u32) {
        #[cfg(not(target_arch = "spirv"))]
        {
            debug_assert!(count >= L::WIDTH, "{count} samples for {} lanes", L::WIDTH);
            L::write(self, buffer, first);
        }
        #[cfg(target_arch = "spirv")]
        {
            let _ = count;
            // SAFETY: the CPU run of every kernel checks its indices
            let four = unsafe { buffer.index_unchecked_mut(first as usize / 4) };
            let at = first % 4;
            let value = self.sum();
            if at == 0 {
                four.x = value;
            }
            if at == 1 {
                four.y = value;
            }
            if at == 2 {
                four.z = value;
            }
            if at == 3 {
                four.w = value;
            }
        }
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

impl Four {
    /// Reads the four values of a vector: those from `4 index` on.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn read_vector(buffer: ReadFours<f32>, index: u32) -> Self {
        #[cfg(target_arch = "spirv")]
        let [x, y, z, w] = buffer.read(index).to_array();
        #[cfg(not(target_arch = "spirv"))]
        let [x, y, z, w] = buffer.read_lanes(4 * index);
        Self { x, y, z, w }
    }

    /// The value of each sample, in every lane.
    #[inline(always)]
    pub fn each<L: Lane>(self) -> [L; 4] {
        [L::splat(self.x), L::splat(self.y), L::splat(self.z), L::splat(self.w)]
    }
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
    fn read(buffer: ReadFours<f32>, first: u32) -> Self {
        #[cfg(not(target_arch = "spirv"))]
        debug_assert!(first.is_multiple_of(4), "a row begins at a multiple of four");
        Self::read_vector(buffer, first / 4)
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn write(self, buffer: WriteFours<f32>, first: u32, count: u32) {
        #[cfg(target_arch = "spirv")]
        if count > 3 {
            buffer.write(first / 4, Vec4::new(self.x, self.y, self.z, self.w));
        } else {
            // SAFETY: the CPU run of every kernel checks its indices
            let four = unsafe { buffer.index_unchecked_mut(first as usize / 4) };
            four.x = self.x;
            if count > 1 {
                four.y = self.y;
            }
            if count > 2 {
                four.z = self.z;
            }
        }
        #[cfg(not(target_arch = "spirv"))]
        (first..first + count.min(4))
            .zip(self.each())
            .for_each(|(at, value)| buffer.write(at, value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::memory::{Read, Write};

    /// A few steps of a layer, with samples.
    fn layer<S: Samples>(input: &[f32], output: &mut [f32], first: u32, count: u32) {
        let a = S::read(Read::from(input), first);
        let b = S::read(Read::from(input), first + 4);
        let sum = a.mul_add(S::splat(-1.5), S::splat(0.25)).max(b);
        sum.where_positive(a).write(Write::from(output), first, count);
    }

    #[test]
    fn four_samples_match_single_samples() {
        let input = [0.5, -2.0, 0.0, 3.0, -0.25, 7.0, f32::MIN_POSITIVE, -1.0, 2.0, 1.0, 4.0, 0.0];
        for count in 1..=4 {
            for first in [0, 4] {
                let mut four = [9.0; 8];
                let mut one = [9.0; 8];
                layer::<Four>(&input, &mut four, first, count);
                (first..first + count).for_each(|at| layer::<f32>(&input, &mut one, at, 1));
                assert_eq!(four, one, "{count} from {first}");
            }
        }
    }

    #[test]
    fn vectors_of_samples_match_single_samples() {
        let input: [f32; 16] = core::array::from_fn(|i| (i * 37 % 11) as f32 - 5.0);
        let mut vectors = [9.0; 12];
        let mut one = [9.0; 12];
        layer::<Vectors<4, true, 3>>(&input, &mut vectors, 0, 12);
        (0..12).for_each(|at| layer::<f32>(&input, &mut one, at, 1));
        assert_eq!(vectors, one);
    }
}
