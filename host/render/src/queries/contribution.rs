//! The contribution of each Gaussian to whole views.
//!
//! A pixel is a sum, so the part of a Gaussian in it is exact: `alpha / max(S, 1)` (Eq. 12 and 13). Its sum over a view's
//! pixels is a gradient. With dL/dI = (1, 0, 0) at each pixel, dL/d(red of the Gaussian) is that sum. So the kernels of
//! training compute it.

use std::slice::from_ref;

use organza_shaders::splat::VECTORS;
use rayon::prelude::*;

use super::pixel_gaussians::{PartSplats, PixelGaussian, depths, surface};
use crate::pass::part::Part;
use crate::stages::cut::PartTiles;
use crate::{DeviceScene, Renderer};
use organza_core::image::{TILE_SIDE, bands};
use organza_core::{Camera, Result, Tile};

/// Weight farther from the median depth than this part of it is not at the surface.
const SURFACE: f64 = 0.12;
/// A pixel of less weight shows the background.
const OPEN: f64 = 0.98;
/// Surfaces are found at every fourth pixel of every fourth row.
const STRIDE: i32 = 4;

/// The contributions of a scene's Gaussians to some views.
#[derive(Clone, Debug, PartialEq)]
pub struct Contributions {
    /// `[N]`
    sums: Vec<GaussianSums>,
}

/// Sums of one Gaussian.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct GaussianSums {
    /// Sum of `alpha / max(S, 1)` over all pixels of all views.
    pixels: f64,
    /// Sum over views of the square of the view's part of `pixels`.
    squares: f64,
    /// Like `pixels`, over the pixels with a measured surface.
    measured: f64,
    /// The part of `measured` that lies in front of the surface.
    in_front: f64,
    /// Like `pixels`, over the pixels that were looked at for surfaces.
    shares: f64,
    /// Sum of the squares of the terms of `shares`.
    share_squares: f64,
}

/// The doubt above which [`Contributions::floaters`] of strength 1/2 go.
const DOUBT: f64 = 0.04;

impl Contributions {
    /// No contribution yet, for a number of Gaussians.
    pub fn new(gaussians: usize) -> Self {
        Self { sums: vec![GaussianSums::default(); gaussians] }
    }

    /// The contribution of a Gaussian, in pixels: 2.5 is as much as all of two pixels and half of a third.
    pub fn pixels(&self, gaussian: usize) -> f64 {
        self.sums[gaussian].pixels
    }

    /// The number of views that see a Gaussian. A view counts in full if none shows more of it: the number is
    /// `(sum of c)^2 / (sum of c^2)` for the contributions c to each view.
    pub fn views(&self, gaussian: usize) -> f64 {
        let GaussianSums { pixels, squares, .. } = self.sums[gaussian];
        if squares > 0.0 { pixels * pixels / squares } else { 0.0 }
    }

    /// The share of a Gaussian's contribution that is in front of surfaces, 0 to 1: more than 12% nearer than the median
    /// depth of the pixel's weights. Pixels with S < 0.98 show the background and do not count. 0 if it was not measured.
    pub fn in_front(&self, gaussian: usize) -> f64 {
        let GaussianSums { measured, in_front, .. } = self.sums[gaussian];
        if measured > 0.0 { in_front / measured } else { 0.0 }
    }

    /// How much a Gaussian looks like a floater: `a (f + 1 / n)`. Here a is the mean of its share of the pixels that it reaches,
    /// weighted by this share; f is the part [in front](Self::in_front) of surfaces, and n the number of [views](Self::views) that
    /// see it.
    fn doubt(&self, gaussian: usize) -> f64 {
        let GaussianSums { shares, share_squares, .. } = self.sums[gaussian];
        let mean = if shares > 0.0 { share_squares / shares } else { 0.0 };
        mean * (self.in_front(gaussian) + self.views(gaussian).recip())
    }

    /// Which Gaussians few views support: those whose doubt is above `0.04 (1 - s) / s`, for a strength s from 0, none, to 1. Needs
    /// surfaces.
    #[must_use]
    pub fn floaters(&self, strength: f64) -> Vec<bool> {
        let max = DOUBT * (1.0 - strength) / strength;
        // NaN, of a Gaussian that no view sees, is no doubt
        (0..self.sums.len()).map(|gaussian| self.doubt(gaussian) > max).collect()
    }

    /// The share of all views' pixels that some Gaussians have, 0 to 1.
    #[must_use]
    pub fn weight(&self, chosen: impl Iterator<Item = usize>) -> f64 {
        let all: f64 = self.sums.iter().map(|sums| sums.pixels).sum();
        let chosen: f64 = chosen.map(|gaussian| self.sums[gaussian].pixels).sum();
        // a sum of nothing is -0
        if chosen > 0.0 { chosen / all } else { 0.0 }
    }

    /// Adds the sums of a view.
    fn add(&mut self, view: Vec<GaussianSums>) {
        for (sum, mut view) in self.sums.iter_mut().zip(view) {
            view.squares = view.pixels * view.pixels;
            sum.add(view);
        }
    }
}

