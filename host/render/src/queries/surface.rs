//! The surface that a view shows: the depth of each pixel.

use std::slice::from_ref;

use glam::{DMat3, DQuat, DVec3, Vec4};
use organza_shaders::composite::{alpha, splat_distance};
use organza_shaders::project::in_support;
use rayon::prelude::*;

use super::pixel_gaussians::PartSplats;
use crate::pass::part::Part;
use crate::stages::cut::PartTiles;
use crate::{DeviceScene, Renderer};
use muslin_device::memory;
use organza_core::image::{bands, to_8_bit};
use organza_core::{Camera, Result, Tile};

/// Side of the tiles: small ones have short lists of Gaussians.
const SIDE: u32 = 16;

/// What a camera sees, pixel by pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// The camera.
    pub camera: Camera,
    /// `[H, W]`: depth along the camera's axis, in units of the scene. It is 0 where the pixel shows the background, with a
    /// weight S below a half.
    pub depth: Vec<f32>,
    /// `[H, W]`
    pub color: Vec<[u8; 3]>,
}

/// The length of T's steps in multiples of sigma. T is most of the work. In trained scenes, meshes are then as near to true points.
const RAY_STEPS: u32 = 4;
/// Smallest S of a surface.
const SOLID: f64 = 0.5;

/// What a camera sees of one of several scenes.
struct Seen {
    /// In the scene's coordinates.
    camera: Camera,
    /// The unit of these coordinates.
    unit: f32,
    densities: Vec<Density>,
}

/// A Gaussian's density along the rays from an eye.
struct Density {
    /// Takes directions to a space in which the Gaussian is a ball.
    to_ball: DMat3,
    /// The Gaussian's center there, seen from the eye.
    center: DVec3,
}

/// A Gaussian in a pixel: the place on the ray where it is densest, and its weight, alpha of Eq. 12.
type Reaching = [f32; 2];

/// The median of the places, weighted: half of the weight is nearer. `None` if the sum of the weights is too small for a surface.
fn median(mut left: &mut [Reaching]) -> Option<f32> {
    let sum = |some: &[Reaching]| some.iter().map(|[_, weight]| f64::from(*weight)).sum::<f64>();
    let all = sum(left);
    if all.is_nan() || all < SOLID {
        return None;
    }
    let mut half = 0.5 * all;
    loop {
        let middle = left.len() / 2;
        let order = |a: &Reaching, b: &Reaching| a[0].total_cmp(&b[0]);
        let (nearer, [depth, weight], farther) = left.select_nth_unstable_by(middle, order);
        let before = sum(nearer);
        let with = before + f64::from(*weight);
        // sums may round, so an end of the rest is the median at last
        if before >= half && !nearer.is_empty() {
            left = nearer;
        } else if with < half && !farther.is_empty() {
            half -= with;
            left = farther;
        } else {
            return Some(*depth);
        }
    }
}

impl Renderer {
    /// Finds the surface that a camera sees. At each pixel, a Gaussian lies where it is densest on the pixel's ray; the surface is
    /// the median of these places, weighted as in Eq. 12.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn surface(&self, scene: &DeviceScene, camera: &Camera) -> Result<Surface> {
        let pixels = camera.width as usize * camera.height as usize;
        let mut found = Surface {
            camera: camera.clone(),
            depth: memory::zeros(pixels, "the depth of a view")?,
            color: memory::zeros(pixels, "the color of a view")?,
        };
        let scene = &scene.with_ray_steps(RAY_STEPS);
        let seen = |scene: &DeviceScene| {
            let own = scene.place().own_camera(camera);
            let densities = self.densities(scene, &own)?;
            Ok(Seen { camera: own, unit: scene.place().scale as f32, densities })
        };
        let seen = scene.all().map(seen).collect::<Result<Vec<_>>>()?;
        let pass = self.pass(scene, from_ref(camera));
        for batch in bands(0, [camera.width, camera.height], SIDE) {
            pass.each_part(&batch?, |part_tiles| {
                let part = Part::evaluate(scene, from_ref(camera), part_tiles, false, None)?;
                let splats = PartSplats::read_all(self.device(), &part)?;
                let image = self.device().read(&part.composite.image)?;
                found.fill(part_tiles, &splats, &image, &seen);
                Ok(())
            })?;
        }
        Ok(found)
    }

    /// The density of each Gaussian along the rays from a camera.
    fn densities(&self, scene: &DeviceScene, camera: &Camera) -> Result<Vec<Density>> {
        let device = self.device();
        let gaussians = &scene.tensors.gaussians;
        let position = device.read(&gaussians.position)?;
        let rotation = device.read(&gaussians.rotation)?;
        let log_scale = device.read(&gaussians.log_scale)?;
        let eye = DVec3::from(camera.eye());
        let places = position.as_chunks::<3>().0.par_iter();
        let shapes = rotation.as_chunks::<4>().0.par_iter().zip(log_scale.as_chunks::<3>().0);
        let density = |(place, (turn, log)): (&[f32; 3], (&[f32; 4], &[f32; 3]))| {
            let [w, x, y, z] = turn.map(f64::from);
            let turn = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
            let inverse = DVec3::from(log.map(|log| (-f64::from(log)).exp()));
            // a larger or smaller ball has the same center; squares must be finite in f32
            let inverse = inverse / inverse.max_element();
            let to_ball = DMat3::from_diagonal(inverse) * turn.transpose();
            Density { to_ball, center: to_ball * (DVec3::from(place.map(f64::from)) - eye) }
        };
        Ok(places.zip(shapes).map(density).collect())
    }
}

