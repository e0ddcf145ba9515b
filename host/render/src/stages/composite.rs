//! Stages B3 and C: the weighted sums of all tiles, and the image.

use glam::Vec4;
use organza_shaders::composite::{CompositeKernel, CompositeParams, SUM_PLANES};
use organza_shaders::composite_backward::{
    CompositeBackwardKernel, CompositeBackwardParams, band_rows,
};
use organza_shaders::limits::MAX_INTERSECTIONS;
use organza_shaders::pixels::{PixelsKernel, PixelsParams};
use organza_shaders::resolve::{ResolveBackwardKernel, ResolveKernel, ResolveParams};
use organza_shaders::slope::{
    SLOPE_GRADIENT_VECTORS, SLOPE_VECTORS, SlopeBackwardKernel, SlopeKernel, SlopeParams,
};
use organza_shaders::splat::{
    SplatBackwardKernel, SplatBackwardParams, SplatKernel, SplatParams, VECTORS,
};
use organza_shaders::tile_cells::{TileCellsKernel, TileCellsParams};

use super::cut::words;
use super::pairs::PairVectors;
use super::tiles::TileBins;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Device, Error, Result};

/// The pairs of a part, and the tiles that show them.
#[derive(Clone, Copy)]
pub struct TileContext<'a> {
    pub scene: &'a DeviceScene,
    pub bins: &'a TileBins,
    /// `[pairs]`
    pub transmittance: &'a Buffer<f32>,
    /// `[pairs, 3]`
    pub color: &'a Buffer<f32>,
}

/// The pairs of another scene that is [shown with](DeviceScene::put) the first one, for a part's tiles. T is the product over the fields
/// of all scenes.
#[derive(Debug)]
pub struct OtherScene {
    pub bins: TileBins,
    pub transmittance: Buffer<f32>,
    pub color: Buffer<f32>,
}

impl<'a> TileContext<'a> {
    /// This scene, and the others that are [shown with](DeviceScene::put) it.
    pub fn all(self, beside: &'a [OtherScene]) -> Vec<Self> {
        let others = self.scene.beside.iter().zip(beside);
        let others = others.map(|(scene, OtherScene { bins, transmittance, color })| Self {
            scene,
            bins,
            transmittance,
            color,
        });
        std::iter::once(self).chain(others).collect()
    }
}

/// The composited tiles of a part.
#[derive(Debug)]
pub struct Composite {
    /// `[tiles, 4, S, S]`: C and S of Eq. 12.
    pub sum: Buffer<f32>,
    /// `[tiles, 3, S, S]`
    pub image: Buffer<f32>,
    /// `[pairs, 3]`
    pub splat: Buffer<Vec4>,
    /// The splats of the other scenes.
    pub others: Vec<Buffer<Vec4>>,
    /// `[pairs, 4]`, of the first scene: see [`slope`](organza_shaders::slope). `None` where colors do not vary.
    pub slope: Option<Buffer<Vec4>>,
}

/// The gradients of a part's pairs.
#[derive(Debug)]
pub struct PairGradients {
    /// `[pairs, 3]`: see [`splat_backward`](organza_shaders::splat).
    pub splat: Buffer<Vec4>,
    /// `[pairs, 9]`: of the Gaussians' slopes; `None` where colors do not vary.
    pub slope: Option<PairVectors>,
}