impl GaussianSums {
    fn add(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.squares += other.squares;
        self.measured += other.measured;
        self.in_front += other.in_front;
        self.shares += other.shares;
        self.share_squares += other.share_squares;
    }
}

impl Renderer {
    /// Adds what each Gaussian contributes to a view: to all of its pixels. With `surfaces`, also how much of that is in
    /// front of surfaces, at every fourth pixel of every fourth row.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    ///
    /// # Panics
    /// If `contributions` has another number of Gaussians.
    pub fn add_contributions(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
        surfaces: bool,
        contributions: &mut Contributions,
    ) -> Result<()> {
        assert_eq!(contributions.sums.len(), scene.len(), "contributions of another scene");
        let position = self.device().read(&scene.tensors.gaussians.position)?;
        let depths = surfaces.then(|| depths(&position, camera));
        let mut view = vec![GaussianSums::default(); scene.len()];
        for batch in bands(0, [camera.width, camera.height], TILE_SIDE) {
            self.pass(scene, from_ref(camera)).each_part(&batch?, |part_tiles| {
                let found = self.part_sums(scene, camera, part_tiles, depths.as_deref())?;
                found.into_iter().for_each(|(gaussian, sums)| view[gaussian].add(sums));
                Ok(())
            })?;
        }
        contributions.add(view);
        Ok(())
    }

    /// Each Gaussian's sums over a part's pixels. A Gaussian can be in the list several times.
    fn part_sums(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
        part_tiles: &PartTiles,
        depths: Option<&[f64]>,
    ) -> Result<Vec<(usize, GaussianSums)>> {
        let device = self.device();
        let red = device.upload("red of the pixels", &red(camera, part_tiles))?;
        let part = Part::evaluate(scene, from_ref(camera), part_tiles, false, None)?;
        let context = part.context(scene);
        let gradient = device.run_in_pool(|| part.composite.backward(context, &red))?;
        let splats = PartSplats::read(device, &part)?;
        let gradient = device.read(&gradient)?;
        // a pair's third vector has the gradient of its color
        let colors = gradient.chunks_exact(VECTORS as usize).map(|vectors| f64::from(vectors[2].x));
        let sums = colors.map(|pixels| GaussianSums { pixels, ..GaussianSums::default() });
        let gaussians = splats.pair.iter().map(|&gaussian| gaussian as usize);
        let mut found: Vec<_> = gaussians.zip(sums).collect();
        if let Some(depths) = depths {
            let tiles = part_tiles.tiles.par_iter().enumerate();
            let tiles = tiles.map(|(index, part_tile)| {
                let pixels = spaced(part_tile.tile, part_tiles.side, camera);
                let pixels = pixels.flat_map(|pixel| {
                    in_pixel(splats.at(index, pixel, |gaussian| depths[gaussian]))
                });
                pixels.collect::<Vec<_>>()
            });
            found.extend(tiles.flatten().collect::<Vec<_>>());
        }
        Ok(found)
    }
}

/// dL/dI `[tiles, 3, S, S]`: 1 in the red channel of pixels inside the image, 0 elsewhere.
fn red(camera: &Camera, part_tiles: &PartTiles) -> Vec<f32> {
    let side = part_tiles.side as i32;
    let area = (side * side) as usize;
    let mut red = vec![0.0; part_tiles.tiles.len() * 3 * area];
    for (tile, planes) in part_tiles.tiles.iter().zip(red.chunks_mut(3 * area)) {
        let [left, top] = tile.tile.origin;
        let columns = side.min(camera.width as i32 - left) as usize;
        let rows = side.min(camera.height as i32 - top) as usize;
        planes[..area]
            .chunks_mut(side as usize)
            .take(rows)
            .for_each(|row| row[..columns].fill(1.0));
    }
    red
}

/// The pixels of a tile where the surface is measured.
fn spaced(tile: Tile, side: u32, camera: &Camera) -> impl Iterator<Item = [i32; 2]> {
    let along = move |axis: usize, size: u32| {
        let first = tile.origin[axis];
        (first..size.min(first as u32 + side) as i32).filter(|at| at % STRIDE == STRIDE / 2)
    };
    let width = camera.width;
    along(1, camera.height).flat_map(move |y| along(0, width).map(move |x| [x, y]))
}

/// The contributions of Gaussians to a pixel, and whether they are in front of its surface.
fn in_pixel(mut reaching: Vec<PixelGaussian>) -> Vec<(usize, GaussianSums)> {
    let Some((surface, sum)) = surface(&mut reaching) else { return Vec::new() };
    let sums_of = |one: &PixelGaussian| {
        let share = one.weight / sum.max(1.0);
        // an open pixel shows the background
        let measured = if sum < OPEN { 0.0 } else { share };
        let is_in_front = one.depth < (1.0 - SURFACE) * surface;
        let in_front = if is_in_front { measured } else { 0.0 };
        let mut sums = GaussianSums { measured, in_front, ..GaussianSums::default() };
        sums.shares = share;
        sums.share_squares = share * share;
        (one.gaussian, sums)
    };
    reaching.iter().map(sums_of).collect()
}
