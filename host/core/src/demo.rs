//! The built-in scene: a pearl in two sheets of organza, made from formulas alone.
//!
//! No file, no training and no random numbers: formulas give every Gaussian, grid entry and weight below. The scene
//! shows what the two fields are for. In the transmittance field, the pearl hides everything behind it and the cloth
//! dims it. The color field is Blinn-Phong shading written in ReLUs, and its grid holds the light that has come
//! through the cloth.
//!
//! Lengths are in world units with z up; the pearl lies at the origin.

mod color;
mod drapery;
mod lattice;
mod light;
mod network;
mod pieces;
mod shape;
mod transmittance;
mod volume;

use std::f64::consts::TAU;
use std::sync::LazyLock;

use crate::camera::Camera;
use crate::scene::{Contraction, Gaussians, GridConfig, MlpConfig, Placement, Scene, SceneConfig};
use lattice::Splats;
use light::Surroundings;
pub use light::key as key_light;
use shape::HALF_BOX;
pub use shape::{BACKGROUND, PEARL};

/// Point that the turntable's cameras look at.
const TARGET: [f64; 3] = [0.0, 0.0, -0.11];
/// Distance of the cameras from that point.
const DISTANCE: f64 = 4.7;
/// Angle of the cameras above the horizon, in degrees.
const ELEVATION: f64 = 17.0;
/// Azimuth of the first camera, in degrees: the view for the front page.
const AZIMUTH: f64 = 195.0;
/// Horizontal field of view of the cameras, in degrees.
const ANGLE: f64 = 29.0;

/// The built-in scene. Two calls give the same scene.
pub fn scene() -> Scene {
    // The fields are sums over all pieces, so the first call takes half a second.
    static SCENE: LazyLock<Scene> = LazyLock::new(build);
    SCENE.clone()
}

fn build() -> Scene {
    let config = config();
    let surroundings = Surroundings::new(&config);
    let mut splats = Splats::default();
    pieces::pearl(&mut splats);
    pieces::cloth(&mut splats);
    pieces::floor(&mut splats, &surroundings);
    let gaussians: Gaussians = splats.into();
    let mut scene = Scene::zeros(config, gaussians.len()).expect("the configuration is valid");
    scene.gaussians = gaussians;
    transmittance::fill(&mut scene, &surroundings);
    color::fill(&mut scene, &surroundings);
    scene
}

/// `views` cameras on a circle around the built-in scene, counterclockwise from its best side. Images are square,
/// `side` pixels wide.
///
/// # Panics
/// If `side` is no valid image size: 0, or more than [`MAX_IMAGE_SIDE`](crate::camera::MAX_IMAGE_SIDE).
pub fn turntable(views: usize, side: u32) -> Vec<Camera> {
    let (height, reach) = ELEVATION.to_radians().sin_cos();
    let camera = |view: usize| {
        let (sin, cos) = (AZIMUTH.to_radians() + TAU * view as f64 / views as f64).sin_cos();
        let offset = [reach * cos, reach * sin, height];
        let eye = std::array::from_fn(|axis| TARGET[axis] + DISTANCE * offset[axis]);
        Camera::look_at(eye, TARGET, [0.0, 0.0, 1.0], ANGLE.to_radians(), [side, side])
            .expect("the eye is away from the target, and the side is an image's")
    };
    (0..views).map(camera).collect()
}

/// The configuration of the built-in scene.
pub fn config() -> SceneConfig {
    let half = f64::from(HALF_BOX);
    // one dense level each, so the network reads at a vertex exactly what the formulas give there
    let grid = |features, log2_table, base_resolution| GridConfig {
        levels: 1,
        features,
        log2_table,
        base_resolution,
        growth: 1.0,
    };
    SceneConfig {
        sh_degree: 1,
        material: shape::MATERIAL as u32,
        extra: transmittance::EXTRA as u32,
        slope: 0,
        shape: 0,
        color_grid: grid(color::FEATURES as u32, 17, 50.0),
        transmittance_grid: grid(transmittance::FEATURES as u32, 21, 128.0),
        color_mlp: MlpConfig { hidden: vec![128, 48] },
        transmittance_mlp: MlpConfig { hidden: vec![16] },
        step: 0.0065,
        occupancy: 0,
        blur: 0.3,
        // the cloth is as sheer in small images as in large ones
        antialiased: true,
        background: BACKGROUND,
        aabb: [[-half; 3], [half; 3]],
        contraction: Contraction::None,
        placement: Placement::default(),
        trained_on: None,
    }
}
