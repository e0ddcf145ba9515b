//! Renders like a viewer that sorts: Gaussians are blended from front to back, in order of depth.

use std::ops::AddAssign;

use glam::{Vec2, Vec3, Vec4};
use muslin::math::sigmoid;
use organza_shaders::camera::Camera as KernelCamera;
use organza_shaders::project::{FALLOFF_CUTOFF, mahalanobis, project_gaussian};
use organza_shaders::splat::Compensation;
use rayon::prelude::*;

use super::Splat;
use super::harmonics::{color_of, harmonics};
use organza_core::camera::Camera;

/// Side of the image's tiles, in pixels.
const SIDE: usize = 16;
/// Added to the diagonal of every projected covariance, as in viewers, in square pixels.
pub(super) const BLUR: f32 = 0.3;
/// Largest alpha of a Gaussian.
pub(super) const MAX_ALPHA: f32 = 0.99;
/// Smallest alpha that counts.
const MIN_ALPHA: f32 = 1.0 / 255.0;
/// Light at which a pixel is finished.
const DARK: f32 = 1e-4;

/// The Gaussians in the image of a camera.
pub(super) struct SortedView {
    pub camera: KernelCamera,
    size: [usize; 2],
    gaussians: usize,
    /// The Gaussians that the image can show, the nearest first.
    pub placed: Vec<Placed>,
    /// For each tile, row by row: indices into `placed`, ascending.
    pub tiles: Vec<Vec<u32>>,
}

/// A Gaussian in an image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub gaussian: u32,
    depth: f32,
    mean: Vec2,
    pub conic: Vec3,
    /// Half the width and height of the area in which alpha is at least [`MIN_ALPHA`].
    extent: Vec2,
    /// Largest q of a pixel in that area.
    reach: f32,
    pub opacity: f32,
    pub color: Vec3,
}

impl Placed {
    fn new(
        camera: &KernelCamera,
        gaussian: usize,
        splat: &Splat,
        is_antialiased: bool,
    ) -> Option<Self> {
        let position = Vec3::from(splat.position);
        let rotation = Vec4::from(splat.rotation);
        let found = project_gaussian(camera, BLUR, position, rotation, splat.log_scale.into());
        let compensated = if is_antialiased { BLUR } else { 0.0 };
        let opacity = sigmoid(splat.opacity) * Compensation::new(found.conic, compensated).factor;
        if found.radius < 0.0 || opacity < MIN_ALPHA {
            return None;
        }
        let basis = harmonics(camera.eye, splat.position);
        // opacity exp(-q / 2) = 1/255
        let reach = 2.0 * (opacity / MIN_ALPHA).ln();
        Some(Self {
            gaussian: gaussian as u32,
            depth: camera.to_camera(position).z,
            mean: found.mean2d,
            conic: found.conic,
            extent: found.extent * (reach / FALLOFF_CUTOFF).sqrt(),
            reach,
            opacity,
            color: Vec3::from(color_of(&splat.color, &basis)).max(Vec3::ZERO),
        })
    }

    /// Alpha at a pixel and the offset from the center; `None` if alpha is too small.
    pub fn alpha(&self, x: f32, y: f32) -> Option<(f32, Vec2)> {
        let offset = Vec2::new(x - self.mean.x, y - self.mean.y);
        let q = mahalanobis(self.conic, offset.x, offset.y);
        // rounding may make the q of a needle negative
        (q <= self.reach).then(|| (self.opacity * (-0.5 * q.max(0.0)).exp(), offset))
    }
}

