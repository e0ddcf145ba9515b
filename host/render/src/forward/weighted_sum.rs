//! Eq. 12: the weighted sums of all pixels.

use glam::Vec4;
use organza_shaders::composite::{CompositeKernel, CompositeParams, SUM_PLANES};
use organza_shaders::limits::MAX_MEMBERS;
use organza_shaders::splat::{SplatKernel, SplatParams, VECTORS};
use organza_shaders::tile_cells::{TileCellsKernel, TileCellsParams};

use super::bin::Bins;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Result};

/// The sums of Eq. 12, `[tiles, 4, S, S]`, of any three values of each pair, `color [pairs, 3]`; and the splats that they
/// are the sums of.
pub fn weighted_sum(
    scene: &DeviceScene,
    side: u32,
    bins: &Bins,
    transmittance: &Buffer<f32>,
    color: &Buffer<f32>,
) -> Result<(Buffer<f32>, Buffer<Vec4>)> {
    let device = scene.device();
    let pairs = &bins.pairs;
    let capacity = pairs.count.upper_bound();
    let splat = device.unwritten("splats", (capacity * VECTORS) as usize)?;
    let kernel = SplatKernel {
        params: SplatParams {
            pairs: capacity,
            gaussians: scene.gaussians,
            compensated_blur: scene.compensated_blur(),
        },
        pair: &pairs.pair,
        projection: &pairs.projection,
        opacity: &scene.tensors.gaussians.opacity,
        transmittance,
        color,
        splat: &splat,
    };
    device.run(&kernel.counted(&pairs.count), capacity, 1)?;

    let tiles = bins.tiles;
    let members = bins.members.upper_bound();
    let cells = device.unwritten("cells", members as usize)?;
    let kernel = TileCellsKernel {
        params: TileCellsParams { members, tiles, side },
        tile: &bins.tile,
        tile_first: &bins.tile_first,
        member: &bins.member,
        splat: &splat,
        cells: &cells,
    };
    device.run(&kernel.counted(&bins.members), members, 1)?;

    let pixels = tiles as usize * (side * side) as usize;
    let sum = device.zeros("sums", pixels * SUM_PLANES as usize)?;
    for pass in 0..bins.largest.div_ceil(MAX_MEMBERS) {
        let kernel = CompositeKernel {
            params: CompositeParams { side, skip: pass * MAX_MEMBERS },
            tile: &bins.tile,
            tile_first: &bins.tile_first,
            member: &bins.member,
            cells: &cells,
            splat: &splat,
            sum: &sum,
        };
        device.run_over(&kernel, [side, side, tiles])?;
    }
    Ok((sum, splat))
}
