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
/// Surfaces are found at every fourth pixel of every fourth row. Smaller images have a smaller stride, for this many pixels in each.
const STRIDE: i32 = 4;
const PIXELS: f64 = 5000.0;
/// Where there is no photograph, what nothing else fills is taken to differ this much from what then shows.
const UNKNOWN: f64 = 0.5;

/// The color of a pixel in the photograph of a view: red, green and blue. `None` where there is none.
pub type PixelColor<'a> = dyn Fn([i32; 2]) -> Option<[f64; 3]> + Sync + 'a;

/// The contributions of a scene's Gaussians to some views.
#[derive(Clone, Debug, PartialEq)]
pub struct Contributions {
    /// The first one is at the whole scene.
    looks: Vec<Look>,
}

/// A look from all views.
#[derive(Clone, Debug, PartialEq)]
struct Look {
    /// Those that are looked at, ascending: the scene has no others.
    gaussians: Vec<usize>,
    /// `[gaussians]`
    sums: Vec<GaussianSums>,
    /// Of a trial `[gaussians]`: those of more suspicion leave first. 0 if there is none.
    suspicion: Option<Vec<f64>>,
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
    /// How much the squared error of these pixels rises without the Gaussian, where others have gone: nearer ones, or in a trial
    /// those of more suspicion.
    need: f64,
    /// The same where no other has gone.
    alone: f64,
}

/// The doubt above which [`Contributions::floaters`] of strength 1/2 go.
const DOUBT: f64 = 0.012;
/// The need that makes a doubt smaller by the factor e: a difference of a tenth.
const NEED: f64 = 0.01;
/// A need below this makes a doubt no larger.
const LEAST_NEED: f64 = -0.03;
/// The need below which photographs are clearly closer without a Gaussian: they differ by a fiftieth anyway.
const CLOSER: f64 = -0.0005;
/// Trials that [`Contributions::next_look`] asks for at most.
const TRIALS: usize = 2;
/// What is a floater of this strength is not there when the scene is looked at again.
const EVIDENT: f64 = 0.3;

impl Contributions {
    /// No contribution yet, for a number of Gaussians.
    pub fn new(gaussians: usize) -> Self {
        Self { looks: vec![Look::new((0..gaussians).collect(), None)] }
    }

    /// The contribution of a Gaussian, in pixels: 2.5 is as much as all of two pixels and half of a third.
    pub fn pixels(&self, gaussian: usize) -> f64 {
        self.looks[0].sums[gaussian].pixels
    }

    /// The number of views that could see a Gaussian's place, and of those that see through it, to a surface more than 12%
    /// farther or to the background. A view counts by parts. A surface is the median depth of a pixel's weights.
    pub fn views(&self, gaussian: usize) -> [f64; 2] {
        let GaussianSums { seeing, through, .. } = self.looks[0].sums[gaussian];
        [seeing, through]
    }

    /// How much views need a Gaussian: by how much the squared error of its pixels, weighted by its shares, would rise without it if
    /// nearer ones had gone before. Below 0, photographs are closer to the views without it.
    pub fn need(&self, gaussian: usize) -> f64 {
        let GaussianSums { shares, need, .. } = self.looks[0].sums[gaussian];
        if shares > 0.0 { need / shares } else { 0.0 }
    }

    /// Ends a look, at the same views each time. Returns the Gaussians of the next one, ascending: add the contributions of a scene
    /// that has no others. `None` after the last look.
    ///
    /// Floaters hide others, so each look is without what is known as a floater of strength 0.3. After the first look, or the second
    /// if the first finds some, a trial follows: of those that photographs are closer without. If it finds some, too, there is one
    /// more look, and one more trial.
    pub fn next_look(&mut self) -> Option<Vec<usize>> {
        let is_known = self.floaters(EVIDENT);
        let look = self.looks.last()?;
        let left = || look.gaussians.iter().zip(&look.sums).filter(|(one, _)| !is_known[**one]);
        let gaussians: Vec<_> = left().map(|(&gaussian, _)| gaussian).collect();
        let finds_more = gaussians.len() < look.gaussians.len();
        let trials = self.looks.iter().filter(|look| look.suspicion.is_some()).count();
        if look.suspicion.is_some() && (!finds_more || trials == TRIALS) {
            return None;
        }
        let is_trial = look.suspicion.is_none() && (!finds_more || self.looks.len() > 1);
        let suspicion: Option<Vec<_>> =
            is_trial.then(|| left().map(|(_, sums)| sums.accused()).collect());
        let is_idle = |all: &Vec<f64>| all.iter().all(|&one| one == 0.0);
        if gaussians.is_empty() || suspicion.as_ref().is_some_and(is_idle) {
            return None;
        }
        self.looks.push(Look::new(gaussians.clone(), suspicion));
        Some(gaussians)
    }