impl SortedView {
    /// With `is_antialiased`, opacities make up for the [`BLUR`].
    pub fn new(splats: &[Splat], camera: &Camera, is_antialiased: bool) -> Self {
        let size = [camera.width as usize, camera.height as usize];
        let camera = camera.for_kernels();
        let mut placed: Vec<_> = splats
            .par_iter()
            .enumerate()
            .filter_map(|(gaussian, splat)| Placed::new(&camera, gaussian, splat, is_antialiased))
            .collect();
        placed.par_sort_unstable_by(|a, b| {
            a.depth.total_cmp(&b.depth).then(a.gaussian.cmp(&b.gaussian))
        });
        let counts = size.map(|side| side.div_ceil(SIDE));
        let mut tiles = vec![Vec::new(); counts[0] * counts[1]];
        for (index, Placed { mean, extent, .. }) in placed.iter().enumerate() {
            let range = |axis: usize| {
                let tile = |at: f32| (at / SIDE as f32).floor();
                let low = mean[axis] - extent[axis];
                let high = mean[axis] + extent[axis];
                // a Gaussian outside on either side is in no tile; casts saturate
                tile(low).max(0.0) as usize
                    ..((tile(high) + 1.0).max(0.0) as usize).min(counts[axis])
            };
            for row in range(1) {
                for column in range(0) {
                    tiles[row * counts[0] + column].push(index as u32);
                }
            }
        }
        Self { camera, size, gaussians: splats.len(), placed, tiles }
    }

    pub fn pixels(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// The Gaussians of a tile, and its pixels: column, row and index in the image.
    pub fn tile(&self, tile: usize) -> (Vec<Placed>, impl Iterator<Item = (f32, f32, usize)>) {
        let intersections =
            self.tiles[tile].iter().map(|&index| self.placed[index as usize]).collect();
        let [width, height] = self.size;
        let columns = width.div_ceil(SIDE);
        let left = tile % columns * SIDE;
        let top = tile / columns * SIDE;
        let row = move |y: usize| {
            let pixel = move |x: usize| (x as f32 + 0.5, y as f32 + 0.5, y * width + x);
            (left..(left + SIDE).min(width)).map(pixel)
        };
        (intersections, (top..(top + SIDE).min(height)).flat_map(row))
    }

    /// A sum over the image for each Gaussian of the scene. `add` adds the pixels of a tile to the tile's Gaussians.
    pub fn sums<S: Clone + Default + Send + AddAssign>(
        &self,
        add: impl Fn(&[Placed], &mut dyn Iterator<Item = (f32, f32, usize)>, &mut [S]) + Sync,
    ) -> Vec<S> {
        let tiles: Vec<_> = (0..self.tiles.len())
            .into_par_iter()
            .map(|tile| {
                let (intersections, mut pixels) = self.tile(tile);
                let mut sums = vec![S::default(); intersections.len()];
                add(&intersections, &mut pixels, &mut sums);
                sums
            })
            .collect();
        // tile after tile, so that sums have a fixed order
        let mut all = vec![S::default(); self.gaussians];
        for (sums, intersections) in tiles.into_iter().zip(&self.tiles) {
            for (sum, &index) in sums.into_iter().zip(intersections) {
                all[self.placed[index as usize].gaussian as usize] += sum;
            }
        }
        all
    }
}

/// A Gaussian that a pixel shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    /// Index among the tile's Gaussians.
    pub intersection: usize,
    /// Alpha before it is clamped to [`MAX_ALPHA`].
    pub alpha: f32,
    pub offset: Vec2,
    /// Light left by the Gaussians in front.
    pub light: f32,
}

/// The color of a pixel: `sum light_i alpha_i c_i + light b`, where `light_i = prod (1 - alpha_j)` over the Gaussians
/// in front.
pub(super) fn blend(
    intersections: &[Placed],
    x: f32,
    y: f32,
    background: Vec3,
    hits: &mut Vec<Hit>,
) -> Vec3 {
    hits.clear();
    let mut color = Vec3::ZERO;
    let mut light = 1.0;
    for (intersection, placed) in intersections.iter().enumerate() {
        let Some((alpha, offset)) = placed.alpha(x, y) else { continue };
        hits.push(Hit { intersection, alpha, offset, light });
        let alpha = alpha.min(MAX_ALPHA);
        color += light * alpha * placed.color;
        light *= 1.0 - alpha;
        if light < DARK {
            break;
        }
    }
    color + light * background
}

