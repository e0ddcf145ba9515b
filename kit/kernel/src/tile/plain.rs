//! Tiles with ordinary arithmetic: on the CPU, and where a device has no cooperative matrices.

// each place is written once for the CPU and for GPUs
#![allow(clippy::needless_range_loop)]

use glam::Vec2;

use super::factor::{Left, Right};
use crate::memory::{Read, Shared, Write};
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};

/// What a tile consists of: [`Left`], [`Right`] or `f32`.
pub trait Element: Copy + Default {
    /// What a buffer holds: for halves a word of two.
    type Word: Copy;
    /// Elements in four words.
    #[doc(hidden)]
    const FOUR: usize;
    #[doc(hidden)]
    fn values(words: [Self::Word; 4]) -> [Self; 8];
    #[doc(hidden)]
    fn words(values: [Self; 8]) -> [Self::Word; 4];
}

macro_rules! halves {
    ($($element:ident)*) => {$(
        impl Element for $element {
            type Word = u32;
            const FOUR: usize = 8;

            #[inline(always)]
            fn values([a, b, c, d]: [u32; 4]) -> [Self; 8] {
                let a = unpack(a);
                let b = unpack(b);
                let c = unpack(c);
                let d = unpack(d);
                [Self(a.x), Self(a.y), Self(b.x), Self(b.y), Self(c.x), Self(c.y), Self(d.x), Self(d.y)]
            }

            #[inline(always)]
            fn words([a, b, c, d, e, f, g, h]: [Self; 8]) -> [u32; 4] {
                [pack(a.0, b.0), pack(c.0, d.0), pack(e.0, f.0), pack(g.0, h.0)]
            }
        }
    )*};
}

halves!(Left Right);

impl Element for f32 {
    type Word = f32;
    const FOUR: usize = 4;

    #[inline(always)]
    fn values([a, b, c, d]: [f32; 4]) -> [f32; 8] {
        [a, b, c, d, 0.0, 0.0, 0.0, 0.0]
    }

    #[inline(always)]
    fn words([a, b, c, d, ..]: [f32; 8]) -> [f32; 4] {
        [a, b, c, d]
    }
}

/// The values of two halves. On a GPU it is one instruction, which may take a half below 2^-14 for 0, as its tensor core may.
#[inline(always)]
fn unpack(word: u32) -> Vec2 {
    #[cfg(target_arch = "spirv")]
    let values = spirv_std::float::f16x2_to_vec2(word);
    #[cfg(not(target_arch = "spirv"))]
    let values = crate::math::unpack_half_2x16(word);
    values
}

/// The word of two halves, whose values are exact.
#[inline(always)]
fn pack(low: f32, high: f32) -> u32 {
    #[cfg(target_arch = "spirv")]
    let word = spirv_std::float::vec2_to_f16x2(Vec2::new(low, high));
    #[cfg(not(target_arch = "spirv"))]
    let word = crate::math::pack_half_2x16(Vec2::new(low, high));
    word
}

/// A `for` loop over `0..$n`. A GPU gets it written out, so that the tile stays in registers, and nothing counts its rounds.
macro_rules! unrolled {
    ([$($at:literal)*] $i:ident < $n:expr, $body:expr) => {
        #[cfg(not(target_arch = "spirv"))]
        for $i in 0..$n {
            $body;
        }
        #[cfg(target_arch = "spirv")]
        {$(
            if const { $at < $n } {
                let $i: usize = $at;
                $body;
            }
        )*}
    };
    ($i:ident < $n:expr, $body:expr) => {
        unrolled!([0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15] $i < $n, $body)
    };
}

/// A matrix of `M` rows and `N` columns: a factor of halves, or `f32`.
#[derive(Clone, Copy)]
pub struct Tile<T: Element, const M: usize, const N: usize> {
    rows: [[T; N]; M],
}

