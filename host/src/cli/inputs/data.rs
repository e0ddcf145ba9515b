//! Options that name a data set, say how to read it, and choose its frames.

use std::fs;
use std::path::Path;

use clap::ValueEnum;
use organza::data::{Alpha, Background, Dataset, DatasetOptions, Point, Pose, Poses};
use organza::error::invalid;
use organza::scene::TrainedOn;
use organza::train::config::DataConfig;
use organza::train::{Binding, CONFIG, Checkpoint, built_in};
use organza::view::{PhotographSource, Photographs};
use organza::{Camera, Error, Renderer, Result};

use super::SceneSource;
use super::kind::{FileKind, told_apart};
use crate::cli::console::Console;
use crate::cli::summary::count;
use crate::cli::usage;

/// Options that say how to read a data set, and which of its frames to use.
#[derive(Debug, Default, clap::Args)]
pub struct DataArgs {
    /// The frames of the data set to use [default: all]
    #[arg(long, value_enum, help_heading = "Data set")]
    split: Option<Split>,
    /// Hold out every Nth frame, starting with the first [default: as in the run, or 8]
    #[arg(long, value_name = "N", help_heading = "Data set")]
    #[arg(value_parser = clap::value_parser!(u32).range(2..))]
    hold_out_every: Option<u32>,
    /// Shrink photographs, and the images of their cameras, by this factor [default: as in the run, or 1]
    #[arg(long, value_name = "N", help_heading = "Data set")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1024))]
    downscale: Option<u32>,
    /// Read files that the data set names outside its own folder, by path or by link
    #[arg(long, help_heading = "Data set")]
    allow_outside: bool,
}

/// Fewest pixels on a side to which training may shrink photographs.
const MIN_SIDE: u32 = 32;
/// Pixels on the longer side that are left to photographs that shrink by themselves.
const SMALL: u32 = 1600;

/// A subset of a data set's frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Split {
    /// The frames that training does not see
    HeldOut,
    /// The frames that training sees
    Train,
    /// All frames
    All,
}

/// A warning or a note, and how it is said.
type Doubt = (fn(Console, &str), String);

/// A data set whose photographs have not been read yet.
pub struct DataSet {
    settings: DataConfig,
    /// `None` for the built-in scene.
    poses: Option<Poses>,
    /// Motions of the built-in scene's cameras.
    motions: Vec<Option<[f64; 6]>>,
    /// The frames of the built-in scene to render.
    split: Split,
    /// Why scores of held-out frames may be too good.
    doubt: Option<Doubt>,
}

impl DataArgs {
    /// Whether the user gave any of the options.
    pub fn is_given(&self) -> bool {
        let Self { split, hold_out_every, downscale, allow_outside } = self;
        split.is_some() || hold_out_every.is_some() || downscale.is_some() || *allow_outside
    }

    /// Whether a named data set is read with its photographs. A file alone is one of cameras, unless an option is given.
    pub fn names_photographs(&self, named: &Path) -> bool {
        named.is_dir() || self.is_given()
    }

    /// The frames to use; `default` is the command's own.
    pub fn split(&self, default: Split) -> Split {
        self.split.unwrap_or(default)
    }

    /// The settings of the data set: from the scene's run, unless an argument or an option says otherwise.
    pub fn settings(&self, scene: &SceneSource, named: Option<&Path>) -> Result<DataConfig> {
        let run = scene.settings()?;
        if run.is_none() && named.is_none() {
            let reason = format!(
                "a scene file does not say what it was trained on, only a training run's folder does; name the data \
                 set: `{}`",
                usage()
            );
            let error = Error::Invalid { origin: scene.named().to_owned(), reason };
            return Err(told_apart(error, scene.named(), FileKind::Scene));
        }
        let mut data = run.map(|config| config.data).unwrap_or_default();
        if let Some(trained_on) = scene.config().and_then(|config| config.trained_on) {
            data.downscale = trained_on.downscale;
            data.alpha = if trained_on.alpha_is_mask { Alpha::Mask } else { Alpha::Background };
        }
        match named {
            Some(named) => {
                fs::metadata(named).map_err(|source| Error::read(named, source))?;
                data.path = Some(named.to_owned());
            }
            None => check_place(&data, scene.named())?,
        }
        data.allow_outside |= self.allow_outside;
        data.downscale = self.downscale.unwrap_or(data.downscale);
        data.hold_out_every =
            self.hold_out_every.map_or(data.hold_out_every, |every| every as usize);
        Ok(data)
    }
}

impl Split {
    /// Whether the subset contains a frame.
    pub fn takes(self, is_held_out: bool) -> bool {
        match self {
            Self::HeldOut => is_held_out,
            Self::Train => !is_held_out,
            Self::All => true,
        }
    }

