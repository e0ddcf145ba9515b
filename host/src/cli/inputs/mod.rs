//! Inputs of commands: a scene or a run's folder, cameras or a data set. All commands share one place for each.

mod data;
mod kind;
mod shown;

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

pub use data::{DataArgs, DataSet, Split, check_place};
pub use kind::{FileKind, told_apart};
pub use shown::Shown;

use crate::cli::console::Console;
use crate::cli::summary::count;
use crate::cli::views::photographs;
use organza::data::Block;
use organza::error::invalid;
use organza::scene::{Ground, Placement, SceneConfig, TrainedOn};
use organza::train::{self, CHECKPOINT, CONFIG, CROPPED, Checkpoint, TrainConfig};
use organza::{Camera, Error, Result, Scene};

/// The origin of a scene.
#[derive(Clone, Debug)]
pub struct SceneSource {
    /// The path that the user named.
    named: PathBuf,
    /// The scene's file.
    file: PathBuf,
    /// Of the first block of a split: what all blocks were trained on.
    whole: Option<Whole>,
    /// Of a block of a split that is shown as one scene: where it shows the world best.
    ground: Option<Ground>,
}

/// What the blocks of a split were trained on together.
#[derive(Clone, Debug)]
struct Whole {
    data: PathBuf,
    trained_on: TrainedOn,
}

impl SceneSource {
    /// Finds the scene's file: the named one, or the checkpoint in a run's folder. Reads nothing yet.
    ///
    /// # Errors
    /// If there is no such file, or the folder is not a run's.
    pub fn find(path: &Path) -> Result<Self> {
        let found = fs::metadata(path).map_err(|source| Error::read(path, source))?;
        let checkpoint = path.join(CHECKPOINT);
        if !found.is_dir() || checkpoint.exists() {
            let file = if found.is_dir() { checkpoint } else { path.to_owned() };
            return Ok(Self { named: path.to_owned(), file, whole: None, ground: None });
        }
        if Self::blocks(path)?.is_some() {
            let reason = "these are the runs of a split, and the command takes one scene: name one of them. `render`, `film`, `view`, \
                          `export-web`, `mesh`, `export` and `eval` take all as one scene";
            return invalid(path, reason);
        }
        let reason = if path.join(CONFIG).exists() {
            format!(
                "the run has no {CHECKPOINT} yet: training writes it at intervals, and at its end"
            )
        } else {
            format!(
                "the folder has no {CHECKPOINT}, so it is not a training run's; name a scene file, or the \
                 folder that training wrote to. `organza capture` makes a data set of photographs"
            )
        };
        Err(told_apart(Error::Invalid { origin: path.to_owned(), reason }, path, FileKind::Scene))
    }

    /// The blocks of a split in a folder of their runs, the first of which stands for all; `None` for every other path.
    ///
    /// # Errors
    /// If blocks are missing, or belong to several splits.
    pub fn blocks(path: &Path) -> Result<Option<Vec<Self>>> {
        if path.join(CHECKPOINT).exists() || path.join(CONFIG).exists() {
            return Ok(None);
        }
        let Some(blocks) = Block::all_in(path)? else { return Ok(None) };
        let source = |(run, block): &(PathBuf, Block)| {
            let file = run.join(CROPPED);
            let found = fs::metadata(&file).map_err(|source| Error::read(&file, source));
            let ground = Some(block.ground());
            found.map(|_| Self { named: run.clone(), file, whole: None, ground })
        };
        let mut sources = blocks.iter().map(source).collect::<Result<Vec<_>>>()?;
        let mut trained_on = TrainedOn::default();
        for one in sources.iter().filter_map(|source| source.config()?.trained_on) {
            let TrainedOn { seen, held_out, downscale, alpha_is_mask } = one;
            trained_on.seen.extend(seen);
            trained_on.held_out.extend(held_out);
            trained_on = TrainedOn { downscale, alpha_is_mask, ..trained_on };
        }
        let data = blocks[0].1.data.clone();
        sources[0].named = path.to_owned();
        sources[0].whole = Some(Whole { data, trained_on });
        Ok(Some(sources))
    }

    /// From now on, the scene of a block with what it has learned outside of the block, which others show better.
    pub fn uncrop(&mut self) {
        self.file.set_file_name(CHECKPOINT);
    }

    /// Moves the cameras of a block's photographs as its run has refined them.
    fn refine(&mut self) -> Result<()> {
        let known = Scene::load_config(&self.file)?.trained_on.unwrap_or_default();
        let learned = Checkpoint::load_poses(&self.file)?;
        if let Some(ground) = &mut self.ground {
            ground.motions = known.seen.into_iter().zip(learned).collect();
        }
        Ok(())
    }

    /// Where the scene of a block shows the world best.
    pub fn ground(&self) -> Option<&Ground> {
        self.ground.as_ref()
    }

