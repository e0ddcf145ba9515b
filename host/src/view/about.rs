//! What the page is told when it opens: the scene, the cameras of its data set, and where to look from.

use glam::DVec3;
use serde::Serialize;

use super::message::{Lens, Mode};
use crate::camera::{Camera, Orbit, upward};
use crate::data::{Point, Pose};
use crate::demo;
use crate::film::Kind;
use crate::render::{DeviceScene, Renderer};

/// Points that the page draws; of more, some are left out.
const MAX_POINTS: usize = 20_000;
/// The size of the first image of a scene without cameras.
const SIZE: [u32; 2] = [960, 640];

/// What the page is told when it opens.
#[derive(Debug)]
pub struct About {
    json: String,
    /// Positions as f32, then colors.
    points: Vec<u8>,
}

#[derive(Serialize)]
struct Told<'a> {
    title: &'a str,
    version: &'static str,
    device: &'a str,
    gaussians: usize,
    aabb: [[f64; 3]; 2],
    step: f64,
    background: [f64; 3],
    /// A unit vector that points up in the world.
    up: [f64; 3],
    /// What the camera goes around.
    center: [f64; 3],
    home: Lens,
    views: Vec<View>,
    /// Whether views have photographs.
    photographs: bool,
    points: usize,
    training: bool,
    /// What films can be written as on this machine.
    films: Vec<Kind>,
    modes: Vec<(Mode, Option<Vec<String>>)>,
}

#[derive(Serialize)]
struct View {
    name: String,
    held_out: bool,
    camera: Lens,
}

impl About {
    /// Of a scene and what is known of its data set. `title` is what the user named.
    #[must_use]
    pub fn new(
        title: &str,
        renderer: &Renderer,
        scene: &DeviceScene,
        poses: &[Pose],
        photographs: bool,
        points: &[Point],
        training: bool,
    ) -> Self {
        let config = scene.config();
        let [low, high] = config.aabb.map(DVec3::from);
        let center = (low + high) / 2.0;
        let up = upward(poses.iter().map(|pose| &pose.camera));
        let first = poses.iter().find(|pose| pose.held_out).or(poses.first());
        let home = first.map_or_else(|| overview(config.aabb), |pose| pose.camera.clone());
        let view = |(index, pose): (usize, &Pose)| View {
            name: pose.camera.file_path.clone().unwrap_or_else(|| format!("view {index}")),
            held_out: pose.held_out,
            camera: Lens::from(&pose.camera),
        };
        let (positions, colors) = sample(points);
        let told = Told {
            title,
            version: env!("CARGO_PKG_VERSION"),
            device: renderer.device().choice(),
            gaussians: scene.len(),
            aabb: config.aabb,
            step: config.step,
            background: config.background,
            up: up.to_array(),
            center: center.to_array(),
            home: Lens::from(&home),
            views: poses.iter().enumerate().map(view).collect(),
            photographs,
            points: colors.len() / 3,
            training,
            films: [Kind::Mp4, Kind::Png]
                .into_iter()
                .filter(|kind| kind.check([2, 2]).is_ok())
                .collect(),
            modes: Mode::ALL.into_iter().map(|mode| (mode, mode.ramp())).collect(),
        };
        let json = serde_json::to_string(&told).expect("numbers and names");
        Self { json, points: [bytemuck::cast_slice(&positions), &*colors].concat() }
    }

    pub(super) fn json(&self) -> &str {
        &self.json
    }

    pub(super) fn points(&self) -> &[u8] {
        &self.points
    }
}

/// A camera that sees the whole box.
fn overview(aabb: [[f64; 3]; 2]) -> Camera {
    let cameras = Orbit::of_box(aabb, SIZE).cameras(1).ok().and_then(|mut cameras| cameras.pop());
    // a box of no size has no outside
    cameras.unwrap_or_else(|| demo::turntable(1, SIZE[1]).remove(0))
}

/// Positions `[n, 3]` and colors `[n, 3]` of some of the points.
fn sample(points: &[Point]) -> (Vec<f32>, Vec<u8>) {
    let every = points.len().div_ceil(MAX_POINTS).max(1);
    let some = points.iter().step_by(every);
    let positions = some.clone().flat_map(|point| point.position.map(|x| x as f32)).collect();
    (positions, some.flat_map(|point| point.color.unwrap_or([160; 3])).collect())
}
