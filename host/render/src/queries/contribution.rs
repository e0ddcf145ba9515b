//! The contribution of each Gaussian to whole views.
//!
//! A pixel is a sum, so the part of a Gaussian in it is exact: `alpha / max(S, 1)` (Eq. 12 and 13). Its sum over a view's
//! pixels is a gradient. With dL/dI = (1, 0, 0) at each pixel, dL/d(red of the Gaussian) is that sum. So the kernels of
//! training compute it.

use std::slice::from_ref;

use organza_shaders::splat::VECTORS;
use rayon::prelude::*;

use super::pixel_gaussians::{PartSplats, PixelGaussian, depth_of, depths, surface};
use crate::pass::part::Part;
use crate::stages::cut::PartTiles;
use crate::{DeviceScene, Renderer};
use organza_core::image::{TILE_SIDE, bands};
use organza_core::{Camera, Result, Tile};

/// What is farther from a surface than this part of its depth is not at it.
const SURFACE: f64 = 0.12;
/// Surfaces are found at every fourth pixel of every fourth row.
const STRIDE: i32 = 4;
/// Where there is no photograph, what nothing else fills is taken to differ this much from what then shows.
const UNKNOWN: f64 = 0.5;

/// The color of a pixel in the photograph of a view: red, green and blue. `None` where there is none.
pub type PixelColor<'a> = dyn Fn([i32; 2]) -> Option<[f64; 3]> + Sync + 'a;

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
    /// Like `pixels`, over the pixels that were looked at for surfaces.
    shares: f64,
    /// Sum of the squares of the terms of `shares`.
    share_squares: f64,
    /// Sums of the falloff over these pixels: where the Gaussian lies in front of the surface, at it, and behind.
    in_front: f64,
    at_surface: f64,
    behind: f64,
    /// Sums over views: the part of the falloff that is not behind surfaces, and the part in front.
    seeing: f64,
    through: f64,
    /// How much the squared error of these pixels rises without the Gaussian, where nearer ones have gone.
    need: f64,
}

/// The doubt above which [`Contributions::floaters`] of strength 1/2 go.
const DOUBT: f64 = 0.012;
/// The need that makes a doubt smaller by the factor e: a difference of a tenth.
const NEED: f64 = 0.01;
/// A need below this makes a doubt no larger.
const LEAST_NEED: f64 = -0.03;

impl Contributions {
    /// No contribution yet, for a number of Gaussians.
    pub fn new(gaussians: usize) -> Self {
        Self { sums: vec![GaussianSums::default(); gaussians] }
    }

    /// The contribution of a Gaussian, in pixels: 2.5 is as much as all of two pixels and half of a third.
    pub fn pixels(&self, gaussian: usize) -> f64 {
        self.sums[gaussian].pixels
    }

    /// The number of views that could see a Gaussian's place, and of those that see through it, to a surface more than 12%
    /// farther or to the background. A view counts by parts. A surface is the median depth of a pixel's weights.
    pub fn views(&self, gaussian: usize) -> [f64; 2] {
        let GaussianSums { seeing, through, .. } = self.sums[gaussian];
        [seeing, through]
    }

    /// How much views need a Gaussian: by how much the squared error of its pixels, weighted by its shares, would rise without it if
    /// nearer ones had gone before. Below 0, photographs are closer to the views without it.
    pub fn need(&self, gaussian: usize) -> f64 {
        let GaussianSums { shares, need, .. } = self.sums[gaussian];
        if shares > 0.0 { need / shares } else { 0.0 }
    }

    /// How much a Gaussian looks like a floater: `a f^2 exp(-e / 0.01)`. Here a is the mean of its share of the pixels that it reaches,
    /// weighted by this share; f is the part of the [views](Self::views) that see through it, of those that could see it; and e is the
    /// [need](Self::need), at least -0.03.
    fn doubt(&self, gaussian: usize) -> f64 {
        let GaussianSums { shares, share_squares, .. } = self.sums[gaussian];
        let [seeing, through] = self.views(gaussian);
        let needs = self.need(gaussian).max(LEAST_NEED) / NEED;
        share_squares / shares * (through / seeing).powi(2) * (-needs).exp()
    }

    /// Which Gaussians most views see through: those whose doubt is above `0.012 (1 - s) / s`, for a strength s from 0, none, to 1.
    /// Needs surfaces.
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
            let seen = view.in_front + view.at_surface;
            let all = seen + view.behind;
            if all > 0.0 {
                view.seeing = seen / all;
                view.through = view.in_front / all;
            }
            sum.add(view);
        }
    }
}

impl GaussianSums {
    fn add(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.shares += other.shares;
        self.share_squares += other.share_squares;
        self.in_front += other.in_front;
        self.at_surface += other.at_surface;
        self.behind += other.behind;
        self.seeing += other.seeing;
        self.through += other.through;
        self.need += other.need;
    }
}

