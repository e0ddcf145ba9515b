//! The frame renderer owns the scene, takes requests from the queue, and answers them: images at a pace that motion needs, and clicked pixels.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::explanation::explain;
use super::message::{FrameRequest, Mode, Quality};
use super::pace::Pace;
use super::picture::{self, Range};
use super::queue::{FrameJob, NextJob, Payload, Question, Queue};
use crate::{Editor, Photographs, Places, Stage};
use organza_core::error::{self, Result, refuse};
use organza_core::image::{ChannelImage, Image, TILE_SIDE};
use organza_core::{Camera, RenderReport, TileBatch};
use organza_data::Photograph;
use organza_render::{DeviceScene, EyeCache, EyeOptions};

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
    /// Of the last image that a page asked for.
    camera: Option<Camera>,
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
        let places = Places::default();
        Self { queue, photographs, eyes: Vec::new(), editor: None, places, camera: None }
    }

    /// Pages may change what is shown: with an editor of the same scene, or by the places of others.
    #[must_use]
    pub fn with(self, editor: Option<Editor>, places: Places) -> Self {
        Self { editor, places, ..self }
    }

    /// The camera of the last image that a page asked for.
    pub fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
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
        self.camera = Some(job.request.camera.clone());
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
                ("image/png", image.encode_png().or_else(|error| refuse(error.to_string()))?)
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
            "blocks": stage.blocks,
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
                Some(editor) => editor.answer(stage, &mut self.photographs, request)?,
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
