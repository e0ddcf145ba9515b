//! What COLMAP found, judged: whether it can be trained, and what to do if not.

use std::collections::HashMap;

use muslin::glam::DVec3;
use organza::camera::{Camera, median};
use organza::data::SparseModel;
use serde::{Deserialize, Serialize};

use crate::cli::console::Console;
use crate::cli::summary::{count, grouped};

/// With fewer poses than this part of the images, a capture is to be mended first. Where 20 of 32 photographs had a
/// pose, training ended at 14.6 dB.
const TRAINABLE: f64 = 2.0 / 3.0;
/// Fewest points that an image shows, in the mean. COLMAP gives an image a pose from 30 on, and good captures have
/// several hundred.
const SEEN_POINTS: f64 = 100.0;
/// Fewest images that see a point, in the mean. Two rays nearly always meet, so a third image is what checks a point.
const TRACK: f64 = 2.5;
/// Largest mean error of points, in pixels. COLMAP drops points beyond 4, and a lens that fits leaves 0.4 to 1.
const ERROR: f64 = 1.5;
/// Largest ratio to the median of focal lengths, in units of the image's longer side. One lens differs by a few
/// percent, and the lenses of a phone by 2.
const FOCAL: f64 = 1.2;
/// A step from an image to the next one is a jump beyond this many median steps. From one round of a walk to the next,
/// it is up to 5.
const JUMP: f64 = 10.0;
/// And beyond this part of the median distance from the middle: a camera that rested makes the median step small.
const FAR: f64 = 0.5;
/// Largest part of the steps that may jump. A camera in a wrong place jumps there and back.
const JUMPS: f64 = 0.1;
/// Names that a message has.
const NAMES: usize = 5;

/// What COLMAP found. Images are sorted by name, and so is each list.
#[derive(Debug, Serialize, Deserialize)]
pub struct Judgment {
    images: usize,
    /// Images that have no pose.
    without_pose: Vec<String>,
    points: usize,
    /// Mean number of images that see a point.
    mean_track: f64,
    /// Mean error of points, in pixels.
    mean_error: f64,
    /// Images whose focal length differs from the others'.
    other_focal: Vec<String>,
    /// Images where the camera jumps to.
    jumps: Vec<String>,
    /// Whether each image was compared with all others.
    all_pairs: bool,
}

impl Judgment {
    /// Judges a model of these images, which are sorted.
    pub fn new(images: &[String], model: &SparseModel, all_pairs: bool) -> Self {
        let name = |camera: &Camera| camera.file_path.clone().unwrap_or_default();
        let cameras = model.cameras.iter().map(|camera| (name(camera), camera));
        let cameras: HashMap<_, _> = cameras.collect();
        let without_pose = images.iter().filter(|name| !cameras.contains_key(*name));
        Self {
            images: images.len(),
            without_pose: without_pose.cloned().collect(),
            points: model.points,
            mean_track: model.mean_track,
            mean_error: model.mean_error,
            other_focal: other_focal(&model.cameras).into_iter().map(name).collect(),
            jumps: jumps(images, &cameras),
            all_pairs,
        }
    }

    fn posed(&self) -> usize {
        self.images - self.without_pose.len()
    }

    /// Mean number of points that an image shows.
    fn seen_points(&self) -> f64 {
        self.points as f64 * self.mean_track / self.posed().max(1) as f64
    }

    /// Whether training is worth its time.
    pub fn is_trainable(&self) -> bool {
        self.posed() as f64 >= TRAINABLE * self.images as f64
            && self.seen_points() >= SEEN_POINTS
            && self.jumps.len() as f64 <= JUMPS * self.posed() as f64
    }

