//! A run from its first step, or from a checkpoint, to its end: its settings, log, checkpoints and scores in its folder.

mod first_steps;
mod open;
mod run;
mod state;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::start::StartNote;
use crate::{Change, Evaluation, RunFolder, StepReport, TrainConfig};
use organza_core::ranks::Ranks;
use organza_core::{Image, Result};
use organza_data::{Dataset, Frame};
use organza_render::{DeviceScene, Renderer};

/// A training run in a folder: a [`Trainer`](crate::Trainer) with a log, checkpoints and evaluations. Its listener
/// makes more of its [events](Event), such as a report.
///
/// ```
/// use std::sync::Arc;
///
/// use muslin_device::DeviceOptions;
/// use organza_render::Renderer;
/// use organza_train::{CHECKPOINT, Event, Outcome, RunFolder, Session, TrainConfig, built_in};
///
/// let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(None))?);
/// let dataset = Arc::new(built_in::dataset(&renderer, 4, 32, 2)?);
/// let mut config = TrainConfig::default();
/// config.run.steps = 2;
/// config.run.tiles_per_step = 2;
/// config.run.tile_size = 16;
/// config.start.gaussians = 100;
///
/// let path = tempfile::tempdir().expect("a folder");
/// let folder = RunFolder::lock(path.path(), false)?;
/// let session = Session::new(&renderer, &config, &dataset, &folder);
/// let mut steps = 0;
/// let outcome = session.run(false, &mut |event| {
///     steps += usize::from(matches!(event, Event::Step { .. }));
///     Ok(())
/// })?;
/// assert_eq!((outcome, steps), (Outcome::Finished, 2));
/// assert!(path.path().join(CHECKPOINT).exists());
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Debug)]
#[non_exhaustive]
pub struct Session<'a> {
    /// Renders and trains.
    pub renderer: &'a Renderer,
    /// All settings. Open numbers of steps and of Gaussians are chosen.
    pub config: &'a TrainConfig,
    /// The photographs.
    pub dataset: &'a Arc<Dataset>,
    /// The folder of the run. A new run writes its settings there.
    pub folder: &'a RunFolder,
    /// Seconds of training after which the run ends early, including those before a resume.
    pub time_limit: Option<f64>,
    /// Seconds that the run should take. The number of steps is chosen to fit, and written to its settings. It
    /// replaces the number in `config`.
    pub scheduled: Option<f64>,
    /// The command line, for the log.
    pub command: Option<String>,
    /// A flag that another thread sets to save and stop.
    pub stop: &'a AtomicBool,
    /// Steps that a GPU may be ahead of the last [`Event::Step`]. With 0, its scene is exactly the step's.
    pub ahead: usize,
    /// The ranks that share the run. This one is rank 0: only it reads and writes files. The others call
    /// [`follow`](super::follow). The scene's bits do not depend on them.
    pub ranks: Option<Arc<dyn Ranks>>,
    /// Whether ranks may differ in program and device. The scene's bits then depend on which rank computes what.
    pub mixed: bool,
}

/// Progress of a run.
#[derive(Debug)]
#[non_exhaustive]
pub enum Event<'a> {
    /// A warning for the user.
    Warning(&'a str),
    /// There are no points to start from: training starts from places that the photographs suggest.
    Suggested {
        /// Number of these places.
        places: usize,
        /// Number of random places besides.
        random: usize,
    },
    /// Training starts after this many steps, 0 for a new run. Nothing has been written to the folder yet.
    Begin(u32),
    /// A setting has a different value than before the resume.
    Changed(&'a Change),
    /// The settings and the log are written, and hold nothing of a later step than this one. Other records of the run now continue, or
    /// begin anew.
    Opened(u64),
    /// The number of steps was chosen again.
    Scheduled(u32),
    /// A step is done.
    Step {
        /// Steps so far.
        step: u32,
        /// Seconds of training so far.
        seconds: f64,
        /// Measurements of the step.
        report: &'a StepReport,
        /// Number of Gaussians.
        gaussians: usize,
        /// The scene on the device, which can be [some steps](Session::ahead) newer.
        scene: &'a DeviceScene,
    },
    /// The first held-out view, as the scene shows it before the first step.
    FirstView(&'a Image),
    /// Held-out views are being measured.
    Evaluating,
    /// A held-out view was measured.
    View {
        /// Index of the view among those that are measured.
        index: usize,
        /// Steps so far.
        step: u64,
        /// The photograph and its camera.
        frame: &'a Frame,
        /// The rendered image, of the photograph's size.
        image: &'a Image,
    },
    /// The held-out views were measured.
    Evaluated(&'a Evaluation),
    /// The log is complete up to here: after an evaluation, and at the end.
    Complete,
}

impl<'a> From<&'a StartNote> for Event<'a> {
    fn from(note: &'a StartNote) -> Self {
        match note {
            StartNote::Warning(text) => Self::Warning(text),
            StartNote::Suggested { places, random } => {
                Self::Suggested { places: *places, random: *random }
            }
        }
    }
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// After its last step.
    Finished,
    /// At its time limit.
    TimeLimit,
    /// Stopped from outside.
    Stopped,
}

/// A listener to a session. Its error ends the run.
pub type Watch<'w> = dyn FnMut(Event<'_>) -> Result<()> + 'w;

/// Steps that are queued on a GPU before the host reads a loss: enough that the GPU never waits. Memory does not depend on it.
const STEPS_AHEAD: usize = 2;

/// A stop flag that is never set.
static NEVER: AtomicBool = AtomicBool::new(false);

impl<'a> Session<'a> {
    /// A run without a time limit and without a stop flag.
    #[must_use]
    pub fn new(
        renderer: &'a Renderer,
        config: &'a TrainConfig,
        dataset: &'a Arc<Dataset>,
        folder: &'a RunFolder,
    ) -> Self {
        Self {
            renderer,
            config,
            dataset,
            folder,
            time_limit: None,
            scheduled: None,
            command: None,
            stop: &NEVER,
            ahead: STEPS_AHEAD,
            ranks: None,
            mixed: false,
        }
    }
}
