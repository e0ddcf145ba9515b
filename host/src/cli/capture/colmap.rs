//! The poses of images: COLMAP's features, matches, model and undistorted images.

use std::fs;
use std::path::Path;

use organza::data::{SparseModel, photograph_size};
use organza::{Error, Result};

use super::frames::{IMAGES, copy};
use super::judge::Judgment;
use super::programs::{Call, command, output};
use super::{CaptureJob, Matcher, SOME};
use crate::cli::refuse;

/// Folder of the undistorted images and their cameras, in the work.
pub const UNDISTORTED: &str = "undistorted";
const DATABASE: &str = "database.db";
/// Folders of COLMAP's models, in the work: the first ones, and the ones after all pairs of images were compared.
const MODELS: [&str; 2] = ["models", "models-of-all"];
/// Folders without content: they say that a step on the database is done.
const FEATURES: &str = "features";
const MATCHES: [&str; 2] = ["matches", "matches-of-all"];
/// Up to this many images are few: they hold few parameters of a lens, and frames of a video are so far apart that all
/// pairs cost only twice what neighbors cost.
const FEW: usize = 50;
/// With fewer poses than this part of the images, all pairs are compared after all.
const ENOUGH: f64 = 0.8;
/// Neighbors on each side that an image is compared with. COLMAP adds neighbors at distances of 2, 4, 8 and so on.
const OVERLAP: &str = "15";
/// Most features of an image without CUDA. The time of a comparison grows as their square: of COLMAP's own 8,192, two
/// cores compare 100 pairs a minute.
const FEATURES_ON_CPU: &str = "4096";
/// Images on a side of a block of pairs. COLMAP says something after each block, and its own 50 make it silent for minutes.
const BLOCK: &str = "10";

/// COLMAP, as it is installed.
pub struct Colmap<'a> {
    job: &'a CaptureJob<'a>,
    /// Whether images come one after another.
    is_video: bool,
    /// Number of images.
    images: usize,
    /// Width and height of the images; `None` if they differ.
    size: Option<[u32; 2]>,
    /// Whether it was built with CUDA. Without it, features on a GPU need a display.
    has_cuda: bool,
}

impl<'a> Colmap<'a> {
    pub fn new(job: &'a CaptureJob<'a>, is_video: bool, images: &[String]) -> Result<Self> {
        let help = output(command("colmap").arg("help"))?;
        let has_cuda = help.contains("with CUDA");
        let size = one_size(&job.path(IMAGES), images)?;
        Ok(Self { job, is_video, images: images.len(), size, has_cuda })
    }

    /// Finds the poses of all images, undistorts these, and judges the poses.
    pub fn run(&self, names: &[String]) -> Result<Judgment> {
        let job = self.job;
        job.step(FEATURES, |_| self.extract())?;
        let mut matcher = job.args.matcher.unwrap_or_else(|| self.matcher());
        let mut found = self.model(0, matcher)?;
        let posed = found.as_ref().map_or(0, |found| found.cameras.len());
        let is_choice = job.args.matcher.is_none() && matcher == Matcher::Sequential;
        let images = self.images;
        if is_choice && images <= SOME && (posed as f64) < ENOUGH * images as f64 {
            job.console.note(&format!(
                "only {posed} of {images} images have a pose, so each is now compared with all others"
            ));
            matcher = Matcher::Exhaustive;
            let other = self.model(1, matcher)?;
            found = found.into_iter().chain(other).max_by_key(|found| found.cameras.len());
        }
        let Some(model) = found else {
            return refuse(format!(
                "COLMAP found no poses for these images. They need texture, sharpness, and much in common with their \
                 neighbors, from different places: walk around the scene, slowly. The whole output of COLMAP is in {}",
                job.path("log.txt").display()
            ));
        };
        let is_fisheye = job.args.camera_model.as_deref() == Some("OPENCV_FISHEYE");
        job.step(UNDISTORTED, |folder| match is_fisheye {
            true => self.keep(&model, folder),
            false => self.undistort(&model.folder, folder),
        })?;
        Ok(Judgment::new(names, &model, matcher == Matcher::Exhaustive))
    }

