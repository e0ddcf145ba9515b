//! The frame renderer owns the scene, takes requests from the queue, and answers them: images at a pace that motion needs, and clicked pixels.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use serde::Serialize;
use serde_json::{Value, json};

use super::message::{FrameRequest, Mode, Quality};
use super::picture::{self, Range};
use super::queue::{FrameJob, NextJob, Payload, Question, Queue};
use crate::{Editor, Photographs, Places, Stage};
use organza_core::error::{self, Result, refuse};
use organza_core::image::{ChannelImage, Image, TILE_SIDE};
use organza_core::{Camera, RenderReport, TileBatch};
use organza_data::Photograph;
use organza_render::{
    Contribution, DeviceScene, EyeCache, EyeOptions, FieldWork, Inspection, Renderer, Trace,
};

/// Number of clients whose evaluated fields are kept.
const MAX_EYES: usize = 8;

/// Answers requests, one at a time.
#[derive(Debug)]
pub struct FrameRenderer {
    queue: Arc<Queue>,
    photographs: Photographs,
    /// The eye that was used last is at the end.
    eyes: Vec<Eye>,
    /// None if pages may not change the scene.
    editor: Option<Editor>,
    places: Places,
}

/// Data kept for a client.
#[derive(Debug)]
struct Eye {
    client: u64,
    version: u64,
    cache: EyeCache,
    pace: Pace,
}

impl FrameRenderer {
    /// A frame renderer that takes requests from `queue`.
    pub fn new(queue: Arc<Queue>, photographs: Photographs) -> Self {
        Self { queue, photographs, eyes: Vec::new(), editor: None, places: Places::default() }
    }

    /// Pages may change what is shown: with an editor of the same scene, or by the places of others.
    #[must_use]
    pub fn with(self, editor: Option<Editor>, places: Places) -> Self {
        Self { editor, places, ..self }
    }

    /// Answers one request, waiting for it for up to `patience`. Returns whether there was one.
    pub fn serve(&mut self, stage: Stage<'_>, patience: Duration) -> bool {
        let Some(job) = self.queue.take(patience) else { return false };
        let (changed, changes) =
            self.editor.as_ref().map_or_else(|| self.places.shown(), Editor::shown);
        let scene = changed.as_deref().unwrap_or(stage.scene);
        let stage = Stage { scene, version: stage.version + changes, ..stage };
        match job {
            NextJob::Question(question, reply) => {
                let _ =
                    reply.send(self.answer(stage, &question).map_err(|error| error::chain(&error)));
            }
            NextJob::Frame(job) => match self.frame(stage, &job) {
                Ok(Some(rendered)) => {
                    let _ = job.reply.send(Ok(rendered));
                }
                Ok(None) => self.queue.put_back(job),
                Err(error) => {
                    let _ = job.reply.send(Err(error::chain(&error)));
                }
            },
        }
        // a training measures its own kernels
        let _ = stage.renderer.device().take_timings();
        true
    }

    /// Paints an image; `None` if it was interrupted.
    fn frame(&mut self, stage: Stage<'_>, job: &FrameJob) -> Result<Option<Payload>> {
        let begin = Instant::now();
        let truth = match (job.request.mode, job.request.view) {
            (Mode::Error, Some(view)) => Some(self.photographs.get(stage.renderer, view)?),
            (Mode::Error, None) => return refuse("an error needs a photograph"),
            _ => None,
        };
        let queue = Arc::clone(&self.queue);
        let eye = self.eye(job.request.client, stage.version);
        let canvas = draw(stage, &job.request, eye, truth.as_deref(), &|slices| {
            let quality = job.request.quality;
            let outdated = quality != Quality::Moving && queue.is_outdated(job);
            // every turn must make progress, or it would never end
            let urgent = slices > 0 && quality == Quality::Exact && queue.has_urgent();
            job.reply.is_closed() || outdated || urgent
        })?;
        let Some(Canvas { image, range, steps, report }) = canvas else { return Ok(None) };
        let (kind, bytes) = match job.request.quality {
            Quality::Exact => {
                let bytes = image.encode_png();
                ("image/png", bytes.or_else(|error| refuse(error.to_string()))?)
            }
            _ => ("image/jpeg", picture::encode_jpeg(&image)?),
        };
        let seconds = begin.elapsed().as_secs_f64();
        if job.request.quality == Quality::Moving {
            let fields = eye.cache.work();
            eye.pace.learn(fields, seconds - fields.seconds);
        }
        let about = json!({
            "sequence": job.request.sequence,
            "quality": job.request.quality,
            "mode": job.request.mode,
            "size": image.size(),
            "version": stage.version,
            "gaussians": stage.scene.all().map(DeviceScene::len).sum::<usize>(),
            "pairs": report.pairs,
            "members": report.intersections,
            // computed for this image; the eye keeps others from earlier images
            "samples": report.samples,
            "renewed": eye.cache.work().evaluated,
            // the length of T's steps, as a multiple of sigma
            "steps": steps,
            "milliseconds": 1000.0 * seconds,
            "range": range.map(|Range { low, high }| [low, high]),
        });
        Ok(Some(rendered_as(kind, bytes, &about)))
    }