/// The image of some Gaussians, row by row. Values are not clamped to 0 to 1. With `is_antialiased`, a Gaussian that the viewer's
/// blur makes wider becomes no heavier, as in Mip-Splatting.
pub fn render(
    splats: &[Splat],
    camera: &Camera,
    background: [f32; 3],
    is_antialiased: bool,
) -> Vec<[f32; 3]> {
    let view = SortedView::new(splats, camera, is_antialiased);
    let tiles: Vec<_> = (0..view.tiles.len())
        .into_par_iter()
        .map(|tile| {
            let (intersections, pixels) = view.tile(tile);
            let mut hits = Vec::new();
            let pixel =
                |(x, y, at)| (at, blend(&intersections, x, y, background.into(), &mut hits));
            pixels.map(pixel).collect::<Vec<_>>()
        })
        .collect();
    let mut image = vec![[0.0; 3]; view.pixels()];
    for (at, color) in tiles.into_iter().flatten() {
        image[at] = color.into();
    }
    image
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::harmonics::{FIRST, HARMONICS};
    use super::*;

    pub const SIZE: [u32; 2] = [28, 20];

    pub fn camera() -> Camera {
        Camera::look_at([0.0, -4.0, 0.3], [0.0; 3], [0.0, 0.0, 1.0], 0.7, SIZE).unwrap()
    }

    /// A ball that blocks half the light, at the center of the image.
    pub fn ball() -> Splat {
        let mut color = [[0.0; 3]; HARMONICS];
        color[0] = [0.5 / FIRST, -9.0, 0.0];
        Splat {
            position: [0.0; 3],
            rotation: [1.0, 0.0, 0.0, 0.0],
            log_scale: [-1.0; 3],
            opacity: 0.0,
            color,
        }
    }

    #[test]
    fn one_behind_another() {
        let camera = camera();
        let middle = SIZE[0] as usize * (SIZE[1] as usize / 2) + SIZE[0] as usize / 2;
        let front = ball();
        let mut back = ball();
        back.position = [0.0, 5.0, -0.375];
        back.log_scale = [1.0; 3];
        back.opacity = 1.0;
        back.color[0] = [-0.5 / FIRST, 0.0, 0.5 / FIRST];
        // the image has no pixel at its center: the falloff at the nearest one is a little below 1
        let image = render(&[back, front], &camera, [0.2, 0.4, 0.6], false);
        let beyond = 1.0 / (1.0 + f32::exp(1.0));
        // red in front, blue and half of the green behind, and the background
        let expected = [
            0.5 + 0.5 * beyond * 0.2,
            0.5 * ((1.0 - beyond) * 0.5 + beyond * 0.4),
            0.25 + 0.5 * ((1.0 - beyond) + beyond * 0.6),
        ];
        for (found, expected) in image[middle].iter().zip(expected) {
            assert!((found - expected).abs() < 0.02, "{:?} {expected}", image[middle]);
        }
        // independent of the order in the file
        assert_eq!(image, render(&[front, back], &camera, [0.2, 0.4, 0.6], false));
    }

    /// The light of a small Gaussian on black: `2 pi` times its variance in the image, in square pixels, times its alpha at the center
    /// above the smallest that counts. The blur adds to that variance, and alpha makes up for it or not.
    #[test]
    fn antialiased_gaussians_keep_their_light() {
        let camera = camera();
        let mut small = ball();
        small.color[0] = [0.5 / FIRST; 3];
        small.log_scale = [-3.0; 3];
        let distance = Vec3::from(camera.eye().map(|x| x as f32)).length();
        let variance = (camera.fl_x as f32 / distance * f32::exp(-3.0)).powi(2);
        for (is_antialiased, factor) in [(true, variance / (variance + BLUR)), (false, 1.0)] {
            let image = render(&[small], &camera, [0.0; 3], is_antialiased);
            let found: f32 = image.iter().map(|color| color[0]).sum();
            let expected = std::f32::consts::TAU * (variance + BLUR) * (0.5 * factor - MIN_ALPHA);
            assert!((found / expected - 1.0).abs() < 0.03, "{is_antialiased}: {found} {expected}");
        }
    }
}
