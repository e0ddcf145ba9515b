//! Photographs of a still life on a table, by sphere tracing: a capture for everyone who has no camera at hand.
//!
//! Its surfaces are solid, and hide and shade each other exactly. Nothing of it comes from Gaussians or from fields, so a
//! scene that is trained on these photographs has learned something. They have the flaws of photographs that are taken by
//! hand: exposures differ, sensors have noise, each is a little blurred and some are shaken, and the camera has seen the
//! table from one side only. The photographs are in the public domain (CC0 1.0).
//!
//! ```
//! use organza_data::still_life::StillLife;
//!
//! let walk = StillLife::new(40, [64, 48])?;
//! assert_eq!(walk.photograph(3)?.size(), [64, 48]);
//! assert_eq!(walk.cameras().len(), 40);
//! # Ok::<(), organza_core::Error>(())
//! ```

use std::f64::consts::TAU;

use glam::{DMat3, DVec2, DVec3};
use rand::RngExt;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use organza_core::{Camera, Image, Result};

use crate::random;

/// Purpose of the random numbers of a photograph.
const PHOTOGRAPH: u64 = 0x7374_696c;
/// Rays of a pixel, each at another moment of the exposure.
const RAYS: usize = 8;
/// One photograph among these is shaken.
const SHAKEN_EVERY: usize = 9;
/// Length of the way of a pixel while the shutter is open, in parts of the image's width: of a steady hand, and of one
/// that shakes.
const STEADY: f64 = 1.0 / 640.0;
const SHAKEN: f64 = 12.0 / 640.0;
/// Standard deviation of a lens's blur, in pixels.
const LENS_BLUR: f64 = 0.45;
/// Variance of a sensor's noise: of a dark pixel, and for each unit of light.
const DARK_NOISE: f64 = 1e-5;
const SHOT_NOISE: f64 = 2e-4;
/// Horizontal field of view, in radians.
const ANGLE: f64 = 1.0;

/// A walk around the table, with a photograph at each step.
#[derive(Debug)]
pub struct StillLife {
    cameras: Vec<Camera>,
    objects: Objects,
}

impl StillLife {
    /// A walk of `count` photographs of `size` pixels.
    ///
    /// # Errors
    /// [`Error::Camera`](organza_core::Error::Camera) if the size is out of range.
    pub fn new(count: usize, size: [u32; 2]) -> Result<Self> {
        let cameras = (0..count).map(|index| camera(index, count, size)).collect::<Result<_>>()?;
        Ok(Self { cameras, objects: Objects::new() })
    }

    /// The true cameras of the photographs.
    #[must_use]
    pub fn cameras(&self) -> &[Camera] {
        &self.cameras
    }

    /// Whether the hand shook at this photograph.
    #[must_use]
    pub fn is_shaken(index: usize) -> bool {
        index % SHAKEN_EVERY == SHAKEN_EVERY - 2
    }

    /// Takes a photograph. Two calls give the same one.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    ///
    /// # Panics
    /// Where there is no photograph of this index.
    pub fn photograph(&self, index: usize) -> Result<Image> {
        let camera = &self.cameras[index];
        let size = [camera.width, camera.height];
        Image::check_memory(size[0], size[1])?;
        let exposure = Exposure::new(index, camera);
        let rows = (0..camera.height).into_par_iter().flat_map_iter(|row| {
            let mut random = random(index as u64, PHOTOGRAPH, u64::from(row));
            (0..camera.width)
                .map(|column| {
                    let light = exposure.light(&self.objects, [column, row], &mut random);
                    light.to_array().map(|light| encoded(noisy(light, &mut random)))
                })
                .collect::<Vec<_>>()
        });
        Ok(Image::from_pixels(size, &rows.collect::<Vec<_>>()))
    }
}

/// The camera at a step of the walk: an arc of 220 degrees, now higher and now lower, at arm's length from the table.
fn camera(index: usize, count: usize, size: [u32; 2]) -> Result<Camera> {
    let time = index as f64 / count.max(2) as f64;
    let azimuth = (220.0 * (time - 0.5)).to_radians();
    let elevation = 0.55 + 0.17 * (2.6 * TAU * time).sin();
    let distance = 2.7 + 0.25 * (1.7 * TAU * time).cos();
    let flat = distance * elevation.cos();
    let eye = [flat * azimuth.sin(), -flat * azimuth.cos(), distance * elevation.sin()];
    // A hand does not aim exactly.
    let aim = |speed: f64| 0.06 * (speed * index as f64).sin();
    Camera::look_at(eye, [aim(1.3), aim(2.1), 0.22 + aim(1.7)], [0.0, 0.0, 1.0], ANGLE, size)
}

