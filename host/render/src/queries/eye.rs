//! The fields as seen from one place: colors and transmittances depend on where the eye is, and on nothing else of a camera.
//!
//! Looking around, zooming and resizing then take the projection and the composite alone.

use std::time::Instant;

use glam::Vec3;
use organza_shaders::composite::splat_distance;
use organza_shaders::project::{EVERYWHERE, in_support};
use rayon::prelude::*;

use crate::pass::blend::blend;
use crate::pass::output::Output;
use crate::pass::renderer::Renderer;
use crate::stages::color::Color;
use crate::stages::composite::{Composite, OtherScene, TileContext};
use crate::stages::cut::PartTiles;
use crate::stages::pairs::Pairs;
use crate::stages::project::project;
use crate::stages::scan::total;
use crate::stages::tiles::TileBins;
use crate::stages::transmittance::{Segments, Transmittance};
use crate::{Capacity, DeviceScene};
use muslin_device::{Buffer, Count, Device, memory};
use organza_core::{Camera, Channel, RenderedTiles, Result, TileBatch};

/// Pairs that are evaluated at once, so that a cancelled frame ends soon: on a CPU about a tenth of a
/// second.
const CPU_PAIRS: usize = 1 << 12;
const GPU_PAIRS: usize = 1 << 17;
/// While the eye moves, a Gaussian's values are computed again about every 4 degrees, as seen from the Gaussian; in radians.
/// Blocks of 8 x 8 pixels of the built-in scene then differ from the exact image by up to 10 levels of 255; with 0.12 radians,
/// by up to 13.
const ANGLE: f32 = 0.07;
/// The eye of a value that is old, as seen from anywhere: farther than any camera can be.
const ELSEWHERE: Vec3 = Vec3::splat(1e17);

/// Colors c (Eq. 3) and transmittances T (Eq. 11) of a scene's Gaussians, as seen from one place. After the scene changes,
/// start with a new cache; after another one was moved, see [`EyeCache::outdate`].
#[derive(Debug, Default)]
pub struct EyeCache {
    /// The place in world space, as kernels read it.
    eye: Vec3,
    /// The eye of the image before.
    eye_before: Vec3,
    position: Vec<Vec3>,
    /// `[N]`: the eye that a Gaussian's values were computed for; infinity if it has none.
    eyes: Vec<Vec3>,
    /// `[N]`: the length of T's steps in multiples of sigma.
    steps: Vec<u16>,
    transmittance: Vec<f32>,
    color: Vec<[f32; 3]>,
    work: FieldWork,
    /// The same of the scenes that are [shown with](DeviceScene::put) this one.
    beside: Vec<Self>,
}

/// The work of the fields for the last image.
#[derive(Clone, Copy, Debug, Default)]
pub struct FieldWork {
    /// The time for colors and transmittances.
    pub seconds: f64,
    /// Gaussians in the image.
    pub gaussians: usize,
    /// Gaussians whose T was computed.
    pub evaluated: usize,
}

