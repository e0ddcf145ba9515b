//! Listens to a run, and keeps its pictures, its report and TensorBoard's file.

use super::pictures::Pictures;
use super::run::Run;
use super::single::write_report;
use super::tensorboard::{EventLog, MAX_VIEWS};
use organza_core::error::Result;
use organza_core::image::Image;
use organza_data::Frame;
use organza_train::metrics::Record;
use organza_train::{Event, REPORT, RunFolder, TrainConfig};
use std::path::PathBuf;

/// Keeps what there is to see of a run in its folder: `report.html` with its pictures, and TensorBoard's file if the
/// settings ask for it. It makes them of the [events](Event) of a [`Session`](organza_train::Session).
///
/// ```
/// use std::sync::Arc;
///
/// use muslin_device::DeviceOptions;
/// use organza_render::Renderer;
/// use organza_report::Reporter;
/// use organza_train::{Outcome, RunFolder, Session, TrainConfig, built_in};
///
/// let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(None))?);
/// let dataset = Arc::new(built_in::dataset(&renderer, 4, 32, 2)?);
/// let mut config = TrainConfig::default();
/// (config.run.steps, config.run.tiles_per_step, config.run.tile_size) = (2, 2, 16);
/// config.start.gaussians = 100;
///
/// let path = tempfile::tempdir().expect("a folder");
/// let folder = RunFolder::lock(path.path(), false)?;
/// let session = Session::new(&renderer, &config, &dataset, &folder);
/// let mut reporter = Reporter::new(&folder, &config);
/// let outcome = session.run(false, &mut |event| reporter.see(&event))?;
/// assert_eq!(outcome, Outcome::Finished);
/// assert!(path.path().join("report.html").exists());
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Debug)]
pub struct Reporter {
    folder: PathBuf,
    pictures: Pictures,
    has_tensorboard: bool,
    /// TensorBoard's file, if the settings ask for it.
    events: Option<EventLog>,
    /// Whether an earlier evaluation has written the photographs for TensorBoard.
    has_photographs: bool,
    /// The views of an evaluation that goes on, for TensorBoard.
    shown: Vec<Shown>,
    /// Steps so far at the last view.
    step: u64,
}

/// A view for TensorBoard.
#[derive(Debug)]
struct Shown {
    name: String,
    rendered: Image,
    photograph: Option<Image>,
}

impl Reporter {
    /// A listener to a run with these settings.
    #[must_use]
    pub fn new(folder: &RunFolder, config: &TrainConfig) -> Self {
        Self {
            folder: folder.path().to_owned(),
            pictures: Pictures::of_run(folder.path()),
            has_tensorboard: config.run.tensorboard,
            events: None,
            has_photographs: false,
            shown: Vec::new(),
            step: 0,
        }
    }

    /// Writes what belongs to an event.
    ///
    /// # Errors
    /// [`Error::WriteFile`](organza_core::Error::WriteFile); after the log is complete, those of [`Run::load`], too.
    pub fn see(&mut self, event: &Event<'_>) -> Result<()> {
        match event {
            Event::Opened { step, resume } => self.open(*step, *resume),
            Event::FirstView(image) => self.pictures.write_first(image),
            Event::Evaluating => {
                self.shown.clear();
                Ok(())
            }
            Event::View { index, step, frame, image, always } => {
                self.step = *step;
                self.pictures.write(*index, *step, &frame.image, image)?;
                if *always {
                    self.keep(frame, image);
                }
                Ok(())
            }
            Event::Logged(record) => self.log(record),
            Event::Evaluated(_) => {
                self.pictures.keep(self.step);
                Ok(())
            }
            Event::Complete => write_report(self.folder.join(REPORT), &Run::load(&self.folder)?),
            _ => Ok(()),
        }
    }

    fn open(&mut self, step: u64, resume: bool) -> Result<()> {
        self.pictures.begin(step)?;
        if !self.has_tensorboard {
            return Ok(());
        }
        let events = match resume {
            true => EventLog::resume(&self.folder, step)?,
            false => EventLog::create(&self.folder)?,
        };
        self.events = Some(events);
        self.has_photographs = !Run::load(&self.folder)?.evaluations().is_empty();
        Ok(())
    }

    /// Keeps a view for TensorBoard until its evaluation is logged. Every evaluation shows the same views.
    fn keep(&mut self, frame: &Frame, image: &Image) {
        if self.events.is_none() || self.shown.len() >= MAX_VIEWS {
            return;
        }
        let photograph =
            (!self.has_photographs).then(|| Image::of_pixels(image.size(), frame.image.pixels()));
        self.shown.push(Shown { name: frame.name.clone(), rendered: image.clone(), photograph });
    }

    /// Writes a record of the log for TensorBoard.
    fn log(&mut self, record: &Record) -> Result<()> {
        let Some(events) = &mut self.events else { return Ok(()) };
        match record {
            Record::Step { step, loss, psnr, gaussians, rates, .. } => {
                let numbers = [("loss", *loss), ("psnr", *psnr), ("gaussians", *gaussians as f64)];
                let numbers = numbers.map(|(tag, value)| (format!("train/{tag}"), Some(value)));
                let rates = rates
                    .iter()
                    .map(|(name, rate)| (format!("learning_rate/{name}"), Some(f64::from(*rate))));
                events.scalars(*step, numbers.into_iter().chain(rates))
            }
            Record::Evaluation { step, psnr, ssim, .. } => {
                let scores = [("psnr", *psnr), ("ssim", *ssim)];
                let scores = scores.map(|(tag, score)| (format!("held_out/{tag}"), score));
                events.scalars(*step, scores)?;
                for Shown { name, rendered, photograph } in self.shown.drain(..) {
                    events.picture(*step, format!("{name}/rendered"), &rendered)?;
                    if let Some(photograph) = photograph {
                        events.picture(*step, format!("{name}/photograph"), &photograph)?;
                    }
                }
                self.has_photographs = true;
                Ok(())
            }
            _ => Ok(()),
        }
    }
}
