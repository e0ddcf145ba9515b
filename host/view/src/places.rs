//! Moves scenes that are shown with the first one.

use std::sync::Arc;

use glam::DVec3;
use serde::Deserialize;
use serde_json::json;

use super::about::visible_box;
use super::stage::Stage;
use organza_core::Result;
use organza_core::error::refuse;
use organza_core::scene::Place;
use organza_render::DeviceScene;

/// A place that a page asks for.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaceRequest {
    /// Its number: the first scene, which stays, has 0.
    scene: usize,
    place: Place,
}

/// A scene that is shown with the first one.
#[derive(Debug)]
struct Placed {
    name: String,
    place: Place,
    /// A ball around nearly all of its opacity, in its own coordinates.
    center: DVec3,
    radius: f64,
}

/// Scenes that are shown with the first one, and their places. None of them is needed.
#[derive(Debug, Default)]
pub struct Places {
    scenes: Vec<Placed>,
    shown: Option<Arc<DeviceScene>>,
    /// Number of changes to what is shown.
    version: u64,
}

impl Places {
    /// The scenes that are shown with `scene`: their names and places.
    pub fn new(scene: &DeviceScene, named: Vec<(String, Place)>) -> Self {
        let placed = |(other, (name, place)): (&DeviceScene, (String, Place))| {
            let [low, high] = visible_box(other).map(DVec3::from);
            let radius = (high - low).max_element() / 2.0;
            Placed { name, place, center: (low + high) / 2.0, radius }
        };
        Self { scenes: scene.all().skip(1).zip(named).map(placed).collect(), ..Self::default() }
    }

    /// The scenes to show instead of the first places, and their version.
    pub(super) fn shown(&self) -> (Option<Arc<DeviceScene>>, u64) {
        (self.shown.clone(), self.version)
    }

    /// Puts a scene where a page asks for, and returns all places.
    pub(super) fn answer(
        &mut self,
        stage: Stage<'_>,
        request: Option<PlaceRequest>,
    ) -> Result<Vec<u8>> {
        if let Some(PlaceRequest { scene, place }) = request {
            let mut others = self.scenes.iter_mut().zip(stage.scene.all().skip(1));
            let Some((placed, other)) = scene.checked_sub(1).and_then(|at| others.nth(at)) else {
                return refuse(format!("there is no scene {scene} that can be moved"));
            };
            let world = &stage.scene.config().placement;
            let found = world.place(&other.config().placement, &place)?;
            self.shown = Some(Arc::new(stage.scene.moved(scene, found)?));
            self.version += 1;
            placed.place = place;
        }
        let shown = self.shown.as_deref().unwrap_or(stage.scene);
        let told = |(placed, other): (&Placed, &DeviceScene)| {
            let Placed { name, place, center, radius } = placed;
            json!({
                "name": name,
                "place": place,
                // in the first scene's coordinates
                "center": other.place().world(center.to_array()),
                "radius": radius * other.place().scale,
            })
        };
        let all: Vec<_> = self.scenes.iter().zip(shown.all().skip(1)).map(told).collect();
        serde_json::to_vec(&all).or_else(|error| refuse(error.to_string()))
    }
}
