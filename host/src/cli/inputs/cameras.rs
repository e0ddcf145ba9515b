//! Cameras from a file or from a data set.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use organza::{Camera, Result};

use super::data::{DataArgs, DataSet, Split};
use super::kind::{Expected, told_apart};
use super::scene::SceneSource;
use crate::cli::console::Console;
use crate::cli::summary::count;
use crate::cli::views::photographs;

/// Cameras and their origin.
#[derive(Debug)]
pub struct Cameras {
    /// The cameras, in the order of the file or the data set.
    pub list: Vec<Camera>,
    /// All cameras of the file or data set, of which `--split` chose some.
    pub all: Vec<Camera>,
    /// The file, the data set or the run, for messages.
    pub origin: PathBuf,
    /// Existing photographs, by their paths without links. No output may replace them.
    photographs: HashSet<PathBuf>,
}

impl Cameras {
    /// Reads cameras, in the scene's coordinates. Those of a data set are undistorted and downscaled. A folder is a data set, and so is a file if an option of [`DataArgs`] is given. Without a name, the data set is
    /// that of the scene's run. `usage` shows how to name cameras.
    pub fn load(
        scene: &SceneSource,
        named: Option<&Path>,
        args: &DataArgs,
        usage: &str,
        console: Console,
    ) -> Result<Self> {
        let cameras = match named {
            Some(file) if !file.is_dir() && !args.is_given() => Self::from_file(scene, file)?,
            _ => Self::from_data_set(scene, named, args, usage, console)?,
        };
        let number = count(cameras.list.len() as u64, "view");
        console.detail(&format!("cameras {}: {number}", cameras.origin.display()));
        Ok(cameras)
    }

    fn from_file(scene: &SceneSource, file: &Path) -> Result<Self> {
        let list = scene.placement().load_cameras(file);
        let list = list.map_err(|error| told_apart(error, file, Expected::Cameras))?;
        let named = list.iter().flat_map(|camera| photographs(camera, file));
        let photographs = existing(named);
        Ok(Self { all: list.clone(), list, origin: file.to_owned(), photographs })
    }

    fn from_data_set(
        scene: &SceneSource,
        named: Option<&Path>,
        args: &DataArgs,
        usage: &str,
        console: Console,
    ) -> Result<Self> {
        let settings = args.settings(scene, named, usage)?;
        let origin = settings.path.as_deref().unwrap_or(scene.named()).to_owned();
        let poses = DataSet::open(settings, scene.placement(), console)?
            .refined(scene, named)?
            .cameras()?;
        let photographs = existing(poses.iter().filter_map(|pose| pose.photograph.clone()));
        let all = poses.iter().map(|pose| pose.camera.clone()).collect();
        let split = args.split(Split::All);
        let chosen = poses.into_iter().filter(|pose| split.takes(pose.held_out));
        let list: Vec<_> = chosen.map(|pose| pose.camera).collect();
        if list.is_empty() {
            return split.nothing(&origin);
        }
        Ok(Self { list, all, origin, photographs })
    }

    /// Whether the photograph of some camera exists.
    pub fn has_photographs(&self) -> bool {
        !self.photographs.is_empty()
    }

    /// Whether a path leads to a photograph of one of the cameras.
    pub fn is_photograph(&self, path: &Path) -> bool {
        fs::canonicalize(path).is_ok_and(|path| self.photographs.contains(&path))
    }
}

/// The existing paths, without links.
fn existing(paths: impl Iterator<Item = PathBuf>) -> HashSet<PathBuf> {
    paths.filter_map(|path| fs::canonicalize(path).ok()).collect()
}
