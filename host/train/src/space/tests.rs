//! Captures of many kinds, made from few numbers.

use std::f64::consts::TAU;

use rand::RngExt;
use rand_pcg::Pcg64;

use super::super::config::TrainConfig;
use super::super::start::{scatter, start};
use super::*;
use organza_data::random;

fn numbers() -> Pcg64 {
    random(7, 0, 0)
}

fn look(eye: DVec3, at: DVec3) -> Camera {
    Camera::look_at(eye.to_array(), at.to_array(), [0.02, 0.01, 1.0], 0.9, [64, 48]).unwrap()
}

/// A random point in the cube from -1 to 1.
fn in_cube(random: &mut Pcg64) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0)))
}

/// `count` eyes on a circle around the z axis.
fn circle(count: usize, radius: f64, height: f64) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |i| {
        let (sin, cos) = (i as f64 * TAU / count as f64).sin_cos();
        DVec3::new(radius * cos, radius * sin, height)
    })
}

/// A ring of cameras at distance 2 from their target.
fn inward() -> Vec<Camera> {
    circle(40, 1.8, 0.9).map(|eye| look(eye, DVec3::ZERO)).collect()
}

fn outward() -> Vec<Camera> {
    circle(40, 0.5, 0.0).map(|eye| look(eye, eye * 3.0)).collect()
}

/// A grid of cameras, a step of `pitch` apart, that look along `axis` within a degree.
fn grid(pitch: f64, axis: DVec3) -> Vec<Camera> {
    let mut random = numbers();
    let right = axis.any_orthonormal_vector();
    let up = axis.cross(right);
    (0..30)
        .map(|i| {
            let eye = right * (f64::from(i % 6) - 2.5) * pitch + up * f64::from(i / 6 - 2) * pitch;
            look(eye, eye + axis + 0.01 * in_cube(&mut random))
        })
        .collect()
}

fn points(places: impl IntoIterator<Item = DVec3>) -> Vec<Point> {
    let point = |place: DVec3| Point { position: place.to_array(), color: None };
    places.into_iter().map(point).collect()
}

fn box_of(cameras: &[Camera], points: &[Point]) -> [DVec3; 2] {
    let mut config = TrainConfig::default();
    config.densification.max_gaussians = 30_000;
    let scene = start(&config, [0.0; 3], cameras, points).unwrap();
    scene.validate().unwrap();
    scene.config.aabb.map(DVec3::from)
}

fn longest([low, high]: [DVec3; 2]) -> f64 {
    (high - low).max_element()
}

/// Fraction of some places that a box contains.
fn share([low, high]: [DVec3; 2], places: &[Point]) -> f64 {
    let is_in = |point: &&Point| {
        let place = DVec3::from(point.position);
        place.cmpge(low).all() && place.cmple(high).all()
    };
    places.iter().filter(is_in).count() as f64 / places.len() as f64
}

/// The points that some camera sees.
fn visible(cameras: &[Camera], mut all: Vec<Point>) -> Vec<Point> {
    all.retain(|point| cameras.iter().any(|at| at.depth_in_image(point.position).is_some()));
    assert!(all.len() > 300, "the cameras see {} points", all.len());
    all
}

/// An object of radius 0.25 on a table, and far things behind it.
fn table(far: usize) -> (Vec<Point>, Vec<Point>) {
    let mut random = numbers();
    let object = points((0..500).map(|_| 0.25 * in_cube(&mut random)));
    let table = (0..400).map(|_| {
        let place = in_cube(&mut random);
        DVec3::new(0.8 * place.x, 0.8 * place.y, -0.25)
    });
    let mut all = [object.clone(), points(table)].concat();
    let behind = (0..far).map(|i| {
        let (sin, cos) = (i as f64 * 0.37).sin_cos();
        DVec3::new(cos, sin, random.random_range(-0.2..0.3)) * random.random_range(8.0..30.0)
    });
    all.extend(points(behind));
    (all, object)
}

#[test]
fn cameras_look_at_their_target() {
    let at = DVec3::new(1.0, 2.0, 3.0);
    let mut cameras: Vec<_> = circle(20, 4.0, 3.0).map(|eye| look(at + eye, at)).collect();
    let target = Target::from_cameras(&cameras);
    assert!(target.is_met && target.center.distance(at) < 1e-2, "{target:?}");
    assert!((target.distance - 5.0).abs() < 1e-2);
    // some cameras look elsewhere, and one has a wrong pose
    for eye in circle(3, 3.0, 1.0) {
        cameras.push(look(at + eye, at + 3.0 * eye));
    }
    cameras.push(look(DVec3::splat(900.0), DVec3::ZERO));
    let target = Target::from_cameras(&cameras);
    assert!(target.is_met && target.center.distance(at) < 0.1, "{target:?}");
    assert!((target.distance - 5.0).abs() < 0.1);
}

