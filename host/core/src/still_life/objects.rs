//! What stands on the table, and how the light falls on it.

use glam::{DMat3, DVec3};
use rand::RngExt;
use rand_pcg::Pcg64;

use super::shapes::{Meeting, Shape};
use super::surfaces::Surface;

/// Light of the sun and of the sky, on a surface that faces them.
const SUN: DVec3 = DVec3::new(0.95, 0.88, 0.76);
const SKY: DVec3 = DVec3::new(0.34, 0.38, 0.44);
/// Tangent of the sun's radius: larger than the true one, as through a window.
const SUN_RADIUS: f64 = 0.04;
/// Blinn and Phong's exponent of glossy surfaces.
const SHINE: f64 = 60.0;
/// Half the sides of the cloth.
const CLOTH: f64 = 1.05;

/// A thing of the still life.
#[derive(Clone, Copy, Debug)]
struct Thing {
    center: DVec3,
    /// World to the shape's axes.
    turn: DMat3,
    shape: Shape,
    surface: Surface,
}

/// A place that a ray has reached.
struct Place {
    position: DVec3,
    normal: DVec3,
    color: DVec3,
    gloss: f64,
    thing: Option<usize>,
}

/// All things, on a floor at z = 0.
#[derive(Debug)]
pub struct Objects {
    things: Vec<Thing>,
    sun: DVec3,
}

impl Objects {
    pub fn new() -> Self {
        let thing = |center: [f64; 3], degrees: f64, shape, surface| Thing {
            center: DVec3::from(center),
            turn: DMat3::from_rotation_z(-degrees.to_radians()),
            shape,
            surface,
        };
        let sphere = |radius| Shape::Sphere { radius };
        let block = |x, y, z| Shape::Block { half: DVec3::new(x, y, z) };
        let red = Surface::Book(DVec3::new(0.42, 0.07, 0.06));
        let green = Surface::Book(DVec3::new(0.10, 0.26, 0.16));
        let things = vec![
            thing([-0.38, 0.22, 0.06], 20.0, block(0.36, 0.27, 0.06), green),
            thing([-0.40, 0.20, 0.17], 33.0, block(0.31, 0.24, 0.05), red),
            thing([-0.42, 0.22, 0.42], 0.0, sphere(0.20), Surface::Stripes),
            thing(
                [0.34, 0.30, 0.21],
                0.0,
                Shape::Cylinder { radius: 0.17, half: 0.21 },
                Surface::Glaze,
            ),
            thing([0.52, -0.28, 0.13], -25.0, block(0.13, 0.13, 0.13), Surface::Diamonds),
            thing([0.06, -0.30, 0.12], 0.0, sphere(0.12), Surface::Peel),
            thing([-0.17, -0.42, 0.11], 0.0, sphere(0.11), Surface::Peel),
            thing([0.22, -0.55, 0.10], 0.0, sphere(0.10), Surface::Peel),
        ];
        Self { things, sun: DVec3::new(-0.55, -0.35, 0.85).normalize() }
    }

    /// The light that comes back along a ray, which starts above the floor.
    pub fn light(&self, origin: DVec3, direction: DVec3, random: &mut Pcg64) -> DVec3 {
        let Some(place) = self.place(origin, direction) else { return SKY };
        let mut any = || 2.0 * random.random::<f64>() - 1.0;
        let sun = (self.sun + SUN_RADIUS * DVec3::new(any(), any(), any())).normalize();
        let facing = place.normal.dot(sun).max(0.0);
        let is_lit = facing > 0.0 && !self.is_hidden(place.position + 1e-6 * place.normal, sun);
        let open = 0.5 * (1.0 + place.normal.z) * self.openness(&place) + 0.15;
        let mut light = open * SKY * place.color;
        if is_lit {
            let between = (sun - direction).normalize();
            let shine = place.gloss * place.normal.dot(between).max(0.0).powf(SHINE);
            light += SUN * (facing * place.color + DVec3::splat(shine));
        }
        light
    }

    /// The first thing that a ray meets.
    fn first(&self, origin: DVec3, direction: DVec3) -> Option<(usize, Meeting)> {
        let meetings = self.things.iter().enumerate().filter_map(|(index, thing)| {
            let from = thing.turn * (origin - thing.center);
            Some((index, thing.shape.meeting(from, thing.turn * direction)?))
        });
        meetings.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance))
    }

    fn is_hidden(&self, origin: DVec3, direction: DVec3) -> bool {
        self.first(origin, direction).is_some()
    }

    /// Where a ray ends: at a thing or on the floor. A ray into the sky has no end.
    fn place(&self, origin: DVec3, direction: DVec3) -> Option<Place> {
        if let Some((index, meeting)) = self.first(origin, direction) {
            let thing = &self.things[index];
            let position = origin + meeting.distance * direction;
            let at = thing.turn * (position - thing.center);
            return Some(Place {
                position,
                normal: thing.turn.transpose() * meeting.normal,
                color: thing.surface.color(at, meeting.normal),
                gloss: thing.surface.gloss(),
                thing: Some(index),
            });
        }
        if direction.z >= 0.0 {
            return None;
        }
        let position = origin - origin.z / direction.z * direction;
        let is_cloth = position.truncate().abs().max_element() < CLOTH;
        let surface = if is_cloth { Surface::Cloth } else { Surface::Boards };
        let color = surface.color(position, DVec3::Z);
        Some(Place { position, normal: DVec3::Z, color, gloss: 0.0, thing: None })
    }

    /// The part of the sky that a place sees past the other things, each as a ball: a ball of radius r at distance d hides
    /// (r/d)^2 times the cosine of its direction.
    fn openness(&self, place: &Place) -> f64 {
        let others =
            self.things.iter().enumerate().filter(|(index, _)| place.thing != Some(*index));
        others
            .map(|(_, thing)| {
                let toward = thing.center - place.position;
                let part = (thing.shape.size() / toward.length()).min(1.0).powi(2);
                1.0 - part * place.normal.dot(toward.normalize()).clamp(0.0, 1.0)
            })
            .product()
    }
}
