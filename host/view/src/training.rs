//! Shows a running training: renders images between its steps, within a part of the time, and keeps its curves and buttons.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::server::Server;
use crate::{About, FrameRenderer, PhotographSource, Photographs, Purpose, Queue};
use organza_core::error::Result;
use organza_data::{Dataset, Pose};
use organza_render::{DeviceScene, Renderer};
use organza_train::Event;
use serde::Serialize;

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
        let clock = Clock { training: 0.0, images: 0.0, since: Instant::now() };
        let server = Some(server);
        let training_status = Arc::default();
        Self {
            renderer,
            dataset,
            stop,
            share,
            title,
            server,
            queue,
            training_status,
            frame_renderer,
            clock,
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
        let stage = Stage { renderer: self.renderer, scene, version };
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
            Pose { camera, held_out: held_out.contains(&index), photograph: None, distorted: false }
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

/// Most points of a curve. If there are more, every second one is dropped.
const MAX_POINTS: usize = 2000;

/// A command from the page to a training.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Command {
    /// Wait before the next step.
    Pause,
    /// Go on.
    Go,
    /// Take one step, then wait.
    Step,
    /// Save and stop.
    Stop,
}

/// The state of a training that the page shows.
#[derive(Debug, Default)]
pub struct TrainingStatus {
    state: Mutex<TrainingState>,
}

#[derive(Clone, Debug, Default, Serialize)]
struct TrainingState {
    step: u64,
    steps: u64,
    seconds: f64,
    gaussians: usize,
    paused: bool,
    /// Whether the page has asked to stop.
    stopping: bool,
    /// Part of the time that images took.
    share: f64,
    curve: Curve,
    evaluations: Evaluations,
    /// Number of steps requested while the training waits.
    #[serde(skip)]
    wanted: u64,
}

/// A curve over steps. Each point is the mean of the steps since the previous point.
#[derive(Clone, Debug, Default, Serialize)]
struct Curve {
    step: Vec<u64>,
    loss: Vec<Option<f64>>,
    psnr: Vec<Option<f64>>,
    #[serde(skip)]
    every: u64,
    #[serde(skip)]
    sum: [f64; 2],
    #[serde(skip)]
    count: u64,
}

#[derive(Clone, Debug, Default, Serialize)]
struct Evaluations {
    step: Vec<u64>,
    psnr: Vec<Option<f64>>,
}

impl Curve {
    fn push(&mut self, step: u64, values: [f64; 2]) {
        self.count += 1;
        self.sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        if self.count < self.every {
            return;
        }
        let mean = self.sum.map(|sum| sum / self.count as f64);
        let [loss, psnr] = mean.map(|mean| mean.is_finite().then_some(mean));
        self.step.push(step);
        self.loss.push(loss);
        self.psnr.push(psnr);
        self.sum = [0.0; 2];
        self.count = 0;
        if self.step.len() > MAX_POINTS {
            self.every = 2 * self.every.max(1);
            self.step = second(&self.step);
            self.loss = second(&self.loss);
            self.psnr = second(&self.psnr);
        }
    }
}

/// Every second value.
fn second<T: Copy>(values: &[T]) -> Vec<T> {
    values.iter().skip(1).step_by(2).copied().collect()
}

impl TrainingStatus {
    fn state(&self) -> MutexGuard<'_, TrainingState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Executes a command of the page.
    pub fn command(&self, command: Command) {
        let mut state = self.state();
        match command {
            Command::Pause => (state.paused, state.wanted) = (true, 0),
            Command::Go => state.paused = false,
            Command::Step => {
                state.paused = true;
                state.wanted += 1;
            }
            Command::Stop => state.stopping = true,
        }
    }

    /// Whether to wait before the next step.
    pub fn is_paused(&self) -> bool {
        let state = self.state();
        state.paused && state.wanted == 0 && !state.stopping
    }

    /// The whole state as JSON.
    pub(super) fn to_json(&self) -> String {
        let state = self.state().clone();
        serde_json::to_string(&state).expect("numbers and names")
    }
}

/// The current scene.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// The renderer of the scene.
    pub renderer: &'a Renderer,
    /// The scene.
    pub scene: &'a DeviceScene,
    /// Changes with the scene: the number of training steps.
    pub version: u64,
}
