//! Photographs of a still life on a table: a capture for everyone who has no camera at hand.
//!
//! A sphere tracer (Hart, "Sphere tracing", 1996) renders solids with signed distances (Quilez, "Distance functions",
//! <https://iquilezles.org/articles/distfunctions>). No part of it is a Gaussian or a field, so a scene that is trained on
//! these photographs has learned something. They have the flaws of photographs that are taken by hand: exposures differ,
//! sensors have noise, all are a little blurred, some are shaken, and none shows the table from behind. They are in the
//! public domain (CC0 1.0).
//!
//! ```
//! use organza_data::still_life;
//!
//! let cameras = still_life::cameras(40, [64, 48])?;
//! assert_eq!(still_life::photograph(&cameras[3], 3)?.size(), [64, 48]);
//! # Ok::<(), organza_core::Error>(())
//! ```

#[cfg(test)]
mod tests;

use std::f64::consts::TAU;

use glam::{DAffine3, DVec2, DVec3, UVec3};
use rand::RngExt;
use rand_distr::StandardNormal;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use crate::random;
use organza_core::{Camera, Image, Result};

/// Purpose of the random numbers of a photograph.
const PHOTOGRAPH: u64 = 0x7374_696c;
/// Rays of a pixel, each at another moment of the exposure.
const RAYS: usize = 8;
/// Motion of the image during an exposure, in image widths: with a steady and with a shaking hand.
const MOTION: [f64; 2] = [1.0 / 640.0, 12.0 / 640.0];
/// Standard deviation of the lens's blur, in pixels.
const LENS_BLUR: f64 = 0.45;
/// Variance of the sensor's noise: in the dark, and for each unit of light.
const NOISE: [f64; 2] = [1e-5, 2e-4];
/// Horizontal field of view, in radians.
const ANGLE: f64 = 1.0;
/// Light of the sun and of the sky on a surface that faces it.
const SUN: DVec3 = DVec3::new(0.95, 0.88, 0.76);
const SKY: DVec3 = DVec3::new(0.34, 0.38, 0.44);
/// Direction to the sun, and the sun's radius as a tangent: shadows are soft.
const TO_SUN: DVec3 = DVec3::new(-0.5135, -0.3268, 0.7937);
const SUN_RADIUS: f64 = 0.04;
/// A ray that is this near to a surface has met it, and no ray is longer than the second length.
const NEAR: f64 = 1e-4;
const FAR: f64 = 20.0;

/// The cameras of a walk of `count` photographs of `size` pixels: an arc of 220 degrees around the table, up and down, at arm's
/// length.
///
/// # Errors
/// [`Error::Invalid`](organza_core::Error::Invalid) if the size is out of range.
pub fn cameras(count: usize, size: [u32; 2]) -> Result<Vec<Camera>> {
    let camera = |index: usize| {
        let time = index as f64 / count.max(2) as f64;
        let azimuth = (220.0 * (time - 0.5)).to_radians();
        let elevation = 0.55 + 0.17 * (2.6 * TAU * time).sin();
        let distance = 2.7 + 0.25 * (1.7 * TAU * time).cos();
        let flat = distance * elevation.cos();
        let eye = [flat * azimuth.sin(), -flat * azimuth.cos(), distance * elevation.sin()];
        // A hand does not aim exactly.
        let aim = |speed: f64| 0.06 * (speed * index as f64).sin();
        Camera::look_at(eye, [aim(1.3), aim(2.1), 0.22 + aim(1.7)], [0.0, 0.0, 1.0], ANGLE, size)
    };
    (0..count).map(camera).collect()
}

/// Whether the hand shakes at the photograph of this index: at one in nine.
pub fn is_shaken(index: usize) -> bool {
    index % 9 == 7
}