    /// Number of looks, with the one under way.
    pub fn looks(&self) -> usize {
        self.looks.len()
    }

    /// Which Gaussians most views see through: those whose doubt, the greatest of all looks, is above `0.012 (1 - s) / s`, for a
    /// strength s from 0, none, to 1. Needs surfaces.
    #[must_use]
    pub fn floaters(&self, strength: f64) -> Vec<bool> {
        let max = DOUBT * (1.0 - strength) / strength;
        let mut found = vec![false; self.looks[0].sums.len()];
        for look in &self.looks {
            for (index, &gaussian) in look.gaussians.iter().enumerate() {
                // NaN, of a Gaussian that no view sees, is no doubt
                found[gaussian] |= look.doubt(index) > max;
            }
        }
        found
    }

    /// The share of all views' pixels that some Gaussians have, 0 to 1.
    #[must_use]
    pub fn weight(&self, chosen: impl Iterator<Item = usize>) -> f64 {
        let all: f64 = self.looks[0].sums.iter().map(|sums| sums.pixels).sum();
        let chosen: f64 = chosen.map(|gaussian| self.pixels(gaussian)).sum();
        // a sum of nothing is -0
        if chosen > 0.0 { chosen / all } else { 0.0 }
    }
}

impl Look {
    fn new(gaussians: Vec<usize>, suspicion: Option<Vec<f64>>) -> Self {
        Self { sums: vec![GaussianSums::default(); gaussians.len()], gaussians, suspicion }
    }

    /// How much a Gaussian looks like a floater. In a trial, what photographs are closer without is needed least.
    fn doubt(&self, index: usize) -> f64 {
        let sums = &self.sums[index];
        match &self.suspicion {
            None => sums.suspicion() * factor(sums.need / sums.shares),
            Some(suspicion) if sums.need < CLOSER * sums.shares => {
                suspicion[index] * factor(LEAST_NEED)
            }
            Some(_) => 0.0,
        }
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

/// What a need makes of a suspicion: `exp(-e / 0.01)`, for a need e of at least -0.03.
fn factor(need: f64) -> f64 {
    (-need.max(LEAST_NEED) / NEED).exp()
}

impl GaussianSums {
    /// `a f^2`. Here a is the mean of a Gaussian's share of the pixels that it reaches, weighted by this share; f is the part of the
    /// [views](Contributions::views) that see through it, of those that could see it.
    fn suspicion(&self) -> f64 {
        self.share_squares / self.shares * (self.through / self.seeing).powi(2)
    }

    /// How much a trial suspects a Gaussian: not at all where the views are closer to photographs with it.
    fn accused(&self) -> f64 {
        // 0 instead of NaN
        if self.alone < 0.0 { self.suspicion().max(0.0) } else { 0.0 }
    }

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
        self.alone += other.alone;
    }
}

/// How a view is looked at for floaters.
struct Seen<'a> {
    /// `[gaussians]`
    depths: Vec<f64>,
    /// As [`Look::suspicion`].
    suspicion: Option<&'a [f64]>,
    background: [f64; 3],
    photograph: &'a PixelColor<'a>,
}

