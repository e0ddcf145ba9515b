//! Training step by step: a thread trains, and Python asks it for the next event by messages.

use std::path::{Path, PathBuf, absolute};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;

use numpy::{IntoPyArray, PyArrayMethods, PyReadonlyArray4};
use organza::Renderer as Device;
use organza::data::DatasetOptions;
use organza::render::{LossBatch, LossGradient, OwnLoss};
use organza::train::report::Reporter;
use organza::train::{self, CHECKPOINT, ConfigBuilder, Event, Outcome, Preset, RunFolder, Session};
use parking_lot::{Mutex, MutexGuard};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::data::Dataset;
use crate::error::{invalid, raise};
use crate::job;
use crate::renderer::Renderer;
use crate::scene::Scene;

/// All settings of a run.
#[pyclass(frozen, module = "organza._organza")]
pub struct TrainConfig(organza::TrainConfig);

#[pymethods]
impl TrainConfig {
    /// Combines a preset, a file that overrides it, and assignments such as `run.steps=300` that override both.
    #[new]
    fn new(
        preset: Option<&str>,
        file: Option<PathBuf>,
        assignments: Vec<String>,
    ) -> PyResult<Self> {
        let preset = preset.map_or(Ok(Preset::Default), named)?;
        let mut builder = ConfigBuilder::new(preset).map_err(raise)?;
        if let Some(file) = file {
            builder = builder.file(file).map_err(raise)?;
        }
        for assignment in &assignments {
            builder = builder.set(assignment).map_err(raise)?;
        }
        builder.build().map(Self).map_err(raise)
    }

    /// The settings of a run's folder.
    #[staticmethod]
    fn from_run(folder: PathBuf) -> PyResult<Self> {
        train::settings_of(&folder).map(Self).map_err(raise)
    }

    /// The text of a settings file.
    fn to_toml(&self) -> String {
        self.0.to_toml()
    }
}

/// The preset of a name.
fn named(name: &str) -> PyResult<Preset> {
    let found = Preset::ALL.into_iter().find(|preset| preset.name() == name);
    found.ok_or_else(|| {
        let names = Preset::ALL.map(Preset::name).join("`, `");
        invalid(format!("there is no preset `{name}`; expected `{names}`"))
    })
}

/// A run in progress in a thread.
#[pyclass(frozen, module = "organza._organza")]
pub struct Training {
    channel: Mutex<Channel>,
    stop: Arc<AtomicBool>,
}

struct Channel {
    messages: Receiver<Message>,
    /// `None` after the end.
    answers: Option<Sender<Answer>>,
    thread: Option<JoinHandle<()>>,
}

#[pymethods]
impl Training {
    #[new]
    #[pyo3(signature = (renderer, config, dataset, path, output, resume, time_limit, has_loss))]
    #[expect(clippy::too_many_arguments, reason = "the package names them")]
    fn new(
        py: Python<'_>,
        renderer: &Renderer,
        config: &TrainConfig,
        dataset: Option<&Dataset>,
        path: Option<PathBuf>,
        output: PathBuf,
        resume: bool,
        time_limit: Option<f64>,
        has_loss: bool,
    ) -> PyResult<Self> {
        let mut config = config.0.clone();
        if let Some(path) = path {
            // absolute, because a run may be resumed from another folder
            config.data.path = Some(absolute(&path).unwrap_or(path));
        }
        if let Some(dataset) = dataset {
            config.data = dataset.data.clone();
        }
        config.check_memory().map_err(raise)?;
        // a run goes on in the coordinates of its scene
        let checkpoint = output.join(CHECKPOINT);
        let placement = match resume && checkpoint.exists() {
            true => Some(organza::Scene::load_config(checkpoint).map_err(raise)?.placement),
            false => None,
        };
        let (messages, receiver) = channel();
        let dataset = match dataset {
            // its warnings are known
            Some(dataset) => Arc::clone(&dataset.dataset),
            None => {
                let options = DatasetOptions { placement, ..config.data.options() };
                let read = Dataset::open(py, config.data.clone(), options, Some(&renderer.0))?;
                let warnings = read.dataset.notes.iter().cloned().map(Message::Warning);
                warnings.for_each(|warning| drop(messages.send(warning)));
                read.dataset
            }
        };
        config.resolve(&dataset, renderer.0.device());
        let folder = open_folder(&output, resume)?;
        let stop = Arc::new(AtomicBool::new(false));
        let (sender, answers) = channel();
        let run = Run {
            device: renderer.0.clone(),
            config,
            dataset,
            folder,
            resume,
            time_limit,
            has_loss,
            stop: Arc::clone(&stop),
            messages,
            answers,
        };
        let thread = Some(job::spawn(move || run.run())?);
        let channel = Channel { messages: receiver, answers: Some(sender), thread };
        Ok(Self { channel: Mutex::new(channel), stop })
    }

