//! Eight lanes as instructions of AVX2, and sixteen as instructions of AVX-512.
//!
//! LLVM makes vectors of arrays by itself, but not well where a comparison decides: of eight lanes it computed the `exp` of four, then of two,
//! then of two more, and it put sixteen together anew in each round of a loop. The operations here belong to
//! [`Wide`](crate::lane::Wide), and have the same bits.
//!
//! # Safety
//! Of every function: `N` is the number of lanes, and the CPU has the instruction set, with FMA.

use core::arch::x86_64::*;
use core::mem::transmute_copy;

/// An array as a vector, or a vector as an array of the same size.
#[inline(always)]
unsafe fn cast<From: Copy, To: Copy>(from: From) -> To {
    // SAFETY: both are numbers of 32 bits
    unsafe { transmute_copy(&from) }
}

/// Functions of arrays, by functions of vectors.
macro_rules! by_vectors {
    ($vector:ty: $($(#[$doc:meta])* $name:ident($($x:ident: $from:ty),*) -> $to:ty => $value:expr;)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub unsafe fn $name<const N: usize>($($x: [$from; N]),*) -> [$to; N] {
            // SAFETY: the caller's
            unsafe {
                $(let $x: $vector = cast($x);)*
                cast($value)
            }
        }
    )*};
}

/// The factors of [`exp`](crate::lane::Lane::exp): 2^n as two powers, of a number that has n in its low bits.
macro_rules! powers {
    ($float:ty, $integer:ty: $left:ident, $right:ident, $add:ident, $sub:ident, $splat:ident) => {
        by_vectors! {
            $float:
            first_power(shifted: f32) -> f32 => power(half(exponent(shifted)));
            second_power(shifted: f32) -> f32 => {
                let whole = exponent(shifted);
                power($sub(whole, half(whole)))
            };
        }

        #[inline(always)]
        unsafe fn exponent(shifted: $float) -> $integer {
            // SAFETY: the caller's
            unsafe { $right::<9>($left::<9>(cast(shifted))) }
        }

        #[inline(always)]
        unsafe fn half(exponent: $integer) -> $integer {
            // SAFETY: the caller's
            unsafe { $right::<1>(exponent) }
        }

        #[inline(always)]
        unsafe fn power(exponent: $integer) -> $float {
            // SAFETY: the caller's
            unsafe { cast($left::<23>($add(exponent, $splat(127)))) }
        }
    };
}

/// Eight lanes. A mask is a vector whose lanes are all ones, or zero.
pub mod avx2 {
    use super::*;

    by_vectors! {
        __m256:
        add(a: f32, b: f32) -> f32 => _mm256_add_ps(a, b);
        sub(a: f32, b: f32) -> f32 => _mm256_sub_ps(a, b);
        mul(a: f32, b: f32) -> f32 => _mm256_mul_ps(a, b);
        div(a: f32, b: f32) -> f32 => _mm256_div_ps(a, b);
        neg(a: f32) -> f32 => _mm256_xor_ps(a, _mm256_set1_ps(-0.0));
        mul_add(a: f32, b: f32, c: f32) -> f32 => _mm256_fmadd_ps(a, b, c);
        // where one is no number, it is the second
        min(a: f32, b: f32) -> f32 => _mm256_min_ps(a, b);
        max(a: f32, b: f32) -> f32 => _mm256_max_ps(a, b);
        sqrt(a: f32) -> f32 => _mm256_sqrt_ps(a);
        less(a: f32, b: f32) -> u32 => _mm256_cmp_ps::<_CMP_LT_OQ>(a, b);
        less_equal(a: f32, b: f32) -> u32 => _mm256_cmp_ps::<_CMP_LE_OQ>(a, b);
        both(a: u32, b: u32) -> u32 => _mm256_and_ps(a, b);
        select(mask: u32, yes: f32, no: f32) -> f32 => {
            _mm256_or_ps(_mm256_and_ps(mask, yes), _mm256_andnot_ps(mask, no))
        };
        whole(a: f32) -> i32 => _mm256_cvttps_epi32(a);
        truncate(a: f32) -> f32 => _mm256_round_ps::<{ _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC }>(a);
    }

