//! The equations of projection and tiles in f64.

use organza::{Camera, Scene, Stages, TileBatch};
use organza_parity::exact::composite::{self, Splat};
use organza_parity::exact::project::{self, Gaussian, Projected, View};
use organza_parity::exact::resolve;

fn wide<const N: usize>(values: [f32; N]) -> [f64; N] {
    values.map(f64::from)
}

/// A camera, for the equations.
pub fn view(camera: &Camera) -> View<f64> {
    View {
        axes: camera.axes().map(|axis| axis.to_array()),
        eye: camera.eye(),
        focal: [camera.fl_x, camera.fl_y],
        center: [camera.cx, camera.cy],
        size: [camera.width, camera.height].map(f64::from),
    }
}

/// A Gaussian, for the equations.
pub fn gaussian(scene: &Scene, gaussian: usize) -> Gaussian<f64> {
    Gaussian {
        position: wide(scene.gaussians.position[gaussian]),
        rotation: wide(scene.gaussians.rotation[gaussian]),
        log_scale: wide(scene.gaussians.log_scale[gaussian]),
    }
}

/// Projects a Gaussian with EWA; `None` if it is culled.
pub fn project(scene: &Scene, camera: &Camera, index: usize) -> Option<Projected<f64>> {
    project::project(&view(camera), scene.config.blur, &gaussian(scene, index))
}

/// Numbers of pixels by their branch of Eq. 13.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Branches {
    /// Pixels with S > 1.
    pub divided: usize,
    /// Pixels with 0 < S <= 1.
    pub mixed: usize,
    /// Pixels with S = 0, which show the background.
    pub empty: usize,
}

/// Eq. 12 and 13 for every pixel of every tile, from the stages of each camera: `[K, 3, S, S]`.
pub fn tiles(scene: &Scene, stages: &[Stages], batch: &TileBatch) -> (Vec<f64>, Branches) {
    let side = batch.side as usize;
    let mut image = vec![0.0; batch.tiles.len() * 3 * side * side];
    let mut branches = Branches::default();
    for (index, tile) in batch.tiles.iter().enumerate() {
        for at in 0..side * side {
            let place = [at % side, at / side];
            let pixel =
                std::array::from_fn(|axis| f64::from(tile.origin[axis]) + place[axis] as f64 + 0.5);
            let sum = weighted_sum(scene, &stages[tile.camera], pixel);
            let count = match sum[3] {
                0.0 => &mut branches.empty,
                ..=1.0 => &mut branches.mixed,
                _ => &mut branches.divided,
            };
            *count += 1;
            for channel in 0..3 {
                let background = scene.config.background[channel];
                image[(index * 3 + channel) * side * side + at] =
                    resolve::pixel(sum[channel], sum[3], background);
            }
        }
    }
    (image, branches)
}

/// Eq. 12: C and S of a pixel.
fn weighted_sum(scene: &Scene, stages: &Stages, pixel: [f64; 2]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for gaussian in (0..stages.radius.len()).filter(|&i| stages.radius[i] >= 0.0) {
        let logit = f64::from(scene.gaussians.opacity[gaussian]);
        let splat = Splat {
            mean: wide(stages.mean2d[gaussian]),
            weight: composite::weight(logit, f64::from(stages.transmittance[gaussian])),
            conic: wide(stages.conic[gaussian]),
            color: std::array::from_fn(|channel| f64::from(stages.color[3 * gaussian + channel])),
            growth: None,
            flatness: None,
        };
        assert!(
            (splat.q(pixel) - project::cutoff()).abs() > 2e-5,
            "Gaussian {gaussian} ends at {pixel:?}: rounding shows"
        );
        let term = splat.term(pixel);
        sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
    }
    sum
}
