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
        let others = shown.beside.iter_mut().map(|(source, ..)| source);
        let mut sources: Vec<_> = [&mut shown.source].into_iter().chain(others).collect();
        shown.is_blended = sources.iter().all(|source| source.ground().is_some());
        if shown.is_blended {
            sources.iter_mut().for_each(|source| source.uncrop());
        }
        Ok(shown)
    }

    /// Fails if there are several scenes, of which none can be edited.
    pub fn require_one(&self) -> Result<()> {
        if self.beside.is_empty() { Ok(()) } else { refuse("`--edit` takes one scene") }
    }

    /// Reads all scenes, in their order.
    pub fn load(&self, console: Console) -> Result<Vec<Scene>> {
        let others = self.beside.iter().map(|(source, ..)| source);
        [&self.source].into_iter().chain(others).map(|source| source.load(console)).collect()
    }

    /// Copies all scenes to a device, each at its place.
    pub fn upload(
        &self,
        scenes: &[Scene],
        options: UploadOptions,
        renderer: &Renderer,
    ) -> Result<DeviceScene> {
        let [first, others @ ..] = scenes else { unreachable!("a scene") };
        let upload = |scene: &Scene, source: &SceneSource| -> Result<DeviceScene> {
            let mut uploaded = renderer.upload_with(scene, options)?;
            if let Some(ground) = source.ground().filter(|_| self.is_blended) {
                uploaded.stand_on(ground.clone());
            }
            Ok(uploaded)
        };
        let mut scene = upload(first, &self.source)?;
        for (other, (source, _, placement)) in others.iter().zip(&self.beside) {
            scene.put(upload(other, source)?, *placement)?;
        }
        Ok(scene)
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
