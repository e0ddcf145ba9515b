//! Properties for all inputs: the clip, and tile intersection.

use glam::{Vec2, Vec3, Vec4};
use organza_shaders::camera::Camera;
use organza_shaders::project::{falloff, mahalanobis, project_gaussian};
use organza_shaders::segment::{clip_to_unit_cube, clipped_segment, point_along};
use organza_shaders::shape::{flatness, shaped_falloff};
use organza_shaders::tile::{distance_squared, reaches};
use organza_shaders::unit_cube::Split;
use proptest::prelude::*;

/// Coordinates on the cube's planes, near them, and anywhere.
fn coordinate() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![4 => -2.0f32..3.0, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-0.0), 1 => Just(1.0 + f32::EPSILON)]
}

/// Directions with axis-parallel, tiny and denormal components.
fn component() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![6 => -3.0f32..3.0, 2 => Just(0.0), 1 => Just(-0.0), 1 => Just(1e-40), 1 => Just(1e-20), 1 => Just(-1e-20)]
}

fn split(x: Vec3) -> [Split; 3] {
    x.to_array().map(|x| Split::new(x, 0.0))
}

/// The number that both parts represent.
fn exact(x: Split) -> f64 {
    f64::from(x.coarse) + f64::from(x.fine)
}

fn vector(of: impl Strategy<Value = f32> + Clone) -> impl Strategy<Value = Vec3> {
    [of.clone(), of.clone(), of].prop_map(Vec3::from_array)
}

/// Eq. 4-6 in f64, like the reference.
fn exact_clip(p: Vec3, v: Vec3) -> (f64, f64) {
    let mut enter = f64::NEG_INFINITY;
    let mut exit = f64::INFINITY;
    for (p, v) in p.to_array().map(f64::from).into_iter().zip(v.to_array().map(f64::from)) {
        let inside = (0.0..=1.0).contains(&p);
        // values that a GPU may flush to zero count as zero
        let (low, high) = match v.abs() < f64::from(f32::MIN_POSITIVE) {
            true if inside => (f64::NEG_INFINITY, f64::INFINITY),
            true => (f64::INFINITY, f64::NEG_INFINITY),
            false => ((-p / v).min((1.0 - p) / v), (-p / v).max((1.0 - p) / v)),
        };
        enter = enter.max(low);
        exit = exit.min(high);
    }
    (enter.clamp(0.0, 1.0), exit.clamp(0.0, 1.0))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]

    #[test]
    fn a_clipped_ray_lies_in_the_cube(p in vector(coordinate()), v in vector(component())) {
        let clip = clip_to_unit_cube(split(p), split(v));
        let (t0, t1) = exact_clip(p, v);
        let [found0, found1, lambda] = [clip.t0, clip.t1, clip.lambda].map(exact);
        prop_assert!((found0 - t0).abs() <= 1e-7, "t0 {found0} for {t0}");
        prop_assert!((found1 - t1).abs() <= 1e-7, "t1 {found1} for {t1}");
        prop_assert!((lambda - (found1 - found0).max(0.0)).abs() <= 1e-7, "{lambda}");
        if lambda > 0.0 {
            for t in [clip.t0, clip.t1] {
                let x = point_along(split(p), t, split(v)).map(exact);
                prop_assert!(x.iter().all(|x| (-3e-7..=1.0 + 3e-7).contains(x)), "{x:?} at {t:?}");
            }
        }
    }

    #[test]
    fn a_segment_has_whole_steps_of_at_most_sigma(p in vector(coordinate()), v in vector(component()), step in 0.001f32..2.0) {
        let segment = clipped_segment(split(p), split(v), step);
        let w = Vec3::from_array(segment.w.map(Split::value));
        let start = Vec3::from_array(segment.start.map(Split::value));
        prop_assert!(w.is_finite() && start.is_finite() && segment.factor.is_finite());
        let length = w.length();
        if segment.count == 0 {
            prop_assert_eq!(segment.factor, 0.0);
            // the length of components whose squares underflow in f32 is zero
            prop_assert!(length <= 1e-18, "{length} but no samples");
        } else {
            // K is the smallest number of steps that are at most sigma long
            let steps = length / step;
            prop_assert!(segment.count as f32 >= steps * (1.0 - 1e-6) && (segment.count - 1) as f32 <= steps * (1.0 + 1e-6));
            prop_assert!(segment.factor <= 1.0 + 1e-6, "{}", segment.factor);
            prop_assert!((segment.factor * segment.count as f32 - steps).abs() <= 1e-5 * steps.max(1.0));
        }
    }

    #[test]
    fn shaped_falloffs_fall_in_the_support_of_a_gaussian(q in 0.0f32..12.0, shape in -100.0f32..100.0) {
        let k = flatness(shape);
        prop_assert!((-0.5..=1.0).contains(&k));
        let [near, far] = [0.99 * q, q].map(|q| shaped_falloff(q, k));
        prop_assert!((0.0..1.0 + 1e-6).contains(&far) && near > far - 1e-6);
        prop_assert_eq!(far > 0.0, falloff(q) > 0.0);
        prop_assert_eq!(shaped_falloff(q, flatness(0.0)), falloff(q));
    }

    #[test]
    fn intersections_are_all_whose_falloff_reaches_a_pixel(
        position in vector(-1.5f32..1.5), rotation in [-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0, 0.1f32..1.0],
        log_scale in vector(-7.0f32..0.5), origin in [-40i32..100, -40i32..100], side in 1u32..24,
    ) {
        let camera = Camera {
            rotation: [Vec3::X, Vec3::Y, Vec3::Z], eye: Vec3::new(0.0, 0.0, -3.0), focal: Vec2::new(90.0, 88.0),
            center: Vec2::new(47.5, 40.5), size: Vec2::new(96.0, 80.0),
        };
        let projection = project_gaussian(&camera, 0.3, position, Vec4::from_array(rotation), log_scale);
        prop_assert!(projection.radius > 0.0);
        let low = Vec2::new(origin[0] as f32, origin[1] as f32);
        let intersects = reaches(projection.mean2d, projection.radius, low, side as f32);
        // within Eq. 15's own radius it intersects the tile; beyond the margin it does not
        let distance = distance_squared(projection.mean2d, low, side as f32).sqrt();
        prop_assert!(intersects || distance > projection.radius);
        prop_assert!(!intersects || distance <= projection.radius * 1.0011 + 0.011);
        for row in 0..side {
            for column in 0..side {
                let pixel = low + Vec2::new(column as f32 + 0.5, row as f32 + 0.5);
                let d = pixel - projection.mean2d;
                let weight = falloff(mahalanobis(projection.conic, d.x, d.y));
                let inside = d.x.abs() <= projection.extent.x && d.y.abs() <= projection.extent.y;
                prop_assert!(inside || weight == 0.0, "{weight} at {pixel}, outside of its extent");
                prop_assert!(intersects || weight == 0.0, "{weight} at {pixel} of a tile that it does not intersect");
            }
        }
    }
}
