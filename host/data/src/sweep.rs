//! Finds points to start from in the photographs of a data set that has none.
//!
//! This is a plane sweep (Collins 1996), one ray at a time. A pixel's ray is cut into depths. A depth is likely if
//! photographs of neighboring cameras show the pixel's colors there. Two depths are drawn by that likelihood. If they are
//! neighbors, the ray gives a point. So a clear match becomes a point on a surface, and a ray that matches everywhere
//! hardly ever becomes one.

use glam::{DMat3, DVec3, Vec3};
use rand::{Rng, RngExt};
use rayon::prelude::*;

use crate::random;
use crate::{Frame, Photograph, Point};

const SWEEP: u64 = 5;

/// Number of depths on a ray, uniform in inverse depth.
const DEPTHS: usize = 96;
/// First and last depth, relative to the cameras' distance from their target.
const RANGE: [f64; 2] = [0.2, 8.0];
/// Number of photographs that a pixel is compared with.
const NEIGHBORS: usize = 6;
/// Number of these that count: the ones that agree best, as something may be in front in the others.
const AGREEING: usize = 3;
/// Best distance between two compared cameras, relative to their distance from the target.
const BASELINE: f64 = 0.25;
/// Cosine of the largest angle between the axes of two compared cameras.
const SAME_SIDE: f64 = 0.5;
/// Longest side of the reduced photographs, in pixels.
const SIDE: u32 = 200;
/// Color difference that makes a depth e times less likely.
const NOISE: f32 = 0.01;
/// Two draws of a depth that are farther apart, in depths, say that a ray matches in several places.
const APART: f64 = 2.5;
/// Number of rays tried per point: some match nowhere or everywhere, and much of an object's photograph may be empty.
const TRIES: u32 = 40;
/// Opacity from which a pixel shows the scene, and not the background.
const SOLID: f32 = 0.5;

/// Finds at most `count` points. `distance` is the cameras' distance from their target.
pub fn points(frames: &[&Frame], distance: f64, count: usize, seed: u64) -> Vec<Point> {
    let views: Vec<ReducedView> = frames.par_iter().map(|frame| ReducedView::new(frame)).collect();
    let neighbors: Vec<_> =
        views.par_iter().map(|view| neighbors(view, &views, distance)).collect();
    let all = 0..count as u64;
    let found = all.into_par_iter().filter_map(|index| {
        let mut random = random(seed, SWEEP, index);
        (0..TRIES).find_map(|_| {
            let view = random.random_range(0..views.len());
            let ray = Ray::random(&views[view], &views, &neighbors[view], &mut random)?;
            ray.point(&views, distance, &mut random)
        })
    });
    found.collect()
}

/// A reduced photograph.
struct ReducedView {
    /// Rotation from world to camera axes: right, down, forward.
    rotation: DMat3,
    eye: DVec3,
    focal: [f64; 2],
    center: [f64; 2],
    size: [u32; 2],
    /// Colors, row by row; `None` if a color is unknown, or if the scene is not there.
    pixels: Vec<Option<Vec3>>,
    /// Row by row: whether the pixel is known to be empty.
    empty: Vec<bool>,
}

