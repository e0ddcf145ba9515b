//! The poses of images: COLMAP's features, matches, model and undistorted images.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use organza::{Error, Result};

use super::frames::IMAGES;
use super::programs::command;
use super::{CaptureJob, is_photograph};
use crate::cli::refuse;

/// Folder of the undistorted images and their cameras, in the work.
pub const UNDISTORTED: &str = "undistorted";
const DATABASE: &str = "database.db";
/// Folder of COLMAP's models, in the work.
const MODELS: &str = "models";
/// Folders without content: they say that a step on the database is done.
const FEATURES: &str = "features";
const MATCHES: &str = "matches";

/// COLMAP, as it is installed.
pub struct Colmap<'a> {
    job: &'a CaptureJob<'a>,
    /// Whether images come one after another.
    is_video: bool,
    /// Whether it was built with CUDA. Without it, features on a GPU need a display.
    has_cuda: bool,
}

impl<'a> Colmap<'a> {
    pub fn new(job: &'a CaptureJob<'a>, is_video: bool) -> Result<Self> {
        let help = output(command("colmap").arg("help"))?;
        Ok(Self { job, is_video, has_cuda: help.contains("with CUDA") })
    }

    /// Finds the poses of all images, and undistorts these. Returns the number of images with a pose.
    pub fn run(&self, images: usize) -> Result<usize> {
        let job = self.job;
        job.step(FEATURES, |_| self.extract(images))?;
        job.step(MATCHES, |_| self.compare(images))?;
        job.step(MODELS, |folder| self.map(images, folder))?;
        let model = self.largest_model()?;
        job.step(UNDISTORTED, |folder| self.undistort(&model, folder))?;
        let undistorted = job.path(UNDISTORTED).join("images");
        let entries =
            fs::read_dir(&undistorted).map_err(|source| Error::read(&undistorted, source))?;
        Ok(entries.flatten().filter(|entry| is_photograph(&entry.path())).count())
    }

    /// A command of COLMAP on the database.
    fn on_database(&self, name: &str) -> Command {
        let mut colmap = command("colmap");
        colmap.arg(name).arg("--database_path").arg(self.job.path(DATABASE));
        colmap
    }

    /// Adds an option for CUDA. COLMAP 3.12 has renamed it, so the command's help says its name.
    fn choose_cuda(&self, colmap: &mut Command, names: [&str; 2]) -> Result<()> {
        let step = colmap.get_args().next().expect("the command's name").to_owned();
        let help = output(command("colmap").arg(step).arg("-h"))?;
        if let Some(name) = names.iter().find(|name| help.contains(**name)) {
            colmap.arg(format!("--{name}")).arg(if self.has_cuda { "1" } else { "0" });
        }
        Ok(())
    }

    fn extract(&self, images: usize) -> Result<()> {
        let mut colmap = self.on_database("feature_extractor");
        colmap.arg("--image_path").arg(self.job.path(IMAGES));
        // A camera keeps its lens, and photographs of one size are of one camera.
        let is_single = self.is_video || self.have_one_size()?;
        colmap.args(["--ImageReader.single_camera", if is_single { "1" } else { "0" }]);
        colmap.args(["--ImageReader.camera_model", "OPENCV"]);
        let side = self.job.args.side.to_string();
        colmap.args(["--SiftExtraction.max_image_size", &side]);
        self.choose_cuda(&mut colmap, ["FeatureExtraction.use_gpu", "SiftExtraction.use_gpu"])?;
        let progress = self.job.console.progress(images as u64, "images");
        progress.say("looking for features");
        self.job.programs.run(colmap, |line| {
            if let Some(done) = number_after(line, "Processed file [") {
                progress.set(done);
            }
        })
    }

