//! The points of a data set: whether training can start from them.

use std::collections::HashSet;

use rand::seq::SliceRandom;

use organza_core::camera::Target;
use organza_data::random;
use organza_data::{Frame, Point};

const SHUFFLE: u64 = 6;

/// Points that are nearer than this part of their mean distance count as one place.
const SAME: f64 = 0.01;
/// Fewer places do not show a scene.
const LEAST_PLACES: usize = 8;
/// Part of the points that photographs must show, if colors prove nothing.
const LEAST_SEEN: f64 = 0.1;
/// Least number of points with compared colors.
const LEAST_COLORS: usize = 30;
/// Largest difference from the photographs' colors, relative to the difference with shuffled colors. It is below 0.4 for
/// COLMAP's points, and near 1 for points in wrong places.
const LARGEST_DIFFERENCE: f64 = 0.65;
/// Least mean difference between the points' colors, in levels of 255.
const LEAST_SPREAD: f64 = 4.0;
/// Most points and photographs that are compared.
const MOST_POINTS: usize = 4000;
const MOST_FRAMES: usize = 64;

/// The distance below which places count as one, of `count` Gaussians around a target. On a surface, they would be
/// `radius / sqrt(count)` apart.
pub(super) fn resolution(target: &Target, count: usize) -> f64 {
    SAME * target.radius / (count.max(1) as f64).sqrt()
}

/// The first point of each place: leaves out points that repeat another one.
pub(super) fn distinct<T: Copy>(
    points: &[T],
    place: impl Fn(&T) -> [f64; 3],
    resolution: f64,
) -> Vec<T> {
    let mut taken = HashSet::new();
    // far away, the cast saturates
    let cell = |point: &T| place(point).map(|x| (x / resolution).floor() as i64);
    points.iter().filter(|point| taken.insert(cell(point))).copied().collect()
}

/// Why training should not start from points: the photographs do not show them there.
pub(super) fn objection(points: &[Point], places: usize, frames: &[&Frame]) -> Option<String> {
    let all = points.len();
    if places < LEAST_PLACES {
        let reason = format!("its {all} points lie in fewer than {LEAST_PLACES} different places");
        return Some(reason);
    }
    let frames: Vec<_> = frames.iter().step_by(frames.len().div_ceil(MOST_FRAMES)).collect();
    let some: Vec<_> = points.iter().step_by(all.div_ceil(MOST_POINTS)).collect();
    // each point with the color of another one
    let mut others: Vec<_> = some.iter().map(|point| point.color).collect();
    others.shuffle(&mut random(0, SHUFFLE, 0));
    let mut seen = 0;
    let mut compared = 0;
    let mut sums = [0.0; 3];
    for (point, other) in some.iter().zip(others) {
        let shown: Vec<_> = frames.iter().filter_map(|frame| shown(point, frame)).collect();
        seen += usize::from(!shown.is_empty());
        if let (Some(color), Some(other), false) = (point.color, other, shown.is_empty()) {
            compared += 1;
            sums[0] += difference(color, &shown);
            sums[1] += difference(other, &shown);
            sums[2] += difference(color, &[other.map(|value| f32::from(value) / 255.0)]);
        }
    }
    let [own, exchanged, spread] = sums.map(|sum| sum / f64::from(compared.max(1) as u32));
    if compared >= LEAST_COLORS && spread >= LEAST_SPREAD {
        return (own > LARGEST_DIFFERENCE * exchanged).then(|| {
            format!(
                "the photographs show other colors where its points are: they differ by {own:.0} levels of 255, and by \
                 {exchanged:.0} when the points exchange their colors"
            )
        });
    }
    let is_seen = seen as f64 >= LEAST_SEEN * some.len() as f64;
    let share = 100.0 * seen as f64 / some.len() as f64;
    (!is_seen).then(|| format!("the photographs show only {share:.0}% of its {all} points"))
}

/// The photograph's color at the projection of a point. It may show something in front of the point.
fn shown(point: &Point, frame: &Frame) -> Option<[f32; 3]> {
    let [x, y, _] = frame.camera.project(point.position)?;
    let [x, y] = [x as u32, y as u32];
    frame.image.is_valid(x, y).then(|| frame.image.color(x, y))
}