/// How [`Renderer::render_from_eye`] renders.
#[derive(Clone, Copy)]
#[allow(missing_debug_implementations, reason = "a function has nothing to show")]
pub struct EyeOptions<'a> {
    /// Channels beside color.
    pub channels: &'a [Channel],
    /// The length of T's steps in multiples of sigma, Eq. 8. With 1, the image equals the one of [`Renderer::render`].
    pub steps: u16,
    /// `[min, max]`: an image may show values of another eye. Each image computes all values that are unknown. It also
    /// renews old values: more if the eye moves faster, at least `min` and at most `max`. `None`: all values are of this
    /// eye.
    pub renewed: Option<[usize; 2]>,
    /// Replaces the scene's background.
    pub background: Option<[f64; 3]>,
    /// Whether the image is no longer needed.
    pub is_cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl EyeCache {
    /// The work of the fields for the last image.
    pub fn work(&self) -> FieldWork {
        self.beside.iter().map(Self::work).fold(self.work, |all, other| FieldWork {
            seconds: all.seconds + other.seconds,
            gaussians: all.gaussians + other.gaussians,
            evaluated: all.evaluated + other.evaluated,
        })
    }

    /// Marks all values as old, after a scene was [moved](DeviceScene::moved).
    pub fn outdate(&mut self) {
        let known = self.eyes.iter_mut().filter(|eye| eye.is_finite());
        known.for_each(|eye| *eye = ELSEWHERE);
        self.beside.iter_mut().for_each(Self::outdate);
    }

    /// Moves the eye to a camera of the first scene. All values of another eye become old.
    fn look_from(&mut self, camera: &Camera, scene: &DeviceScene) -> Result<()> {
        self.beside.resize_with(scene.beside.len(), Self::default);
        for (cache, other) in self.beside.iter_mut().zip(&scene.beside) {
            cache.look_from(camera, other)?;
        }
        let eye = scene.place.own_camera(camera).for_kernels().eye;
        let gaussians = scene.len();
        if self.steps.len() != gaussians {
            self.position =
                scene.device().read(&scene.tensors.gaussians.position.view::<Vec3>())?;
            self.eyes = memory::zeros(gaussians, "what is kept of one place")?;
            self.eyes.fill(Vec3::INFINITY);
            self.steps = memory::zeros(gaussians, "what is kept of one place")?;
            self.transmittance = memory::zeros(gaussians, "what is kept of one place")?;
            self.color = memory::zeros(gaussians, "what is kept of one place")?;
        }
        self.eye_before = std::mem::replace(&mut self.eye, eye);
        self.work = FieldWork::default();
        Ok(())
    }

    /// Whether a Gaussian's values are of the current eye.
    fn is_current(&self, gaussian: u32) -> bool {
        self.eyes[gaussian as usize] == self.eye
    }

    /// The angle between the eye and another place, seen from a Gaussian, in multiples of [`ANGLE`].
    fn moved(&self, from: Vec3, gaussian: u32) -> f32 {
        let distance = self.position[gaussian as usize].distance(self.eye);
        self.eye.distance(from) / (ANGLE * distance.clamp(f32::MIN_POSITIVE, f32::MAX))
    }

    /// Selects the Gaussians whose values must be computed.
    fn missing(&self, gaussians: &[u32], options: &EyeOptions<'_>) -> Vec<u32> {
        let is_missing =
            |&at: &u32| !self.is_current(at) || self.steps[at as usize] > options.steps;
        let missing = gaussians.iter().copied().filter(is_missing);
        let Some([min, max]) = options.renewed else { return missing.collect() };
        // neighbors are renewed at different times, so that old values look like faint noise, not like a hole
        let scattered = |at: u32| 1.0 + at.wrapping_mul(0x9e37_79b9) as f32 / u32::MAX as f32;
        let age = |at| self.moved(self.eyes[at as usize], at) * scattered(at);
        let mut missing: Vec<_> = missing.map(|at| (age(at), at)).collect();
        missing.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        // an unknown value has the age infinity
        let unknown = missing.partition_point(|(age, _)| *age > f32::MAX);
        let overdue = missing.partition_point(|(age, _)| *age > 2.0) - unknown;
        let share: f32 = gaussians.iter().map(|&at| self.moved(self.eye_before, at).min(1.0)).sum();
        missing.truncate(unknown + overdue.max(share as usize).max(min).min(max));
        missing.into_iter().map(|(_, at)| at).collect()
    }

    /// Evaluates the [missing](Self::missing) values of some Gaussians. Returns the number of samples; `None` if cancelled.
    fn complete(
        &mut self,
        scene: &DeviceScene,
        camera: &Camera,
        bins: &TileBins,
        gaussians: &[u32],
        options: &EyeOptions<'_>,
    ) -> Result<Option<u32>> {
        let device = scene.device();
        let steps = options.steps;
        let scene = &scene.with_ray_steps(steps.into());
        let missing = self.missing(gaussians, options);
        self.work.gaussians += gaussians.len();
        let mut samples = 0;
        let at_once = if device.is_cpu_like() { CPU_PAIRS } else { GPU_PAIRS };
        for some in missing.chunks(at_once) {
            if (options.is_cancelled)() {
                return Ok(None);
            }
            let pairs = pairs_of(device, bins, some)?;
            let segments = Segments::new(scene, &pairs)?;
            let count = total(device, &segments.first_sample)?;
            let evaluated = Transmittance::evaluate(scene, &pairs, segments, count, false)?;
            samples += evaluated.samples.upper_bound();
            samples += evaluated.attenuate(scene, &[camera], &pairs, bins)?;
            let without: Vec<_> = some.iter().copied().filter(|&at| !self.is_current(at)).collect();
            let color = match &*without {
                [] => Vec::new(),
                some => {
                    let pairs = pairs_of(device, bins, some)?;
                    device.read(&Color::evaluate(scene, &pairs, false)?.color)?
                }
            };
            for (&at, t) in some.iter().zip(device.read(&evaluated.transmittance)?) {
                self.transmittance[at as usize] = t;
                self.steps[at as usize] = steps;
                self.eyes[at as usize] = self.eye;
            }
            self.work.evaluated += some.len();
            for (&at, color) in without.iter().zip(color.as_chunks().0) {
                self.color[at as usize] = *color;
            }
        }
        Ok(Some(samples))
    }

    /// T `[pairs]` and c `[pairs, 3]` of some Gaussians, on the device.
    fn gather(&self, device: &Device, gaussians: &[u32]) -> Result<(Buffer<f32>, Buffer<f32>)> {
        let transmittance: Vec<_> =
            gaussians.iter().map(|&at| self.transmittance[at as usize]).collect();
        let color: Vec<_> = gaussians.iter().map(|&at| self.color[at as usize]).collect();
        let transmittance = device.upload("transmittance", &transmittance)?;
        Ok((transmittance, device.upload("color", color.as_flattened())?))
    }

    /// A scene's pairs in the tiles of a part, and the room that they need; `None` if cancelled.
    fn evaluate(
        &mut self,
        scene: &DeviceScene,
        camera: &Camera,
        part_tiles: &PartTiles,
        options: &EyeOptions<'_>,
    ) -> Result<Option<(OtherScene, Capacity)>> {
        let device = scene.device();
        let projection = project(device, scene, &[camera], &part_tiles.windows())?;
        let bins = TileBins::new(scene, part_tiles, projection, None)?;
        // with one camera, a pair is its Gaussian
        let gaussians = device.read(&bins.pairs.pair)?;
        let begin = Instant::now();
        let samples = self.complete(scene, camera, &bins, &gaussians, options)?;
        self.work.seconds += begin.elapsed().as_secs_f64();
        let Some(samples) = samples else { return Ok(None) };
        let (transmittance, color) = self.gather(device, &gaussians)?;
        let pairs = gaussians.len() as u32;
        let needed = Capacity { pairs, intersections: bins.intersections.upper_bound(), samples };
        Ok(Some((OtherScene { bins, transmittance, color }, needed)))
    }

    fn render(
        &mut self,
        scene: &DeviceScene,
        camera: &Camera,
        part_tiles: &PartTiles,
        options: &EyeOptions<'_>,
        tiles: &mut RenderedTiles,
    ) -> Result<bool> {
        let device = scene.device();
        let own = self.evaluate(scene, camera, part_tiles, options)?;
        let Some((own, mut needed)) = own else { return Ok(false) };
        let mut beside = Vec::new();
        for (cache, other) in self.beside.iter_mut().zip(&scene.beside) {
            let found = cache.evaluate(other, camera, part_tiles, options)?;
            let Some((found, more)) = found else { return Ok(false) };
            needed = needed.plus(more);
            beside.push(found);
        }
        let OtherScene { bins, transmittance, color } = &own;
        let contexts = TileContext { scene, bins, transmittance, color }.all(&beside);
        let background = options.background.unwrap_or(scene.config.background);
        let composite = Composite::new(&contexts, background)?;
        let mut output = Output::Tiles { tiles, channels: options.channels };
        let (buffers, sums) = output.buffers(&contexts, &composite)?;
        let words = device.read_all(&buffers)?;
        output.take(device, part_tiles, contexts.len(), sums, words, needed)?;
        Ok(true)
    }
}

