//! Films.

use std::path::{Path, PathBuf};

use organza::film::{FilmKind, Frames};
use organza_core::check_writable;
use pyo3::prelude::*;

use crate::cameras::Cameras;
use crate::error::{invalid, raise};
use crate::job;
use crate::renderer::{DeviceScene, Renderer, lock};

/// Renders a frame for each camera, and writes a film of them, or a folder.
#[pyfunction]
pub fn film(
    py: Python<'_>,
    renderer: &Renderer,
    scene: &DeviceScene,
    path: PathBuf,
    cameras: &Cameras,
    fps: u32,
) -> PyResult<()> {
    let kind = FilmKind::from_path(&path).map_err(raise)?;
    let cameras = cameras.0.clone();
    let Some(first) = cameras.first() else { return Err(invalid("a film needs a camera")) };
    let size = [first.width, first.height];
    if cameras.iter().any(|camera| [camera.width, camera.height] != size) {
        return Err(invalid("the frames of a film need cameras of one size"));
    }
    if !(1..=240).contains(&fps) {
        return Err(invalid(format!("`fps` is {fps}, expected 1 to 240")));
    }
    kind.check(size).map_err(raise)?;
    if kind != FilmKind::Frames {
        check_writable(&path).map_err(raise)?;
    }
    let held = renderer.own(scene)?;
    let renderer = renderer.0.clone();
    job::run_while_awaited(py, move |awaited| {
        let unfinished = match kind {
            FilmKind::Frames => Folder::new(&path)?,
            FilmKind::Mp4 | FilmKind::Png => Folder::beside(&path)?,
        };
        let folder = unfinished.path();
        let mut files = Vec::new();
        for (index, camera) in cameras.iter().enumerate() {
            awaited()?;
            let scene = &lock(&held).scene;
            let camera = scene.config().placement.own_camera(camera);
            let image = renderer.render_view(scene, &camera)?;
            let file = folder.join(format!("{index:05}.png"));
            image.save_png(&file)?;
            files.push(file);
        }
        awaited()?;
        kind.write(&Frames { files: &files, fps, scratch: folder, progress: &|| () }, &path)
    })
}

/// The folder of the frames.
enum Folder {
    Kept(PathBuf),
    /// Removed with the value.
    Removed(tempfile::TempDir),
}

impl Folder {
    /// A folder for a film in frames, which must hold nothing yet.
    fn new(path: &Path) -> organza::Result<Self> {
        let failed = |source| organza::Error::write(path, source);
        std::fs::create_dir_all(path).map_err(failed)?;
        if std::fs::read_dir(path).map_err(failed)?.next().is_some() {
            let origin = path.to_owned();
            let reason = "the folder for the frames is not empty; name a new one".to_owned();
            return Err(organza::Error::Invalid { origin, reason });
        }
        Ok(Self::Kept(path.to_owned()))
    }

    /// A folder for the frames of a film in one file.
    fn beside(path: &Path) -> organza::Result<Self> {
        let parent = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        let folder = tempfile::Builder::new().prefix(".organza-").suffix(".tmp").tempdir_in(parent);
        folder.map(Self::Removed).map_err(|source| organza::Error::write(parent, source))
    }

    fn path(&self) -> &Path {
        match self {
            Self::Kept(path) => path,
            Self::Removed(folder) => folder.path(),
        }
    }
}
