//! Photographs of a still life on a table, which a ray tracer takes: a capture for everyone who has no camera at hand.
//!
//! Its surfaces are solid, and hide and shade each other exactly. Nothing of it comes from Gaussians or from fields, so a
//! scene that is trained on these photographs has learned something. They have the flaws of photographs that are taken by
//! hand: exposures differ, sensors have noise, each is a little blurred and some are shaken, and the camera has seen the
//! table from one side only. The photographs are in the public domain (CC0 1.0).
//!
//! ```
//! use organza_core::still_life::StillLife;
//!
//! let walk = StillLife::new(40, [64, 48])?;
//! assert_eq!(walk.photograph(3)?.size(), [64, 48]);
//! assert_eq!(walk.cameras().len(), 40);
//! # Ok::<(), organza_core::Error>(())
//! ```

mod objects;

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use rand::RngExt;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use crate::{Camera, Image, Result, random};
use objects::Objects;

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
    /// [`Error::Camera`](crate::Error::Camera) if the size is out of range.
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
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
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
}