/// One opening of the shutter.
struct Exposure<'a> {
    camera: &'a Camera,
    /// How much of the light reaches the sensor.
    gain: f64,
    /// Way of a pixel while the shutter is open, in pixels.
    way: DVec2,
}

impl<'a> Exposure<'a> {
    fn new(index: usize, camera: &'a Camera) -> Self {
        let at = index as f64;
        let length = if StillLife::is_shaken(index) { SHAKEN } else { STEADY };
        let way = DVec2::from_angle(2.4 * at) * length * f64::from(camera.width);
        Self { camera, gain: 1.0 + 0.12 * (0.37 * at).sin(), way }
    }

    /// The light that reaches a pixel: a mean over time, and over the blur of the lens.
    fn light(&self, objects: &Objects, pixel: [u32; 2], random: &mut Pcg64) -> DVec3 {
        let sum: DVec3 = (0..RAYS)
            .map(|ray| {
                let time = (ray as f64 + random.random::<f64>()) / RAYS as f64 - 0.5;
                let blur = LENS_BLUR * DVec2::new(normal(random), normal(random));
                let center = DVec2::from(pixel.map(|at| f64::from(at) + 0.5));
                let direction = direction(self.camera, center + blur + time * self.way);
                objects.light(DVec3::from(self.camera.eye()), direction, random)
            })
            .sum();
        self.gain * sum / RAYS as f64
    }
}

/// Direction of the ray through a place of the image, in world space.
fn direction(camera: &Camera, at: DVec2) -> DVec3 {
    let local = [(at.x - camera.cx) / camera.fl_x, (camera.cy - at.y) / camera.fl_y, -1.0];
    let along = |row: [f64; 4]| row[0] * local[0] + row[1] * local[1] + row[2] * local[2];
    let [x, y, z, _] = camera.camera_to_world;
    DVec3::new(along(x), along(y), along(z)).normalize()
}

/// A value of the standard normal distribution (Box and Muller, 1958).
fn normal(random: &mut Pcg64) -> f64 {
    let radius = (-2.0 * (1.0 - random.random::<f64>()).ln()).sqrt();
    radius * (TAU * random.random::<f64>()).cos()
}

/// Light with a sensor's noise, whose variance grows with the light.
fn noisy(light: f64, random: &mut Pcg64) -> f64 {
    light + (DARK_NOISE + SHOT_NOISE * light).sqrt() * normal(random)
}

/// A value of sRGB (IEC 61966-2-1), 0 to 255.
fn encoded(light: f64) -> u8 {
    let light = light.clamp(0.0, 1.0);
    let value =
        if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (255.0 * value).round() as u8
}

/// Light of the sun and of the sky, on a surface that faces them.
const SUN: DVec3 = DVec3::new(0.95, 0.88, 0.76);
const SKY: DVec3 = DVec3::new(0.34, 0.38, 0.44);
/// Tangent of the sun's radius: larger than the true one, as through a window.
const SUN_RADIUS: f64 = 0.04;
/// Blinn and Phong's exponent of glossy surfaces.
const SHINE: f64 = 60.0;
/// Half the side of the cloth.
const CLOTH: f64 = 1.05;
/// A ray this close to a surface has met it, and none goes farther than the second length.
const NEAR: f64 = 1e-4;
const FAR: f64 = 20.0;

/// A solid around its own center, whose axis is z.
#[derive(Clone, Copy, Debug)]
enum Shape {
    Ball(f64),
    /// Half its sides.
    Block(DVec3),
    /// Radius and half the height.
    Cylinder(f64, f64),
}

impl Shape {
    /// The signed distance of a place from the surface, negative inside.
    fn distance(self, at: DVec3) -> f64 {
        let beyond = match self {
            Self::Ball(radius) => return at.length() - radius,
            Self::Block(half) => at.abs() - half,
            Self::Cylinder(radius, half) => {
                DVec3::new(at.truncate().length() - radius, at.z.abs() - half, f64::MIN)
            }
        };
        beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
    }

