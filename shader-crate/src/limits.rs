//! Size limits: the host checks scenes and batches against them, and they bound the kernels' loops.

pub use muslin::MAX_ITERATIONS;

/// The highest degree of the spherical harmonics.
pub const MAX_SH_DEGREE: u32 = 7;

/// The longest material or extra vector of a Gaussian.
pub const MAX_VECTOR: u32 = 256;

/// The widest hidden layer.
pub const MAX_HIDDEN_WIDTH: u32 = 128;

/// Largest number of layers of a network, including the last one.
pub const MAX_LAYERS: u32 = 5;

/// Largest number of levels of a grid.
pub const MAX_LEVELS: u32 = 32;

/// Largest number of features of a level.
pub const MAX_FEATURES: u32 = 8;

/// Largest number of samples of a segment. A scene's step must be so long that the diagonal of the unit cube has no more.
pub const MAX_SAMPLES: u32 = 16_384;

/// Intersections that one dispatch of [`composite`](crate::composite::composite) adds up; a fuller tile takes more passes.
pub const MAX_INTERSECTIONS: u32 = 16_384;

/// Tiles of one part of a batch: [`pair_mask`](crate::pair::pair_mask) loops over a camera's tiles.
pub const MAX_TILES: u32 = 16_384;

/// Largest number of values of a sample in the color network's input, the wider of the two (Eq. 1).
pub const MAX_INPUTS: u32 =
    (MAX_SH_DEGREE + 1) * (MAX_SH_DEGREE + 1) + MAX_LEVELS * MAX_FEATURES + MAX_VECTOR;

/// The largest side of a tile, in pixels: [`loss_rows`](crate::loss::loss_rows) loops over a row.
pub const MAX_TILE_SIDE: u32 = 4_096;

/// Steps over pixels and rows that one invocation of
/// [`composite_backward`](crate::composite_backward::composite_backward) takes; a larger tile takes more passes.
pub const MAX_BAND: u32 = 57_600;

/// Cameras of one part of a batch: [`project_backward`](crate::project_backward::project_backward) loops over them.
pub const MAX_CAMERAS: u32 = 4_096;

/// Photographs whose exposures are learned: [`exposure_center`](crate::exposure::exposure_center) loops over them.
pub const MAX_PHOTOGRAPHS: u32 = 30_000;

/// Samples of a slice that one invocation of
/// [`dense_weight_backward`](crate::dense_weight_backward::dense_weight_backward) adds up.
pub const MAX_SLICE: u32 = 4_096;