impl Surface {
    /// The places of all pixels that show a surface, in the scene.
    pub fn places(&self) -> impl Iterator<Item = DVec3> {
        let width = self.camera.width as usize;
        let eye = DVec3::from(self.camera.eye());
        let pixels = self.depth.iter().enumerate().filter(|(_, depth)| **depth > 0.0);
        pixels.map(move |(at, &depth)| {
            let ray = self.camera.ray([at % width, at / width].map(|at| at as f64 + 0.5));
            eye + f64::from(depth) * ray
        })
    }

    /// Fills in the pixels of a part's tiles.
    fn fill(
        &mut self,
        part_tiles: &PartTiles,
        splats: &[PartSplats],
        image: &[f32],
        seen: &[Seen],
    ) {
        let [width, height] = [self.camera.width, self.camera.height].map(|side| side as i32);
        let side = SIDE as i32;
        let in_tile = |(index, tile): (usize, Tile)| {
            let [left, top] = tile.origin;
            let mut reached = vec![Vec::new(); (SIDE * SIDE) as usize];
            for (splats, seen) in splats.iter().zip(seen) {
                reach(seen, tile, splats.in_tile(index), &mut reached);
            }
            let pixels = (0..).zip(reached);
            let pixels =
                pixels.map(move |(at, all)| (at, [left + at % side, top + at / side], all));
            let inside = pixels.filter(move |(_, [x, y], _)| *x < width && *y < height);
            inside.map(move |(at, [x, y], mut all)| {
                let channel = |channel: i32| {
                    image[((3 * index as i32 + channel) * side * side + at) as usize]
                };
                let color = [0, 1, 2].map(|at| to_8_bit(channel(at)));
                (
                    (y * width + x) as usize,
                    median(&mut all).map_or(0.0, |depth| depth.max(0.0)),
                    color,
                )
            })
        };
        let tiles = part_tiles.tiles.par_iter().map(|tile| tile.tile).enumerate();
        for (place, depth, color) in tiles.flat_map_iter(in_tile).collect::<Vec<_>>() {
            self.depth[place] = depth;
            self.color[place] = color;
        }
    }
}