    /// The error if the subset is empty; `origin` is the data set.
    pub fn nothing<T>(self, origin: &Path) -> Result<T> {
        let reason = match self {
            Self::Train => {
                "every frame of the data set is held out; use others with `--split held-out` or `--split all`"
            }
            Self::HeldOut | Self::All => {
                "no frame of the data set is held out; use others with `--split train` or `--split all`, or hold \
                 some out with `--hold-out-every`"
            }
        };
        invalid(origin, reason.to_owned())
    }
}

impl DataSet {
    /// Reads the cameras, and warns of files that are missing or outside. [`Self::read`] reads the photographs.
    pub fn open(settings: DataConfig, options: &DatasetOptions, console: Console) -> Result<Self> {
        let open = |path| Poses::load(path, options);
        let poses = match &settings.path {
            Some(path) => Some(open(path).map_err(|e| told_apart(e, path, FileKind::DataSet))?),
            None => None,
        };
        let data = &settings;
        if let Some(poses) = &poses {
            let path = poses.dataset.path.display();
            let kind = poses.dataset.kind;
            let downscale = data.downscale;
            let every = data.hold_out_every;
            console.detail(&format!(
                "data set {path}: {kind}, downscale {downscale}, hold-out-every {every}"
            ));
            warn_of_files(console, poses);
        } else {
            let views = data.built_in_views;
            let side = data.built_in_side;
            console.detail(&format!("data set: {views} views of the built-in scene, side {side}"));
        }
        Ok(Self { settings, poses, motions: Vec::new(), split: Split::All, doubt: None })
    }

    /// [`Self::open`] for a scene. The data set of its run must be what the run was trained on, and gets the cameras that the
    /// run has refined. One that the user has named is taken as it is, and a note says if it is another one. The frames are held
    /// out that the scene has not seen, unless options name others. The background is the scene's, unless it is given.
    pub fn of(
        scene: &SceneSource,
        named: Option<&Path>,
        args: &DataArgs,
        background: Option<Background>,
        console: Console,
    ) -> Result<Self> {
        let mut settings = args.settings(scene, named)?;
        let config = scene.config();
        let of_scene = config.as_ref().map(|config| Background::from(config.background));
        settings.background = background.or(of_scene).unwrap_or(settings.background);
        let known = config.and_then(|config| config.trained_on);
        let trained_on = known.clone().filter(|_| args.hold_out_every.is_none());
        let placement = Some(scene.placement());
        let options = DatasetOptions { placement, trained_on, ..settings.options() };
        let mut data = Self::open(settings, &options, console)?;
        data.doubt = data.doubt_of(scene, known.as_ref())?;
        if scene.is_whole() {
            return Ok(data);
        }
        let (run, binding) = match scene.settings()? {
            Some(run) => (run, Binding::load(scene.file())?),
            // a checkpoint alone also knows its run, and other files do not
            None => match Binding::load(scene.file()) {
                Ok(binding) => (binding.settings(scene.file())?, binding),
                Err(_) => return Ok(data),
            },
        };
        let other = data.as_trained(&run.data, options, known)?;
        let trained = other.as_ref().or(data.poses.as_ref());
        if let Some(poses) = trained
            && let Some(what) = poses.difference(binding.data())
        {
            let run_data = &run.data.path;
            let run = scene.named().display();
            let reason = format!("its {what} are not those that {run} was trained on");
            let Some(named) = named else {
                let way_out = "put them back, or name the data set to take it as it is now";
                let origin = poses.dataset.path.clone();
                return Err(Error::Invalid { origin, reason: format!("{reason}; {way_out}") });
            };
            // another data set is not meant to be the same
            let own = run_data.as_ref().and_then(|own| fs::canonicalize(own).ok());
            let is_own = fs::canonicalize(named).is_ok_and(|named| own == Some(named));
            let say = if is_own { Console::warn } else { Console::note };
            say(console, &format!("{}: {reason}", named.display()));
        }
        if named.is_some() {
            return Ok(data);
        }
        let held_out: Vec<_> = match trained {
            Some(poses) => poses.cameras()?.iter().map(|pose| pose.held_out).collect(),
            None => built_in::cameras(&run.data).iter().map(|pose| pose.held_out).collect(),
        };
        // smaller photographs may be other files
        let is_same_size = run.data.downscale == data.settings.downscale;
        if let Some(poses) = data.poses.as_mut().filter(|_| is_same_size) {
            poses.require(binding.data());
        }
        if run.poses.refine {
            data.refine(scene.file(), &held_out)?;
        }
        Ok(data)
    }

