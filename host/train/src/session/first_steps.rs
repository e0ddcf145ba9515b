//! Judges the first steps of a new run: whether they show a Gaussian, and whether the loss falls.

use crate::{StepReport, Trainer};
use organza_core::Result;
use organza_core::camera::Camera;
use organza_core::scene::Scene;

/// Steps after which some Gaussian must have been in a tile.
pub(super) const SEEN_AFTER: u32 = 10;
/// Steps after which the loss must have moved, and number of steps at each end whose mean is compared.
const MOVED_AFTER: u32 = 200;
const ENDS: u32 = 50;
/// Least part of the loss that must be gone by then. Tiles differ, so a loss that stands still moves a little, too.
const MIN_GAIN: f64 = 0.03;

/// The mean losses of the first steps of a new run, and of the last ones before it is judged.
#[derive(Debug, Default)]
pub(super) struct FirstSteps([f64; 2]);

impl FirstSteps {
    /// A warning if the steps of a new run so far have shown or learned nothing.
    pub fn judge(&mut self, report: &StepReport, trainer: &Trainer) -> Result<Option<String>> {
        let step = report.step;
        // the other part of the loss depends on how coarse images are
        let loss = if report.l1.is_finite() { report.l1 } else { report.loss };
        if step <= ENDS {
            self.0[0] += loss / f64::from(ENDS);
        } else if (MOVED_AFTER - ENDS + 1..=MOVED_AFTER).contains(&step) {
            self.0[1] += loss / f64::from(ENDS);
        }
        // Gaussians that another program has made may be as good as they can be
        let is_new = trainer.config().start.path.is_none();
        let reason = match step {
            // densification forgets what was seen
            SEEN_AFTER if report.densified.is_none() && trainer.seen()? == 0 => {
                format!("the first {SEEN_AFTER} steps have shown no Gaussian")
            }
            MOVED_AFTER if is_new => {
                let [first, last] = self.0;
                // no warning, either, if the run was resumed meanwhile: the first losses are unknown
                if first == 0.0 || last < (1.0 - MIN_GAIN) * first {
                    return Ok(None);
                }
                format!(
                    "the loss has not moved in {step} steps: the mean difference from the photographs was {first:.4}, \
                     and is {last:.4}"
                )
            }
            _ => return Ok(None),
        };
        Ok(Some(format!("{reason}; {}", facts(trainer)?)))
    }
}

/// The facts that explain an empty image.
fn facts(trainer: &Trainer) -> Result<String> {
    let cameras = trainer.cameras();
    let dataset = trainer.dataset();
    let device = trainer.renderer.device();
    let Scene { gaussians, config, .. } = trainer.scene().download(device)?;
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
