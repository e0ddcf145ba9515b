//! The photographs of a data set, which are read on demand.

use std::collections::VecDeque;
use std::fmt;
use std::sync::Arc;

use super::message::refuse;
use organza_core::{Camera, Result, demo};
use organza_data::{Dataset, Photograph, Poses};
use organza_render::{DeviceScene, Renderer};

/// Number of photographs that are kept after reading.
const KEPT: usize = 4;

/// The source of photographs.
pub struct Photographs {
    source: Source,
    /// The photographs used last, newest first.
    kept: VecDeque<(usize, Arc<Photograph>)>,
}

enum Source {
    None,
    /// A training's photographs, in memory.
    Dataset(Arc<Dataset>),
    /// Photographs in files.
    Poses(Box<Poses>),
    /// Views of the built-in scene, rendered on demand.
    BuiltIn(Vec<Camera>, Option<Box<DeviceScene>>),
}

impl fmt::Debug for Photographs {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kept: Vec<_> = self.kept.iter().map(|(view, _)| view).collect();
        formatter.debug_struct("Photographs").field("kept", &kept).finish_non_exhaustive()
    }
}

impl Photographs {
    fn from(source: Source) -> Self {
        Self { source, kept: VecDeque::new() }
    }

    /// No photographs.
    #[must_use]
    pub fn none() -> Self {
        Self::from(Source::None)
    }

    /// A training's photographs, in memory.
    #[must_use]
    pub fn from_dataset(dataset: Arc<Dataset>) -> Self {
        Self::from(Source::Dataset(dataset))
    }

    /// Photographs in files.
    #[must_use]
    pub fn from_poses(poses: Poses) -> Self {
        Self::from(Source::Poses(Box::new(poses)))
    }

    /// Views of the built-in scene.
    #[must_use]
    pub fn built_in(cameras: Vec<Camera>) -> Self {
        Self::from(Source::BuiltIn(cameras, None))
    }

    /// Whether there are any.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        matches!(self.source, Source::None)
    }

    /// The photograph of a view in the data set.
    pub(super) fn get(&mut self, renderer: &Renderer, view: usize) -> Result<Arc<Photograph>> {
        if let Some((_, found)) = self.kept.iter().find(|(kept, _)| *kept == view) {
            return Ok(Arc::clone(found));
        }
        let none = || refuse(format!("there is no photograph of view {view}"));
        let photograph = match &mut self.source {
            Source::None => return none(),
            Source::Dataset(dataset) => match dataset.frames.get(view) {
                Some(frame) => frame.image.clone(),
                None => return none(),
            },
            Source::Poses(poses) => match poses.photograph(view)? {
                Some(frame) => frame.image,
                None => return none(),
            },
            Source::BuiltIn(cameras, scene) => {
                let Some(camera) = cameras.get(view) else { return none() };
                let scene = match scene {
                    Some(scene) => scene,
                    None => scene.insert(Box::new(renderer.upload(&demo::scene())?)),
                };
                Photograph::from(&renderer.render_view(scene, camera)?)
            }
        };
        let photograph = Arc::new(photograph);
        self.kept.truncate(KEPT - 1);
        self.kept.push_front((view, Arc::clone(&photograph)));
        Ok(photograph)
    }
}