/// Takes the photograph of this index. Two calls give the same one.
///
/// # Errors
/// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
pub fn photograph(camera: &Camera, index: usize) -> Result<Image> {
    let [width, height] = [camera.width, camera.height];
    Image::check_memory(width, height)?;
    let solids = &solids();
    let gain = 1.0 + 0.12 * (0.37 * index as f64).sin();
    let length = MOTION[usize::from(is_shaken(index))] * f64::from(width);
    let motion = length * DVec2::from_angle(2.4 * index as f64);
    let rows = (0..height).into_par_iter().flat_map_iter(|row| {
        let mut random = random(index as u64, PHOTOGRAPH, u64::from(row));
        (0..width).map(move |column| {
            let center = DVec2::new(f64::from(column), f64::from(row)) + 0.5;
            let mut sum = DVec3::ZERO;
            for ray in 0..RAYS {
                let time = (ray as f64 + random.random::<f64>()) / RAYS as f64 - 0.5;
                let blur = DVec2::from([(); 2].map(|()| random.sample(StandardNormal)));
                let at = center + LENS_BLUR * blur + time * motion;
                let direction = camera.ray(at.into()).normalize();
                sum += light(solids, camera.eye().into(), direction, &mut random);
            }
            let light = gain / RAYS as f64 * sum;
            light.to_array().map(|light| encoded(noisy(light, &mut random)))
        })
    });
    Ok(Image::from_pixels([width, height], &rows.collect::<Vec<_>>()))
}

/// Light with the sensor's noise.
fn noisy(light: f64, random: &mut Pcg64) -> f64 {
    light + (NOISE[0] + NOISE[1] * light).sqrt() * random.sample::<f64, _>(StandardNormal)
}

/// A value of sRGB (IEC 61966-2-1), 0 to 255.
fn encoded(light: f64) -> u8 {
    let light = light.clamp(0.0, 1.0);
    let curve = 1.055 * light.powf(1.0 / 2.4) - 0.055;
    (255.0 * if light <= 0.003_130_8 { 12.92 * light } else { curve }).round() as u8
}

/// A solid of the still life. Shape and pattern are in its own axes, around its center.
#[derive(Debug)]
struct Solid {
    /// From the world to its own axes.
    pose: DAffine3,
    /// Half its size along its axes.
    half: DVec3,
    /// The signed distance of a place, given `half`; negative inside.
    shape: fn(DVec3, DVec3) -> f64,
    /// The index of the color at a place with a normal.
    pattern: fn(DVec3, DVec3) -> usize,
    /// Colors, 0xRRGGBB in linear light.
    colors: [u32; 4],
    /// Frequency of the spots in them, along its axes.
    grain: DVec3,
    /// Strength of highlights.
    gloss: f64,
}

impl Solid {
    fn distance(&self, place: DVec3) -> f64 {
        (self.shape)(self.pose.transform_point3(place), self.half)
    }
}

const GREEN: [u32; 4] = [0x1a_4229, 0xd9_c27a, 0xc7_b894, 0xa3_9679];
const RED: [u32; 4] = [0x6b_120f, 0xd9_c27a, 0xc7_b894, 0xa3_9679];
const BALL: [u32; 4] = [0xb3_211a, 0xd9_c79e, 0x14_5752, 0xd9_8c1f];
const CUP: [u32; 4] = [0xcc_ccc2, 0x0d_1f61, 0, 0];
const BOX: [u32; 4] = [0x24_5733, 0x56_743f, 0x9a_9350, 0xe0_bd5c];
const PEEL: [u32; 4] = [0xcc_5c0d, 0, 0, 0];
const CLOTH: [u32; 4] = [0xd1_c7ad, 0x73_859e, 0x1f_3361, 0x9e_1f1a];
const WOOD: [u32; 4] = [0x4b_2e19, 0x5d_3a1f, 0x70_4625, 0x22_150c];