/// The difference of a color from the best quarter of the photographs, in levels of 255: in the others, something may be
/// in front.
fn difference(color: [u8; 3], shown: &[[f32; 3]]) -> f64 {
    let mean = |shown: &[f32; 3]| {
        let pairs = color.iter().zip(shown);
        pairs.map(|(a, b)| f64::from((f32::from(*a) - 255.0 * b).abs())).sum::<f64>() / 3.0
    };
    let mut all: Vec<_> = shown.iter().map(mean).collect();
    let quarter = (all.len() - 1) / 4;
    *all.select_nth_unstable_by(quarter, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DMat3, DVec3};
    use organza_core::Camera;
    use organza_data::Photograph;

    /// The color of a wavy world at a place of the plane z = 0.
    fn color(place: DVec3) -> [u8; 3] {
        let wave = |phase: f64| (127.0 + 120.0 * (3.0 * place.x + phase).sin()) as u8;
        [wave(0.0), (127.0 + 120.0 * (2.0 * place.y).cos()) as u8, wave(2.0)]
    }

    /// Photographs of the plane, from above a ring.
    fn frames() -> Vec<Frame> {
        let frame = |i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 6.0).sin_cos();
            let eye = [3.0 * cos, 3.0 * sin, 4.0];
            let camera = Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.8, [48, 48]).unwrap();
            let [right, down, forward] = camera.axes();
            let pixel = |at: u32| {
                let x = (f64::from(at % 48) + 0.5 - camera.cx) / camera.fl_x;
                let y = (f64::from(at / 48) + 0.5 - camera.cy) / camera.fl_y;
                let ray = right * x + down * y + forward;
                color(DVec3::from(eye) - ray * (eye[2] / ray.z))
            };
            let pixels = (0..48 * 48).map(pixel).collect();
            let image = Photograph::new([48, 48], pixels, None).unwrap();
            Frame { name: format!("{i}"), camera, image }
        };
        (0..6).map(frame).collect()
    }

    fn points(place: impl Fn(DVec3) -> DVec3) -> Vec<Point> {
        let grid = (0..400).map(|i| DVec3::new(f64::from(i % 20), f64::from(i / 20), 0.0));
        grid.map(|cell| {
            let on_plane = (cell - DVec3::new(9.5, 9.5, 0.0)) * 0.1;
            Point { position: place(on_plane).to_array(), color: Some(color(on_plane)) }
        })
        .collect()
    }

    fn places(points: &[Point], resolution: f64) -> Vec<Point> {
        distinct(points, |point| point.position, resolution)
    }

    fn objection_to(points: &[Point]) -> Option<String> {
        let frames = frames();
        let frames: Vec<_> = frames.iter().collect();
        objection(points, places(points, 1e-3).len(), &frames)
    }

    #[test]
    fn points_that_the_photographs_show_are_fine() {
        assert_eq!(objection_to(&points(|place| place)), None);
        // a hand's breadth beside a surface
        assert_eq!(objection_to(&points(|place| place + DVec3::Z * 0.02)), None);
        let gray = points(|place| place).into_iter().map(|p| Point { color: None, ..p });
        assert_eq!(objection_to(&gray.collect::<Vec<_>>()), None);
        let white = points(|place| place).into_iter();
        let white = white.map(|p| Point { color: Some([255; 3]), ..p });
        assert_eq!(objection_to(&white.collect::<Vec<_>>()), None);
    }

    #[test]
    fn points_in_another_frame_are_not_used() {
        for turn in [DMat3::from_rotation_y(1.5), DMat3::from_rotation_z(1.5)] {
            let reason = objection_to(&points(|place| turn * place)).expect("a reason");
            assert!(reason.contains("other colors"), "{reason}");
        }
        let reason = objection_to(&points(|place| place * 0.1)).expect("a reason");
        assert!(reason.contains("other colors"), "{reason}");
        let reason = objection_to(&points(|place| place + DVec3::Y * 30.0)).expect("a reason");
        assert!(reason.contains("only 0% of its 400 points"), "{reason}");
        let reason = objection_to(&points(|_| DVec3::ZERO)).expect("a reason");
        assert!(reason.contains("its 400 points lie in fewer than 8 different places"), "{reason}");
    }

    #[test]
    fn repeated_points_count_once() {
        let once = points(|place| place);
        let again = |by: f64| points(move |place| place + DVec3::splat(by));
        assert_eq!(places(&[&once[..], &once, &again(1e-7)].concat(), 0.0137), once);
        assert_eq!(places(&once, 0.05).len(), 400);
    }
}
