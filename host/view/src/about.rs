//! Facts that the page gets when it opens: the scene, the cameras of its data set, and the first view.

use glam::DVec3;
use serde::Serialize;
use serde_json::json;

use super::home::home;
use super::message::Mode;
use organza_core::camera::{Camera, Orbit};
use organza_core::demo;
use organza_core::scene::{Placement, bounds};
use organza_data::{Point, Pose};
use organza_render::DeviceScene;

/// Most points that the page draws; others are left out.
const MAX_POINTS: usize = 20_000;
/// Size of the first image of a scene without cameras, in pixels.
const SIZE: [u32; 2] = [960, 640];

/// The purpose of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Purpose {
    /// To look at a scene.
    Look,
    /// To remove Gaussians from a scene, too.
    Edit,
    /// To look at a scene that is being trained.
    Train,
}

/// Facts that the page gets when it opens.
#[derive(Debug)]
pub struct About {
    /// The camera of the first view.
    pub home: Camera,
    pub(super) json: String,
    /// Positions as f32, followed by colors.
    pub(super) points: Vec<u8>,
    pub(super) placement: Placement,
}

impl About {
    /// Facts about a scene and its data set. `title` is the path that the user named.
    pub fn new(
        title: &str,
        scene: &DeviceScene,
        poses: &[Pose],
        photographs: bool,
        points: &[Point],
        purpose: Purpose,
    ) -> Self {
        let config = scene.config();
        let gaussians = &scene.tensors().gaussians;
        // nothing, if the device fails
        let read = |values| scene.device().read(values).unwrap_or_default();
        let [position, opacity] = [&gaussians.position, &gaussians.opacity].map(read);
        let cameras: Vec<_> = poses.iter().map(|pose| pose.camera.clone()).collect();
        let home = home(&cameras, position.as_chunks().0, &opacity);
        // data sets have views of their own to begin with
        let visible = if home.is_none() { visible_box(scene) } else { config.aabb };
        let home = home.cloned().unwrap_or_else(|| overview(visible));
        let [low, high] = visible.map(DVec3::from);
        let center = (low + high) / 2.0;
        let up = config.placement.upward(&cameras);
        let view = |(index, pose): (usize, &Pose)| {
            let name = pose.camera.file_path.clone().unwrap_or_else(|| format!("view {index}"));
            json!({ "name": name, "held_out": pose.held_out, "camera": pose.camera })
        };
        let views: Vec<_> = poses.iter().enumerate().map(view).collect();
        let (positions, colors) = sample(points);
        let told = json!({
            "title": title,
            "version": env!("CARGO_PKG_VERSION"),
            "device": scene.device().choice(),
            "gaussians": scene.len(),
            "scenes": scene.all().count(),
            "aabb": config.aabb,
            // the page computes in the scene's coordinates, and shows the world's
            "placement": config.placement,
            "step": config.step,
            "background": config.background,
            "up": up,
            // of the camera's orbit
            "center": center.to_array(),
            "home": home,
            "views": views,
            // whether there are any of the views
            "photographs": photographs,
            "points": colors.len() / 3,
            "purpose": purpose,
            "modes": Mode::ALL.map(|mode| (mode, mode.ramp())),
        });
        let json = told.to_string();
        let points = [bytemuck::cast_slice(&positions), &*colors].concat();
        Self { home, json, points, placement: config.placement }
    }
}

/// The box of nearly all of a scene's opacity, in its own coordinates.
pub fn visible_box(scene: &DeviceScene) -> [[f64; 3]; 2] {
    let gaussians = &scene.tensors().gaussians;
    let read = |values| scene.device().read(values).unwrap_or_default();
    let opacity = read(&gaussians.opacity);
    if opacity.is_empty() {
        return scene.config().aabb;
    }
    let [position, log_scale] = [&gaussians.position, &gaussians.log_scale].map(read);
    bounds(position.as_chunks().0, log_scale.as_chunks().0, &opacity)
}

/// A camera that sees the whole box.
fn overview(aabb: [[f64; 3]; 2]) -> Camera {
    let cameras = Orbit::from_box(aabb, SIZE).cameras(1).ok().and_then(|mut cameras| cameras.pop());
    // a box without size has no outside
    cameras.unwrap_or_else(|| demo::turntable(1, SIZE[1]).remove(0))
}

/// Positions `[n, 3]` and colors `[n, 3]` of a sample of the points.
fn sample(points: &[Point]) -> (Vec<f32>, Vec<u8>) {
    let some = points.iter().step_by(points.len().div_ceil(MAX_POINTS).max(1));
    let positions = some.clone().flat_map(|point| point.position.map(|x| x as f32)).collect();
    (positions, some.flat_map(|point| point.color.unwrap_or([160; 3])).collect())
}
