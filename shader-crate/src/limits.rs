//! How large things may be: the host holds scenes and batches to it, and no kernel loops longer.

/// Iterations of all loops of one invocation together: llvmpipe ends it silently after 65,536.
pub const MAX_ITERATIONS: u32 = 60_000;

/// The highest degree of the spherical harmonics.
pub const MAX_SH_DEGREE: u32 = 7;

/// The longest material or extra vector a Gaussian may carry.
pub const MAX_VECTOR: u32 = 256;

/// The widest a hidden layer may be.
pub const MAX_HIDDEN_WIDTH: u32 = 128;

/// The most levels a grid may have.
pub const MAX_LEVELS: u32 = 32;

/// The most features a level may have.
pub const MAX_FEATURES: u32 = 8;

/// Largest number of samples of a segment, and of one across the whole unit cube.
pub const MAX_SAMPLES: u32 = 16_384;

/// Members that one dispatch of [`composite`](crate::composite::composite) adds up; a fuller tile takes more passes.
pub const MAX_MEMBERS: u32 = 16_384;

/// Tiles of one part of a batch: [`pair_mask`](crate::pair::pair_mask) loops over those of a camera.
pub const MAX_TILES: u32 = 16_384;

/// The most values a sample may have in the color network's input, the wider of the two (Eq. 1).
pub const MAX_INPUTS: u32 =
    (MAX_SH_DEGREE + 1) * (MAX_SH_DEGREE + 1) + MAX_LEVELS * MAX_FEATURES + MAX_VECTOR;
