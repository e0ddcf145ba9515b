//! Derivatives of the image that a viewer that sorts shows, with respect to every value of the Gaussians.

use std::ops::AddAssign;

use glam::{Vec2, Vec3, Vec4};
use organza_shaders::camera::Camera as KernelCamera;
use organza_shaders::project_backward::project_gaussian_backward;
use rayon::prelude::*;

use super::Splat;
use super::harmonics::harmonics;
use super::sorted::{BLUR, Hit, MAX_ALPHA, Placed, SortedView, blend};
use organza_core::camera::Camera;

/// Derivatives of a loss with respect to a Gaussian in an image.
#[derive(Clone, Copy, Debug, Default)]
struct Slope {
    color: Vec3,
    /// Derivative by the opacity, not by its logit.
    opacity: f32,
    mean: Vec2,
    conic: Vec3,
}

impl AddAssign for Slope {
    fn add_assign(&mut self, other: Self) {
        self.color += other.color;
        self.opacity += other.opacity;
        self.mean += other.mean;
        self.conic += other.conic;
    }
}

/// The derivative of the mean squared error between [`render`](super::sorted::render)'s image and `truth`. Returns a
/// Gaussian's index and a [`Splat`] of derivatives, for each Gaussian that the image shows. The dependence of colors
/// on positions is ignored.
pub(super) fn gradient(
    splats: &[Splat],
    camera: &Camera,
    background: [f32; 3],
    truth: &[[f32; 3]],
) -> Vec<(u32, Splat)> {
    let view = SortedView::new(splats, camera, false);
    let background = Vec3::from(background);
    let scale = 2.0 / (3 * view.pixels()) as f32;
    let sums = view.sums(|intersections, pixels, slopes: &mut [Slope]| {
        let mut hits = Vec::new();
        for (x, y, at) in pixels {
            let color = blend(intersections, x, y, background, &mut hits);
            let by_color = scale * (color - Vec3::from(truth[at]));
            blend_backward(intersections, &hits, by_color, background, slopes);
        }
    });
    let backward = |placed: &Placed| {
        let gaussian = placed.gaussian as usize;
        let slope = placed_backward(&view.camera, &splats[gaussian], placed, &sums[gaussian]);
        (placed.gaussian, slope)
    };
    view.placed.par_iter().map(backward).collect()
}

/// The derivative of [`blend`]: adds a pixel's part to the derivatives of its Gaussians. `by_color` is the derivative
/// by the pixel's color.
fn blend_backward(
    intersections: &[Placed],
    hits: &[Hit],
    by_color: Vec3,
    background: Vec3,
    slopes: &mut [Slope],
) {
    let Some(last) = hits.last() else { return };
    // contribution of everything behind to the loss's derivative, from the last Gaussian to the first
    let mut behind = last.light * (1.0 - last.alpha.min(MAX_ALPHA)) * by_color.dot(background);
    for hit in hits.iter().rev() {
        let placed = &intersections[hit.intersection];
        let slope = &mut slopes[hit.intersection];
        let alpha = hit.alpha.min(MAX_ALPHA);
        let shade = by_color.dot(placed.color);
        slope.color += hit.light * alpha * by_color;
        let by_alpha = hit.light * shade - behind / (1.0 - alpha);
        behind += hit.light * alpha * shade;
        if hit.alpha < MAX_ALPHA {
            slope.opacity += by_alpha * alpha / placed.opacity;
            // alpha = opacity exp(-q / 2), q = d^T conic d, d the offset from the center
            let by_q = -0.5 * by_alpha * alpha;
            let d = hit.offset;
            let conic = placed.conic;
            let by_d = Vec2::new(conic.x * d.x + conic.y * d.y, conic.y * d.x + conic.z * d.y);
            slope.mean -= 2.0 * by_q * by_d;
            slope.conic += by_q * Vec3::new(d.x * d.x, 2.0 * d.x * d.y, d.y * d.y);
        }
    }
}