    /// Radius of a ball around it.
    fn radius(self) -> f64 {
        match self {
            Self::Ball(radius) => radius,
            Self::Block(half) => half.length(),
            Self::Cylinder(radius, half) => radius.hypot(half),
        }
    }
}

/// The color at a place of a surface, given its normal: the part of light that it throws back, 0 to 1.
type Paint = fn(DVec3, DVec3) -> DVec3;

/// A thing of the still life.
#[derive(Debug)]
struct Thing {
    center: DVec3,
    /// World to the shape's axes.
    turn: DMat3,
    shape: Shape,
    paint: Paint,
    /// How much of the light is thrown back as by a mirror.
    gloss: f64,
}

impl Thing {
    fn distance(&self, at: DVec3) -> f64 {
        self.shape.distance(self.turn * (at - self.center))
    }

    /// Whether a ray of length 1 comes near.
    fn is_near(&self, origin: DVec3, direction: DVec3) -> bool {
        let toward = self.center - origin;
        let along = toward.dot(direction).max(0.0);
        (toward - along * direction).length() < self.shape.radius() + NEAR
    }
}

/// All things, on a floor at z = 0.
#[derive(Debug)]
struct Objects {
    things: Vec<Thing>,
    sun: DVec3,
}

impl Objects {
    fn new() -> Self {
        let thing = |center: [f64; 3], degrees: f64, shape, paint: Paint, gloss| Thing {
            center: DVec3::from(center),
            turn: DMat3::from_rotation_z(-degrees.to_radians()),
            shape,
            paint,
            gloss,
        };
        let block = |x, y, z| Shape::Block(DVec3::new(x, y, z));
        let green: Paint = |at, normal| book(at, normal, DVec3::new(0.10, 0.26, 0.16));
        let red: Paint = |at, normal| book(at, normal, DVec3::new(0.42, 0.07, 0.06));
        let things = vec![
            thing([-0.38, 0.22, 0.06], 20.0, block(0.36, 0.27, 0.06), green, 0.0),
            thing([-0.40, 0.20, 0.17], 33.0, block(0.31, 0.24, 0.05), red, 0.0),
            thing([-0.42, 0.22, 0.42], 0.0, Shape::Ball(0.20), stripes, 0.15),
            thing([0.34, 0.30, 0.21], 0.0, Shape::Cylinder(0.17, 0.21), glaze, 0.35),
            thing([0.52, -0.28, 0.13], -25.0, block(0.13, 0.13, 0.13), diamonds, 0.0),
            thing([0.06, -0.30, 0.12], 0.0, Shape::Ball(0.12), peel, 0.15),
            thing([-0.17, -0.42, 0.11], 0.0, Shape::Ball(0.11), peel, 0.15),
            thing([0.22, -0.55, 0.10], 0.0, Shape::Ball(0.10), peel, 0.15),
        ];
        Self { things, sun: DVec3::new(-0.55, -0.35, 0.85).normalize() }
    }

    /// The first thing that a ray of length 1 meets, and how far away. Each step is as long as the nearest surface is far (Hart, "Sphere
    /// tracing", 1996).
    fn march(&self, origin: DVec3, direction: DVec3) -> Option<(f64, &Thing)> {
        let near: Vec<_> =
            self.things.iter().filter(|thing| thing.is_near(origin, direction)).collect();
        let mut far = 0.0;
        while far < FAR {
            let at = origin + far * direction;
            let distances = near.iter().map(|thing| (thing.distance(at), *thing));
            let (step, thing) = distances.min_by(|a, b| a.0.total_cmp(&b.0))?;
            if step < NEAR {
                return Some((far, thing));
            }
            far += step;
        }
        None
    }