    /// Waits for the next event. Returns its kind and its data.
    fn wait<'py>(&self, py: Python<'py>) -> PyResult<(&'static str, Bound<'py, PyDict>)> {
        let dict = PyDict::new(py);
        let mut channel = self.lock()?;
        if channel.answers.is_none() {
            return Ok(("end", dict));
        }
        let Some(message) = job::receive(py, &mut channel.messages)? else {
            channel.answers = None;
            return Err(job::panicked(channel.thread.take().expect("it is there until the end")));
        };
        let kind = match message {
            Message::Warning(text) => {
                dict.set_item("text", text)?;
                "warning"
            }
            Message::Step { step, seconds, loss, psnr, gaussians, densified } => {
                dict.set_item("step", step)?;
                dict.set_item("seconds", seconds)?;
                dict.set_item("loss", loss)?;
                dict.set_item("psnr", psnr)?;
                dict.set_item("gaussians", gaussians)?;
                dict.set_item("densified", densified)?;
                "step"
            }
            Message::Evaluated { step, psnr, ssim } => {
                dict.set_item("step", step)?;
                dict.set_item("psnr", psnr)?;
                dict.set_item("ssim", ssim)?;
                "evaluated"
            }
            Message::Loss { rendered, target, valid, shape } => {
                let [count, _, height, width] = shape;
                dict.set_item("rendered", rendered.into_pyarray(py).reshape(shape)?)?;
                dict.set_item("target", target.into_pyarray(py).reshape(shape)?)?;
                let valid = valid.into_pyarray(py).reshape([count, 1, height, width])?;
                dict.set_item("valid", valid)?;
                "loss"
            }
            Message::Scene(_) => unreachable!("`scene` takes it"),
            Message::End(outcome) => {
                channel.answers = None;
                dict.set_item("outcome", outcome.map_err(raise)?)?;
                "end"
            }
        };
        Ok((kind, dict))
    }

    /// Continues after a step.
    fn proceed(&self) -> PyResult<()> {
        self.lock()?.answer(Answer::Continue);
        Ok(())
    }

    /// The scene after the last reported step.
    fn scene(&self, py: Python<'_>) -> PyResult<Scene> {
        let mut channel = self.lock()?;
        channel.answer(Answer::Scene);
        match job::receive(py, &mut channel.messages)? {
            Some(Message::Scene(scene)) => scene.map(Scene::new).map_err(raise),
            _ => Err(invalid("training has ended")),
        }
    }

    /// Answers a request with the loss and `grad_tiles [K, 3, S, S]`, dL/dY.
    fn answer(&self, loss: f64, grad_tiles: PyReadonlyArray4<'_, f32>) -> PyResult<()> {
        let grad_tiles = grad_tiles.as_slice()?.to_vec();
        self.lock()?.answer(Answer::Loss(LossGradient { loss, grad_tiles }));
        Ok(())
    }

    /// Reports that the loss has raised an exception.
    fn fail(&self) -> PyResult<()> {
        self.lock()?.answer(Answer::Failed);
        Ok(())
    }

    /// Saves and stops after the next step; `wait` then returns the end.
    fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// Saves, stops, and waits for the end.
    fn close(&self, py: Python<'_>) {
        self.stop();
        py.detach(|| self.channel.lock().close());
    }
}

impl Training {
    /// Locks the channel. A waiting call holds the lock until the next event, so this must not wait.
    fn lock(&self) -> PyResult<MutexGuard<'_, Channel>> {
        self.channel.try_lock().ok_or_else(|| invalid("another thread waits for this run"))
    }
}

impl Drop for Training {
    fn drop(&mut self) {
        self.stop();
        let channel = self.channel.get_mut();
        if channel.thread.is_some() {
            Python::attach(|py| py.detach(|| channel.close()));
        }
    }
}