impl Renderer {
    /// Adds what each Gaussian contributes to a view: to all of its pixels. With `photograph`, which may be of no pixel, also what
    /// floaters are known by, at every fourth pixel of every fourth row.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    ///
    /// # Panics
    /// If the look of `contributions` has another number of Gaussians.
    pub fn add_contributions(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
        photograph: Option<&PixelColor<'_>>,
        contributions: &mut Contributions,
    ) -> Result<()> {
        let look = contributions.looks.last_mut().expect("the first look");
        assert_eq!(look.sums.len(), scene.len(), "contributions of another scene");
        let position = self.device().read(&scene.tensors.gaussians.position)?;
        let seen = photograph.map(|photograph| Seen {
            depths: depths(&position, camera),
            suspicion: look.suspicion.as_deref(),
            background: scene.config().background,
            photograph,
        });
        let mut view = vec![GaussianSums::default(); scene.len()];
        for batch in bands(0, [camera.width, camera.height], TILE_SIDE) {
            self.pass(scene, from_ref(camera)).each_part(&batch?, |part_tiles| {
                let found = self.part_sums(scene, camera, part_tiles, seen.as_ref())?;
                found.into_iter().for_each(|(gaussian, sums)| view[gaussian].add(sums));
                Ok(())
            })?;
        }
        look.add(view);
        Ok(())
    }

    /// Each Gaussian's sums over a part's pixels. A Gaussian can be in the list several times.
    fn part_sums(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
        part_tiles: &PartTiles,
        seen: Option<&Seen<'_>>,
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
        if let Some(seen) = seen {
            let tiles = part_tiles.tiles.par_iter().enumerate();
            let tiles = tiles.map(|(index, part_tile)| {
                let pixels = spaced(part_tile.tile, part_tiles.side, camera);
                let pixels = pixels.flat_map(|pixel| {
                    let reaching = splats.at(index, pixel, |gaussian| seen.depths[gaussian]);
                    in_pixel(reaching, seen, (seen.photograph)(pixel))
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
    let area = f64::from(camera.width) * f64::from(camera.height);
    let stride = ((area / PIXELS).sqrt() as i32).clamp(1, STRIDE);
    let along = move |axis: usize, size: u32| {
        let first = tile.origin[axis];
        (first..size.min(first as u32 + side) as i32).filter(move |at| at % stride == stride / 2)
    };
    let width = camera.width;
    along(1, camera.height).flat_map(move |y| along(0, width).map(move |x| [x, y]))
}

/// The sums of Gaussians in a pixel, whose color in the photograph may be known.
fn in_pixel(
    mut reaching: Vec<PixelGaussian>,
    seen: &Seen<'_>,
    photograph: Option<[f64; 3]>,
) -> Vec<(usize, GaussianSums)> {
    let Some((_, sum)) = surface(&mut reaching) else { return Vec::new() };
    // the background is behind them all
    let surface = depth_of(&reaching, 0.5 * sum.max(1.0)).unwrap_or(f64::INFINITY);
    if let Some(suspicion) = seen.suspicion {
        let of = |one: &PixelGaussian| suspicion[one.gaussian];
        reaching.sort_by(|a, b| of(b).total_cmp(&of(a)));
    }
    let rise = |with: [f64; 4], without: [f64; 4]| match photograph {
        Some(photograph) => {
            let error = |sums| error_of(sums, seen.background, photograph);
            error(without) - error(with)
        }
        None => (UNKNOWN * (with[3].min(1.0) - without[3].min(1.0))).powi(2),
    };
    let mut all = [0.0; 4];
    for one in &reaching {
        all = less(all, one, -1.0);
    }
    // what is left of C and S
    let mut rest = all;
    let mut sums_of = |one: &PixelGaussian| {
        let before = rest;
        rest = less(rest, one, 1.0);
        let need = rise(before, rest);
        let alone = rise(all, less(all, one, 1.0));
        let share = one.weight / sum.max(1.0);
        let mut sums = GaussianSums { shares: share, need, alone, ..GaussianSums::default() };
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

/// The sums C and S of a pixel without a part of a Gaussian.
fn less(mut sums: [f64; 4], one: &PixelGaussian, part: f64) -> [f64; 4] {
    let [red, green, blue] = one.color;
    for (sum, factor) in sums.iter_mut().zip([red, green, blue, 1.0]) {
        *sum -= part * one.weight * factor;
    }
    sums
}

/// The squared error of a pixel with these sums C and S.
fn error_of(sums: [f64; 4], background: [f64; 3], photograph: [f64; 3]) -> f64 {
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
