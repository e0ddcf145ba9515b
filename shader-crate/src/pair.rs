//! The (Gaussian, camera) pairs that some tile needs: color and transmittance are evaluated only for these.

use glam::Vec4;

use crate::limits::{MAX_CAMERAS, MAX_TILES};
use muslin::prelude::*;

/// Parameters of [`pair_mask`].
#[params]
pub struct PairMaskParams {
    /// Words of a mask.
    pub words: u32,
}

/// The union of the masks of a camera's tiles, `mask [cameras, words]`, and how many bits each word has, `count [cameras, words]`:
/// words along x and y, cameras along z. The tiles of camera c are `first_tile[c] .. first_tile[c + 1]`.
#[kernel(threads(64), over(params.words, first_tile.len() - 1), iterations = MAX_TILES)]
pub fn pair_mask(
    id: Invocation,
    params: &PairMaskParams,
    first_tile: Read<u32>,
    tile_mask: Read<u32>,
    mask: Write<u32>,
    count: Write<u32>,
) {
    let word = id.index();
    if word < params.words {
        let camera = id.workgroup.z;
        let end = first_tile.read(camera + 1);
        let mut tile = first_tile.read(camera);
        let mut bits = 0;
        while tile < end {
            bits |= tile_mask.read(tile * params.words + word);
            tile += 1;
        }
        mask.write(camera * params.words + word, bits);
        count.write(camera * params.words + word, bits.count_ones());
    }
}

/// Parameters of [`pair_fill`].
#[params]
pub struct PairFillParams {
    /// Words of a mask.
    pub words: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
}

/// Writes the slot of each pair, `pair [pairs] = camera * gaussians + gaussian`, in ascending order.
#[kernel(threads(64), over(params.words, mask.len() / params.words.max(1)), iterations = u32::BITS)]
pub fn pair_fill(
    id: Invocation,
    params: &PairFillParams,
    mask: Read<u32>,
    first_pair: Read<u32>,
    pair: Write<u32>,
) {
    let word = id.index();
    if word < params.words {
        let camera = id.workgroup.z;
        let bits = mask.read(camera * params.words + word);
        let mut next = first_pair.read(camera * params.words + word);
        let mut bit = 0;
        while bit < 32 {
            if (bits >> bit) & 1 != 0 {
                pair.write(next, camera * params.gaussians + word * 32 + bit);
                next += 1;
            }
            bit += 1;
        }
    }
}

/// Parameters of [`pair_sum`].
#[params]
pub struct PairSumParams {
    /// Words of a mask.
    pub words: u32,
    /// The first camera.
    pub first_camera: u32,
    /// Cameras from there on.
    pub cameras: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Values of a vector.
    pub width: u32,
}

/// Values of a vector that one invocation of [`pair_sum`] adds up.
const VALUES_PER_INVOCATION: u32 = 4;

/// Adds the vectors of a Gaussian's pairs in some of the cameras to its own, one after the other. The vectors are gradients of what all
/// cameras share: the material of Eq. 1, the extra vector of Eq. 9 and the slope of Eq. 17.
///
/// `mask` and `first_pair [cameras, words]`, `pair_vector [pairs, width]`, `vector [gaussians, width]`.
///
/// An invocation sums four values of a Gaussian.
#[kernel(threads(64), over(params.gaussians * params.width.div_ceil(VALUES_PER_INVOCATION)), iterations = MAX_CAMERAS)]
pub fn pair_sum(
    id: Invocation,
    params: &PairSumParams,
    mask: Read<u32>,
    first_pair: Read<u32>,
    pair_vector: Read<f32>,
    vector: Write<f32>,
) {
    let index = id.index();
    let width = params.width;
    let groups = width.div_ceil(VALUES_PER_INVOCATION);
    if index < params.gaussians * groups {
        let gaussian = index / groups;
        let value = index % groups * VALUES_PER_INVOCATION;
        let second = value + 1 < width;
        let third = value + 2 < width;
        let fourth = value + 3 < width;
        let bit = gaussian % 32;
        let mut at = params.first_camera * params.words + gaussian / 32;
        let to = gaussian * width + value;
        let mut sum = Vec4::new(vector.read(to), 0.0, 0.0, 0.0);
        if second {
            sum.y = vector.read(to + 1);
        }
        if third {
            sum.z = vector.read(to + 2);
        }
        if fourth {
            sum.w = vector.read(to + 3);
        }
        let mut camera = 0;
        while camera < params.cameras {
            let bits = mask.read(at);
            if (bits >> bit) & 1 != 0 {
                let pair = first_pair.read(at) + (bits & ((1 << bit) - 1)).count_ones();
                let from = pair * width + value;
                sum.x += pair_vector.read(from);
                if second {
                    sum.y += pair_vector.read(from + 1);
                }
                if third {
                    sum.z += pair_vector.read(from + 2);
                }
                if fourth {
                    sum.w += pair_vector.read(from + 3);
                }
            }
            at += params.words;
            camera += 1;
        }
        vector.write(to, sum.x);
        if second {
            vector.write(to + 1, sum.y);
        }
        if third {
            vector.write(to + 2, sum.z);
        }
        if fourth {
            vector.write(to + 3, sum.w);
        }
    }
}