    /// The light that comes back along a ray, which starts above the floor.
    fn light(&self, origin: DVec3, direction: DVec3, random: &mut Pcg64) -> DVec3 {
        let (place, normal, color, gloss) = match self.march(origin, direction) {
            Some((far, thing)) => {
                let place = origin + far * direction;
                let at = thing.turn * (place - thing.center);
                let slope = |axis: DVec3| {
                    let ahead = thing.shape.distance(at + NEAR * axis);
                    ahead - thing.shape.distance(at - NEAR * axis)
                };
                let axes = [DVec3::X, DVec3::Y, DVec3::Z];
                let normal = DVec3::from(axes.map(slope)).normalize();
                let color = (thing.paint)(at, normal);
                (place, thing.turn.transpose() * normal, color, thing.gloss)
            }
            None if direction.z >= 0.0 => return SKY,
            None => {
                let place = origin - origin.z / direction.z * direction;
                let is_cloth = place.truncate().abs().max_element() < CLOTH;
                let color = if is_cloth { cloth(place) } else { boards(place) };
                (place, DVec3::Z, color, 0.0)
            }
        };
        let mut any = || 2.0 * random.random::<f64>() - 1.0;
        let sun = (self.sun + SUN_RADIUS * DVec3::new(any(), any(), any())).normalize();
        let facing = normal.dot(sun).max(0.0);
        let above = place + 10.0 * NEAR * normal;
        let open = 0.5 * (1.0 + normal.z) * self.openness(place, normal) + 0.15;
        let mut light = open * SKY * color;
        if facing > 0.0 && self.march(above, sun).is_none() {
            let between = (sun - direction).normalize();
            let shine = gloss * normal.dot(between).max(0.0).powf(SHINE);
            light += SUN * (facing * color + DVec3::splat(shine));
        }
        light
    }

    /// The part of the sky that a place sees: less where other surfaces are near along the normal (Evans, "Fast approximations for global
    /// illumination", 2006).
    fn openness(&self, place: DVec3, normal: DVec3) -> f64 {
        let hidden = |height: f64| {
            let at = place + height * normal;
            let nearest = self.things.iter().map(|thing| thing.distance(at)).fold(at.z, f64::min);
            1.0 - (nearest / height).clamp(0.0, 1.0)
        };
        1.0 - 0.25 * [0.04, 0.1, 0.2, 0.35].map(hidden).iter().sum::<f64>()
    }
}

fn boards(at: DVec3) -> DVec3 {
    let board = (at.x / 0.31).floor();
    let shift = at.y + 7.3 * noise(DVec3::new(board, 0.5, 0.5));
    let grain = clouds(DVec3::new(70.0 * at.x, 5.0 * shift, board));
    let tone = noise(DVec3::new(board, (shift / 2.2).floor(), 9.5));
    let joint = (at.x / 0.31 - board).min(0.5).min((shift / 2.2).rem_euclid(1.0) * 7.0);
    let dark = if joint < 0.02 { 0.35 } else { 1.0 };
    dark * (0.45 + 0.35 * tone + 0.5 * grain) * DVec3::new(0.42, 0.26, 0.14)
}

fn cloth(at: DVec3) -> DVec3 {
    let check = |x: f64| ((x / 0.16).rem_euclid(2.0) < 0.9) as u8;
    let color = match check(at.x) + check(at.y) {
        0 => DVec3::new(0.82, 0.78, 0.68),
        1 => DVec3::new(0.45, 0.52, 0.62),
        _ => DVec3::new(0.12, 0.20, 0.38),
    };
    let weave = (260.0 * at.x).sin() * (260.0 * at.y).sin();
    let thread = |x: f64| (x / 0.08).rem_euclid(4.0) < 0.12;
    let color = if thread(at.x) || thread(at.y) { DVec3::new(0.62, 0.12, 0.10) } else { color };
    (0.85 + 0.08 * weave + 0.3 * clouds(18.0 * at) - 0.15) * color
}

fn stripes(at: DVec3, _: DVec3) -> DVec3 {
    const PAINTS: [DVec3; 4] = [
        DVec3::new(0.70, 0.13, 0.10),
        DVec3::new(0.85, 0.78, 0.62),
        DVec3::new(0.08, 0.34, 0.32),
        DVec3::new(0.85, 0.55, 0.12),
    ];
    let wave = 0.02 * (6.0 * at.y.atan2(at.x)).sin();
    let stripe = ((at.z + wave) / 0.065).floor();
    let paint = PAINTS[stripe.rem_euclid(4.0) as usize];
    (0.8 + 0.4 * clouds(14.0 * at)) * paint
}

