//! The points of a data set: whether training can start from them.

use std::collections::HashSet;
use std::ops::RangeInclusive;

use rand::seq::SliceRandom;

use organza_core::camera::Target;
use organza_data::random;
use organza_data::{Frame, Point};

const SHUFFLE: u64 = 6;

/// Points that are nearer than this part of their mean distance count as one place.
const SAME: f64 = 0.01;
/// Smallest number of places that show a scene.
const MIN_PLACES: usize = 8;
/// Share of the points that photographs must show, if colors prove nothing.
const MIN_SEEN: f64 = 0.1;
/// Smallest number of points with compared colors.
const MIN_COLORS: usize = 30;
/// How much worse other points' colors fit the photographs, relative to the difference between what photographs show at points.
/// It is 0.7 to 1 for the points of COLMAP, below 0.25 in the wrong place, and more if the points lie too close together.
const EXPLAINED: RangeInclusive<f64> = 0.65..=2.0;
/// Smallest difference of colors from each other, in levels of 255.
const MIN_SPREAD: f64 = 4.0;
/// Largest number of points, and of photographs, that are compared.
const MAX_POINTS: usize = 4000;
const MAX_FRAMES: usize = 64;

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
    if places < MIN_PLACES {
        let reason = format!("its {all} points lie in fewer than {MIN_PLACES} different places");
        return Some(reason);
    }
    let frames: Vec<_> = frames.iter().step_by(frames.len().div_ceil(MAX_FRAMES)).collect();
    let some: Vec<_> = points.iter().step_by(all.div_ceil(MAX_POINTS)).collect();
    let shown: Vec<Vec<_>> = some
        .iter()
        .map(|point| frames.iter().filter_map(|frame| shown(point, frame)).collect())
        .collect();
    let seen = shown.iter().filter(|shown| !shown.is_empty()).count();
    // each point with another one, so that these exchange their colors
    let compared: Vec<_> =
        (0..some.len()).filter(|&i| some[i].color.is_some() && !shown[i].is_empty()).collect();
    let mut others = compared.clone();
    others.shuffle(&mut random(0, SHUFFLE, 0));
    let mut sums = [0.0; 4];
    for (&i, &j) in compared.iter().zip(&others) {
        let [own, other] = [i, j].map(|at| some[at].color.unwrap_or_default().map(f32::from));
        sums[0] += difference(own, &shown[i]);
        sums[1] += difference(other, &shown[i]);
        sums[2] += difference(own, &[other]);
        sums[3] += difference(shown[j][j % shown[j].len()], &shown[i]);
    }
    // A pixel is the mean of what it covers. A point's color is that, and detail too fine for the photographs. Both are independent,
    // so their squares add, and `exchanged - own` is `photographs`, however much detail is lost where photographs are shrunk.
    let [own, exchanged, points, photographs] = sums.map(|sum| sum / compared.len().max(1) as f64);
    if compared.len() >= MIN_COLORS && points.min(photographs) >= MIN_SPREAD.powi(2) {
        return (!EXPLAINED.contains(&((exchanged - own) / photographs))).then(|| {
            let [own, exchanged] = [own, exchanged].map(f64::sqrt);
            format!(
                "the photographs show other colors where its points are: they differ by {own:.0} levels of 255, and by \
                 {exchanged:.0} when the points exchange their colors"
            )
        });
    }
    let is_seen = seen as f64 >= MIN_SEEN * some.len() as f64;
    let share = 100.0 * seen as f64 / some.len() as f64;
    (!is_seen).then(|| format!("the photographs show only {share:.0}% of its {all} points"))
}

/// The color where a photograph shows a point, or what is in front of it, in levels of 255.
fn shown(point: &Point, frame: &Frame) -> Option<[f32; 3]> {
    let [x, y, _] = frame.camera.project(point.position)?;
    let [x, y] = [x as u32, y as u32];
    frame.image.is_valid(x, y).then(|| frame.image.color(x, y).map(|value| 255.0 * value))
}

/// The squared difference of a color from the photographs', the mean over channels: the first quartile over photographs, because in some,
/// another thing may be in front.
fn difference(color: [f32; 3], shown: &[[f32; 3]]) -> f64 {
    let mean = |shown: &[f32; 3]| {
        let pairs = color.iter().zip(shown);
        pairs.map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>() / 3.0
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
    use rand::RngExt;

    /// The color of a wavy world at a place of the plane z = 0.
    fn color(place: DVec3) -> [u8; 3] {
        let wave = |phase: f64| (127.0 + 60.0 * (3.0 * place.x + phase).sin()) as u8;
        [wave(0.0), (127.0 + 60.0 * (2.0 * place.y).cos()) as u8, wave(2.0)]
    }

    /// Photographs of the plane, from above a ring.
    fn frames() -> Vec<Frame> {
        let frame = |i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 6.0).sin_cos();
            let eye = [3.0 * cos, 3.0 * sin, 4.0];
            let camera = Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.8, [48, 48]).unwrap();
            let pixel = |at: u32| {
                let ray = camera.ray([at % 48, at / 48].map(|at| f64::from(at) + 0.5));
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

    /// Points of a print in dots that are too fine for the photographs, which show the dots' mean.
    fn dots(points: Vec<Point>) -> Vec<Point> {
        let mut random = random(0, 0, 0);
        let mut dot = |mean: u8| if random.random_range(0..255) < mean { 255 } else { 0 };
        let dots = |point: Point| Point { color: point.color.map(|c| c.map(&mut dot)), ..point };
        points.into_iter().map(dots).collect()
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
        assert_eq!(objection_to(&dots(points(|place| place))), None);
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
        for small in [points(|place| place * 0.1), dots(points(|place| place * 0.1))] {
            let reason = objection_to(&small).expect("a reason");
            assert!(reason.contains("other colors"), "{reason}");
        }
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
