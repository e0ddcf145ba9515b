//! The curves and buttons of a training on the page.

use parking_lot::{Mutex, MutexGuard};
use serde::{Deserialize, Serialize};

/// Most points of a curve. If there are more, every second one is dropped.
const MAX_POINTS: usize = 2000;

/// A command from the page to a training.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
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

/// What the page shows.
#[derive(Clone, Debug, Default, Serialize)]
pub struct TrainingState {
    pub step: u64,
    pub steps: u64,
    pub seconds: f64,
    pub gaussians: usize,
    pub paused: bool,
    /// Whether the page has asked to stop.
    pub stopping: bool,
    /// Part of the time that images took.
    pub share: f64,
    pub curve: Curve,
    pub evaluations: Evaluations,
    /// Number of steps requested while the training waits.
    #[serde(skip)]
    pub wanted: u64,
}

/// A curve over steps. Each point is the mean of the steps since the previous point.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Curve {
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

/// Mean PSNR of held-out views.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Evaluations {
    pub step: Vec<u64>,
    pub psnr: Vec<Option<f64>>,
}

impl Curve {
    /// Adds the loss and the PSNR of a step.
    pub fn push(&mut self, step: u64, values: [f64; 2]) {
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
    /// The state, for as long as the guard lives.
    pub fn state(&self) -> MutexGuard<'_, TrainingState> {
        self.state.lock()
    }

    /// Executes a command of the page.
    pub fn command(&self, command: Command) {
        let mut state = self.state();
        match command {
            Command::Pause => {
                state.paused = true;
                state.wanted = 0;
            }
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
    pub fn to_json(&self) -> String {
        let state = self.state().clone();
        serde_json::to_string(&state).expect("numbers and names")
    }
}
