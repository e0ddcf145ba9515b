//! The thread that trains, and its messages to and from Python.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender};

use organza::Renderer as Device;
use organza::error::chain;
use organza::ranks::Ranks;
use organza::render::{LossBatch, LossGradient};
use organza::train::report::Reporter;
use organza::train::{self, Event, Outcome, RunFolder, Session, StepHooks, Trainer};

use crate::ranks::PythonRanks;

/// A message of the thread.
pub enum Message {
    Begin(u32),
    Warning(String),
    Step(StepNumbers),
    Evaluated { step: u32, psnr: Option<f64>, ssim: Option<f64> },
    Loss { rendered: Vec<f32>, target: Vec<f32>, valid: Vec<f32>, shape: [usize; 4] },
    Scene(Box<organza::Result<organza::Scene>>),
    End(organza::Result<&'static str>),
}

pub struct StepNumbers {
    pub step: u32,
    pub seconds: Option<f64>,
    pub loss: f64,
    pub psnr: f64,
    pub gaussians: usize,
    pub grown: bool,
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
    pub folder: Option<RunFolder>,
    pub resume: bool,
    pub time_limit: Option<f64>,
    pub has_loss: bool,
    /// The ranks that share the run.
    pub ranks: Option<Arc<PythonRanks>>,
    pub stop: Arc<AtomicBool>,
    pub messages: Sender<Message>,
    pub answers: Receiver<Answer>,
}

impl Run {
    /// Trains to the end.
    pub fn run(self) {
        let outcome = match (&self.ranks, &self.folder) {
            (Some(ranks), _) if ranks.rank() > 0 => self.follow(ranks),
            (_, Some(folder)) => self.in_folder(folder),
            (_, None) => self.without_folder(),
        };
        // the receiver may have gone
        let _ = self.messages.send(Message::End(outcome));
    }

    fn hooks(&self) -> StepHooks<'_> {
        match self.has_loss {
            true => StepHooks::new().loss(|batch| self.loss(batch)),
            false => StepHooks::new(),
        }
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

    fn in_folder(&self, folder: &RunFolder) -> organza::Result<&'static str> {
        let mixed = self.ranks.as_ref().is_some_and(|ranks| ranks.mixed);
        let ranks = self.ranks.clone().map(|ranks| ranks as Arc<dyn Ranks>);
        let session = Session::new(&self.device, &self.config, &self.dataset, folder)
            .with_time_limit(self.time_limit)
            .with_stop(&self.stop)
            .with_ranks(ranks, mixed);
        let mut reporter = Reporter::new(folder);
        let mut now = 0;
        let mut watch = |event: Event<'_>| {
            reporter.see(&event)?;
            match event {
                Event::Begin(step) => {
                    now = step;
                    self.send(Message::Begin(step));
                }
                Event::Warning(text) => self.send(Message::Warning(text.to_owned())),
                Event::Step { step, seconds, report, scene: Some(scene), .. } => {
                    now = step;
                    let loss = report.loss;
                    let psnr = report.psnr;
                    let gaussians = scene.len();
                    let grown = report.grown.is_some();
                    let seconds = Some(seconds);
                    self.step(StepNumbers { step, seconds, loss, psnr, gaussians, grown }, scene);
                }
                Event::Evaluated(evaluation) => {
                    let psnr = evaluation.mean.psnr;
                    let ssim = evaluation.mean.ssim;
                    self.send(Message::Evaluated { step: now, psnr, ssim });
                }
                _ => {}
            }
            Ok(())
        };
        let outcome = session.run_with(self.resume, &mut watch, &mut self.hooks())?;
        Ok(match outcome {
            Outcome::Finished => "finished",
            Outcome::TimeLimit => "time limit",
            _ => "stopped",
        })
    }

    /// Follows the orders of rank 0.
    fn follow(&self, ranks: &Arc<PythonRanks>) -> organza::Result<&'static str> {
        let all: Arc<dyn Ranks> = ranks.clone();
        let followed = train::follow(&self.device, &self.dataset, &all, ranks.mixed);
        followed.inspect_err(|error| ranks.fail(&chain(error)))?;
        Ok("followed")
    }

    fn without_folder(&self) -> organza::Result<&'static str> {
        let config = self.config.clone();
        let dataset = Arc::clone(&self.dataset);
        let mut trainer = Trainer::start(&self.device, config, dataset)?;
        self.send(Message::Begin(0));
        let begin = std::time::Instant::now();
        while !trainer.is_finished() {
            let seconds = begin.elapsed().as_secs_f64();
            if self.time_limit.is_some_and(|limit| seconds >= limit) {
                return Ok("time limit");
            }
            if self.stop.load(Ordering::Relaxed) {
                return Ok("stopped");
            }
            let report = trainer.step_with(&mut self.hooks())?;
            let step = trainer.steps();
            let scene = trainer.scene().expect("a trainer alone has the whole scene");
            let loss = report.loss;
            let psnr = report.psnr;
            let gaussians = scene.len();
            let grown = report.grown.is_some();
            let seconds = Some(begin.elapsed().as_secs_f64());
            self.step(StepNumbers { step, seconds, loss, psnr, gaussians, grown }, scene);
        }
        Ok("finished")
    }

    /// Reports a step, and sends its scene on request, until Python continues.
    fn step(&self, numbers: StepNumbers, scene: &organza::DeviceScene) {
        self.send(Message::Step(numbers));
        while let Ok(Answer::Scene) = self.answers.recv() {
            self.send(Message::Scene(Box::new(scene.download(self.device.device()))));
        }
    }

    fn send(&self, message: Message) {
        // the receiver may have gone
        let _ = self.messages.send(message);
    }
}
