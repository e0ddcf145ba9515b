//! The scenes that a command shows together.

use std::path::{Path, PathBuf, is_separator};

use organza::error::invalid;
use organza::scene::{Place, Placement};
use organza::{DeviceScene, Renderer, Result, Scene, UploadOptions};
use organza_core::input::read_json;
use serde::Deserialize;

use super::SceneSource;
use crate::cli::console::Console;
use crate::cli::{refuse, title};

/// A scene, others at their places, and cameras.
pub struct Shown {
    /// The scene that cameras and background belong to.
    pub source: SceneSource,
    /// What the user named as cameras or as a data set.
    pub cameras: Option<PathBuf>,
    /// The others, and their places: as the user has named them, and in the first scene's coordinates.
    beside: Vec<(SceneSource, Place, Placement)>,
    /// Whether each is the uncropped scene of a block, and counts where it shows its ground.
    is_blended: bool,
}

impl Shown {
    /// The arguments `SCENE [SCENE@PLACE.json]... [CAMERAS]`. The runs of a split are one scene. Reads no scene yet.
    pub fn find(scene: &Path, others: &[PathBuf]) -> Result<Self> {
        let mut blocks = SceneSource::blocks(scene)?.unwrap_or_default().into_iter();
        let source = blocks.next().map_or_else(|| SceneSource::find(scene), Ok)?;
        let mut beside = Vec::new();
        for block in blocks {
            let place = Place { same_world: true, ..Place::default() };
            let placement = source.placement().place(&block.placement(), &place)?;
            beside.push((block, place, placement));
        }
        let mut cameras: Option<PathBuf> = None;
        for path in others {
            if let Some((path, file)) = placed(path) {
                let place = read_place(file.as_ref())?;
                let other = SceneSource::find(path.as_ref())?;
                let placement = source.placement().place(&other.placement(), &place);
                let placement = placement.map_err(|error| error.in_file(file.as_ref()))?;
                beside.push((other, place, placement));
            } else if let Some(cameras) = cameras.replace(path.clone()) {
                let [cameras, path] = [&cameras, path].map(|path| path.display());
                return refuse(format!(
                    "cameras can be named once, not as {cameras} and {path}; another scene has a place: {cameras}@PLACE.json"
                ));
            }
        }
        Ok(Self { source, cameras, beside, is_blended: false })
    }

    /// Like [`Self::find`], for commands that render images: if the runs of a split are all there is to show, each is a whole image.
    pub fn find_images(scene: &Path, others: &[PathBuf]) -> Result<Self> {
        let mut shown = Self::find(scene, others)?;
        let is_blended = shown.sources().all(|source| source.ground().is_some());
        shown.is_blended = is_blended;
        if is_blended {
            shown.sources_mut().for_each(SceneSource::uncrop);
        }
        Ok(shown)
    }

    /// From now on, each block shows a photograph's camera where its own run has refined it.
    pub fn refine(&mut self) -> Result<()> {
        let is_blended = self.is_blended;
        self.sources_mut().filter(|_| is_blended).try_for_each(SceneSource::refine)
    }

    fn sources_mut(&mut self) -> impl Iterator<Item = &mut SceneSource> {
        let others = self.beside.iter_mut().map(|(source, ..)| source);
        [&mut self.source].into_iter().chain(others)
    }

    /// Fails if there are several scenes, of which none can be edited.
    pub fn require_one(&self) -> Result<()> {
        if self.beside.is_empty() { Ok(()) } else { refuse("`--edit` takes one scene") }
    }

    /// Whether these are the runs of a split, each of which is a whole image.
    pub fn is_blended(&self) -> bool {
        self.is_blended
    }

    /// All scenes, in their order.
    pub fn sources(&self) -> impl Iterator<Item = &SceneSource> {
        [&self.source].into_iter().chain(self.beside.iter().map(|(source, ..)| source))
    }

    /// Reads all scenes, in their order.
    pub fn load(&self, console: Console) -> Result<Vec<Scene>> {
        self.sources().map(|source| source.load(console)).collect()
    }

    /// Copies scenes to a device, each at its place: all, or the first ones.
    pub fn upload(
        &self,
        scenes: &[Scene],
        options: UploadOptions,
        renderer: &Renderer,
    ) -> Result<DeviceScene> {
        let scenes = scenes.iter().enumerate();
        let uploaded = scenes.map(|(index, scene)| {
            self.upload_one(index, scene, options, renderer).map(|uploaded| (index, uploaded))
        });
        self.join(uploaded.collect::<Result<Vec<_>>>()?)
    }

    /// Copies the scene with this number to a device.
    pub fn upload_one(
        &self,
        index: usize,
        scene: &Scene,
        options: UploadOptions,
        renderer: &Renderer,
    ) -> Result<DeviceScene> {
        let mut uploaded = renderer.upload_with(scene, options)?;
        let ground = self.sources().nth(index).and_then(SceneSource::ground);
        if let Some(ground) = ground.filter(|_| self.is_blended) {
            uploaded.stand_on(ground.clone());
        }
        Ok(uploaded)
    }

    /// Scenes on a device, by their numbers, each at its place. The first one has the number 0.
    pub fn join(&self, scenes: Vec<(usize, DeviceScene)>) -> Result<DeviceScene> {
        let mut scenes = scenes.into_iter();
        let (_, mut all) = scenes.next().expect("a scene");
        for (index, scene) in scenes {
            all.put(scene, self.beside[index - 1].2)?;
        }
        Ok(all)
    }

    /// The box of nearly all of the opacity of all scenes, in the first one's coordinates.
    pub fn visible_box(&self, scenes: &[Scene]) -> [[f64; 3]; 2] {
        let others = scenes[1..].iter().zip(&self.beside);
        let others = others.map(|(scene, (.., place))| place.world_box(scene.visible_box()));
        others.fold(scenes[0].visible_box(), |[low, high], [lowest, highest]| {
            let ends = |axis: usize| [low[axis].min(lowest[axis]), high[axis].max(highest[axis])];
            let [x, y, z] = [0, 1, 2].map(ends);
            [0, 1].map(|end| [x[end], y[end], z[end]])
        })
    }

    /// Names of the other scenes, and their places.
    pub fn places(&self) -> Vec<(String, Place)> {
        self.beside.iter().map(|(source, place, _)| (title(source.named()), *place)).collect()
    }
}

/// The scene and the place that `SCENE@PLACE.json` names. Paths may have an `@`, too, so the parts that exist decide.
pub(super) fn placed(path: &Path) -> Option<(&str, &str)> {
    let text = path.to_str().filter(|_| !path.exists())?;
    let parts = text.match_indices('@').map(|(at, _)| (&text[..at], &text[at + 1..]));
    let likely = |(scene, place): &(&str, &str)| {
        let there = [scene, place].iter().filter(|part| Path::new(part).exists()).count();
        // without either, an `@` before a separator belongs to a folder's name
        (there, !place.contains(is_separator))
    };
    // of equal ones, the last
    parts.max_by_key(likely).filter(|parts| likely(parts) != (0, false))
}

fn read_place(file: &Path) -> Result<Place> {
    let place = Place::deserialize(read_json(file)?);
    place.or_else(|error| invalid(file, format!("this is no place of a scene: {error}")))
}
