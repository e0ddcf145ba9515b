//! The results of single stages: each stage for every Gaussian, or all stages for one pixel.

use glam::{Vec2, Vec3, Vec4};
use organza_shaders::composite::{alpha, splat_distance};
use organza_shaders::project::{EVERYWHERE, in_support};
use organza_shaders::shape::shaped_falloff;
use organza_shaders::splat::VECTORS;
use organza_shaders::tile::Tile as KernelTile;
use serde::Serialize;

use super::pixel_gaussians::color_at;
use crate::pass::part::Part;
use crate::stages::color::Color;
use crate::stages::pairs::Pairs;
use crate::stages::project::{Projection, project};
use crate::stages::scan::total;
use crate::stages::transmittance::{Ray, Segments, Transmittance};
use crate::{DeviceScene, Renderer};

use muslin_device::Count;
use organza_core::error::argument;
use organza_core::image::to_8_bit;
use organza_core::{Camera, Result, Tile, TileBatch};

/// The outputs of each stage for every Gaussian in one camera, N Gaussians.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stages {
    /// Spherical harmonics of the view direction, `[N, (degree + 1)^2]`.
    pub sh: Vec<f32>,
    /// Color hash grid at the Gaussian's position, `[N, levels * features]`.
    pub color_encoding: Vec<f32>,
    /// `[N, 3]`
    pub color: Vec<f32>,
    /// K of Eq. 8, `[N]`.
    pub sample_count: Vec<u32>,
    /// T of Eq. 11, `[N]`.
    pub transmittance: Vec<f32>,
    /// Projected center in pixels, `[N]`.
    pub mean2d: Vec<[f32; 2]>,
    /// Inverse of the projected covariance: xx, xy, yy, `[N]`.
    pub conic: Vec<[f32; 3]>,
    /// Support radius in pixels, `[N]`; negative where the Gaussian is culled.
    pub radius: Vec<f32>,
}

/// One Gaussian's part in a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Contribution {
    /// Index of the Gaussian.
    pub gaussian: usize,
    /// Distance from the projected center, in pixels.
    pub distance: f32,
    /// `exp(-q/2)`, 0 past its end.
    pub falloff: f32,
    /// `sigmoid` of the opacity logit.
    pub opacity: f32,
    /// Steps of the segment, K of Eq. 8.
    pub samples: u32,
    /// T of Eq. 11.
    pub transmittance: f32,
    /// `opacity * falloff * T` (Eq. 12).
    pub alpha: f32,
    /// c of Eq. 3.
    pub color: [f32; 3],
    /// C of Eq. 12 up to and including this Gaussian.
    pub color_sum: [f32; 3],
    /// S of Eq. 12 up to and including this Gaussian.
    pub alpha_sum: f32,
}

/// Where a Gaussian lies on the screen, and the ray from it to the eye.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Projected center in pixels.
    pub mean2d: [f32; 2],
    /// Inverse of the projected covariance: xx, xy, yy. The support ends at the ellipse `d^T conic d = 2 ln 255`.
    pub conic: [f32; 3],
    /// The ray in the unit cube.
    pub ray: Ray,
}

/// The Gaussians and the sums that make a pixel. As JSON, it has all but the Gaussians.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Inspection {
    /// The Gaussians whose support reaches the pixel's square, ascending.
    #[serde(skip)]
    pub contributions: Vec<Contribution>,
    /// C of Eq. 12.
    pub color_sum: [f32; 3],
    /// S of Eq. 12.
    pub alpha_sum: f32,
    /// Background b.
    pub background: [f32; 3],
    /// Whether Eq. 13 divided: S > 1.
    pub divided: bool,
    /// I of Eq. 13.
    pub color: [f32; 3],
    /// The same in 8 bits.
    pub color_8_bit: [u8; 3],
}

impl Renderer {
    /// Evaluates every stage for every Gaussian in `camera`, needed by a tile or not. For tests.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    #[doc(hidden)]
    pub fn stages(&self, scene: &DeviceScene, camera: &Camera) -> Result<Stages> {
        let device = self.device();
        let (pairs, transmittance) = self.every_pair(scene, camera)?;

        let sh_width = scene.config.sh_width();
        let grid_width = scene.config.color_grid.width();
        let mut sh = Vec::new();
        let mut color_encoding = Vec::new();
        // `keep`, so that the network's input can be read
        let color = Color::evaluate(scene, &pairs, true)?;
        for chunk in color.blocks.iter().flat_map(|block| block.chunks().collect::<Vec<_>>()) {
            let rows = device.read(&chunk.input())?;
            for sample in 0..chunk.samples() as usize {
                let column = |row: usize| rows[row * chunk.stride() as usize + sample];
                sh.extend((0..sh_width).map(column));
                color_encoding.extend((sh_width..sh_width + grid_width).map(column));
            }
        }

        let projection = device.read(&pairs.projection)?;
        Ok(Stages {
            sh,
            color_encoding,
            color: device.read(&color.color)?,
            sample_count: transmittance.segments.steps(device)?,
            transmittance: device.read(&transmittance.transmittance)?,
            mean2d: projection.iter().step_by(2).map(|p| [p.x, p.y]).collect(),
            radius: projection.iter().step_by(2).map(|p| p.z).collect(),
            conic: projection.iter().skip(1).step_by(2).map(|c| [c.x, c.y, c.z]).collect(),
        })
    }

