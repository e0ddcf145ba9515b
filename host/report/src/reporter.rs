//! The listener that writes a run's pictures and its report.

use std::path::PathBuf;

use super::pictures::Pictures;
use super::run::Run;
use super::single::write_report;
use organza_core::error::Result;
use organza_train::{Event, REPORT, RunFolder};

/// Keeps what there is to see of a run in its folder: `report.html` with its pictures. It makes them of the
/// [events](Event) of a [`Session`](organza_train::Session): `session.run(false, &mut |event| reporter.see(&event))`.
#[derive(Debug)]
pub struct Reporter {
    folder: PathBuf,
    pictures: Pictures,
    /// Steps so far at the last view.
    step: u64,
}

impl Reporter {
    /// A listener to the run in a folder.
    pub fn new(folder: &RunFolder) -> Self {
        let folder = folder.path().to_owned();
        Self { pictures: Pictures::from_run(&folder), folder, step: 0 }
    }

    /// Writes what belongs to an event.
    ///
    /// # Errors
    /// [`Error::WriteFile`](organza_core::Error::WriteFile); after the log is complete, errors of [`Run::load`], too.
    pub fn see(&mut self, event: &Event<'_>) -> Result<()> {
        match event {
            Event::Opened(step) => self.pictures.begin(*step),
            Event::FirstView(image) => self.pictures.write_first(image),
            Event::View { index, step, frame, image } => {
                self.step = *step;
                self.pictures.write(*index, *step, &frame.image, image)
            }
            Event::Evaluated(_) => {
                self.pictures.keep(self.step);
                Ok(())
            }
            Event::Complete => write_report(self.folder.join(REPORT), &Run::load(&self.folder)?),
            _ => Ok(()),
        }
    }
}