    /// Why scores of the held-out frames may be too good, if the scene may have been trained on some.
    fn doubt_of(&self, scene: &SceneSource, known: Option<&TrainedOn>) -> Result<Option<Doubt>> {
        let name = scene.named().display();
        let Some(known) = known else {
            let is_run = scene.settings()?.is_some();
            let text = format!(
                "{name} does not say what it was trained on: it may have seen the frames that are held out here"
            );
            return Ok((!is_run).then_some((Console::note, text)));
        };
        let poses = self.cameras()?;
        let names = poses.iter().filter_map(|pose| pose.camera.file_path.as_deref());
        if known.held_out_of(names).is_none() {
            let text = format!(
                "no frame here has the name of one that {name} was trained on: it may have seen these by other names"
            );
            return Ok(Some((Console::note, text)));
        }
        let held_out: Vec<_> = poses.iter().filter(|pose| pose.held_out).collect();
        let seen =
            known.seen_of(held_out.iter().filter_map(|pose| pose.camera.file_path.as_deref()));
        let all = count(held_out.len() as u64, "frame");
        let text = format!(
            "{name} was trained on {seen} of the {all} held out here: their scores are too good"
        );
        Ok((seen > 0).then_some((Console::warn, text)))
    }

    /// Says why scores of held-out frames may be too good, if a command tells these from the others.
    pub fn say_doubt(&mut self, split: Split, console: Console) {
        if split != Split::All
            && let Some((say, doubt)) = self.doubt.take()
        {
            say(console, &doubt);
        }
    }

    /// The path of the data set; `None` for the built-in scene.
    pub fn path(&self) -> Option<&Path> {
        self.settings.path.as_deref()
    }

    /// The poses as a run has read them, if options now hold out other frames or change the size.
    fn as_trained(
        &self,
        run: &DataConfig,
        own: DatasetOptions,
        trained_on: Option<TrainedOn>,
    ) -> Result<Option<Poses>> {
        let DataConfig { downscale, hold_out_every, hold_out_length, .. } = *run;
        let rule = DatasetOptions { downscale, hold_out_every, hold_out_length, ..own.clone() };
        let trained = DatasetOptions { trained_on, ..rule };
        match &self.settings.path {
            Some(path) if trained != own => Poses::load(path, &trained).map(Some),
            _ => Ok(None),
        }
    }

    /// Moves the cameras as a run has refined them. `held_out` says which frames it was not trained on.
    fn refine(&mut self, checkpoint: &Path, held_out: &[bool]) -> Result<()> {
        let learned = Checkpoint::load_poses(checkpoint)?;
        let found = learned.len();
        let trained = held_out.iter().filter(|is_held_out| !**is_held_out).count();
        if found != trained {
            return invalid(
                checkpoint,
                format!(
                    "it has the poses of {found} photographs, but the data set of the run has {trained} to train on: name the \
                 data set to use its own poses"
                ),
            );
        }
        let mut learned = learned.into_iter();
        let motions: Vec<_> = held_out
            .iter()
            .map(|is_held_out| if *is_held_out { None } else { learned.next() })
            .collect();
        match &mut self.poses {
            Some(poses) => poses.move_cameras(&motions)?,
            None => self.motions = motions,
        }
        Ok(())
    }

    /// Refuses a downscale that leaves too little of a photograph to train on.
    pub fn check_downscale(&self) -> Result<()> {
        let factor = self.settings.downscale;
        let (Some(poses), true) = (&self.poses, factor > 1) else { return Ok(()) };
        for Pose { camera: Camera { width, height, .. }, photograph, .. } in poses.cameras()? {
            let side = width.min(height);
            if side < MIN_SIDE {
                let max = (u64::from(side) * u64::from(factor) / u64::from(MIN_SIDE)).max(1);
                let reason = format!(
                    "a downscale of {factor} leaves {width} x {height} pixels, and training needs {MIN_SIDE} a side; use \
                     `--downscale {max}`"
                );
                let origin = photograph.unwrap_or_else(|| poses.dataset.path.clone());
                return Err(Error::Invalid { origin, reason });
            }
        }
        Ok(())
    }

    /// Shrinks the photographs of a new run so far that `pixels`, which it draws, are all of the pixels to train on. Small ones keep
    /// their size. Returns the factor, and says what it is.
    pub fn shrink(&mut self, pixels: f64, console: Console) -> Result<u32> {
        let own = self.settings.downscale;
        let Some(poses) = &mut self.poses else { return Ok(own) };
        let cameras = poses.cameras()?.into_iter().filter(|pose| !pose.held_out);
        let sizes: Vec<_> = cameras.map(|pose| [pose.camera.width, pose.camera.height]).collect();
        let all: f64 =
            sizes.iter().map(|[width, height]| f64::from(*width) * f64::from(*height)).sum();
        let longest = sizes.iter().flatten().max().unwrap_or(&0);
        let shortest = sizes.iter().flatten().min().unwrap_or(&0);
        let most = (longest / SMALL).min(shortest / MIN_SIDE);
        let factor = ((all / pixels).sqrt().ceil() as u32).min(most);
        if factor <= 1 {
            return Ok(own);
        }
        let options = DatasetOptions { downscale: factor, ..self.settings.options() };
        *poses = Poses::load(&poses.dataset.path, &options)?;
        self.settings.downscale = factor;
        console.note(&format!(
            "the photographs have {:.1} times the pixels that this run draws, so they shrink by {factor}: `--downscale 1` keeps \
             their size",
            all / pixels
        ));
        Ok(factor)
    }