fn glaze(at: DVec3, normal: DVec3) -> DVec3 {
    let white = (0.9 + 0.12 * clouds(30.0 * at)) * DVec3::new(0.80, 0.80, 0.76);
    let blue = DVec3::new(0.05, 0.12, 0.38);
    let angle = 8.0 * at.y.atan2(at.x) / TAU;
    let zigzag = 0.07 * (2.0 * (angle.rem_euclid(1.0) - 0.5).abs());
    let is_painted = (at.z - zigzag).abs() < 0.018 || (at.z + 0.09).abs() < 0.012;
    if is_painted && normal.z.abs() < 0.5 { blue } else { white }
}

fn peel(at: DVec3, _: DVec3) -> DVec3 {
    let dimples = noise(110.0 * at);
    (0.75 + 0.25 * dimples + 0.2 * clouds(12.0 * at)) * DVec3::new(0.80, 0.36, 0.05)
}

fn diamonds(at: DVec3, normal: DVec3) -> DVec3 {
    let [u, v] = on_face(at, normal).to_array().map(|x| x / 0.11);
    let at_diamond = DVec2::new((u + v).floor(), (u - v).floor());
    let tone = hash([at_diamond.x as i64, at_diamond.y as i64, normal.x.round() as i64 + 2]);
    let color = DVec3::new(0.14, 0.34, 0.20).lerp(DVec3::new(0.88, 0.74, 0.36), tone);
    (0.8 + 0.35 * clouds(20.0 * at)) * color
}

fn book(at: DVec3, normal: DVec3, cover: DVec3) -> DVec3 {
    if normal.z.abs() < 0.5 {
        let page = 0.75 + 0.25 * noise(DVec3::new(3.0 * at.x, 3.0 * at.y, 420.0 * at.z));
        return page * DVec3::new(0.78, 0.72, 0.58);
    }
    // Lines of print, which end where words do.
    let word = noise(DVec3::new(24.0 * at.x, (at.y / 0.036).floor(), 1.5));
    let is_print = (at.y / 0.036).rem_euclid(1.0) < 0.45 && at.y.abs() < 0.2 && word > 0.45;
    let worn = 0.75 + 0.5 * clouds(9.0 * at);
    if is_print { worn * DVec3::new(0.85, 0.76, 0.48) } else { worn * cover }
}

/// A place of a block's face, in the two axes of the face.
fn on_face(at: DVec3, normal: DVec3) -> DVec2 {
    let along = normal.abs();
    match along.max_element() {
        most if most == along.x => DVec2::new(at.y, at.z),
        most if most == along.y => DVec2::new(at.x, at.z),
        _ => DVec2::new(at.x, at.y),
    }
}

/// Noise of four octaves, 0 to 1.
fn clouds(at: DVec3) -> f64 {
    let octave = |octave: i32| {
        let scale = f64::from(1 << octave);
        noise(scale * at) / scale
    };
    (0..4).map(octave).sum::<f64>() / 1.875
}

/// Noise between the points of a lattice, 0 to 1 (Perlin's value noise).
fn noise(at: DVec3) -> f64 {
    let corner = at.floor();
    let part = at - corner;
    let part = part * part * (3.0 - 2.0 * part);
    let [x, y, z] = corner.to_array().map(|x| x as i64);
    let value = |bits: i64| hash([x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2)]);
    let mix = |a: f64, b: f64, part: f64| a + part * (b - a);
    let along_x = |bits: i64| mix(value(bits), value(bits + 1), part.x);
    let along_y = |bits: i64| mix(along_x(bits), along_x(bits + 2), part.y);
    mix(along_y(0), along_y(4), part.z)
}

