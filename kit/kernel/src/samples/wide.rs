//! Samples on the CPU: several vectors of lanes.
//!
//! A layer of one vector reads a weight for each multiply-add, and CPUs have as many units for one as for the other. With several
//! vectors, a weight serves all of them.

use crate::lane::{Lane, Wide};
use crate::memory::{ReadFours, WriteFours};
use crate::samples::Samples;

/// `K` vectors of `N` lanes.
#[derive(Clone, Copy)]
pub struct Vectors<const N: usize, const FUSED: bool, const K: usize>([Wide<N, FUSED>; K]);

impl<const N: usize, const FUSED: bool, const K: usize> Samples for Vectors<N, FUSED, K> {
    const WIDTH: u32 = (N * K) as u32;
    // a single lane runs what a GPU runs
    const COLUMNS: u32 = if N == 1 { 4 } else { 1 };

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([Lane::splat(value); K])
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(lanes!(|i| Lane::mul_add(self.0[i], a.0[i], b.0[i])))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(lanes!(|i| Lane::max(self.0[i], other.0[i])))
    }

    #[inline(always)]
    fn where_positive(self, x: Self) -> Self {
        Self(lanes!(|i| self.0[i].where_positive(x.0[i])))
    }

    #[inline(always)]
    #[track_caller]
    fn read(buffer: ReadFours<f32>, first: u32) -> Self {
        Self(buffer.read_vectors(first).map(Wide))
    }

    #[inline(always)]
    #[track_caller]
    fn write(self, buffer: WriteFours<f32>, first: u32, count: u32) {
        debug_assert!(count >= Self::WIDTH, "{count} samples for {} lanes", Self::WIDTH);
        let mut i = 0;
        while i < K {
            Lane::write(self.0[i], buffer, first + (i * N) as u32);
            i += 1;
        }
    }
}