    /// The cameras as training has them.
    pub fn cameras(&self) -> Result<Vec<Pose>> {
        let data = &self.settings;
        match &self.poses {
            Some(poses) => poses.cameras(),
            None => {
                let mut poses = built_in::cameras(data);
                self.move_built_in(poses.iter_mut().map(|pose| &mut pose.camera));
                Ok(poses)
            }
        }
    }

    fn move_built_in<'a>(&self, cameras: impl Iterator<Item = &'a mut Camera>) {
        for (camera, motion) in cameras.zip(&self.motions) {
            if let Some(motion) = motion {
                *camera = camera.moved(*motion);
            }
        }
    }

    /// The photographs, each of which is read when needed, and the points.
    pub fn photographs(self) -> (Photographs, Vec<Point>) {
        match self.poses {
            Some(poses) => {
                let points = poses.dataset.points.clone();
                (Photographs::new(PhotographSource::Poses(Box::new(poses))), points)
            }
            None => {
                let cameras = built_in::cameras(&self.settings).into_iter().map(|pose| pose.camera);
                (Photographs::new(PhotographSource::BuiltIn(cameras.collect())), Vec::new())
            }
        }
    }

    /// The data set without unused photographs, which are not read. Ask for its cameras before.
    pub fn only(mut self, split: Split) -> Self {
        self.poses = self.poses.map(|poses| poses.only(|held_out| split.takes(held_out)));
        self.split = split;
        let cameras = built_in::cameras(&self.settings);
        let mut cameras = cameras.iter();
        self.motions.retain(|_| cameras.next().is_some_and(|pose| split.takes(pose.held_out)));
        self
    }

    /// Reads the photographs, or renders the built-in scene's.
    pub fn read(mut self, renderer: &Renderer, console: Console) -> Result<Dataset> {
        let Some(poses) = self.poses.take() else {
            let data = &self.settings;
            let bar = console.progress("rendering the built-in scene", 0, "views");
            let progress = &mut |done, all| bar.set_of(done, all);
            let takes = |is_held_out| self.split.takes(is_held_out);
            let mut dataset = built_in::part(renderer, data, &takes, progress)?;
            self.move_built_in(dataset.frames.iter_mut().map(|frame| &mut frame.camera));
            return Ok(dataset);
        };
        let bar = console.progress("reading", 0, "photographs");
        let known = poses.dataset.notes.len();
        let dataset = poses.photographs(&mut |done, all| bar.set_of(done, all))?;
        drop(bar);
        let all = dataset.frames.len() as u64;
        let held_out = dataset.held_out.len();
        let kind = dataset.kind;
        let mut note = format!("{} ({kind}), {held_out} held out", count(all, "photograph"));
        if dataset.prepared > 0 {
            note += &format!(", {} from images_{}", dataset.prepared, self.settings.downscale);
        }
        if dataset.masked > 0 {
            note += &format!(", {} with a mask", dataset.masked);
        }
        console.note(&note);
        dataset.notes[known..].iter().for_each(|note| console.warn(note));
        if self.settings.background == Background::Auto && dataset.background == [1.0; 3] {
            console.note(
                "the background is white, as in published tables of Blender's data sets; --background changes it",
            );
        }
        Ok(dataset)
    }
}

/// Fails if the data set of the run in a folder is not where the run's settings say.
pub fn check_place(data: &DataConfig, folder: &Path) -> Result<()> {
    let Some(path) = data.path.as_ref().filter(|path| !path.exists()) else { return Ok(()) };
    invalid(
        path,
        format!(
            "the run's data set is no longer there; if it has moved, write its new place to `data.path` in {}",
            folder.join(CONFIG).display()
        ),
    )
}

/// Warns of a data set's files that do not exist, and of files outside its folder.
fn warn_of_files(console: Console, poses: &Poses) {
    let kinds = [
        (&poses.dataset.missing, "photograph", "missing, so left out"),
        (&poses.dataset.outside, "file", "read outside the data set's folder, as was allowed"),
    ];
    for (files, unit, what) in kinds {
        if let Some(first) = files.first() {
            let files = count(files.len() as u64, unit);
            let first = first.display();
            console.warn(&format!("{what}: {files}, the first is {first}"));
        }
    }
    poses.dataset.notes.iter().for_each(|note| console.warn(note));
}