impl ReducedView {
    fn new(frame: &Frame) -> Self {
        let camera = &frame.camera;
        let image = &frame.image;
        let factor = image.width().max(image.height()).div_ceil(SIDE).max(1);
        let size = [image.width() / factor, image.height() / factor].map(|side| side.max(1));
        let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y]));
        let (pixels, empty) = places.map(|place| reduce(image, place, factor)).unzip();
        let scale = f64::from(factor);
        Self {
            rotation: camera.to_world().transpose(),
            eye: DVec3::from(camera.eye()),
            focal: [camera.fl_x / scale, camera.fl_y / scale],
            center: [camera.cx / scale, camera.cy / scale],
            size,
            pixels,
            empty,
        }
    }

    fn forward(&self) -> DVec3 {
        self.rotation.transpose().z_axis
    }

    /// The ray through a place in the image, scaled to depth 1.
    fn ray(&self, [x, y]: [f64; 2]) -> DVec3 {
        DVec3::new((x - self.center[0]) / self.focal[0], (y - self.center[1]) / self.focal[1], 1.0)
    }

    /// The image position of a point in camera space, in pixels; `None` if it is outside.
    fn project(&self, point: DVec3) -> Option<[f64; 2]> {
        if point.z <= 1e-9 {
            return None;
        }
        let place = [0, 1].map(|i| self.focal[i] * point[i] / point.z + self.center[i]);
        let is_inside = (0..2).all(|i| (0.0..f64::from(self.size[i])).contains(&place[i]));
        is_inside.then_some(place)
    }

    fn index(&self, [x, y]: [f64; 2]) -> usize {
        y as usize * self.size[0] as usize + x as usize
    }

    /// The color at a place, interpolated between pixel centers; `None` if one of the pixels is unknown.
    fn color(&self, [x, y]: [f64; 2]) -> Option<Vec3> {
        let [(x, x_next, x_part), (y, y_next, y_part)] = [(x, self.size[0]), (y, self.size[1])]
            .map(|(place, size)| {
                let last = f64::from(size - 1);
                let place = (place - 0.5).clamp(0.0, last);
                (place.floor(), (place.floor() + 1.0).min(last), (place - place.floor()) as f32)
            });
        let texel = |x, y| self.pixels[self.index([x, y])];
        let upper = texel(x, y)?.lerp(texel(x_next, y)?, x_part);
        let lower = texel(x, y_next)?.lerp(texel(x_next, y_next)?, x_part);
        Some(upper.lerp(lower, y_part))
    }
}

/// The mean color of a square, and whether the square is empty.
fn reduce(image: &Photograph, [x, y]: [u32; 2], factor: u32) -> (Option<Vec3>, bool) {
    let end = |place: u32, length: u32| ((place + 1) * factor).min(length);
    let mut sum = Vec3::ZERO;
    let mut alpha = 0.0;
    let mut count = 0.0_f32;
    for row in y * factor..end(y, image.height()) {
        for column in x * factor..end(x, image.width()) {
            if image.is_valid(column, row) {
                sum += Vec3::from(image.color(column, row));
                alpha += image.alpha(column, row);
                count += 1.0;
            }
        }
    }
    let is_solid = alpha >= SOLID * count;
    ((count > 0.0 && is_solid).then(|| sum / count), count > 0.0 && !is_solid)
}

/// The views to compare a view with.
fn neighbors(view: &ReducedView, views: &[ReducedView], distance: f64) -> Vec<usize> {
    let mut found: Vec<(f64, usize)> = Vec::new();
    for (index, other) in views.iter().enumerate() {
        let baseline = other.eye.distance(view.eye) / distance;
        if baseline > 0.02 && view.forward().dot(other.forward()) > SAME_SIDE {
            found.push(((baseline / BASELINE).ln().abs(), index));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    found.into_iter().take(NEIGHBORS).map(|(_, index)| index).collect()
}

/// A pixel's ray and patch, as other cameras see them.
struct Ray<'v> {
    view: &'v ReducedView,
    place: [f64; 2],
    color: Vec3,
    others: Vec<Other<'v>>,
}

struct Other<'v> {
    view: &'v ReducedView,
    /// Center of the ray's camera.
    eye: DVec3,
    /// Directions and colors of the patch of pixels, starting with the ray's own.
    patch: Vec<(DVec3, Vec3)>,
}

