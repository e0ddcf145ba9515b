//! Says so if a run shows nothing, or learns nothing, from its first step on.

use super::Event;
use super::state::SessionState;
use crate::step_report::StepReport;
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::scene::Scene;

/// Steps after which some Gaussian must have been in a tile.
const SEEN_AFTER: u32 = 10;
/// Steps after which the loss must have moved, and number of steps at each end whose mean is compared.
const MOVED_AFTER: u32 = 200;
const ENDS: u32 = 50;
/// Least part of the loss that must be gone by then. Tiles differ, so a loss that stands still moves a little, too.
const LEAST_GAIN: f64 = 0.03;

/// The mean losses of the first steps of a new run, and of the last ones before it is judged.
#[derive(Debug, Default)]
pub(super) struct FirstSteps([f64; 2]);

impl SessionState<'_, '_, '_> {
    /// Judges a new run by the steps so far.
    pub(super) fn judge(&mut self, report: &StepReport) -> Result<()> {
        let step = self.trainer.steps();
        // the other part of the loss depends on how coarse images are
        let loss = if report.l1.is_finite() { report.l1 } else { report.loss };
        if step <= ENDS {
            self.first_steps.0[0] += loss / f64::from(ENDS);
        } else if (MOVED_AFTER - ENDS + 1..=MOVED_AFTER).contains(&step) {
            self.first_steps.0[1] += loss / f64::from(ENDS);
        }
        // Gaussians that another program has made may be as good as they can be
        let is_new = self.trainer.config().start.path.is_none();
        let reason = match step {
            // growth forgets what was seen
            SEEN_AFTER if report.grown.is_none() && self.trainer.seen()? == Some(0) => {
                format!("the first {SEEN_AFTER} steps have shown no Gaussian")
            }
            MOVED_AFTER if is_new => {
                let [first, last] = self.first_steps.0;
                // also false if the run was resumed meanwhile, and the first losses are unknown
                if first == 0.0 || last < (1.0 - LEAST_GAIN) * first {
                    return Ok(());
                }
                format!(
                    "the loss has not moved in {step} steps: the mean difference from the photographs was {first:.4}, \
                     and is {last:.4}"
                )
            }
            _ => return Ok(()),
        };
        let looked_at = self.looked_at()?;
        (self.watch)(Event::Warning(&format!("{reason}; {looked_at}")))
    }

    /// The facts that explain an empty image.
    fn looked_at(&self) -> Result<String> {
        let cameras = self.trainer.cameras();
        let dataset = self.session.dataset;
        let device = self.session.renderer.device();
        let Scene { gaussians, config, .. } = self.trainer.shard().download(device)?;
        let in_image = |place: &&[f32; 3]| {
            let place = place.map(f64::from);
            cameras.iter().any(|camera| camera.depth_in_image(place).is_some())
        };
        let inside = gaussians.position.iter().filter(in_image).count();
        let all = gaussians.len();
        let box_of = |places: &mut dyn Iterator<Item = [f64; 3]>| {
            let ends = places.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |ends, place| {
                let [low, high] = ends;
                let low = std::array::from_fn(|axis| low[axis].min(place[axis]));
                let high = std::array::from_fn(|axis| high[axis].max(place[axis]));
                [low, high]
            });
            let shown = |corner: [f64; 3]| corner.map(|x| format!("{x:.3}")).join(",");
            let [low, high] = ends.map(shown);
            format!("{low} to {high}")
        };
        let world = |place: [f64; 3]| config.placement.world(place);
        let mut places = gaussians.position.iter().map(|place| world(place.map(f64::from)));
        let mut eyes = cameras.iter().map(Camera::eye).map(world);
        let places = box_of(&mut places);
        let eyes = box_of(&mut eyes);
        let mut text = format!(
            "{inside} of {all} Gaussians are in the image of some photograph; they lie at {places}, and the cameras at {eyes}"
        );
        if let Some(file) = &dataset.points_file {
            text += &format!("; the points of {} may belong to other cameras", file.display());
        }
        Ok(text)
    }
}