/// Two books, a ball, a cup, a box, three oranges, a cloth and a floor.
fn solids() -> Vec<Solid> {
    let solid = |center, degrees, half, shape, pattern, colors, grain, gloss| Solid {
        pose: DAffine3::from_rotation_z(-f64::to_radians(degrees))
            * DAffine3::from_translation(-DVec3::from_array(center)),
        half: DVec3::from_array(half),
        shape,
        pattern,
        colors,
        grain: DVec3::from_array(grain),
        gloss,
    };
    vec![
        solid([-0.38, 0.22, 0.06], 20.0, [0.36, 0.27, 0.06], block, print, GREEN, [9.0; 3], 0.0),
        solid([-0.40, 0.20, 0.17], 33.0, [0.31, 0.24, 0.05], block, print, RED, [9.0; 3], 0.0),
        solid([-0.42, 0.22, 0.42], 0.0, [0.20; 3], ball, stripes, BALL, [14.0; 3], 0.15),
        solid([0.34, 0.30, 0.21], 0.0, [0.17, 0.17, 0.21], cylinder, zigzag, CUP, [60.0; 3], 0.35),
        solid([0.52, -0.28, 0.13], -25.0, [0.13; 3], block, mosaic, BOX, [20.0; 3], 0.0),
        solid([0.06, -0.30, 0.12], 0.0, [0.12; 3], ball, |_, _| 0, PEEL, [55.0; 3], 0.15),
        solid([-0.17, -0.42, 0.11], 0.0, [0.11; 3], ball, |_, _| 0, PEEL, [55.0; 3], 0.15),
        solid([0.22, -0.55, 0.10], 0.0, [0.10; 3], ball, |_, _| 0, PEEL, [55.0; 3], 0.15),
        solid([0.0, 0.0, -0.002], 0.0, [1.05, 1.05, 0.002], block, checks, CLOTH, [18.0; 3], 0.0),
        solid([0.0, 0.0, -1.004], 0.0, [FAR, FAR, 1.0], block, boards, WOOD, [70.0, 5.0, 1.0], 0.0),
    ]
}

fn ball(at: DVec3, half: DVec3) -> f64 {
    at.length() - half.x
}

fn block(at: DVec3, half: DVec3) -> f64 {
    let beyond = at.abs() - half;
    beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
}

fn cylinder(at: DVec3, half: DVec3) -> f64 {
    block(DVec3::new(at.truncate().length(), 0.0, at.z), half)
}

/// The first solid that a ray meets, and how far away. Each step is as long as the nearest surface is far.
fn march(solids: &[Solid], origin: DVec3, direction: DVec3) -> Option<(f64, &Solid)> {
    // whether it meets the solid's box
    let is_near = |solid: &&Solid| {
        let at = solid.pose.transform_point3(origin);
        let along = solid.pose.transform_vector3(direction);
        let sides = [-1.0, 1.0].map(|side| (side * (solid.half + NEAR) - at) / along);
        let end = sides[0].max(sides[1]).min_element();
        (0.0..=end).contains(&sides[0].min(sides[1]).max_element().max(0.0))
    };
    let near: Vec<_> = solids.iter().filter(is_near).collect();
    let mut far = 0.0;
    while far < FAR {
        let distance = |solid: &Solid| solid.distance(origin + far * direction);
        let distances = near.iter().map(|solid| (distance(solid), *solid));
        let (step, solid) = distances.min_by(|a, b| a.0.total_cmp(&b.0))?;
        if step < NEAR {
            return Some((far, solid));
        }
        far += step;
    }
    None
}

/// The light along a ray: of the sky, of the sun with a shadow, and a highlight (Blinn and Phong).
fn light(solids: &[Solid], origin: DVec3, direction: DVec3, random: &mut Pcg64) -> DVec3 {
    let Some((far, solid)) = march(solids, origin, direction) else { return SKY };
    let place = origin + far * direction;
    let slope = |step: DVec3| solid.distance(place + step) - solid.distance(place - step);
    let normal = DVec3::from(DVec3::AXES.map(|axis| slope(NEAR * axis))).normalize();
    let own = solid.pose.transform_point3(place);
    let index = (solid.pattern)(own, solid.pose.transform_vector3(normal));
    let [_, rgb @ ..] = solid.colors[index].to_be_bytes();
    let color = (0.75 + 0.5 * clouds(solid.grain * own)) / 255.0 * DVec3::from(rgb.map(f64::from));
    let mut offset = || SUN_RADIUS * (2.0 * random.random::<f64>() - 1.0);
    let to_sun = (TO_SUN + DVec3::new(offset(), offset(), offset())).normalize();
    let facing = normal.dot(to_sun);
    let ambient = 0.5 * (1.0 + normal.z) * openness(solids, place, normal) + 0.15;
    let mut light = ambient * SKY * color;
    if facing > 0.0 && march(solids, place + 10.0 * NEAR * normal, to_sun).is_none() {
        let halfway = (to_sun - direction).normalize();
        light += SUN * (facing * color + solid.gloss * normal.dot(halfway).max(0.0).powf(60.0));
    }
    light
}

