//! The scenes that a command shows together.

use std::path::{Path, PathBuf};

use organza::error::invalid;
use organza::scene::{Place, Placement};
use organza::{DeviceScene, Renderer, Result, Scene};
use organza_core::input::{has_extension, read_json, read_text};
use serde::Deserialize;

use super::SceneSource;
use crate::cli::console::Console;
use crate::cli::device::SceneArgs;
use crate::cli::{refuse, title};

/// Most bytes of a file that lists scenes.
const MAX_BYTES: u64 = 1 << 20;

/// A scene, others at their places, and cameras.
pub struct Shown {
    /// The scene that cameras and background belong to.
    pub source: SceneSource,
    /// What the user named as cameras or as a data set.
    pub cameras: Option<PathBuf>,
    /// The others, and their places: as the user has named them, and in the first scene's coordinates.
    beside: Vec<(SceneSource, Place, Placement)>,
}

/// A file that lists scenes.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    scene: Vec<Listed>,
}

/// A scene that the user named with a place.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Listed {
    path: PathBuf,
    #[serde(default)]
    place: Place,
    /// The file that says so.
    #[serde(skip)]
    origin: PathBuf,
}

impl Shown {
    /// The arguments `SCENE [SCENE@PLACE.json]... [CAMERAS]`, where the first scene can be a TOML file that lists several.
    /// Reads no scene yet.
    pub fn find(scene: &Path, others: &[PathBuf]) -> Result<Self> {
        let place = Place::default();
        let mut listed = match has_extension(scene, &["toml"]) {
            true => Listed::all(scene)?,
            false => vec![Listed { path: scene.to_owned(), place, origin: scene.to_owned() }],
        };
        let mut cameras: Option<PathBuf> = None;
        for path in others {
            if let Some(placed) = Listed::named(path)? {
                listed.push(placed);
            } else if let Some(cameras) = cameras.replace(path.clone()) {
                let [cameras, path] = [&cameras, path].map(|path| path.display());
                return refuse(format!(
                    "cameras can be named once, not as {cameras} and {path}; another scene has a place: {cameras}@PLACE.json"
                ));
            }
        }
        let mut listed = listed.into_iter();
        let Some(first) = listed.next() else { return invalid(scene, "it lists no scenes") };
        let source = SceneSource::find(&first.path)?;
        let own = source.placement();
        let beside = listed.map(|Listed { path, place, origin }| {
            let source = SceneSource::find(&path)?;
            let placement = own.place(&source.placement(), &place);
            let placement = placement.map_err(|error| error.in_file(&origin))?;
            Ok((source, place, placement))
        });
        let beside = beside.collect::<Result<_>>()?;
        Ok(Self { source, cameras, beside })
    }

    /// Fails if there are several scenes, of which none can be edited.
    pub fn require_one(&self) -> Result<()> {
        match self.beside.is_empty() {
            true => Ok(()),
            false => refuse("`--edit` takes one scene"),
        }
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
        args: &SceneArgs,
        renderer: &Renderer,
    ) -> Result<DeviceScene> {
        let [first, others @ ..] = scenes else { unreachable!("a scene") };
        let mut scene = args.upload(renderer, first)?;
        for (other, (.., placement)) in others.iter().zip(&self.beside) {
            scene.put(args.upload(renderer, other)?, *placement)?;
        }
        Ok(scene)
    }

    /// Names of the other scenes, and their places.
    pub fn places(&self) -> Vec<(String, Place)> {
        self.beside.iter().map(|(source, place, _)| (title(source.named()), *place)).collect()
    }
}

impl Listed {
    /// `SCENE@PLACE.json`; `None` for another path.
    fn named(path: &Path) -> Result<Option<Self>> {
        let named = path.to_str().and_then(|text| text.rsplit_once('@'));
        let Some((scene, origin)) = named.filter(|_| !path.exists()) else { return Ok(None) };
        let origin = PathBuf::from(origin);
        let place = Place::deserialize(read_json(&origin)?);
        let place =
            place.or_else(|e| invalid(&origin, format!("this is no place of a scene: {e}")))?;
        Ok(Some(Self { path: scene.into(), place, origin }))
    }

    /// The scenes of a file, in which paths are relative to it.
    fn all(file: &Path) -> Result<Vec<Self>> {
        let text = read_text(file, MAX_BYTES, "a list of scenes")?;
        let list: List = toml::from_str(&text).or_else(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            invalid(file, format!("line {line}: {}", error.message()))
        })?;
        if list.scene.first().is_some_and(|first| first.place != Place::default()) {
            return invalid(
                file,
                "the first scene has the cameras, so it stays where it is: move the others",
            );
        }
        let folder = file.parent().unwrap_or(Path::new(""));
        let found = |Listed { path, place, .. }| Self {
            path: folder.join(path),
            place,
            origin: file.to_owned(),
        };
        Ok(list.scene.into_iter().map(found).collect())
    }
}
