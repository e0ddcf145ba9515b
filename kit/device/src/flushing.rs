//! Denormals as a GPU may treat them: what is smaller than any normal number counts as zero.

/// While it lives, its thread flushes denormals to zero, where the CPU can do that.
pub struct Flushing {
    #[cfg(target_arch = "x86_64")]
    before: u32,
}

#[cfg(target_arch = "x86_64")]
impl Flushing {
    /// Bits of MXCSR: results are flushed, and denormal arguments are zeros.
    const BITS: u32 = 1 << 15 | 1 << 6;

    pub fn enable() -> Self {
        let mut before = 0_u32;
        // SAFETY: it writes to `before`
        unsafe { std::arch::asm!("stmxcsr [{}]", in(reg) &raw mut before) };
        Self::set(before | Self::BITS);
        Self { before }
    }

    fn set(bits: u32) {
        // SAFETY: The bits are those of the register, which has no others. Compilers compute constants without flushing: such a result
        // is that of the usual run, and then nothing is found.
        unsafe { std::arch::asm!("ldmxcsr [{}]", in(reg) &raw const bits) };
    }
}

#[cfg(target_arch = "x86_64")]
impl Drop for Flushing {
    fn drop(&mut self) {
        Self::set(self.before);
    }
}

#[cfg(not(target_arch = "x86_64"))]
impl Flushing {
    pub fn enable() -> Self {
        Self {}
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use std::hint::black_box;

    use super::*;

    #[test]
    fn a_denormal_is_zero_while_it_lives() {
        // functions that the compiler does not know keep it from moving arithmetic out of here: so do kernels
        let add: fn(f32, f32) -> f32 = black_box(|a, b| a + b);
        let multiply: fn(f32, f32) -> f32 = black_box(|a, b| a * b);
        let results = || [add(1e-40, 0.0), multiply(1e-30, 1e-10)];
        let usual = results();
        let flushing = Flushing::enable();
        let flushed = results();
        drop(flushing);
        assert!(usual.iter().all(|x| *x != 0.0));
        assert_eq!(flushed, [0.0; 2]);
        assert_eq!(results(), usual);
    }
}