    fn compare(&self, images: usize) -> Result<()> {
        let is_sequential = self.is_video && !self.job.args.exhaustive;
        let name = if is_sequential { "sequential_matcher" } else { "exhaustive_matcher" };
        let mut colmap = self.on_database(name);
        self.choose_cuda(&mut colmap, ["FeatureMatching.use_gpu", "SiftMatching.use_gpu"])?;
        let unit = if is_sequential { "images" } else { "blocks of images" };
        let progress = self.job.console.progress(images as u64, unit);
        progress.say("comparing images");
        if !is_sequential {
            // COLMAP may say nothing until it has compared all
            self.job.console.note("comparing each image with all others: this takes minutes");
        }
        self.job.programs.run(colmap, |line| {
            // Blocks of pairs, or images.
            let part = ["Matching block [", "Matching image [", "Processing block ["];
            let Some((begin, done)) =
                part.iter().find_map(|begin| Some((begin, number_after(line, begin)?)))
            else {
                return;
            };
            let rest = &line[line.find(*begin).unwrap_or(0)..];
            // a single block says nothing about its end
            if let Some(all) = number_after(rest, "/").filter(|&all| all > 1) {
                progress.set_of(done.saturating_sub(1), all);
            }
        })
    }

    fn map(&self, images: usize, folder: &Path) -> Result<()> {
        let mut colmap = self.on_database("mapper");
        colmap.arg("--image_path").arg(self.job.path(IMAGES));
        colmap.arg("--output_path").arg(folder);
        let progress = self.job.console.progress(images as u64, "images");
        progress.say("finding poses");
        let result = self.job.programs.run(colmap, |line| {
            if let Some(place) = line.find("Registering image #") {
                // `Registering image #12 (34)`: the image, and how many have a pose.
                if let Some(posed) = number_after(&line[place..], "(") {
                    progress.set(posed);
                }
            }
        });
        self.job.programs.check()?;
        // COLMAP also fails where it finds nothing.
        if models(folder).is_empty() {
            return refuse(format!(
                "COLMAP found no poses for these images. They need texture, sharpness, and much in common with their \
                 neighbors, from different places: walk around the scene, slowly. The whole output of COLMAP is in {}",
                self.job.path("log.txt").display()
            ));
        }
        result
    }

    /// The model with the most images: their number is close to the size of the file that has their features.
    fn largest_model(&self) -> Result<PathBuf> {
        let size =
            |model: &PathBuf| fs::metadata(model.join("images.bin")).map_or(0, |found| found.len());
        let models = models(&self.job.path(MODELS));
        match models.into_iter().max_by_key(size) {
            Some(model) => Ok(model),
            None => refuse("COLMAP has written no model"),
        }
    }

    fn undistort(&self, model: &Path, folder: &Path) -> Result<()> {
        let mut colmap = command("colmap");
        colmap.arg("image_undistorter").arg("--image_path").arg(self.job.path(IMAGES));
        colmap.arg("--input_path").arg(model).arg("--output_path").arg(folder);
        let side = self.job.args.side.to_string();
        colmap.args(["--output_type", "COLMAP", "--max_image_size", &side]);
        self.job.console.during("undistorting images", || self.job.programs.run(colmap, |_| {}))
    }

    /// Whether all images have one width and height.
    fn have_one_size(&self) -> Result<bool> {
        let images = self.job.path(IMAGES);
        let entries = fs::read_dir(&images).map_err(|source| Error::read(&images, source))?;
        let mut first = None;
        for entry in entries.flatten() {
            let path = entry.path();
            let size = match image::image_dimensions(&path) {
                Ok(size) => size,
                Err(error) => return refuse(format!("{}: {error}", path.display())),
            };
            if *first.get_or_insert(size) != size {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// The models that COLMAP has written to a folder.
fn models(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).filter(|path| path.join("images.bin").exists()).collect()
}

/// All that a command prints.
fn output(command: &mut Command) -> Result<String> {
    match command.output() {
        Ok(output) => {
            let both = [output.stdout, output.stderr].concat();
            Ok(String::from_utf8_lossy(&both).into_owned())
        }
        Err(error) => refuse(format!("cannot run colmap: {error}")),
    }
}

/// The number that follows `begin` in a line.
fn number_after(line: &str, begin: &str) -> Option<usize> {
    let rest = &line[line.find(begin)? + begin.len()..];
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    rest[..end].parse().ok()
}
