//! The photographs of a data set, which are read on demand.

use std::collections::VecDeque;
use std::fmt;
use std::sync::Arc;

use organza_core::error::refuse;
use organza_core::{Camera, Result, demo};
use organza_data::{Dataset, Photograph, Pose, Poses};
use organza_render::{Contributions, DeviceScene, Renderer};

/// Number of photographs that are kept after reading.
const KEPT: usize = 4;

/// Photographs of a data set's views.
#[derive(Default)]
pub struct Photographs {
    source: PhotographSource,
    /// The built-in scene, once one of its views was rendered.
    scene: Option<DeviceScene>,
    /// The photographs used last, newest first.
    kept: VecDeque<(usize, Arc<Photograph>)>,
}

/// The source of photographs.
#[derive(Default)]
pub enum PhotographSource {
    /// There are none.
    #[default]
    None,
    /// A training's photographs, in memory.
    Dataset(Arc<Dataset>),
    /// Photographs in files.
    Poses(Box<Poses>),
    /// Views of the built-in scene, rendered on demand.
    BuiltIn(Vec<Camera>),
}

impl fmt::Debug for Photographs {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kept: Vec<_> = self.kept.iter().map(|(view, _)| view).collect();
        formatter.debug_struct("Photographs").field("kept", &kept).finish_non_exhaustive()
    }
}

impl Photographs {
    /// Photographs of a source.
    pub fn new(source: PhotographSource) -> Self {
        Self { source, ..Self::default() }
    }

    /// Whether there are any.
    pub fn is_empty(&self) -> bool {
        matches!(self.source, PhotographSource::None)
    }

    /// Adds what Gaussians contribute to a view, by its photograph if there is one that is not held out.
    ///
    /// # Errors
    /// The same errors as [`Renderer::add_contributions`], and as reading the photograph.
    pub fn add_contributions(
        &mut self,
        renderer: &Renderer,
        scene: &DeviceScene,
        (view, pose): (usize, &Pose),
        found: &mut Contributions,
    ) -> Result<()> {
        let is_known = !pose.held_out && !self.is_empty();
        let photograph = is_known.then(|| self.get(renderer, view)).transpose()?;
        let color = |[x, y]: [i32; 2]| {
            let [x, y] = [x as u32, y as u32];
            let photograph = photograph.as_ref().filter(|photograph| photograph.is_valid(x, y));
            photograph.map(|photograph| photograph.color(x, y).map(f64::from))
        };
        renderer.add_contributions(scene, &pose.camera, Some(&color), found)
    }

    /// The photograph of a view in the data set.
    ///
    /// # Errors
    /// The same errors as [`Poses::photograph`], and if there is none.
    pub fn get(&mut self, renderer: &Renderer, view: usize) -> Result<Arc<Photograph>> {
        if let Some((_, found)) = self.kept.iter().find(|(kept, _)| *kept == view) {
            return Ok(Arc::clone(found));
        }
        let none = || refuse(format!("there is no photograph of view {view}"));
        let photograph = match &self.source {
            PhotographSource::None => return none(),
            PhotographSource::Dataset(dataset) => match dataset.frames.get(view) {
                Some(frame) => frame.image.clone(),
                None => return none(),
            },
            PhotographSource::Poses(poses) => match poses.photograph(view)? {
                Some(frame) => frame.image,
                None => return none(),
            },
            PhotographSource::BuiltIn(cameras) => {
                let Some(camera) = cameras.get(view) else { return none() };
                let scene = match &mut self.scene {
                    Some(scene) => scene,
                    None => self.scene.insert(renderer.upload(&demo::scene())?),
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
