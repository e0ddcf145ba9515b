//! Integers and truth values in lanes on the CPU.

use core::ops::{BitAnd, BitXor};

use crate::lane::LaneIndex;

/// `N` truth values: all bits of a lane are set, or none.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct WideMask<const N: usize>(pub [u32; N]);

/// `N` integers.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct WideIndex<const N: usize>(pub [u32; N]);

impl<const N: usize> BitXor for WideIndex<N> {
    type Output = Self;

    #[inline(always)]
    fn bitxor(self, other: Self) -> Self {
        Self(sixteen!(bitxor(self.0, other.0), lanes!(|i| self.0[i] ^ other.0[i])))
    }
}

impl<const N: usize> BitAnd for WideIndex<N> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(sixteen!(bitand(self.0, other.0), lanes!(|i| self.0[i] & other.0[i])))
    }
}

impl<const N: usize> LaneIndex for WideIndex<N> {
    type Mask = WideMask<N>;

    #[inline(always)]
    fn splat(value: u32) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn wrapping_add(self, other: Self) -> Self {
        let sum =
            sixteen!(wrapping_add(self.0, other.0), lanes!(|i| self.0[i].wrapping_add(other.0[i])));
        Self(sum)
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        let difference =
            sixteen!(wrapping_sub(self.0, other.0), lanes!(|i| self.0[i].wrapping_sub(other.0[i])));
        Self(difference)
    }

    #[inline(always)]
    fn wrapping_mul(self, other: Self) -> Self {
        let product =
            sixteen!(wrapping_mul(self.0, other.0), lanes!(|i| self.0[i].wrapping_mul(other.0[i])));
        Self(product)
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        WideMask(sixteen!(index_less(self.0, other.0), mask!(|i| self.0[i] < other.0[i])))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let chosen = sixteen!(
            index_select(mask.0, yes.0, no.0),
            lanes!(|i| if mask.0[i] != 0 { yes.0[i] } else { no.0[i] })
        );
        Self(chosen)
    }

    #[inline(always)]
    fn lane(self, lane: u32) -> u32 {
        self.0[lane as usize]
    }
}