    /// The matcher that suits the images.
    fn matcher(&self) -> Matcher {
        match self.images <= if self.is_video { FEW } else { SOME } {
            true => Matcher::Exhaustive,
            false => Matcher::Sequential,
        }
    }

    /// The largest model of an attempt.
    fn model(&self, attempt: usize, matcher: Matcher) -> Result<Option<SparseModel>> {
        self.job.step(MATCHES[attempt], |_| self.compare(matcher))?;
        self.job.step(MODELS[attempt], |folder| self.map(folder))?;
        SparseModel::largest(&self.job.path(MODELS[attempt]))
    }

    /// A command of COLMAP on the database.
    fn on_database(&self, name: &str) -> Result<Call> {
        let mut colmap = self.job.programs.colmap(name)?;
        colmap.option("--database_path", self.job.path(DATABASE));
        Ok(colmap)
    }

    /// Whether COLMAP computes with CUDA, as an option's value.
    fn with_cuda(&self) -> &'static str {
        if self.has_cuda { "1" } else { "0" }
    }

    fn extract(&self) -> Result<()> {
        let mut colmap = self.on_database("feature_extractor")?;
        colmap.option("--image_path", self.job.path(IMAGES));
        // A camera keeps its lens, and photographs of one size are of one camera.
        let is_single = self.is_video || self.size.is_some();
        colmap.option("--ImageReader.single_camera", if is_single { "1" } else { "0" });
        let is_simple = self.images <= FEW || !is_single;
        let model = if is_simple { "SIMPLE_RADIAL" } else { "OPENCV" };
        let model = self.job.args.camera_model.as_deref().unwrap_or(model);
        colmap.option("--ImageReader.camera_model", model);
        colmap.option("--FeatureExtraction.max_image_size", self.job.args.side.to_string());
        if !self.has_cuda {
            colmap.option("--SiftExtraction.max_num_features", FEATURES_ON_CPU);
        }
        colmap.option("--FeatureExtraction.use_gpu", self.with_cuda());
        let progress = self.job.console.progress("looking for features", self.images, "images");
        self.job.programs.run(colmap, |line| {
            if let Some(done) = number_after(line, "Processed file [") {
                progress.set(done);
            }
        })
    }

    fn compare(&self, matcher: Matcher) -> Result<()> {
        let (name, unit, option, value) = match matcher {
            Matcher::Sequential => {
                ("sequential_matcher", "images", "--SequentialMatching.overlap", OVERLAP)
            }
            Matcher::Exhaustive => {
                ("exhaustive_matcher", "blocks of pairs", "--ExhaustiveMatching.block_size", BLOCK)
            }
        };
        let mut colmap = self.on_database(name)?;
        colmap.option(option, value);
        colmap.option("--FeatureMatching.use_gpu", self.with_cuda());
        let progress = self.job.console.progress("comparing images", self.images, unit);
        self.job.programs.run(colmap, |line| {
            if let Some([done, all]) = compared(line) {
                progress.set_of(done, all);
            }
        })
    }

    fn map(&self, folder: &Path) -> Result<()> {
        let mut colmap = self.on_database("mapper")?;
        colmap.option("--image_path", self.job.path(IMAGES));
        colmap.option("--output_path", folder);
        let progress = self.job.console.progress("finding poses", self.images, "images");
        // COLMAP begins again where it finds few, and keeps the largest model.
        let mut max = 0;
        let result = self.job.programs.run(colmap, |line| {
            if let Some(posed) = registered(line) {
                max = max.max(posed);
                progress.set(max);
            }
        });
        self.job.programs.check()?;
        // COLMAP also fails where it finds nothing.
        let finds_nothing = SparseModel::largest(folder)?.is_none();
        if finds_nothing { Ok(()) } else { result }
    }

    /// Keeps images as they are: no plane holds a fisheye's.
    fn keep(&self, model: &SparseModel, folder: &Path) -> Result<()> {
        let [images, sparse] = ["images", "sparse"].map(|name| folder.join(name));
        for path in [&images, &sparse] {
            fs::create_dir(path).map_err(|source| Error::write(path, source))?;
        }
        let names = model.cameras.iter().filter_map(|camera| camera.file_path.as_deref());
        let files: Vec<_> = names.map(|name| self.job.path(IMAGES).join(name)).collect();
        copy(&files, &images)?;
        let files = fs::read_dir(&model.folder).into_iter().flatten().flatten();
        let files: Vec<_> = files.map(|file| file.path()).collect();
        copy(&files, &sparse)
    }

    fn undistort(&self, model: &Path, folder: &Path) -> Result<()> {
        let mut colmap = self.job.programs.colmap("image_undistorter")?;
        colmap.option("--image_path", self.job.path(IMAGES));
        colmap.option("--input_path", model);
        colmap.option("--output_path", folder);
        colmap.option("--output_type", "COLMAP");
        colmap.option("--max_image_size", self.job.args.side.to_string());
        self.job.console.during("undistorting images", || self.job.programs.run(colmap, |_| {}))
    }
}