/// Adds the Gaussians of a scene that reach each pixel of a tile, row by row.
///
/// A place is where the density `exp(-|B (t d - center)|^2 / 2)` is largest on the ray `t d` from the eye: `t = (B d . B center) / |B d|^2`.
/// Rays change evenly from pixel to pixel, and so does B d. A row is computed at once, by vector instructions.
fn reach(
    Seen { camera, unit, densities }: &Seen,
    tile: Tile,
    gaussians: impl Iterator<Item = (usize, [Vec4; 3])>,
    pixels: &mut [Vec<Reaching>],
) {
    const ROW: usize = SIDE as usize;
    let [left, top] = tile.origin.map(|at| at as f32 + 0.5);
    let ray = |x: f32, y: f32| camera.ray([left + x, top + y].map(f64::from));
    let corner = ray(0.0, 0.0);
    let steps = [ray(1.0, 0.0) - corner, ray(0.0, 1.0) - corner];
    let ramp: [f32; ROW] = std::array::from_fn(|x| x as f32);
    for (gaussian, [placed, conic, color]) in gaussians {
        let Density { to_ball, center } = &densities[gaussian];
        let [first, across, down] = [corner, steps[0], steps[1]].map(|ray| *to_ball * ray);
        let center = center.as_vec3();
        let across = across.as_vec3();
        for (row, pixels) in pixels.chunks_exact_mut(ROW).enumerate() {
            let y = top + row as f32;
            let q = ramp.map(|x| splat_distance(placed, conic, left + x, y));
            if !q.iter().any(|q| in_support(*q)) {
                continue;
            }
            let begin = (first + row as f64 * down).as_vec3();
            let depth = ramp.map(|x| {
                let direction = begin + x * across;
                unit * direction.dot(center) / direction.length_squared()
            });
            for ((pixel, q), depth) in pixels.iter_mut().zip(q).zip(depth) {
                if in_support(q) {
                    pixel.push([depth, alpha(placed, color, true, q)]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::LN_2;

    use muslin_check::devices;

    use super::*;
    use organza_core::scene::{Placement, Scene};

    /// By sorting, as it is defined.
    #[test]
    fn the_median_has_half_of_the_weight_before_it() {
        let value = |at: usize, of: usize| ((at * of + at * at) % 97) as f32 / 97.0;
        for count in 1..60 {
            let mut all: Vec<Reaching> =
                (0..count).map(|at| [value(at, 31) - 0.3, value(at, 57) + 0.01]).collect();
            let sum: f32 = all.iter().map(|[_, weight]| weight).sum();
            let found = median(&mut all);
            all.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let mut before = 0.0;
            let half = all.iter().find(|[_, weight]| {
                before += weight;
                before >= 0.5 * sum
            });
            let expected = half.filter(|_| f64::from(sum) >= SOLID).map(|[depth, _]| *depth);
            assert_eq!(found, expected, "{count}");
        }
    }

    /// Flat Gaussians on a plane, whose depth at each pixel is known.
    #[test]
    fn a_plane_of_flat_gaussians_has_the_depth_of_the_plane() {
        let places = |at: i32| f64::from(at) * 0.1;
        let tilt = DQuat::from_rotation_x(0.7);
        let mut scene = Scene::zeros(organza_core::demo::config(), 41 * 41).unwrap();
        scene.transmittance.network.layers.last_mut().unwrap().bias[0] = 50.0;
        let all = (-20..=20).flat_map(|y| (-20..=20).map(move |x| [places(x), places(y), 0.0]));
        let gaussians = &mut scene.gaussians;
        gaussians.position =
            all.map(|place| (tilt * DVec3::from(place)).as_vec3().to_array()).collect();
        let [x, y, z, w] = tilt.to_array().map(|part| part as f32);
        gaussians.rotation.fill([w, x, y, z]);
        gaussians.log_scale.fill([0.08_f32.ln(), 0.08_f32.ln(), -9.0]);
        gaussians.opacity.fill(2.0);
        let up = [0.0, 1.0, 0.0];
        let camera = Camera::look_at([0.0, 0.0, 4.0], [0.0; 3], up, 0.4, [40, 30]).unwrap();
        let renderer = Renderer::new(devices::cpu(Some(1)));
        // every second row as a scene of its own, of half the size
        let part = |rows: std::ops::Range<usize>| Scene {
            gaussians: scene.gaussians.select(&rows.step_by(2).collect::<Vec<_>>()),
            ..scene.clone()
        };
        let mut other = part(1..41 * 41);
        other.gaussians.position.as_flattened_mut().iter_mut().for_each(|x| *x *= 0.5);
        other.gaussians.log_scale.as_flattened_mut().iter_mut().for_each(|x| *x -= LN_2);
        let mut both = renderer.upload(&part(0..41 * 41)).unwrap();
        let place = Placement { scale: 2.0, ..Placement::default() };
        both.put(renderer.upload(&other).unwrap(), place).unwrap();
        let scene = renderer.upload(&scene).unwrap();
        let found = renderer.surface(&scene, &camera).unwrap();
        let together = renderer.surface(&both, &camera).unwrap().depth;
        let pairs = together.iter().zip(&found.depth);
        assert!(pairs.into_iter().all(|(both, one)| (both - one).abs() < 1e-3));
        let normal = tilt * DVec3::Z;
        for (at, &depth) in found.depth.iter().enumerate() {
            let ray = camera.ray([at % 40, at / 40].map(|at| at as f64 + 0.5));
            let expected = -4.0 * normal.z / normal.dot(ray);
            assert!((f64::from(depth) - expected).abs() < 1e-3, "{at}: {depth} {expected}");
        }
        // away from the plane, there is nothing
        let away = Camera::look_at([0.0, 0.0, 4.0], [0.0, 0.0, 9.0], up, 0.4, [8, 8]).unwrap();
        let found = renderer.surface(&scene, &away).unwrap();
        assert!(found.depth.iter().all(|&depth| depth == 0.0));
    }
}