    /// The data kept for a client, for the current version of the scene.
    fn eye(&mut self, client: u64, version: u64) -> &mut Eye {
        let found = self.eyes.iter().position(|eye| eye.client == client);
        if found.is_none() && self.eyes.len() >= MAX_EYES {
            self.eyes.remove(0);
        }
        let new = || Eye { client, version, cache: EyeCache::default(), pace: Pace::default() };
        let mut eye = found.map_or_else(new, |at| self.eyes.remove(at));
        if eye.version != version {
            eye.version = version;
            match self.places.shown() {
                (Some(_), _) => eye.cache.outdate(),
                (None, _) => eye.cache = EyeCache::default(),
            }
        }
        self.eyes.push(eye);
        self.eyes.last_mut().expect("pushed above")
    }

    fn answer(&mut self, stage: Stage<'_>, question: &Question) -> Result<Payload> {
        let bytes = match question {
            Question::Photograph(view) => {
                let photograph = self.photographs.get(stage.renderer, *view)?;
                let size = [photograph.width(), photograph.height()];
                let image = Image::from_pixels(size, photograph.pixels());
                let bytes = picture::encode_jpeg(&image)?;
                return Ok(rendered_as("image/jpeg", bytes, &json!({ "size": size })));
            }
            Question::Pixel(pixel, camera) => explain(stage.renderer, stage.scene, camera, *pixel)?,
            Question::Edit(request) => match &mut self.editor {
                Some(editor) => editor.answer(stage, request)?,
                None => return refuse("the scene is not edited: begin with `--edit FILE`"),
            },
            Question::Place(request) => self.places.answer(stage, *request)?,
        };
        Ok(rendered_as("application/json", bytes, &json!({})))
    }
}

fn rendered_as(kind: &'static str, bytes: Vec<u8>, about: &Value) -> Payload {
    Payload { kind, bytes, about: about.to_string() }
}

/// The result of drawing.
struct Canvas {
    image: Image,
    range: Option<Range>,
    steps: u16,
    report: RenderReport,
}

/// Draws an image. `is_cancelled` is called before each slice of the Gaussians, with the number of finished slices.
fn draw(
    Stage { renderer, scene, .. }: Stage<'_>,
    request: &FrameRequest,
    Eye { cache, pace, .. }: &mut Eye,
    truth: Option<&Photograph>,
    is_cancelled: &(dyn Fn(usize) -> bool + Sync),
) -> Result<Option<Canvas>> {
    let (shrink, steps, renewed) = match request.quality {
        Quality::Moving => (pace.shrink, pace.steps, Some(pace.renewed)),
        Quality::Still => (1, pace.steps, None),
        Quality::Exact => (1, 1, None),
    };
    // errors are compared at the photograph's own pixels
    let camera = &request.camera.shrunk(if truth.is_some() { 1 } else { shrink });
    let size = [camera.width, camera.height];
    let batch = TileBatch::cover(0, size[0], size[1], TILE_SIDE)?;
    let slices = AtomicUsize::new(0);
    let options = EyeOptions {
        channels: request.mode.channels(),
        steps,
        renewed,
        background: request.background,
        is_cancelled: &|| is_cancelled(slices.fetch_add(1, Ordering::Relaxed)),
    };
    let rendered = renderer.render_from_eye(scene, camera, &batch, cache, &options)?;
    let Some(tiles) = rendered else { return Ok(None) };
    let (image, range) = match (request.mode, request.mode.channels()) {
        (Mode::Gaussians, _) => {
            picture::count_image(&renderer.count_gaussians(scene, camera)?, size)
        }
        (mode, [channel]) => {
            let mut image = ChannelImage::new(*channel, size[0], size[1])?;
            image.paste(&batch, &tiles)?;
            picture::channel_image(mode, &image, scene, camera)
        }
        _ => {
            let mut image = Image::new(size[0], size[1])?;
            image.paste(&batch, &tiles)?;
            match truth {
                Some(truth) => picture::error_image(&image, truth)?,
                None => (image, None),
            }
        }
    };
    Ok(Some(Canvas { image, range, steps, report: tiles.report }))
}

