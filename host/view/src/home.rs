//! The view that a page opens with.

use muslin::math::sigmoid;
use organza_core::camera::{Camera, Orbit};

/// Most Gaussians that are looked for in the cameras' images.
const MAX: usize = 4000;

/// The camera that shows most of a scene's opacity, head on. What many cameras show counts more: they were held toward it.
/// `None` without cameras.
pub fn home<'a>(
    cameras: &'a [Camera],
    position: &[[f32; 3]],
    opacity: &[f32],
) -> Option<&'a Camera> {
    let center = Orbit::around(cameras).ok()?.center;
    let every = position.len().div_ceil(MAX).max(1);
    let some: Vec<_> = position.iter().zip(opacity).step_by(every).collect();
    let shows = |camera: &Camera| -> Vec<bool> {
        some.iter()
            .map(|(place, _)| camera.depth_in_image(place.map(f64::from)).is_some())
            .collect()
    };
    let shown: Vec<_> = cameras.iter().map(shows).collect();
    let weight = |(index, (_, logit)): (usize, &(_, &f32))| {
        let times = shown.iter().filter(|shown| shown[index]).count();
        f64::from(sigmoid(**logit)) * times as f64
    };
    let weights: Vec<_> = some.iter().enumerate().map(weight).collect();
    let score = |(camera, shown): &(&Camera, &Vec<bool>)| {
        let sum: f64 = weights.iter().zip(*shown).filter(|pair| *pair.1).map(|pair| pair.0).sum();
        let [.., forward] = camera.axes();
        let toward = glam::DVec3::from(center) - glam::DVec3::from(camera.eye());
        sum * (1.0 + forward.dot(toward.normalize_or_zero()))
    };
    let best = cameras.iter().zip(&shown).max_by(|a, b| score(a).total_cmp(&score(b)));
    best.map(|(camera, _)| camera)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_view_shows_the_most_and_looks_at_it() {
        // a row of Gaussians along x, and three outside of it that nobody was held toward
        let place =
            |i: usize| if i < 40 { [0.05 * i as f32 - 1.0, 0.0, 0.0] } else { [9.0, 9.0, 9.0] };
        let position: Vec<_> = (0..43).map(place).collect();
        let opacity = vec![2.0; position.len()];
        let camera = |eye: [f64; 3], target: [f64; 3]| {
            Camera::look_at(eye, target, [0.0, 0.0, 1.0], 0.6, [60, 40]).unwrap()
        };
        let cameras = [
            // a part from near by, the others, all of it from aside, all of it head on
            camera([0.3, -1.5, 0.2], [0.3, 0.0, 0.0]),
            camera([12.0, 9.0, 9.0], [9.0, 9.0, 9.0]),
            camera([0.0, -5.0, 0.5], [0.5, 0.0, 0.4]),
            camera([0.0, -5.0, 0.5], [0.0, 0.0, 0.0]),
        ];
        assert_eq!(home(&cameras, &position, &opacity), Some(&cameras[3]));
        assert_eq!(home(&cameras[..2], &position, &opacity), Some(&cameras[0]));
        assert!(home(&cameras, &[], &[]).is_some());
        assert_eq!(home(&[], &position, &opacity), None);
    }
}