impl Composite {
    /// Eq. 12 and 13, of one scene or several. [`Self::splat`] has the first scene's splats.
    pub fn new(contexts: &[TileContext<'_>], background: [f64; 3]) -> Result<Self> {
        let TileContext { scene, bins, color, .. } = contexts[0];
        let device = scene.device();
        let side = bins.side;
        let pixels = bins.tiles as usize * (side * side) as usize;
        let sum = device.zeros("sums", pixels * SUM_PLANES as usize)?;
        let slope = slopes(contexts[0])?;
        let splat = add_sloped(contexts[0], color, slope.as_ref(), &sum)?;
        let others = contexts[1..]
            .iter()
            .map(|other| add_sloped(*other, other.color, slopes(*other)?.as_ref(), &sum));
        let others = others.collect::<Result<_>>()?;
        let image = device.unwritten("tiles", 3 * pixels)?;
        let kernel = ResolveKernel {
            params: resolve_params(background, scene.divide_above, side),
            tile: &bins.tile,
            sum: &sum,
            image: &image,
        };
        device.run_all(&kernel)?;
        Ok(Self { sum, image, splat, others, slope })
    }

    /// How the colors of the first scene's pairs grow along x and y; empty where they do not vary.
    pub fn read_slopes(&self, device: &Device) -> Result<Vec<[Vec4; 2]>> {
        let Some(slope) = &self.slope else { return Ok(Vec::new()) };
        let slopes = device.read(slope)?;
        Ok(slopes.chunks_exact(SLOPE_VECTORS as usize).map(|of| [of[0], of[1]]).collect())
    }

    /// The gradients of the pairs, given dL/dY `[tiles, 3, S, S]`.
    pub fn backward(
        &self,
        context: TileContext<'_>,
        d_tiles: &Buffer<f32>,
    ) -> Result<PairGradients> {
        let TileContext { scene, bins, transmittance, .. } = context;
        let device = scene.device();
        let side = bins.side;
        let sum_gradient = device.unwritten("gradient of the sums", self.sum.len())?;
        let kernel = ResolveBackwardKernel {
            params: resolve_params(scene.config.background, scene.divide_above, side),
            tile: &bins.tile,
            sum: &self.sum,
            image_gradient: d_tiles,
            sum_gradient: &sum_gradient,
        };
        device.run_all(&kernel)?;
        let (intersection_gradient, intersection_slope) =
            self.intersections_gradient(context, &sum_gradient)?;
        let pairs = &bins.pairs;
        let capacity = pairs.count.upper_bound();
        let pair_gradient =
            device.unwritten("gradient of the pairs", (capacity * VECTORS) as usize)?;
        let params = SplatBackwardParams {
            pairs: capacity,
            gaussians: scene.gaussians,
            words: words(scene.gaussians),
        };
        let kernel = SplatBackwardKernel {
            params,
            pair: &pairs.pair,
            first_tile: &bins.first_tile,
            tile_mask: &bins.tile_mask.bits,
            first_intersection: &bins.tile_mask.first,
            opacity: &scene.tensors.gaussians.opacity,
            transmittance,
            intersection_gradient: &intersection_gradient,
            pair_gradient: &pair_gradient,
        };
        device.run_all(&kernel.counted(&pairs.count))?;
        let Some(pair_slope) = &self.slope else {
            return Ok(PairGradients { splat: pair_gradient, slope: None });
        };
        let width = scene.config.slope;
        let slope_gradient =
            device.unwritten("gradient of the pairs' slopes", (capacity * width) as usize)?;
        let kernel = SlopeBackwardKernel {
            params,
            pair: &pairs.pair,
            first_tile: &bins.first_tile,
            tile_mask: &bins.tile_mask.bits,
            first_intersection: &bins.tile_mask.first,
            pair_slope,
            intersection_slope: &intersection_slope,
            slope_gradient: &slope_gradient,
        };
        device.run_all(&kernel.counted(&pairs.count))?;
        let slope = Some(PairVectors { values: slope_gradient, width });
        Ok(PairGradients { splat: pair_gradient, slope })
    }

    /// The gradient of each tile's intersections, `[intersections, 3]`, and of their slopes `[intersections, 2]`, summed over its pixels, in
    /// bands of rows if a tile is large.
    fn intersections_gradient(
        &self,
        TileContext { scene, bins, .. }: TileContext<'_>,
        sum_gradient: &Buffer<f32>,
    ) -> Result<(Buffer<Vec4>, Buffer<Vec4>)> {
        let intersections = bins.intersections.upper_bound();
        let bytes = u64::from(intersections) * u64::from(VECTORS) * size_of::<Vec4>() as u64;
        // kernels number the vectors in 32 bits
        if intersections > u32::MAX / VECTORS {
            let what = format!("the gradients of {intersections} intersections");
            return Err(Error::OutOfMemory { needed: bytes, available: None, what });
        }
        let device = scene.device();
        let len = (intersections * VECTORS) as usize;
        let intersection_gradient = device.zeros("gradient of the intersections", len)?;
        let sloped = u32::from(self.slope.is_some());
        let len = (intersections * SLOPE_GRADIENT_VECTORS * sloped).max(1);
        let intersection_slope =
            device.zeros("gradient of the intersections' slopes", len as usize)?;
        let side = bins.side;
        let band = band_rows(side);
        for first_row in (0..side).step_by(band as usize) {
            let kernel = CompositeBackwardKernel {
                params: CompositeBackwardParams {
                    intersections,
                    tiles: bins.tiles,
                    side,
                    first_row,
                    rows: band.min(side - first_row),
                    compensated_blur: scene.compensated_blur(),
                    sloped,
                    shaped: scene.config.shape,
                },
                tile: &bins.tile,
                tile_first: &bins.tile_first,
                intersection: &bins.intersection,
                splat: &self.splat,
                // every binding needs a buffer, even if the kernel does not read it
                slope: self.slope.as_ref().unwrap_or(&self.splat),
                sum_gradient,
                intersection_gradient: &intersection_gradient,
                intersection_slope: &intersection_slope,
            };
            device.run_all(&kernel.counted(&bins.intersections))?;
        }
        Ok((intersection_gradient, intersection_slope))
    }
}

/// Composites any three values per pair, `color [pairs, 3]`, by Eq. 12. Returns the sums `[tiles, 4, S, S]` and the splats
/// `[pairs, 3]`.
pub fn weighted_sum(
    context: TileContext<'_>,
    color: &Buffer<f32>,
) -> Result<(Buffer<f32>, Buffer<Vec4>)> {
    let TileBins { side, tiles, .. } = *context.bins;
    let pixels = tiles as usize * (side * side) as usize;
    let sum = context.scene.device().zeros("sums", pixels * SUM_PLANES as usize)?;
    let splat = add_weighted(context, color, &sum)?;
    Ok((sum, splat))
}

/// How the colors of the pairs vary, `[pairs, 4]`; `None` if they do not.
fn slopes(TileContext { scene, bins, .. }: TileContext<'_>) -> Result<Option<Buffer<Vec4>>> {
    if scene.config.slope == 0 {
        return Ok(None);
    }
    let pairs = &bins.pairs;
    let capacity = pairs.count.upper_bound();
    let pair_slope = scene.device().unwritten("slopes", (capacity * SLOPE_VECTORS) as usize)?;
    let gaussians = &scene.tensors.gaussians;
    let kernel = SlopeKernel {
        params: SlopeParams { pairs: capacity, gaussians: scene.gaussians },
        pair: &pairs.pair,
        camera: &pairs.camera,
        position: &gaussians.position,
        rotation: &gaussians.rotation,
        log_scale: &gaussians.log_scale,
        projection: &pairs.projection,
        slope: &gaussians.slope,
        pair_slope: &pair_slope,
    };
    scene.device().run_all(&kernel.counted(&pairs.count))?;
    Ok(Some(pair_slope))
}

/// Adds to the sums of [`weighted_sum`]. Returns the splats.
pub fn add_weighted(
    context: TileContext<'_>,
    color: &Buffer<f32>,
    sum: &Buffer<f32>,
) -> Result<Buffer<Vec4>> {
    add_sloped(context, color, None, sum)
}

/// [`add_weighted`] for values that vary by [`slopes`].
fn add_sloped(
    TileContext { scene, bins, transmittance, .. }: TileContext<'_>,
    color: &Buffer<f32>,
    slope: Option<&Buffer<Vec4>>,
    sum: &Buffer<f32>,
) -> Result<Buffer<Vec4>> {
    let device = scene.device();
    let side = bins.side;
    let pairs = &bins.pairs;
    let capacity = pairs.count.upper_bound();
    let splat = device.unwritten("splats", (capacity * VECTORS) as usize)?;
    let kernel = SplatKernel {
        params: SplatParams {
            pairs: capacity,
            gaussians: scene.gaussians,
            compensated_blur: scene.compensated_blur(),
            shaped: scene.config.shape,
        },
        pair: &pairs.pair,
        projection: &pairs.projection,
        opacity: &scene.tensors.gaussians.opacity,
        transmittance,
        color,
        shape: &scene.tensors.gaussians.shape,
        splat: &splat,
    };
    device.run_all(&kernel.counted(&pairs.count))?;

    let tiles = bins.tiles;
    let intersections = bins.intersections.upper_bound();
    let cells = device.unwritten("cells", intersections as usize)?;
    let kernel = TileCellsKernel {
        params: TileCellsParams { intersections, tiles, side },
        tile: &bins.tile,
        tile_first: &bins.tile_first,
        intersection: &bins.intersection,
        splat: &splat,
        cells: &cells,
    };
    device.run_all(&kernel.counted(&bins.intersections))?;

    for pass in 0..bins.largest.div_ceil(MAX_INTERSECTIONS) {
        let kernel = CompositeKernel {
            params: CompositeParams {
                side,
                skip: pass * MAX_INTERSECTIONS,
                sloped: u32::from(slope.is_some()),
                shaped: scene.config.shape,
            },
            tile: &bins.tile,
            tile_first: &bins.tile_first,
            intersection: &bins.intersection,
            cells: &cells,
            splat: &splat,
            // every binding needs a buffer, even if the kernel does not read it
            slope: slope.unwrap_or(&splat),
            sum,
        };
        device.run_all(&kernel)?;
    }
    Ok(splat)
}

/// `[tiles, S, S]`: tiles as 8-bit RGBA.
pub fn pixels(device: &Device, side: u32, image: &Buffer<f32>) -> Result<Buffer<u32>> {
    let rgba = device.unwritten("pixels", image.len() / 3)?;
    let params = PixelsParams { count: rgba.len() as u32, area: side * side };
    device.run_all(&PixelsKernel { params, image, rgba: &rgba })?;
    Ok(rgba)
}

fn resolve_params(background: [f64; 3], divide_above: f32, side: u32) -> ResolveParams {
    let [background_r, background_g, background_b] = background.map(|channel| channel as f32);
    ResolveParams { side, background_r, background_g, background_b, divide_above }
}
