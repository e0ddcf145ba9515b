//! B3 and C: the weighted sums of all tiles, and the image.

use glam::Vec4;
use organza_kernels::composite::{CompositeKernel, CompositeParams, ResolveKernel, ResolveParams};
use organza_kernels::limits::MAX_MEMBERS;
use organza_kernels::splat::{SplatKernel, SplatParams, VECTORS};

use super::DeviceScene;
use super::bin::Bins;
use crate::backend::{Buffer, Device};
use crate::error::Result;

/// The composited tiles of a part.
#[derive(Debug)]
pub struct Composite {
    /// `[tiles, S, S]`: C and S of Eq. 12.
    pub sum: Buffer<Vec4>,
    /// `[tiles, 3, S, S]`
    pub image: Buffer<f32>,
    /// `[pairs, 3]`
    pub splat: Buffer<Vec4>,
}

impl Composite {
    pub fn new(
        device: &Device,
        scene: &DeviceScene,
        side: u32,
        bins: &Bins,
        transmittance: &Buffer<f32>,
        color: &Buffer<f32>,
    ) -> Result<Self> {
        let pairs = &bins.pairs;
        let splat = device.zeros("splats", (pairs.count * VECTORS) as usize)?;
        let kernel = SplatKernel {
            params: SplatParams { pairs: pairs.count, gaussians: scene.gaussians },
            pair: &pairs.pair,
            projection: &pairs.projection,
            opacity: &scene.opacity,
            transmittance,
            color,
            splat: &splat,
        };
        device.run(&kernel, pairs.count, 1)?;

        let tiles = bins.first.len() - 1;
        let pixels = tiles * (side * side) as usize;
        let sum = device.zeros("sums", pixels)?;
        let groups = side.div_ceil(8);
        for pass in 0..bins.largest().div_ceil(MAX_MEMBERS) {
            let kernel = CompositeKernel {
                params: CompositeParams { side, skip: pass * MAX_MEMBERS },
                tile: &bins.tile,
                tile_first: &bins.tile_first,
                member: &bins.member,
                splat: &splat,
                sum: &sum,
            };
            device.dispatch(&kernel, [groups, groups, tiles as u32])?;
        }

        let image = device.zeros("tiles", pixels * 3)?;
        let [background_r, background_g, background_b] =
            scene.config.background.map(|channel| channel as f32);
        let kernel = ResolveKernel {
            params: ResolveParams { side, background_r, background_g, background_b },
            tile: &bins.tile,
            sum: &sum,
            image: &image,
        };
        device.dispatch(&kernel, [groups, groups, tiles as u32])?;
        Ok(Self { sum, image, splat })
    }
}