/// A number from 0 to 1 for a point of a lattice.
fn hash([x, y, z]: [i64; 3]) -> f64 {
    let mut bits = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    bits = (bits ^ (z as u32).wrapping_mul(0xc2b2_ae3d)).wrapping_mul(0x27d4_eb2f);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    f64::from(bits ^ (bits >> 12)) / f64::from(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Variance of the differences of neighbors in a row: sharp images have large ones.
    fn sharpness(image: &Image) -> f64 {
        let pairs = image.pixels().windows(2);
        let count = pairs.len() as f64;
        pairs.map(|pair| (f64::from(pair[0][1]) - f64::from(pair[1][1])).powi(2)).sum::<f64>()
            / count
    }

    #[test]
    fn shaken_photographs_are_blurred() {
        let walk = StillLife::new(36, [160, 120]).unwrap();
        let of = |is_shaken: bool| {
            let taken: Vec<_> = (0..36)
                .filter(|&index| StillLife::is_shaken(index) == is_shaken)
                .take(4)
                .map(|index| sharpness(&walk.photograph(index).unwrap()))
                .collect();
            taken.iter().sum::<f64>() / taken.len() as f64
        };
        let [steady, shaken] = [of(false), of(true)];
        assert!(shaken < 0.8 * steady, "{shaken} {steady}");
    }

    #[test]
    fn a_photograph_is_taken_again_to_the_bit() {
        let walk = StillLife::new(5, [64, 48]).unwrap();
        assert_eq!(walk.photograph(2).unwrap(), walk.photograph(2).unwrap());
        assert_ne!(walk.photograph(2).unwrap(), walk.photograph(3).unwrap());
    }

    #[test]
    fn noise_has_its_variance() {
        let mut random = random(1, 2, 3);
        let count = 100_000;
        for light in [0.0, 0.5] {
            let off: Vec<_> = (0..count).map(|_| noisy(light, &mut random) - light).collect();
            let mean = off.iter().sum::<f64>() / f64::from(count);
            let variance = off.iter().map(|off| off * off).sum::<f64>() / f64::from(count);
            let expected = DARK_NOISE + SHOT_NOISE * light;
            assert!(mean.abs() < 5.0 * (expected / f64::from(count)).sqrt(), "{mean}");
            assert!((variance / expected - 1.0).abs() < 0.03, "{variance} {expected}");
        }
    }

    #[test]
    fn rays_go_through_the_places_that_the_camera_projects_to() {
        let walk = StillLife::new(7, [64, 48]).unwrap();
        for camera in walk.cameras() {
            let place = DVec3::new(0.2, -0.1, 0.3);
            let [x, y, _] = camera.project(place.to_array()).unwrap();
            let ray = direction(camera, DVec2::new(x, y));
            let expected = (place - DVec3::from(camera.eye())).normalize();
            assert!(ray.distance(expected) < 1e-12, "{ray} {expected}");
        }
    }

    /// Rays meet a ball and a block where the roots and the slabs of textbooks say.
    #[test]
    fn a_march_ends_where_a_ray_meets_a_solid() {
        let mut random = random(5, 0, 0);
        let mut any = || 2.0 * random.random::<f64>() - 1.0;
        let half = DVec3::new(0.3, 0.5, 0.2);
        let mut met = 0;
        for shape in [Shape::Ball(0.45), Shape::Block(half)] {
            let turn = DMat3::IDENTITY;
            let thing = Thing { center: DVec3::ZERO, turn, shape, paint: peel, gloss: 0.0 };
            let objects = Objects { things: vec![thing], sun: DVec3::Z };
            for _ in 0..300 {
                let origin = 2.0 * DVec3::new(any(), any(), any()).normalize();
                let direction = (0.6 * DVec3::new(any(), any(), any()) - origin).normalize();
                let expected = match shape {
                    Shape::Ball(radius) => {
                        let b = origin.dot(direction);
                        let root = (b * b - origin.length_squared() + radius * radius).sqrt();
                        root.is_finite().then_some(-b - root)
                    }
                    _ => {
                        let [low, high] = [-half, half].map(|side| (side - origin) / direction);
                        let enters = low.min(high).max_element();
                        (enters <= low.max(high).min_element()).then_some(enters)
                    }
                };
                match (objects.march(origin, direction), expected) {
                    (Some((far, _)), Some(expected)) => {
                        met += 1;
                        // a ray that grazes a surface is near before it meets it
                        assert!((0.0..0.05).contains(&(expected - far)), "{far} {expected}");
                    }
                    (None, Some(expected)) => panic!("{shape:?} is missed at {expected}"),
                    // it passes within `NEAR`
                    (Some((far, thing)), None) => {
                        assert!(thing.distance(origin + far * direction) < NEAR);
                    }
                    (None, None) => {}
                }
            }
        }
        assert!(met > 200, "{met}");
    }
}
