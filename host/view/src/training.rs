//! Shows a running training: renders images between its steps, within a part of the time.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::server::Server;
use super::stage::Stage;
use super::training_status::TrainingStatus;
use crate::{About, FrameRenderer, PhotographSource, Photographs, Purpose, Queue};
use organza_core::error::Result;
use organza_data::{Dataset, Pose};
use organza_render::{DeviceScene, Renderer};
use organza_train::Event;

/// Longest delay until a signal ends the waiting.
const PATIENCE: Duration = Duration::from_millis(100);

/// Shows a training to clients. It reads the scene between steps and changes nothing, so the training's bits do not
/// depend on it.
#[derive(Debug)]
pub struct TrainingView<'a> {
    renderer: &'a Renderer,
    dataset: &'a Arc<Dataset>,
    /// Set if the page asks to save and stop.
    stop: &'a AtomicBool,
    /// Part of the time that images may take.
    share: f64,
    title: String,
    /// Waits until there is a scene to show, and is started then.
    server: Option<Server>,
    queue: Arc<Queue>,
    training_status: Arc<TrainingStatus>,
    frame_renderer: FrameRenderer,
    clock: Clock,
}

/// Measures the use of time. It stands still while the training waits.
#[derive(Debug)]
struct Clock {
    training: f64,
    images: f64,
    since: Instant,
}

impl Clock {
    fn share(&self) -> f64 {
        self.images / (self.images + self.training).max(1e-9)
    }
}

impl<'a> TrainingView<'a> {
    /// Shows a training on a `server`. Images take up to `share` of the time. The page's button sets `stop`.
    pub fn new(
        server: Server,
        renderer: &'a Renderer,
        dataset: &'a Arc<Dataset>,
        stop: &'a AtomicBool,
        share: f64,
        title: String,
    ) -> Self {
        let queue = Arc::new(Queue::default());
        let photographs = PhotographSource::Dataset(Arc::clone(dataset));
        let frame_renderer = FrameRenderer::new(Arc::clone(&queue), Photographs::new(photographs));
        Self {
            renderer,
            dataset,
            stop,
            share,
            title,
            server: Some(server),
            queue,
            training_status: Arc::default(),
            frame_renderer,
            clock: Clock { training: 0.0, images: 0.0, since: Instant::now() },
        }
    }

    /// Handles an event of a training. After a step, answers the page's requests. If the page has paused the
    /// training, this returns when the pause is over.
    ///
    /// # Errors
    /// The same errors as [`Server::start`].
    pub fn see(&mut self, event: &Event<'_>, steps: u32) -> Result<()> {
        let mut state = self.training_status.state();
        match event {
            Event::Begin(step) => {
                state.step = u64::from(*step);
                state.steps = u64::from(steps);
            }
            Event::Scheduled(steps) => state.steps = u64::from(*steps),
            Event::Evaluated(evaluation) => {
                let step = state.step;
                state.evaluations.step.push(step);
                state.evaluations.psnr.push(evaluation.mean.psnr);
            }
            Event::Step { step, seconds, report, scene, .. } => {
                state.step = u64::from(*step);
                state.seconds = *seconds;
                state.gaussians = scene.len();
                state.share = self.clock.share();
                state.wanted = state.wanted.saturating_sub(1);
                state.curve.push(u64::from(*step), [report.loss, report.psnr]);
                drop(state);
                self.serve(scene, u64::from(*step))?;
            }
            _ => {}
        }
        Ok(())
    }

    fn serve(&mut self, scene: &DeviceScene, version: u64) -> Result<()> {
        if let Some(server) = self.server.take() {
            self.start(server, scene)?;
        }
        let stage = Stage { renderer: self.renderer, scene, version, blocks: None };
        let begin = Instant::now();
        self.clock.training += (begin - self.clock.since).as_secs_f64();
        if self.clock.share() < self.share && self.frame_renderer.serve(stage, Duration::ZERO) {
            self.clock.images += begin.elapsed().as_secs_f64();
        }
        while self.training_status.is_paused() && !self.stop.load(Ordering::Relaxed) {
            self.frame_renderer.serve(stage, PATIENCE);
        }
        if self.training_status.state().stopping {
            self.stop.store(true, Ordering::Relaxed);
        }
        self.clock.since = Instant::now();
        Ok(())
    }

    fn start(&self, server: Server, scene: &DeviceScene) -> Result<()> {
        let Dataset { frames, held_out, points, .. } = &**self.dataset;
        let pose = |(index, frame): (usize, &organza_data::Frame)| {
            let camera = organza_core::Camera {
                file_path: Some(frame.name.clone()),
                ..frame.camera.clone()
            };
            Pose { held_out: held_out.contains(&index), ..Pose::from(camera) }
        };
        let poses: Vec<_> = frames.iter().enumerate().map(pose).collect();
        let about = About::new(&self.title, scene, &poses, true, points, Purpose::Train);
        server.start(Arc::clone(&self.queue), about, Some(Arc::clone(&self.training_status)))
    }
}

impl Drop for TrainingView<'_> {
    fn drop(&mut self) {
        self.queue.stop();
    }
}