/// The part of the sky that a place sees: less if surfaces are near along its normal (Evans 2006).
fn openness(solids: &[Solid], place: DVec3, normal: DVec3) -> f64 {
    let open = |height: f64| {
        let distances = solids.iter().map(|solid| solid.distance(place + height * normal));
        distances.fold(height, f64::min).max(0.0) / height
    };
    [0.04, 0.1, 0.2, 0.35].map(open).iter().sum::<f64>() / 4.0
}

/// Lines of words on a cover; at the sides, pages.
fn print(at: DVec3, normal: DVec3) -> usize {
    if normal.z.abs() < 0.5 {
        return 2 + ((at.z / 0.004).floor() as i64 & 1) as usize;
    }
    let [word, line] = [at.x / 0.03, at.y / 0.036];
    let is_word = hash(DVec3::new(word.floor(), line.floor(), 0.0)) > 0.3;
    usize::from(is_word && line.rem_euclid(1.0) < 0.45 && at.y.abs() < 0.2)
}

fn stripes(at: DVec3, _: DVec3) -> usize {
    let wave = 0.02 * (6.0 * at.y.atan2(at.x)).sin();
    (((at.z + wave) / 0.065).floor() as i64 & 3) as usize
}

fn zigzag(at: DVec3, normal: DVec3) -> usize {
    let angle = 8.0 * at.y.atan2(at.x) / TAU;
    let height = 0.14 * (angle.rem_euclid(1.0) - 0.5).abs();
    let is_line = (at.z - height).abs() < 0.018 || (at.z + 0.09).abs() < 0.012;
    usize::from(is_line && normal.z.abs() < 0.5)
}

/// A color for each cell between three sets of planes.
fn mosaic(at: DVec3, _: DVec3) -> usize {
    let planes = DVec3::new(at.x + at.y + at.z, at.x - at.y + at.z, at.x + at.y - at.z) / 0.11;
    (4.0 * hash(planes.floor())) as usize
}

fn checks(at: DVec3, _: DVec3) -> usize {
    let is_dark = |x: f64| (x / 0.16).rem_euclid(2.0) < 0.9;
    let is_thread = |x: f64| (x / 0.08).rem_euclid(4.0) < 0.12;
    if is_thread(at.x) || is_thread(at.y) {
        return 3;
    }
    usize::from(is_dark(at.x)) + usize::from(is_dark(at.y))
}

/// Boards of three tones, with dark joints.
fn boards(at: DVec3, _: DVec3) -> usize {
    let board = (at.x / 0.31).floor();
    let along = at.y / 2.2 + hash(DVec3::new(board, 0.0, 0.0));
    let is_joint = at.x / 0.31 - board < 0.02 || along.rem_euclid(1.0) < 0.003;
    if is_joint { 3 } else { (3.0 * hash(DVec3::new(board, along.floor(), 1.0))) as usize }
}

/// Value noise of four octaves, 0 to 1: smooth between random values at the points of a lattice.
fn clouds(at: DVec3) -> f64 {
    let octave = |scale: f64| {
        let lowest = (scale * at).floor();
        let part = scale * at - lowest;
        let part = part * part * (3.0 - 2.0 * part);
        let corner = |bits: u32| {
            let step = UVec3::new(bits & 1, bits >> 1 & 1, bits >> 2).as_dvec3();
            let weight = step * part + (1.0 - step) * (1.0 - part);
            weight.element_product() * hash(lowest + step)
        };
        (0..8).map(corner).sum::<f64>() / scale
    };
    [1.0, 2.0, 4.0, 8.0].map(octave).iter().sum::<f64>() / 1.875
}

/// A random number, 0 to 1, for a point of a lattice.
fn hash(point: DVec3) -> f64 {
    let [x, y, z] = point.as_ivec3().as_uvec3().to_array();
    let bits =
        x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77) ^ z.wrapping_mul(0xc2b2_ae3d);
    let bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    f64::from((bits ^ (bits >> 13)).wrapping_mul(0x27d4_eb2f) >> 8) / f64::from(1 << 24)
}