#[test]
fn axes_that_do_not_meet_have_no_target() {
    let still: Vec<_> = circle(20, 1.0, 0.1).map(|at| look(DVec3::ONE, DVec3::ONE + at)).collect();
    for cameras in [outward(), grid(0.1, DVec3::X), still, inward()[..1].to_vec()] {
        let target = Target::from_cameras(&cameras);
        assert!(!target.is_met && target.center.is_finite() && target.radius > 0.0, "{target:?}");
    }
}

#[test]
fn an_object_on_a_table_is_not_lost_among_far_points() {
    for far in [0, 110, 900] {
        let (all, object) = table(far);
        let found = box_of(&inward(), &all);
        assert!(longest(found) < 4.0, "{far} far points: {found:?}");
        assert_eq!(share(found, &object), 1.0, "{far} far points: {found:?}");
    }
}

#[test]
fn an_object_without_points_is_in_the_box() {
    // a table with a pattern, 1 below, and a white sphere without any matched point
    let mut random = numbers();
    let pattern = (0..500).map(|_| in_cube(&mut random).with_z(-0.4));
    let [low, high] = box_of(&inward(), &points(pattern));
    assert!(low.z < -0.4 && high.z > 0.3, "{low} {high}");
}

#[test]
fn a_room_seen_from_within_is_in_the_box() {
    let size = DVec3::new(2.5, 2.0, 1.2);
    let mut random = numbers();
    let walls = (0..2000).map(|i| {
        let mut place = in_cube(&mut random);
        place[i % 3] = place[i % 3].signum();
        place * size
    });
    let mut walls = points(walls);
    // through a window
    let room = walls.clone();
    walls.extend(points((0..100).map(|i| DVec3::new(40.0, f64::from(i % 10), 0.0))));
    let found = box_of(&outward(), &walls);
    assert!(share(found, &visible(&outward(), room)) > 0.95, "{found:?}");
    assert!(longest(found) < 12.0, "{found:?}");
}

#[test]
fn the_box_holds_points_ahead_of_parallel_cameras() {
    let mut random = numbers();
    let mut near = |_| {
        let depth = random.random_range(2.0..4.0);
        in_cube(&mut random).with_x(depth)
    };
    let near = points((0..1000).map(&mut near));
    let mut all = near.clone();
    all.extend(points((0..200).map(|i| DVec3::new(60.0, f64::from(i % 20) - 10.0, 5.0))));
    let found = box_of(&grid(0.1, DVec3::X), &all);
    assert!(share(found, &near) > 0.9 && longest(found) < 8.0, "{found:?}");
}

#[test]
fn ground_below_a_drone_is_in_the_box() {
    let mut random = numbers();
    let ground = (0..2000).map(|i| {
        let place = in_cube(&mut random) * DVec3::new(100.0, 100.0, 0.0);
        // trees
        place.with_z(if i % 10 == 0 { -52.0 } else { -60.0 })
    });
    let ground = points(ground);
    let drone = grid(20.0, DVec3::NEG_Z);
    let found = box_of(&drone, &ground);
    assert!(share(found, &visible(&drone, ground)) > 0.95, "{found:?}");
    let [low, high] = found;
    assert!(high.z - low.z >= 0.09 * longest(found), "{found:?}");
}

#[test]
fn random_places_have_a_box_that_holds_most() {
    let still: Vec<_> = circle(20, 1.0, 0.0).map(|at| look(DVec3::ONE, DVec3::ONE + at)).collect();
    let one = inward()[..1].to_vec();
    for cameras in [inward(), outward(), grid(0.1, DVec3::X), still, one] {
        let target = Target::from_cameras(&cameras);
        let places = scatter(&target, &cameras, 1000, &mut random(0, 0, 0));
        let found = box_of(&cameras, &places);
        assert!(share(found, &places) > 0.75, "{} in {found:?}", share(found, &places));
    }
}

#[test]
fn points_that_no_camera_sees_have_a_box() {
    let cameras = inward();
    let behind = points((0..50).map(|i| DVec3::new(0.0, f64::from(i), 500.0)));
    let found = box_of(&cameras, &behind);
    assert!(found.iter().all(|corner| corner.is_finite()), "{found:?}");
    let one = box_of(&cameras, &points([DVec3::ONE]));
    assert!(longest(one) > 0.0);
}