    /// Whether this stands for all blocks of a split.
    pub fn is_whole(&self) -> bool {
        self.whole.is_some()
    }

    /// A file or folder of another program, with the coordinates of the world.
    pub fn foreign(path: &Path) -> Self {
        Self { named: path.to_owned(), file: path.to_owned(), whole: None, ground: None }
    }

    /// Path of the scene's file.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// The path that the user named: the scene's file, or the run's folder.
    pub fn named(&self) -> &Path {
        &self.named
    }

    /// Reads the scene.
    pub fn load(&self, console: Console) -> Result<Scene> {
        let start = Instant::now();
        let scene = console
            .during("reading the scene", || Scene::load(&self.file))
            .map_err(|error| told_apart(error, &self.file, FileKind::Scene))?;
        console.detail(&format!(
            "scene {}: {}, read in {:.2} s",
            self.file.display(),
            count(scene.gaussians.len() as u64, "Gaussian"),
            start.elapsed().as_secs_f64()
        ));
        Ok(scene)
    }

    /// The configuration of the scene. What is no file of organza has none, and is reported when it is read.
    pub fn config(&self) -> Option<SceneConfig> {
        let mut config = Scene::load_config(&self.file).ok()?;
        if let Some(whole) = &self.whole {
            config.trained_on = Some(whole.trained_on.clone());
        }
        Some(config)
    }

    /// Where the scene lies in the world.
    pub fn placement(&self) -> Placement {
        self.config().map(|config| config.placement).unwrap_or_default()
    }

    /// The settings of the run, if the user named a run's folder.
    pub fn settings(&self) -> Result<Option<TrainConfig>> {
        if let (Some(whole), Some(run)) = (&self.whole, self.file.parent()) {
            let mut config = train::settings_of(run)?;
            config.data.path = Some(whole.data.clone());
            return Ok(Some(config));
        }
        if self.named.join(CONFIG).exists() {
            return train::settings_of(&self.named).map(Some);
        }
        Ok(None)
    }
}

/// Cameras and their origin.
pub struct Cameras {
    /// The cameras, in the order of the file or the data set.
    pub list: Vec<Camera>,
    /// All cameras of the file or data set, of which `--split` chose some.
    pub all: Vec<Camera>,
    /// The file, the data set or the run, for messages.
    pub origin: PathBuf,
    /// The data set, if they are of one.
    pub data: Option<DataSet>,
    /// Existing photographs, by their paths without links. No output may replace them.
    photographs: HashSet<PathBuf>,
}

impl Cameras {
    /// Reads cameras, in the scene's coordinates. A data set's cameras are undistorted and downscaled. A folder is a data
    /// set, and so is a file if an option of [`DataArgs`] is given. Without a name, the scene's run has the data set.
    pub fn load(
        scene: &SceneSource,
        named: Option<&Path>,
        args: &DataArgs,
        console: Console,
    ) -> Result<Self> {
        if let Some((path, _)) = named.and_then(shown::placed) {
            let reason = format!(
                "this names a scene at a place, and the command takes one scene; `render`, `film`, `view` and `export-web` show \
                 {path} with others"
            );
            return invalid(named.unwrap_or(Path::new("")), reason);
        }
        let cameras = match named {
            Some(file) if !file.is_dir() && !args.is_given() => Self::from_file(scene, file)?,
            _ => Self::from_data_set(scene, named, args, console)?,
        };
        let number = count(cameras.list.len() as u64, "view");
        console.detail(&format!("cameras {}: {number}", cameras.origin.display()));
        Ok(cameras)
    }

    fn from_file(scene: &SceneSource, file: &Path) -> Result<Self> {
        let list = scene.placement().load_cameras(file);
        let list = list.map_err(|error| told_apart(error, file, FileKind::Cameras))?;
        let named = list.iter().flat_map(|camera| photographs(camera, file));
        let photographs = existing(named);
        Ok(Self { all: list.clone(), list, origin: file.to_owned(), data: None, photographs })
    }

    fn from_data_set(
        scene: &SceneSource,
        named: Option<&Path>,
        args: &DataArgs,
        console: Console,
    ) -> Result<Self> {
        let mut data = DataSet::of(scene, named, args, None, console)?;
        let origin = data.path().unwrap_or(scene.named()).to_owned();
        let split = args.split(Split::All);
        data.say_doubt(split, console);
        let poses = data.cameras()?;
        let photographs = existing(poses.iter().filter_map(|pose| pose.photograph.clone()));
        let all = poses.iter().map(|pose| pose.camera.clone()).collect();
        let chosen = poses.into_iter().filter(|pose| split.takes(pose.held_out));
        let list: Vec<_> = chosen.map(|pose| pose.camera).collect();
        if list.is_empty() {
            return split.nothing(&origin);
        }
        Ok(Self { list, all, origin, data: Some(data), photographs })
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
