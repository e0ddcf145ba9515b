//! What the lanes of a CPU are written with.

/// An array of what an expression gives for each lane.
macro_rules! lanes {
    (|$lane:ident| $value:expr) => {
        core::array::from_fn(
            #[inline(always)]
            |$lane| $value,
        )
    };
}

/// The mask of a condition of each lane.
macro_rules! mask {
    (|$lane:ident| $value:expr) => {
        lanes!(|$lane| if $value { u32::MAX } else { 0 })
    };
}

/// What an operation on arrays gives, by the instructions for as many lanes where there are some.
macro_rules! vectors {
    ($name:ident($($x:expr),*), $array:expr) => {{
        #[cfg(target_arch = "x86_64")]
        match (N, FUSED) {
            // SAFETY: these lanes belong to the run of a CPU with AVX2 and FMA
            (8, true) => unsafe { $crate::wide_vectors::avx2::$name::<N>($($x),*) },
            // SAFETY: and these to the run of a CPU with AVX-512
            (16, true) => unsafe { $crate::wide_vectors::avx512::$name::<N>($($x),*) },
            _ => $array,
        }
        #[cfg(not(target_arch = "x86_64"))]
        $array
    }};
}

/// As [`vectors`], for sixteen lanes alone: integers as vectors made the hash grid twice as slow with AVX2.
macro_rules! sixteen {
    ($name:ident($($x:expr),*), $array:expr) => {{
        #[cfg(target_arch = "x86_64")]
        match N {
            // SAFETY: these lanes belong to the run of a CPU with AVX-512
            16 => unsafe { $crate::wide_vectors::avx512::$name::<N>($($x),*) },
            _ => $array,
        }
        #[cfg(not(target_arch = "x86_64"))]
        $array
    }};
}
