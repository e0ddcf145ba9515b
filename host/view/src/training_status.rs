//! The state of a training for the page: its curves, and the buttons to pause, step and stop.

use std::sync::{Mutex, MutexGuard, PoisonError};

use serde::Serialize;

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

    /// Training begins or continues after `step` steps.
    pub fn begin(&self, step: u64, steps: u64) {
        let mut state = self.state();
        state.step = step;
        state.steps = steps;
    }

    /// The total number of steps was chosen.
    pub fn planned(&self, steps: u64) {
        self.state().steps = steps;
    }

    /// A step is done; `share` is the part of the time that images took.
    pub fn step(
        &self,
        step: u64,
        seconds: f64,
        [loss, psnr]: [f64; 2],
        gaussians: usize,
        share: f64,
    ) {
        let mut state = self.state();
        state.step = step;
        state.seconds = seconds;
        state.gaussians = gaussians;
        state.share = share;
        state.wanted = state.wanted.saturating_sub(1);
        state.curve.push(step, [loss, psnr]);
    }

    /// Held-out views were measured.
    pub fn evaluated(&self, psnr: Option<f64>) {
        let mut state = self.state();
        let step = state.step;
        state.evaluations.step.push(step);
        state.evaluations.psnr.push(psnr);
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

    /// Whether to save and stop.
    pub fn is_stopping(&self) -> bool {
        self.state().stopping
    }

    /// The whole state as JSON.
    pub(super) fn to_json(&self) -> String {
        let state = self.state().clone();
        serde_json::to_string(&state).expect("numbers and names")
    }
}