impl Channel {
    fn answer(&self, answer: Answer) {
        if let Some(answers) = &self.answers {
            // if it has ended with an error, the next message has it
            let _ = answers.send(answer);
        }
    }

    fn close(&mut self) {
        self.answers = None;
        if let Some(thread) = self.thread.take() {
            // a panic was reported, or is not asked for
            let _ = thread.join();
        }
    }
}

fn open_folder(path: &Path, resume: bool) -> PyResult<RunFolder> {
    if !resume {
        let made = std::fs::create_dir_all(path);
        made.map_err(|source| raise(organza::Error::write(path, source)))?;
    }
    RunFolder::lock(path, resume).map_err(raise)
}

/// A message of the thread.
pub enum Message {
    Warning(String),
    Step { step: u32, seconds: f64, loss: f64, psnr: f64, gaussians: usize, densified: bool },
    Evaluated { step: u32, psnr: Option<f64>, ssim: Option<f64> },
    Loss { rendered: Vec<f32>, target: Vec<f32>, valid: Vec<f32>, shape: [usize; 4] },
    Scene(Box<organza::Result<organza::Scene>>),
    End(organza::Result<&'static str>),
}

/// An answer of Python.
pub enum Answer {
    /// After a step: continue.
    Continue,
    /// After a step: send the scene, and wait for another answer.
    Scene,
    Loss(LossGradient),
    /// The loss has raised an exception.
    Failed,
}

/// The parts of a run, for its thread.
pub struct Run {
    pub device: Device,
    pub config: organza::TrainConfig,
    pub dataset: Arc<organza::Dataset>,
    pub folder: RunFolder,
    pub resume: bool,
    pub time_limit: Option<f64>,
    pub has_loss: bool,
    pub stop: Arc<AtomicBool>,
    pub messages: Sender<Message>,
    pub answers: Receiver<Answer>,
}

impl Run {
    /// Trains to the end.
    pub fn run(self) {
        let outcome = self.train();
        // the receiver may have gone
        let _ = self.messages.send(Message::End(outcome));
    }

    fn loss(&self, batch: &LossBatch<'_>) -> organza::Result<LossGradient> {
        self.send(Message::Loss {
            rendered: batch.rendered.data.clone(),
            target: batch.target.image.to_vec(),
            valid: batch.target.valid.to_vec(),
            shape: batch.batch.output_shape(),
        });
        match self.answers.recv() {
            Ok(Answer::Loss(found)) => Ok(found),
            _ => Err(organza::Error::Argument { reason: "the loss gave no answer".into() }),
        }
    }

    fn train(&self) -> organza::Result<&'static str> {
        let mut session = Session::new(&self.device, &self.config, &self.dataset, &self.folder);
        session.time_limit = self.time_limit;
        session.stop = &self.stop;
        // a caller may keep the scene of a step
        session.ahead = 0;
        let mut reporter = Reporter::new(&self.folder);
        let mut now = 0;
        let mut watch = |event: Event<'_>| {
            reporter.see(&event)?;
            match event {
                Event::Begin(step) => now = step,
                Event::Warning(text) => self.send(Message::Warning(text.to_owned())),
                Event::Step { step, seconds, report, scene, .. } => {
                    now = step;
                    self.send(Message::Step {
                        step,
                        seconds,
                        loss: report.loss,
                        psnr: report.psnr,
                        gaussians: scene.len(),
                        densified: report.densified.is_some(),
                    });
                    self.send_scenes(scene);
                }
                Event::Evaluated(evaluation) => {
                    let psnr = evaluation.mean.psnr;
                    self.send(Message::Evaluated { step: now, psnr, ssim: evaluation.mean.ssim });
                }
                _ => {}
            }
            Ok(())
        };
        let mut loss: OwnLoss<'_> = Box::new(|batch| self.loss(batch));
        Ok(match session.run_with(self.resume, &mut watch, self.has_loss.then_some(&mut loss))? {
            Outcome::Finished => "finished",
            Outcome::TimeLimit => "time limit",
            _ => "stopped",
        })
    }

    /// Sends the scene of a step on request, until Python continues.
    fn send_scenes(&self, scene: &organza::DeviceScene) {
        while let Ok(Answer::Scene) = self.answers.recv() {
            self.send(Message::Scene(Box::new(scene.download(self.device.device()))));
        }
    }

    fn send(&self, message: Message) {
        // the receiver may have gone
        let _ = self.messages.send(message);
    }
}