    /// What is wrong, and what to do.
    fn faults(&self) -> Vec<String> {
        let matcher = if self.all_pairs { "" } else { ", or try `--matcher exhaustive`" };
        let Self { without_pose, mean_track, mean_error, other_focal, jumps, .. } = self;
        let seen = self.seen_points();
        let faults = [
            (
                !without_pose.is_empty(),
                format!(
                    "no pose: {}. Add images of what lies between, so that neighbors share half of what they show{matcher}",
                    named(without_pose)
                ),
            ),
            (
                seen < SEEN_POINTS,
                format!(
                    "an image shows only {seen:.0} points, expected {SEEN_POINTS} or more. Take sharp images of what has \
                     texture, with more overlap{matcher}"
                ),
            ),
            (
                *mean_track < TRACK,
                format!(
                    "only {mean_track:.1} images see a point, expected {TRACK} or more. Take more images, closer \
                     together{matcher}"
                ),
            ),
            (
                *mean_error > ERROR,
                format!(
                    "points are {mean_error:.1} pixels off, expected {ERROR} or fewer: the lens does not fit. Try another \
                     `--camera-model`"
                ),
            ),
            (
                !other_focal.is_empty(),
                format!(
                    "another focal length than most: {}. Use one lens without zoom, or try another `--camera-model`",
                    named(other_focal)
                ),
            ),
            (
                !jumps.is_empty(),
                format!(
                    "the camera jumps at {}. If it did not, poses there are wrong: leave these images out, or add some \
                     between",
                    named(jumps)
                ),
            ),
        ];
        faults.into_iter().filter(|fault| fault.0).map(|fault| fault.1).collect()
    }

    /// Says what was found and what is wrong.
    pub fn print(&self, output: &str, console: Console) {
        let Self { images, mean_track, mean_error, .. } = self;
        let posed = self.posed();
        let points = count(self.points as u64, "point");
        console.note(&format!("wrote {output}: {posed} of {images} images have a pose"));
        console.note(&format!(
            "{points}: {mean_track:.1} images see each in the mean, {mean_error:.2} pixels off; an image shows {}",
            grouped(self.seen_points().round() as u64)
        ));
        let faults = self.faults();
        faults.iter().for_each(|fault| console.warn(fault));
        if self.is_trainable() {
            console.note(match faults.is_empty() {
                true => "the poses are sound, so this can be trained",
                false => "this can be trained, but what a warning names will look worse: do as it says and capture again, or train and see",
            });
        }
    }
}

/// Cameras whose focal length is far from the median.
fn other_focal(cameras: &[Camera]) -> Vec<&Camera> {
    let focal = |camera: &Camera| camera.fl_x / f64::from(camera.width.max(camera.height));
    let middle = median(cameras.iter().map(focal));
    let usual = middle / FOCAL..=middle * FOCAL;
    let differs = |camera: &&Camera| !usual.contains(&focal(camera));
    cameras.iter().filter(differs).collect()
}

/// Images that are far from the one before. Where that has no pose, nothing is known.
fn jumps(images: &[String], cameras: &HashMap<String, &Camera>) -> Vec<String> {
    let eye = |name: &String| cameras.get(name).map(|camera| DVec3::from(camera.eye()));
    let steps = images.windows(2).filter_map(|pair| {
        let [from, to] = [eye(&pair[0])?, eye(&pair[1])?];
        Some((from.distance(to), &pair[1]))
    });
    let steps: Vec<_> = steps.collect();
    let spread = spread(images.iter().filter_map(eye).collect());
    let min = (JUMP * median(steps.iter().map(|step| step.0))).max(FAR * spread);
    steps.into_iter().filter(|step| step.0 > min).map(|step| step.1.clone()).collect()
}

/// The median distance from the middle.
fn spread(eyes: Vec<DVec3>) -> f64 {
    let middle = DVec3::from([0, 1, 2].map(|axis| median(eyes.iter().map(|eye| eye[axis]))));
    median(eyes.iter().map(|eye| eye.distance(middle)))
}

/// The first names, and how many more there are.
fn named(names: &[String]) -> String {
    let shown = names[..names.len().min(NAMES)].join(", ");
    match names.len().saturating_sub(NAMES) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}
