//! Matrices of a tensor core: a [`Tile`] is loaded, multiplied and stored as a whole.
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin::prelude::*;
//! use muslin::tile::{Left, Right, Tile};
//!
//! /// Parameters of [`turn`].
//! #[params]
//! pub struct TurnParams {
//!     /// Rows of eight halves, in eights.
//!     pub count: u32,
//! }
//!
//! /// `output [8 * count, 8] = left [8 * count, 8] right [8, 8]`
//! #[kernel(threads(64), tiles(8, 8, 8), over(params.count))]
//! pub fn turn(id: Invocation, params: &TurnParams, left: Read<u32>, right: Read<u32>, output: Write<f32>) {
//!     if id.index() < params.count {
//!         let at = 64 * id.index();
//!         let a = Tile::<Left, 8, 8>::load(left, at, 8);
//!         let b = Tile::<Right, 8, 8>::load(right, 0, 8);
//!         Tile::<f32, 8, 8>::zero().multiply_add(a, b).store(output, at, 8);
//!     }
//! }
//! # fn main() {}
//! ```
//!
//! A kernel declares the shape of its products, `tiles(M, N, K)`. In the plain entry point and on the CPU, each invocation computes its tiles with
//! ordinary arithmetic. In the variant, `NAME_tiles`, a whole subgroup is one invocation: it has one `id`, and its lanes share each tile. So `id.size.x`
//! and `id.local.x` differ between the two, and a kernel takes any size. It stores tiles alone: each lane would do a write or an atomic, and the builder
//! refuses those.
//!
//! Halves lie in words, the first in the lower bits. The product of two halves is exact. Sums are `f32`, in any order. A tensor core may round them
//! toward zero, and take a half below 2^-14 for 0. A parity case allows the first: `Rounded::sum` has three halves of a unit for each addition.
//!
//! A side is 8 or 16. The shapes that a device offers are `Device::tiles()` of `muslin-device`; with another one, it runs the plain entry point.

// the capability of the second compilation, which rustc does not know
#![allow(unexpected_cfgs)]

#[cfg(all(target_arch = "spirv", target_feature = "CooperativeMatrixKHR"))]
mod cooperative;
mod factor;
#[cfg(not(all(target_arch = "spirv", target_feature = "CooperativeMatrixKHR")))]
mod plain;

#[cfg(all(target_arch = "spirv", target_feature = "CooperativeMatrixKHR"))]
pub use cooperative::{Element, Tile};
#[cfg(not(all(target_arch = "spirv", target_feature = "CooperativeMatrixKHR")))]
pub use plain::{Element, Tile};

pub use factor::{Left, Right};

/// Chooses the entry point of this compilation: the variant with tiles, or the plain one.
#[doc(hidden)]
#[macro_export]
#[cfg(all(target_arch = "spirv", target_feature = "CooperativeMatrixKHR"))]
macro_rules! tile_entry {
    ({ $($plain:tt)* } { $($variant:tt)* }) => { $($variant)* };
}
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(target_arch = "spirv", target_feature = "CooperativeMatrixKHR")))]
macro_rules! tile_entry {
    ({ $($plain:tt)* } { $($variant:tt)* }) => { $($plain)* };
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::half::half_bits;
    use crate::memory::{Read, Write};
    use std::vec::Vec;

    /// The product of small whole numbers is exact, at any place, from a buffer with longer rows.
    #[test]
    fn products_are_those_of_matrices() {
        fn check<const M: usize, const N: usize, const K: usize>() {
            let number = |row: usize, column: usize| ((7 * row + 3 * column) % 19) as f32 - 9.0;
            let stride = 24;
            let halves = |rows: usize| -> Vec<u32> {
                let bits = |at: usize| half_bits(number(at / stride, at % stride));
                (0..rows * stride / 2).map(|at| bits(2 * at) | bits(2 * at + 1) << 16).collect()
            };
            let [left, right] = [halves(M + 1), halves(K + 1)];
            let [left, right] = [&left, &right].map(|all| Read::from(&all[..]));
            let first = stride as u32 + 8;
            let mut output = std::vec![1.0; (M + 1) * stride];
            let view = Write::from(&mut output[..]);
            let sum = Tile::<f32, M, N>::load_written(view, 4, stride as u32);
            let sum = sum.multiply_add(
                Tile::<Left, M, K>::load(left, first, stride as u32),
                Tile::<Right, K, N>::load(right, first, stride as u32),
            );
            sum.store(view, 4, stride as u32);
            for (at, found) in output.into_iter().enumerate() {
                let [row, column] = [at / stride, at % stride];
                let product = |k| number(row + 1, k + 8) * number(k + 1, column + 4);
                let is_inside = row < M && (4..4 + N).contains(&column);
                let exact: f32 = if is_inside { (0..K).map(product).sum() } else { 0.0 };
                assert_eq!(found, 1.0 + exact, "{M} x {N} x {K}: {row}, {column}");
            }
        }
        check::<8, 8, 8>();
        check::<16, 8, 16>();
        check::<8, 16, 8>();
        check::<16, 16, 16>();
    }

    #[test]
    #[should_panic = "a tile begins at a multiple of 8 elements, and so do its rows: not at 4, in rows of 8"]
    fn a_tile_begins_at_16_bytes() {
        let _ = Tile::<Left, 8, 8>::load(Read::from(&[0; 64][..]), 4, 8);
    }
}