impl Renderer {
    /// Adds what each Gaussian contributes to a view: to all of its pixels. With `photograph`, which may be of no pixel, also what
    /// floaters are known by, at every fourth pixel of every fourth row.
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
        photograph: Option<&PixelColor<'_>>,
        contributions: &mut Contributions,
    ) -> Result<()> {
        assert_eq!(contributions.sums.len(), scene.len(), "contributions of another scene");
        let position = self.device().read(&scene.tensors.gaussians.position)?;
        let looks = photograph.map(|photograph| (depths(&position, camera), photograph));
        let mut view = vec![GaussianSums::default(); scene.len()];
        for batch in bands(0, [camera.width, camera.height], TILE_SIDE) {
            self.pass(scene, from_ref(camera)).each_part(&batch?, |part_tiles| {
                let found = self.part_sums(scene, camera, part_tiles, looks.as_ref())?;
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
        looks: Option<&(Vec<f64>, &PixelColor<'_>)>,
    ) -> Result<Vec<(usize, GaussianSums)>> {
        let device = self.device();
        let red = device.upload("red of the pixels", &red(camera, part_tiles))?;
        let part = Part::evaluate(scene, from_ref(camera), part_tiles, false, None)?;
        let context = part.context(scene);
        let gradient = device.run_in_pool(|| part.composite.backward(context, &red))?.splat;
        let splats = PartSplats::read(device, &part)?;
        let gradient = device.read(&gradient)?;
        // a pair's third vector has the gradient of its color
        let colors = gradient.chunks_exact(VECTORS as usize).map(|vectors| f64::from(vectors[2].x));
        let sums = colors.map(|pixels| GaussianSums { pixels, ..GaussianSums::default() });
        let gaussians = splats.pair.iter().map(|&gaussian| gaussian as usize);
        let mut found: Vec<_> = gaussians.zip(sums).collect();
        let background = scene.config().background;
        if let Some((depths, photograph)) = looks {
            let tiles = part_tiles.tiles.par_iter().enumerate();
            let tiles = tiles.map(|(index, part_tile)| {
                let pixels = spaced(part_tile.tile, part_tiles.side, camera);
                let pixels = pixels.flat_map(|pixel| {
                    let reaching = splats.at(index, pixel, |gaussian| depths[gaussian]);
                    in_pixel(reaching, background, photograph(pixel))
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

/// The sums of Gaussians in a pixel, whose color in the photograph may be known.
fn in_pixel(
    mut reaching: Vec<PixelGaussian>,
    background: [f64; 3],
    photograph: Option<[f64; 3]>,
) -> Vec<(usize, GaussianSums)> {
    let Some((_, sum)) = surface(&mut reaching) else { return Vec::new() };
    // the background is behind them all
    let surface = depth_of(&reaching, 0.5 * sum.max(1.0)).unwrap_or(f64::INFINITY);
    // what is left of C and S without the nearer ones
    let mut rest = [0.0; 4];
    for one in &reaching {
        take(&mut rest, one, -1.0);
    }
    let mut error = error_of(rest, background, photograph);
    let mut sums_of = |one: &PixelGaussian| {
        let filled = rest[3].min(1.0);
        take(&mut rest, one, 1.0);
        let without = error_of(rest, background, photograph);
        let need = match photograph {
            Some(_) => without - error,
            None => (UNKNOWN * (filled - rest[3].min(1.0))).powi(2),
        };
        error = without;
        let share = one.weight / sum.max(1.0);
        let mut sums = GaussianSums { shares: share, need, ..GaussianSums::default() };
        sums.share_squares = share * share;
        let side = match one.depth {
            depth if depth < (1.0 - SURFACE) * surface => &mut sums.in_front,
            depth if depth <= (1.0 + SURFACE) * surface => &mut sums.at_surface,
            _ => &mut sums.behind,
        };
        *side = one.falloff;
        (one.gaussian, sums)
    };
    reaching.iter().map(&mut sums_of).collect()
}

/// Takes a Gaussian's part from the sums C and S of a pixel.
fn take(sums: &mut [f64; 4], one: &PixelGaussian, part: f64) {
    let [red, green, blue] = one.color;
    for (sum, factor) in sums.iter_mut().zip([red, green, blue, 1.0]) {
        *sum -= part * one.weight * factor;
    }
}

/// The squared error of a pixel with these sums C and S; 0 without a photograph.
fn error_of(sums: [f64; 4], background: [f64; 3], photograph: Option<[f64; 3]>) -> f64 {
    let Some(photograph) = photograph else { return 0.0 };
    let sum = sums[3];
    let channel = |channel: usize| {
        // Eq. 13
        let color = match sum > 1.0 {
            true => sums[channel] / sum,
            false => sums[channel] + (1.0 - sum) * background[channel],
        };
        (color - photograph[channel]).powi(2)
    };
    (0..3).map(channel).sum::<f64>() / 3.0
}