// Chooses the coarseness of images while the camera moves, so that motion is fluid on this device and with this
// scene.

/// Target time for the other parts of a moving image, in seconds: projection, composite and encoding.
const DRAW: f64 = 0.030;
/// Target time for colors and transmittances of a moving image, in seconds. If the other parts take longer, so may these.
const FIELDS: f64 = 0.060;
/// Their longest time. A fast motion may ask for that much: an image that comes late is better than a wrong one.
const LONGEST: f64 = 1.0;
/// Longest of T's steps, as a multiple of sigma. Longer ones miss thin surfaces.
const MAX_STEPS: u16 = 2;
/// The values of a Gaussian are at most about this many images old, however slow the device is.
const MAX_AGE: usize = 16;
/// Largest divisor of the sides of moving images.
const MAX_SHRINK: u32 = 4;

/// The coarseness of a client's images while its camera moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Divisor of the image's sides.
    pub shrink: u32,
    /// Factor of the length of T's steps.
    pub steps: u16,
    /// The smallest and the largest number of Gaussians whose values are computed again for each image.
    pub renewed: [usize; 2],
}

impl Default for Pace {
    fn default() -> Self {
        Self { shrink: 2, steps: MAX_STEPS, renewed: [1 << 12, 1 << 16] }
    }
}

impl Pace {
    /// Adapts to an image whose fields took this work, and whose other parts took this many seconds.
    pub fn learn(&mut self, fields: FieldWork, draw: f64) {
        let per_side = f64::from(self.shrink) / f64::from(self.shrink.max(2) - 1);
        if draw > DRAW {
            self.shrink = (self.shrink + 1).min(MAX_SHRINK);
        } else if draw * per_side * per_side < 0.6 * DRAW {
            self.shrink = (self.shrink - 1).max(1);
        }
        // if all was known already, the time says nothing
        if fields.evaluated == 0 {
            return;
        }
        let rate = fields.evaluated as f64 / fields.seconds.max(1e-9);
        let all = fields.gaussians as f64;
        let oldest = fields.gaussians.div_ceil(MAX_AGE);
        self.renewed = [FIELDS, LONGEST].map(|time| ((rate * time.max(draw)) as usize).max(oldest));
        let affordable = rate * FIELDS;
        if affordable < all {
            self.steps = MAX_STEPS;
        } else if self.steps > 1 && affordable > 3.0 * all {
            // all of them at steps of half the length
            self.steps /= 2;
            self.renewed = self.renewed.map(|count| count / 2);
        }
    }
}

/// Most Gaussians in an answer: those with the largest alpha.
const MAX_GAUSSIANS: usize = 200;

/// A pixel, with all digits of its numbers.
#[derive(Debug, Serialize)]
struct Explanation {
    pixel: [i32; 2],
    /// Number of all Gaussians. The page gets those with the largest alpha.
    all: usize,
    gaussians: Vec<Row>,
    #[serde(flatten)]
    inspection: Inspection,
}

/// One Gaussian of the pixel.
#[derive(Debug, Serialize)]
struct Row {
    #[serde(flatten)]
    contribution: Contribution,
    /// Center of the Gaussian on the screen, in pixels.
    mean2d: [f32; 2],
    /// Depth along the camera's axis, in world units.
    depth: f64,
    conic: [f32; 3],
    /// The ray in the unit cube, and T from the Gaussian to the end of each step.
    places: Vec<[f32; 3]>,
    transmittances: Vec<f32>,
}