    #[inline(always)]
    pub unsafe fn any<const N: usize>(mask: [u32; N]) -> bool {
        // SAFETY: the caller's
        unsafe { _mm256_movemask_ps(cast(mask)) != 0 }
    }

    powers! {
        __m256, __m256i:
        _mm256_slli_epi32, _mm256_srai_epi32, _mm256_add_epi32, _mm256_sub_epi32, _mm256_set1_epi32
    }
}

/// Sixteen lanes. A mask in memory is as for eight lanes, and has a register of its own kind.
pub mod avx512 {
    use super::*;

    by_vectors! {
        __m512:
        add(a: f32, b: f32) -> f32 => _mm512_add_ps(a, b);
        sub(a: f32, b: f32) -> f32 => _mm512_sub_ps(a, b);
        mul(a: f32, b: f32) -> f32 => _mm512_mul_ps(a, b);
        div(a: f32, b: f32) -> f32 => _mm512_div_ps(a, b);
        neg(a: f32) -> f32 => _mm512_xor_ps(a, _mm512_set1_ps(-0.0));
        mul_add(a: f32, b: f32, c: f32) -> f32 => _mm512_fmadd_ps(a, b, c);
        min(a: f32, b: f32) -> f32 => _mm512_min_ps(a, b);
        max(a: f32, b: f32) -> f32 => _mm512_max_ps(a, b);
        sqrt(a: f32) -> f32 => _mm512_sqrt_ps(a);
        less(a: f32, b: f32) -> u32 => _mm512_movm_epi32(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b));
        less_equal(a: f32, b: f32) -> u32 => {
            _mm512_movm_epi32(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b))
        };
        both(a: u32, b: u32) -> u32 => _mm512_movm_epi32(mask(a) & mask(b));
        select(which: u32, yes: f32, no: f32) -> f32 => _mm512_mask_blend_ps(mask(which), no, yes);
        // p 2^n
        scale(p: f32, n: f32) -> f32 => _mm512_scalef_ps(p, n);
        whole(a: f32) -> i32 => _mm512_cvttps_epi32(a);
        truncate(a: f32) -> f32 => {
            _mm512_roundscale_ps::<{ _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC }>(a)
        };
    }

    by_vectors! {
        __m512i:
        bitxor(a: u32, b: u32) -> u32 => _mm512_xor_si512(a, b);
        bitand(a: u32, b: u32) -> u32 => _mm512_and_si512(a, b);
        wrapping_add(a: u32, b: u32) -> u32 => _mm512_add_epi32(a, b);
        wrapping_sub(a: u32, b: u32) -> u32 => _mm512_sub_epi32(a, b);
        wrapping_mul(a: u32, b: u32) -> u32 => _mm512_mullo_epi32(a, b);
        index_less(a: u32, b: u32) -> u32 => _mm512_movm_epi32(_mm512_cmplt_epu32_mask(a, b));
        index_select(which: u32, yes: u32, no: u32) -> u32 => {
            _mm512_mask_blend_epi32(_mm512_movepi32_mask(which), no, yes)
        };
    }

    #[inline(always)]
    pub unsafe fn any<const N: usize>(of: [u32; N]) -> bool {
        // SAFETY: the caller's
        unsafe { mask(cast(of)) != 0 }
    }

    #[inline(always)]
    unsafe fn mask(lanes: __m512) -> __mmask16 {
        // SAFETY: the caller's
        unsafe { _mm512_movepi32_mask(cast(lanes)) }
    }

    powers! {
        __m512, __m512i:
        _mm512_slli_epi32, _mm512_srai_epi32, _mm512_add_epi32, _mm512_sub_epi32, _mm512_set1_epi32
    }
}