/// Pairs of some Gaussians and the camera of `bins`.
fn pairs_of(device: &Device, bins: &TileBins, gaussians: &[u32]) -> muslin_device::Result<Pairs> {
    Ok(Pairs {
        count: Count::known(gaussians.len() as u32),
        pair: device.upload("pairs", gaussians)?,
        camera: bins.pairs.camera.view(),
        projection: bins.pairs.projection.view(),
        camera_ends: Vec::new(),
    })
}

impl Renderer {
    /// Renders tiles of one camera; the camera index of a tile is ignored. Colors and transmittances in the cache are not
    /// computed again. Returns `None` if cancelled; the cache keeps the values that were computed by then.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn render_from_eye(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
        batch: &TileBatch,
        cache: &mut EyeCache,
        options: &EyeOptions<'_>,
    ) -> Result<Option<RenderedTiles>> {
        if let Some(scenes) = scene.grounds() {
            cache.work = FieldWork::default();
            let caches = &mut cache.beside;
            caches.resize_with(scenes.len(), EyeCache::default);
            // those that are not seen do nothing
            caches.iter_mut().for_each(|cache| cache.work = FieldWork::default());
            let render = &mut |index: usize, one: &_, own: &[_], some: &_, all: &[_]| {
                let options = &EyeOptions { channels: all, ..*options };
                self.render_from_eye(one, &own[0], some, &mut caches[index], options)
            };
            let cameras = std::slice::from_ref(camera);
            return blend(&scenes, cameras, batch, options.channels, render);
        }
        let pass = self.pass(scene, std::slice::from_ref(camera));
        let mut parts = pass.cut(batch)?;
        cache.look_from(camera, scene)?;
        let device = self.device();
        let mut tiles = RenderedTiles::new(batch, options.channels)?;
        let mut index = 0;
        while let Some(at) = parts.list.get(index) {
            let render = || cache.render(scene, camera, &at.part_tiles, options, &mut tiles);
            match device.run_in_pool(render) {
                Ok(true) => index += 1,
                Ok(false) => return Ok(None),
                Err(error) => pass.make_room(error, &mut parts, index..index + 1)?,
            }
        }
        Ok(Some(tiles))
    }

    /// The number of Gaussians whose support reaches each pixel's center, row by row.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn count_gaussians(&self, scene: &DeviceScene, camera: &Camera) -> Result<Vec<u32>> {
        let device = self.device();
        let mut projection = Vec::new();
        for scene in scene.all() {
            let values = project(device, scene, &[camera], &[EVERYWHERE])?.values;
            projection.extend(device.read(&values)?);
        }
        let width = camera.width as usize;
        let mut count = memory::zeros(width * camera.height as usize, "Gaussians of pixels")?;
        const ROWS: usize = 16;
        count.par_chunks_mut(ROWS * width).enumerate().for_each(|(band, count)| {
            let top = band * ROWS;
            for [placed, conic] in projection.as_chunks().0 {
                let mean = [placed.x, placed.y];
                let reach = placed.z;
                // the pixels whose centers the radius may reach; the radius of culled Gaussians is negative
                let range = |axis: usize, first: usize, len: usize| {
                    let at = |value: f32| (value as isize - first as isize).clamp(0, len as isize);
                    at(mean[axis] - reach - 1.0) as usize..at(mean[axis] + reach + 1.0) as usize
                };
                let rows = range(1, top, count.len() / width);
                if reach < 0.0 || rows.is_empty() {
                    continue;
                }
                for row in rows {
                    let y = (top + row) as f32 + 0.5;
                    for column in range(0, 0, width) {
                        let q = splat_distance(*placed, *conic, column as f32 + 0.5, y);
                        count[row * width + column] += u32::from(in_support(q));
                    }
                }
            }
        });
        Ok(count)
    }
}