impl Row {
    fn new(contribution: Contribution, trace: Trace, depth: f64) -> Self {
        let Trace { mean2d, conic, ray } = trace;
        let mut sum = 0.0;
        let mut up_to = |log_rho: &f32| -> f32 {
            sum += log_rho;
            sum.exp()
        };
        let transmittances = ray.log_rho.iter().map(&mut up_to).collect();
        Self { contribution, mean2d, depth, conic, places: ray.places, transmittances }
    }
}

/// Breaks a pixel down.
pub fn explain(
    renderer: &Renderer,
    scene: &DeviceScene,
    camera: &Camera,
    pixel: [i32; 2],
) -> Result<Vec<u8>> {
    let size = [camera.width, camera.height].map(i64::from);
    if !pixel.iter().zip(size).all(|(&at, size)| (0..size).contains(&i64::from(at))) {
        let [x, y] = pixel;
        return refuse(format!("pixel {x},{y} is outside the image"));
    }
    let cameras = std::slice::from_ref(camera);
    let (mut inspection, traces) = renderer.inspect_traced(scene, cameras, 0, pixel)?;
    let contributions = std::mem::take(&mut inspection.contributions);
    let mut rows: Vec<_> = contributions.into_iter().zip(traces).collect();
    rows.retain(|(contribution, _)| contribution.falloff > 0.0);
    rows.sort_by(|(a, _), (b, _)| b.alpha.total_cmp(&a.alpha));
    let all = rows.len();
    rows.truncate(MAX_GAUSSIANS);
    let position = renderer.device().read(&scene.tensors().gaussians.position)?;
    let (position, _) = position.as_chunks::<3>();
    let row = |(contribution, trace): (Contribution, Trace)| {
        let depth = camera.depth(position[contribution.gaussian].map(f64::from));
        Row::new(contribution, trace, depth * scene.config().placement.scale)
    };
    let gaussians = rows.into_iter().map(row).collect();
    let explanation = Explanation { pixel, all, gaussians, inspection };
    serde_json::to_vec(&explanation).or_else(|error| refuse(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_settles_where_an_image_takes_its_time() {
        const GAUSSIANS: usize = 100_000;
        // seconds of a whole image, and of all its samples
        for (whole, samples) in [(0.01, 0.01), (0.1, 0.1), (0.1, 0.2), (0.25, 0.5), (5.0, 5.0)] {
            let mut pace = Pace::default();
            let mut seen = Vec::new();
            for _ in 0..40 {
                let area = f64::from(pace.shrink * pace.shrink);
                let evaluated = pace.renewed[0].min(GAUSSIANS);
                let part = evaluated as f64 / GAUSSIANS as f64;
                let seconds = part * samples / f64::from(pace.steps);
                pace.learn(FieldWork { seconds, gaussians: GAUSSIANS, evaluated }, whole / area);
                seen.push((pace, seconds));
            }
            let settled: Vec<_> =
                seen[20..].iter().map(|(pace, _)| (pace.shrink, pace.steps)).collect();
            assert!(settled.iter().all(|pace| *pace == settled[0]), "{whole}: {seen:?}");
            let (Pace { shrink, steps, renewed: [renewed, _] }, seconds) = seen[39];
            let area = f64::from(shrink * shrink);
            assert!(whole / area <= DRAW || shrink == MAX_SHRINK, "{whole}: {shrink}");
            let oldest = GAUSSIANS / MAX_AGE;
            // less than the other parts take would make no image faster
            let time = FIELDS.max(whole / area);
            assert!(seconds <= 1.01 * time || renewed == oldest, "{samples}: {seconds}");
            let is_used = seconds >= 0.99 * time || renewed >= GAUSSIANS;
            assert!(is_used || renewed == oldest, "{samples}: {seconds}");
            // no device that has time for all of them leaves some out
            assert!(renewed >= GAUSSIANS || samples / f64::from(steps) > time, "{samples}");
            assert!(renewed >= oldest, "{samples}: {renewed}");
        }
    }
}
