//! A pixel, Gaussian by Gaussian, for the page.

use serde::Serialize;

use organza_core::Camera;
use organza_core::error::{Result, refuse};
use organza_render::{Contribution, DeviceScene, Inspection, Renderer, Trace};

/// Most Gaussians in an answer: those with the largest alpha.
const MAX_GAUSSIANS: usize = 200;

/// A pixel, with all digits of its numbers.
#[derive(Debug, Serialize)]
struct Explanation {
    pixel: [i32; 2],
    /// Number of all Gaussians. The page gets those with the largest alpha.
    all: usize,
    gaussians: Vec<Row>,
    #[serde(flatten)]
    inspection: Inspection,
}

/// One Gaussian of the pixel.
#[derive(Debug, Serialize)]
struct Row {
    #[serde(flatten)]
    contribution: Contribution,
    /// Center of the Gaussian on the screen, in pixels.
    mean2d: [f32; 2],
    /// Depth along the camera's axis, in world units.
    depth: f64,
    conic: [f32; 3],
    /// The ray in the unit cube, and T from the Gaussian to the end of each step.
    places: Vec<[f32; 3]>,
    transmittances: Vec<f32>,
}

impl Row {
    fn new(contribution: Contribution, trace: Trace, depth: f64) -> Self {
        let Trace { mean2d, conic, ray } = trace;
        let mut sum = 0.0;
        let mut up_to = |log_rho: &f32| -> f32 {
            sum += log_rho;
            sum.exp()
        };
        let transmittances = ray.log_rho.iter().map(&mut up_to).collect();
        Self { contribution, mean2d, depth, conic, places: ray.places, transmittances }
    }
}

/// Breaks a pixel down.
pub fn explain(
    renderer: &Renderer,
    scene: &DeviceScene,
    camera: &Camera,
    pixel: [i32; 2],
) -> Result<Vec<u8>> {
    let size = [camera.width, camera.height].map(i64::from);
    if !pixel.iter().zip(size).all(|(&at, size)| (0..size).contains(&i64::from(at))) {
        let [x, y] = pixel;
        return refuse(format!("pixel {x},{y} is outside the image"));
    }
    let cameras = std::slice::from_ref(camera);
    let (mut inspection, traces) = renderer.inspect_traced(scene, cameras, 0, pixel)?;
    let contributions = std::mem::take(&mut inspection.contributions);
    let mut rows: Vec<_> = contributions.into_iter().zip(traces).collect();
    rows.retain(|(contribution, _)| contribution.falloff > 0.0);
    rows.sort_by(|(a, _), (b, _)| b.alpha.total_cmp(&a.alpha));
    let all = rows.len();
    rows.truncate(MAX_GAUSSIANS);
    let position = renderer.device().read(&scene.tensors().gaussians.position)?;
    let (position, _) = position.as_chunks::<3>();
    let row = |(contribution, trace): (Contribution, Trace)| {
        let depth = camera.depth(position[contribution.gaussian].map(f64::from));
        Row::new(contribution, trace, depth * scene.config().placement.scale)
    };
    let gaussians = rows.into_iter().map(row).collect();
    let explanation = Explanation { pixel, all, gaussians, inspection };
    serde_json::to_vec(&explanation).or_else(|error| refuse(error.to_string()))
}