impl<'v> Ray<'v> {
    fn random(
        view: &'v ReducedView,
        views: &'v [ReducedView],
        neighbors: &[usize],
        random: &mut impl Rng,
    ) -> Option<Self> {
        let pixel = view.size.map(|side| random.random_range(0..side));
        let place = pixel.map(|at| f64::from(at) + 0.5);
        let color = view.pixels[view.index(place)]?;
        let mut patch = vec![(view.ray(place), color)];
        for (dx, dy) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))) {
            let near = [place[0] + f64::from(dx), place[1] + f64::from(dy)];
            let is_inside = (0..2).all(|i| (0.0..f64::from(view.size[i])).contains(&near[i]));
            let color = if is_inside { view.pixels[view.index(near)] } else { None };
            if (dx, dy) != (0, 0)
                && let Some(color) = color
            {
                patch.push((view.ray(near), color));
            }
        }
        let other = |&index: &usize| {
            let other = &views[index];
            let turn = other.rotation * view.rotation.transpose();
            let patch = patch.iter().map(|&(ray, color)| (turn * ray, color)).collect();
            Other { view: other, eye: other.rotation * (view.eye - other.eye), patch }
        };
        Some(Self { view, place, color, others: neighbors.iter().map(other).collect() })
    }

    /// Difference between the photographs at an inverse depth; `None` if fewer than two see the place, or if one
    /// shows that it is empty.
    fn difference(&self, inverse: f64) -> Option<f32> {
        let mut found = Vec::with_capacity(NEIGHBORS);
        for other in &self.others {
            let Some(place) = other.view.project(other.patch[0].0 + other.eye * inverse) else {
                continue;
            };
            if other.view.empty[other.view.index(place)] {
                return None;
            }
            let differences = other.patch.iter().filter_map(|&(ray, color)| {
                let place = other.view.project(ray + other.eye * inverse)?;
                Some((other.view.color(place)? - color).abs().element_sum() / 3.0)
            });
            let (sum, count) =
                differences.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
            if count > 0.0 {
                found.push(sum / count);
            }
        }
        if found.len() < 2 {
            return None;
        }
        found.sort_by(f32::total_cmp);
        let agreeing = &found[..found.len().min(AGREEING)];
        Some(agreeing.iter().sum::<f32>() / agreeing.len() as f32)
    }

    /// A point on the ray, drawn by how well photographs agree on it. `None` if they agree nowhere, or in several places: then two
    /// draws are apart.
    fn point(&self, views: &[ReducedView], distance: f64, random: &mut impl Rng) -> Option<Point> {
        let [first, last] = RANGE.map(|range| 1.0 / (range * distance));
        let step = (first - last) / DEPTHS as f64;
        let depths = (0..DEPTHS).map(|index| last + (index as f64 + 0.5) * step);
        let scored = depths.filter_map(|inverse| Some((self.difference(inverse)?, inverse)));
        let scored: Vec<_> = scored.collect();
        // the smallest sum is drawn with a probability proportional to exp(-difference / NOISE): Gumbel's trick
        let mut draw = || {
            let key = |&(difference, inverse): &(f32, f64)| {
                let uniform: f32 = random.random_range(f32::MIN_POSITIVE..1.0);
                (difference / NOISE + (-uniform.ln()).ln(), inverse)
            };
            let mut keys: Vec<_> = scored.iter().map(key).collect();
            keys.sort_by(|a, b| a.0.total_cmp(&b.0));
            keys.into_iter().find(|(_, inverse)| self.is_possible(*inverse, views))
        };
        let (_, inverse) = draw()?;
        let (_, other) = draw()?;
        if (other - inverse).abs() > APART * step {
            return None;
        }
        // refine between two depths
        let scored = |at: f64| (self.difference(at).unwrap_or(f32::INFINITY), at);
        let mut best = scored(inverse);
        for part in [0.5, 0.25, 0.125] {
            let near = [best.1 - part * step, best.1 + part * step].map(scored);
            best = near
                .into_iter()
                .fold(best, |best, found| if found.0 < best.0 { found } else { best });
        }
        let inverse = best.1;
        let color = (self.color * 255.0).round().to_array().map(|value| value as u8);
        Some(Point { position: self.at(inverse).to_array(), color: Some(color) })
    }

    /// The place on the ray at an inverse depth.
    fn at(&self, inverse: f64) -> DVec3 {
        self.view.eye + self.view.rotation.transpose() * self.view.ray(self.place) / inverse
    }

    /// Whether no photograph shows the place empty: whether it is in the hull of the silhouettes.
    fn is_possible(&self, inverse: f64, views: &[ReducedView]) -> bool {
        let place = self.at(inverse);
        views.iter().all(|view| {
            let seen = view.project(view.rotation * (place - view.eye));
            seen.is_none_or(|at| !view.empty[view.index(at)])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::Camera;

    /// The color and the position of a ray's hit; `None` if it hits nothing.
    type Scene = fn(DVec3, DVec3) -> Option<(Vec3, DVec3)>;

    fn texture(x: f64, y: f64) -> Vec3 {
        let wave = |a: f64, b: f64| (0.5 + 0.4 * (a * x + b * y).sin()) as f32;
        Vec3::new(wave(9.0, 4.0), wave(-5.0, 8.0), wave(3.0, -11.0))
    }

    /// A plane, z = 0.3 x.
    fn plane(eye: DVec3, ray: DVec3) -> Option<(Vec3, DVec3)> {
        let depth = -(eye.z - 0.3 * eye.x) / (ray.z - 0.3 * ray.x);
        let place = eye + ray * depth;
        Some((texture(place.x, place.y), place))
    }

    /// A ball of radius 1 with a single color.
    fn ball(eye: DVec3, ray: DVec3) -> Option<(Vec3, DVec3)> {
        let ray = ray.normalize();
        let middle = -eye.dot(ray);
        let rest = 1.0 - (eye + ray * middle).length_squared();
        (rest > 0.0).then(|| (Vec3::splat(0.6), eye + ray * (middle - rest.sqrt())))
    }

    /// Photographs from circles of radius 3 at these heights.
    fn photographs(scene: Scene, heights: &[f64], angle: f64) -> Vec<Frame> {
        let eye = |height: f64, i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 12.0).sin_cos();
            [3.0 * cos, 3.0 * sin, height]
        };
        let eyes = heights.iter().flat_map(|&height| (0..12).map(move |i| eye(height, i)));
        let cameras =
            eyes.map(|eye| Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], angle, [64, 64]));
        let frame = |camera: Camera| {
            let rays = (0..64 * 64).map(|i| {
                let ray = camera.ray([i % 64, i / 64].map(|at| f64::from(at) + 0.5));
                scene(DVec3::from(camera.eye()), ray)
            });
            let pixel = |hit: Option<(Vec3, DVec3)>| match hit {
                Some((color, _)) => ((color * 255.0).to_array().map(|value| value as u8), 255),
                None => ([255; 3], 0),
            };
            let (pixels, alpha) = rays.map(pixel).unzip();
            let image = Photograph::new([64, 64], pixels, None).unwrap().with_alpha(alpha).unwrap();
            Frame { name: String::new(), camera, image }
        };
        cameras.map(|camera| frame(camera.unwrap())).collect()
    }

    fn found(scene: Scene, heights: &[f64], angle: f64) -> Vec<Point> {
        let frames = photographs(scene, heights, angle);
        let frames: Vec<_> = frames.iter().collect();
        let points = points(&frames, 5.0, 200, 7);
        assert_eq!(points, super::points(&frames, 5.0, 200, 7));
        assert!(points.len() > 150, "{}", points.len());
        points
    }

    #[test]
    fn points_lie_on_a_surface_with_a_texture_and_have_its_color() {
        let points = found(plane, &[4.0], 0.5);
        let mut away: Vec<f64> = points
            .iter()
            .map(|point| (point.position[2] - 0.3 * point.position[0]).abs())
            .collect();
        away.sort_by(f64::total_cmp);
        // cameras are 5 away
        assert!(away[away.len() / 2] < 0.05, "{}", away[away.len() / 2]);
        assert!(away[away.len() * 9 / 10] < 0.3, "{}", away[away.len() * 9 / 10]);
        let close = points.iter().filter(|point| {
            let [x, y, _] = point.position;
            let color = point.color.expect("a color").map(|value| f32::from(value) / 255.0);
            (Vec3::from(color) - texture(x, y)).abs().max_element() < 0.15
        });
        assert!(close.count() * 10 > points.len() * 8);
    }

    #[test]
    fn points_lie_in_the_hull_of_silhouettes() {
        // for an object of one color, silhouettes are the only hint
        for point in found(ball, &[-4.0, 0.0, 4.0], 1.2) {
            let length = DVec3::from(point.position).length();
            assert!(length < 1.25, "{length}");
        }
    }
}