/// The width and height of all images; `None` if they differ.
fn one_size(folder: &Path, images: &[String]) -> Result<Option<[u32; 2]>> {
    let mut first = None;
    for name in images {
        let size = photograph_size(&folder.join(name))?;
        if *first.get_or_insert(size) != size {
            return Ok(None);
        }
    }
    Ok(first)
}

/// The number that follows `begin` in a line.
fn number_after(line: &str, begin: &str) -> Option<usize> {
    let rest = &line[line.find(begin)? + begin.len()..];
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    rest[..end].parse().ok()
}

/// How many images have a pose, after `Registering image #12 (34)`, or since COLMAP 3.12 `#12 (num_reg_frames=34)`.
fn registered(line: &str) -> Option<usize> {
    let place = line.find("Registering image #")?;
    ["(", "(num_reg_frames="].iter().find_map(|begin| number_after(&line[place..], begin))
}

/// How much a matcher has compared, and of how much: `Matching block [2/7, 3/7]` comes after nine blocks of 49, and
/// `Matching image [5/150] in 0.3s` after five images: COLMAP 3 ends a line when it is done.
fn compared(line: &str) -> Option<[usize; 2]> {
    let begin =
        ["Matching block [", "Matching image [", "Processing block [", "Processing image ["];
    let place = begin.iter().find_map(|begin| Some(line.find(begin)? + begin.len()))?;
    let (inside, end) = line[place..].split_once(']')?;
    let counted = inside.split(", ").try_fold([0, 1], |[done, all], part| {
        let (number, length) = part.split_once('/')?;
        let [number, length]: [usize; 2] = [number.parse().ok()?, length.parse().ok()?];
        Some([done * length + number.checked_sub(1)?, all * length])
    });
    counted.map(|[done, all]| [done + usize::from(end.starts_with(" in ")), all])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn progress_is_read_from_each_version_of_colmap() {
        assert_eq!(compared("Matching block [1/2, 2/2] in 29.268s"), Some([2, 4]));
        assert_eq!(
            compared("I20260101 pairing.cc:169] Processing block [2/7, 3/7]"),
            Some([9, 49])
        );
        assert_eq!(compared("Matching image [5/150] in 0.3s"), Some([5, 150]));
        assert_eq!(compared("Matching image [x/150]"), None);
        assert_eq!(compared("Matching block [0/7, 3/7]"), None);
        assert_eq!(compared("Elapsed time: 3 [minutes]"), None);
        assert_eq!(registered("Registering image #12 (34)"), Some(34));
        let line =
            "I20260101 incremental_pipeline.cc:439] Registering image #12 (num_reg_frames=34)";
        assert_eq!(registered(line), Some(34));
        assert_eq!(registered("=> Image sees 130 / 246 points"), None);
    }
}
