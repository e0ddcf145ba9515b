//! Tiles as cooperative matrices, which the lanes of a subgroup share.

// the CPU's functions of the same names have some
#![allow(missing_docs)]

use core::arch::asm;
use core::marker::PhantomData;
use core::mem::MaybeUninit;

use spirv_std::arch::IndexUnchecked;
use spirv_std::spirv;

use super::factor::{Left, Right};
use crate::memory::{Read, Shared, Write};

/// The compiler's type. `spirv_std` has one whose sides are `u32`, which no array's length can be.
#[spirv(cooperative_matrix)]
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Matrix<T, const USE: u32, const M: usize, const N: usize> {
    // a type without a size would not reach the compiler's back end
    unused: MaybeUninit<u32>,
    of: PhantomData<T>,
}

/// What a tile consists of: [`Left`], [`Right`] or `f32`.
pub trait Element: Copy {
    /// What a buffer holds: for halves a word of two.
    type Word: Copy;
    /// Elements in a word.
    const IN_WORD: u32;
    /// The matrix of this use: 0 and 1 are factors, 2 is a sum.
    type Matrix<const M: usize, const N: usize>: Copy;
}

macro_rules! elements {
    ($($element:ident: $word:ident, $in_word:literal, $number:ident, $of:literal;)*) => {$(
        impl Element for $element {
            type Word = $word;
            const IN_WORD: u32 = $in_word;
            type Matrix<const M: usize, const N: usize> = Matrix<$number, $of, M, N>;
        }
    )*};
}

elements! {
    Left: u32, 2, f16, 0;
    Right: u32, 2, f16, 1;
    f32: f32, 1, f32, 2;
}

/// A matrix of `M` rows and `N` columns: a factor of halves, or `f32`.
#[derive(Clone, Copy)]
pub struct Tile<T: Element, const M: usize, const N: usize> {
    matrix: T::Matrix<M, N>,
}

macro_rules! loads {
    ($($name:ident[$($generics:tt)*]($memory:ty);)*) => {$(
        #[inline(always)]
        #[must_use]
        pub fn $name<$($generics)*>(memory: $memory, at: u32, stride: u32) -> Self {
            // SAFETY: the CPU run of every kernel checks its indices
            Self::load_at(unsafe { memory.index_unchecked((at / T::IN_WORD) as usize) }, stride / T::IN_WORD)
        }
    )*};
}

macro_rules! stores {
    ($($name:ident[$($generics:tt)*]($memory:ty);)*) => {$(
        #[inline(always)]
        pub fn $name<$($generics)*>(self, memory: $memory, at: u32, stride: u32) {
            // SAFETY: the CPU run of every kernel checks its indices
            self.store_at(unsafe { memory.index_unchecked_mut((at / T::IN_WORD) as usize) }, stride / T::IN_WORD);
        }
    )*};
}

impl<T: Element, const M: usize, const N: usize> Tile<T, M, N> {
    loads! {
        load[](Read<T::Word>);
        load_written[](Write<T::Word>);
        load_shared[const LEN: usize](Shared<T::Word, LEN>);
    }

    stores! {
        store[](Write<T::Word>);
        store_shared[const LEN: usize](Shared<T::Word, LEN>);
    }

    #[inline(always)]
    fn load_at(first: &T::Word, stride: u32) -> Self {
        let mut matrix = MaybeUninit::<T::Matrix<M, N>>::uninit();
        // SAFETY: it writes the matrix, of memory that the CPU run checks
        unsafe {
            asm!(
                "%u32 = OpTypeInt 32 0",
                "%by_rows = OpConstant %u32 0",
                "%stride = OpLoad %u32 {stride}",
                "%matrix = OpCooperativeMatrixLoadKHR typeof* {out} {first} %by_rows %stride",
                "OpStore {out} %matrix",
                first = in(reg) first,
                stride = in(reg) &stride,
                out = in(reg) matrix.as_mut_ptr(),
            );
            Self { matrix: matrix.assume_init() }
        }
    }

    #[inline(always)]
    fn store_at(self, first: &mut T::Word, stride: u32) {
        let matrix = self.matrix;
        // SAFETY: it writes memory that the CPU run checks
        unsafe {
            asm!(
                "%u32 = OpTypeInt 32 0",
                "%by_rows = OpConstant %u32 0",
                "%stride = OpLoad %u32 {stride}",
                "%matrix = OpLoad _ {matrix}",
                "OpCooperativeMatrixStoreKHR {first} %matrix %by_rows %stride",
                first = in(reg) first,
                matrix = in(reg) &matrix,
                stride = in(reg) &stride,
            );
        }
    }
}

impl<const M: usize, const N: usize> Tile<f32, M, N> {
    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        let mut matrix = MaybeUninit::<Matrix<f32, 2, M, N>>::uninit();
        // SAFETY: it writes the matrix
        unsafe {
            asm!(
                "%f32 = OpTypeFloat 32",
                "%zero = OpConstant %f32 0.0",
                "%matrix = OpCompositeConstruct typeof* {out} %zero",
                "OpStore {out} %matrix",
                out = in(reg) matrix.as_mut_ptr(),
            );
            Self { matrix: matrix.assume_init() }
        }
    }

    #[inline(always)]
    #[must_use]
    pub fn multiply_add<const K: usize>(
        self,
        left: Tile<Left, M, K>,
        right: Tile<Right, K, N>,
    ) -> Self {
        let left = left.matrix;
        let right = right.matrix;
        let sum = self.matrix;
        let mut matrix = MaybeUninit::<Matrix<f32, 2, M, N>>::uninit();
        // SAFETY: it writes the matrix
        unsafe {
            asm!(
                "%left = OpLoad _ {left}",
                "%right = OpLoad _ {right}",
                "%sum = OpLoad _ {sum}",
                "%matrix = OpCooperativeMatrixMulAddKHR _ %left %right %sum",
                "OpStore {out} %matrix",
                left = in(reg) &left,
                right = in(reg) &right,
                sum = in(reg) &sum,
                out = in(reg) matrix.as_mut_ptr(),
            );
            Self { matrix: matrix.assume_init() }
        }
    }
}