/// The derivative of [`Placed::new`]: turns derivatives in the image into derivatives by a Gaussian's values.
fn placed_backward(camera: &KernelCamera, splat: &Splat, placed: &Placed, slope: &Slope) -> Splat {
    let position = Vec3::from(splat.position);
    let rotation = Vec4::from(splat.rotation);
    let geometry = project_gaussian_backward(
        camera,
        BLUR,
        position,
        rotation,
        splat.log_scale.into(),
        slope.mean,
        slope.conic,
    );
    let basis = harmonics(camera.eye, splat.position);
    // a channel that is clamped to 0 has a derivative only if it should be brighter
    let is_held = placed.color.cmple(Vec3::ZERO) & slope.color.cmpgt(Vec3::ZERO);
    let by_channel = Vec3::select(is_held, Vec3::ZERO, slope.color);
    let color = basis.map(|basis| (by_channel * basis).to_array());
    Splat {
        position: geometry.position.into(),
        rotation: geometry.rotation.into(),
        log_scale: geometry.log_scale.into(),
        opacity: slope.opacity * placed.opacity * (1.0 - placed.opacity),
        color,
    }
}

#[cfg(test)]
mod tests {
    use super::super::VALUES;
    use super::super::sorted::render;
    use super::super::sorted::tests::{SIZE, ball, camera};
    use super::*;

    /// The mean squared error of an image.
    fn error(splats: &[Splat], camera: &Camera, background: [f32; 3], truth: &[[f32; 3]]) -> f64 {
        let image = render(splats, camera, background, false);
        let off = image.as_flattened().iter().zip(truth.as_flattened());
        off.map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>() / truth.len() as f64 / 3.0
    }

    /// Gaussians of several shapes, visible in all pixels: an alpha that crosses 1/255 would be a step in the loss.
    fn many() -> Vec<Splat> {
        (0..14)
            .map(|i: usize| {
                let mut next = (0..).map(|k: usize| ((i * 37 + k * 61) % 97) as f32 / 97.0 - 0.5);
                let mut value = || next.next().unwrap();
                let mut splat = ball();
                splat.position = std::array::from_fn(|_| 1.6 * value());
                splat.rotation = std::array::from_fn(|_| value() + 0.1);
                splat.log_scale = std::array::from_fn(|_| 0.6 * value() + 0.6);
                splat.opacity = 4.0 * value();
                splat.color = std::array::from_fn(|_| std::array::from_fn(|_| 0.3 * value()));
                splat
            })
            .collect()
    }

    #[test]
    fn the_gradient_follows_finite_differences() {
        let splats = many();
        let camera = camera();
        let background = [0.9, 0.5, 0.1];
        let truth = vec![[0.3, 0.6, 0.2]; (SIZE[0] * SIZE[1]) as usize];
        let gradient = gradient(&splats, &camera, background, &truth);
        let error_of = |splats: &[Splat]| error(splats, &camera, background, &truth);
        assert!(gradient.len() > 10, "{}", gradient.len());
        let largest = gradient
            .iter()
            .flat_map(|(_, splat)| bytemuck::cast_ref::<_, [f32; VALUES]>(splat))
            .fold(0.0, |largest: f32, value| largest.max(value.abs()));
        for (gaussian, slope) in &gradient {
            let slope: &[f32; VALUES] = bytemuck::cast_ref(slope);
            // a color also depends on the position, through its direction, but that is ignored
            for (value, found) in slope.iter().enumerate().skip(3) {
                let moved = |by: f32| {
                    let mut splats = splats.clone();
                    let own = &mut splats[*gaussian as usize];
                    bytemuck::cast_mut::<_, [f32; VALUES]>(own)[value] += by;
                    error_of(&splats)
                };
                let step = 4e-3;
                let expected = (moved(step) - moved(-step)) / f64::from(2.0 * step);
                let found = f64::from(*found);
                let off = (found - expected).abs();
                assert!(
                    off < 0.02 * expected.abs() + 0.002 * f64::from(largest),
                    "{gaussian}, {value}: {found} {expected}"
                );
            }
        }
    }

    #[test]
    fn a_center_moves_with_its_gradient() {
        // with one color for all directions
        let camera = camera();
        let background = [0.0; 3];
        let mut splat = ball();
        splat.position = [0.1, 0.2, -0.1];
        let truth = render(&[ball()], &camera, background, false);
        let gradient = gradient(&[splat], &camera, background, &truth);
        for axis in 0..3 {
            let moved = |by: f32| {
                let mut splat = splat;
                splat.position[axis] += by;
                error(&[splat], &camera, background, &truth)
            };
            let expected = (moved(2e-3) - moved(-2e-3)) / 4e-3;
            let found = f64::from(gradient[0].1.position[axis]);
            assert!((found - expected).abs() < 0.03 * expected.abs() + 1e-4, "{found} {expected}");
        }
    }
}