macro_rules! loads {
    ($($(#[$doc:meta])* $name:ident[$($generics:tt)*]($memory:ty);)*) => {$(
        $(#[$doc])*
        /// It begins at the element `at`, and its rows are `stride` elements apart: both are multiples of 16 bytes.
        #[inline(always)]
        #[must_use]
        #[cfg_attr(not(target_arch = "spirv"), track_caller)]
        pub fn $name<$($generics)*>(memory: $memory, at: u32, stride: u32) -> Self {
            let [first, stride] = Self::words(at, stride);
            let mut rows = [[T::default(); N]; M];
            unrolled!(i < M, {
                unrolled!([0 1 2 3] four < N / T::FOUR, {
                    let word = first + i as u32 * stride + 4 * four as u32;
                    let words =
                        [memory.read(word), memory.read(word + 1), memory.read(word + 2), memory.read(word + 3)];
                    let values = T::values(words);
                    unrolled!([0 1 2 3 4 5 6 7] j < T::FOUR, rows[i][four * T::FOUR + j] = values[j]);
                });
            });
            Self { rows }
        }
    )*};
}

macro_rules! stores {
    ($($(#[$doc:meta])* $name:ident[$($generics:tt)*]($memory:ty);)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        #[cfg_attr(not(target_arch = "spirv"), track_caller)]
        pub fn $name<$($generics)*>(self, memory: $memory, at: u32, stride: u32) {
            let [first, stride] = Self::words(at, stride);
            unrolled!(i < M, {
                unrolled!([0 1 2 3] four < N / T::FOUR, {
                    let word = first + i as u32 * stride + 4 * four as u32;
                    let mut values = [T::default(); 8];
                    unrolled!([0 1 2 3 4 5 6 7] j < T::FOUR, values[j] = self.rows[i][four * T::FOUR + j]);
                    let [a, b, c, d] = T::words(values);
                    memory.write(word, a);
                    memory.write(word + 1, b);
                    memory.write(word + 2, c);
                    memory.write(word + 3, d);
                });
            });
        }
    )*};
}

impl<T: Element, const M: usize, const N: usize> Tile<T, M, N> {
    loads! {
        /// Loads a tile.
        load[](Read<T::Word>);
        /// Loads a tile from a buffer that is also written.
        load_written[](Write<T::Word>);
        /// Loads a tile from workgroup memory.
        load_shared[const LEN: usize](Shared<T::Word, LEN>);
    }

    stores! {
        /// Stores a tile: see [`load`](Self::load).
        store[](Write<T::Word>);
        /// Stores a tile in workgroup memory: see [`load`](Self::load).
        store_shared[const LEN: usize](Shared<T::Word, LEN>);
    }

    /// A tile's first word, and the words from row to row.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn words(at: u32, stride: u32) -> [u32; 2] {
        const {
            assert!(
                (M == 8 || M == 16) && (N == 8 || N == 16),
                "a tile has 8 or 16 rows, and so many columns"
            );
        }
        let four = T::FOUR as u32;
        #[cfg(not(target_arch = "spirv"))]
        assert!(
            at.is_multiple_of(four) && stride.is_multiple_of(four),
            "a tile begins at a multiple of {four} elements, and so do its rows: not at {at}, in rows of {stride}"
        );
        [at / four * 4, stride / four * 4]
    }
}

impl<const M: usize, const N: usize> Tile<f32, M, N> {
    /// A tile of zeros.
    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        Self { rows: [[0.0; N]; M] }
    }

    /// `self + left right`
    #[inline(always)]
    #[must_use]
    pub fn multiply_add<const K: usize>(
        mut self,
        left: Tile<Left, M, K>,
        right: Tile<Right, K, N>,
    ) -> Self {
        unrolled!(i < M, {
            let mut row = self.rows[i];
            unrolled!(k < K, row = add_scaled(row, left.rows[i][k].0, right.rows[k]));
            self.rows[i] = row;
        });
        self
    }
}

/// `row + a by`
#[inline(always)]
fn add_scaled<const N: usize>(mut row: [f32; N], a: f32, by: [Right; N]) -> [f32; N] {
    unrolled!(j < N, row[j] += a * by[j].0);
    row
}