    /// The networks' values of every Gaussian in `camera`, needed by a tile or not: colors c (Eq. 3), and T (Eq. 11).
    pub fn shades(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
    ) -> Result<(Vec<[f32; 3]>, Vec<f32>)> {
        let device = self.device();
        let (pairs, transmittance) = self.every_pair(scene, camera)?;
        let color = device.read(&Color::evaluate(scene, &pairs, false)?.color)?;
        let color = color.as_chunks::<3>().0.to_vec();
        Ok((color, device.read(&transmittance.transmittance)?))
    }

    /// Pairs of all Gaussians and a camera, and their T.
    fn every_pair(&self, scene: &DeviceScene, camera: &Camera) -> Result<(Pairs, Transmittance)> {
        let device = self.device();
        let projection = project(device, scene, &[camera], &[EVERYWHERE])?;
        let Projection { camera, values: projection, .. } = projection;
        let every: Vec<u32> = (0..scene.gaussians).collect();
        let pairs = Pairs {
            count: Count::known(scene.gaussians),
            pair: device.upload("pairs", &every)?,
            camera,
            projection,
            camera_ends: Vec::new(),
        };
        let segments = Segments::new(scene, &pairs)?;
        let samples = total(device, &segments.first_sample)?;
        let transmittance = Transmittance::evaluate(scene, &pairs, segments, samples, false)?;
        Ok((pairs, transmittance))
    }

    /// Renders one pixel of `cameras[camera]`, with the contribution of each Gaussian.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn inspect(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        camera: usize,
        pixel: [i32; 2],
    ) -> Result<Inspection> {
        self.inspect_part(scene, cameras, camera, pixel).map(|(inspection, _)| inspection)
    }

    /// Like [`Self::inspect`], with a trace of each contribution; evaluates the samples of T once more.
    pub fn inspect_traced(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        camera: usize,
        pixel: [i32; 2],
    ) -> Result<(Inspection, Vec<Trace>)> {
        let (inspection, part) = self.inspect_part(scene, cameras, camera, pixel)?;
        let device = self.device();
        let rays = part.transmittance.rays(scene, &part.bins.pairs)?;
        let splat = device.read(&part.composite.splat)?;
        let trace = |intersection: u32| {
            let index = intersection as usize;
            let [placed, conic] = std::array::from_fn(|v| splat[index * VECTORS as usize + v]);
            Trace {
                mean2d: [placed.x, placed.y],
                conic: [conic.x, conic.y, conic.z],
                ray: rays[index].clone(),
            }
        };
        let traces = device.read(&part.bins.intersection)?.into_iter().map(trace).collect();
        Ok((inspection, traces))
    }

    fn inspect_part(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        camera: usize,
        pixel: [i32; 2],
    ) -> Result<(Inspection, Part)> {
        if !scene.beside.is_empty() {
            return argument("a pixel of several scenes cannot be explained");
        }
        let device = self.device();
        let batch = TileBatch { side: 1, tiles: vec![Tile { camera, origin: pixel }] };
        let parts = self.pass(scene, cameras).cut(&batch)?;
        let part = Part::evaluate(scene, cameras, &parts.list[0].part_tiles, false, None)?;

        let contributions = contributions(scene, &part, pixel)?;
        // the running sums were added here; these sums are the kernels'
        let sum = device.read(&part.composite.sum)?;
        let image = device.read(&part.composite.image)?;
        let color = [image[0], image[1], image[2]];
        let inspection = Inspection {
            contributions,
            color_sum: [sum[0], sum[1], sum[2]],
            alpha_sum: sum[3],
            background: scene.config.background.map(|channel| channel as f32),
            divided: sum[3] > 1.0,
            color,
            color_8_bit: color.map(to_8_bit),
        };
        Ok((inspection, part))
    }
}

/// The parts that a pixel's Gaussians have in its sums, in the order of the sums. `part` has one tile of this pixel alone.
fn contributions(scene: &DeviceScene, part: &Part, pixel: [i32; 2]) -> Result<Vec<Contribution>> {
    let device = scene.device();
    let pair = device.read(&part.bins.pairs.pair)?;
    let steps = part.transmittance.segments.steps(device)?;
    let transmittance = device.read(&part.transmittance.transmittance)?;
    let color = device.read(&part.color.color)?;
    let (color, _) = color.as_chunks::<3>();
    let splat = device.read(&part.composite.splat)?;
    let slope = part.composite.read_slopes(device)?;
    let opacity = device.read(&scene.tensors.gaussians.opacity)?;
    let center = KernelTile { camera: 0, origin: pixel, output: 0 }.pixel_center(0, 0);

    let mut sum = Vec4::ZERO;
    let mut contributions = Vec::new();
    for intersection in device.read(&part.bins.intersection)? {
        let index = intersection as usize;
        let [placed, conic, values] = std::array::from_fn(|v| splat[index * VECTORS as usize + v]);
        let d = center - Vec2::new(placed.x, placed.y);
        let at_center = Vec3::from(color[index]).extend(0.0);
        let color = color_at(at_center, slope.get(index), d).truncate().to_array();
        let q = splat_distance(placed, conic, center.x, center.y);
        let reached = in_support(q);
        let alpha = if reached { alpha(placed, values, true, q) } else { 0.0 };
        if reached {
            sum += Vec4::new(alpha * color[0], alpha * color[1], alpha * color[2], alpha);
        }
        let gaussian = (pair[index] % scene.gaussians) as usize;
        contributions.push(Contribution {
            gaussian,
            distance: d.length(),
            falloff: shaped_falloff(q, values.w),
            opacity: muslin::math::sigmoid(opacity[gaussian]),
            samples: steps[index],
            transmittance: transmittance[index],
            alpha,
            color,
            color_sum: sum.truncate().to_array(),
            alpha_sum: sum.w,
        });
    }
    Ok(contributions)
}
