//! What a viewer that sorts shows: Gaussians are blended from front to back in the order of their depth. And the derivative of
//! that with respect to every value of the Gaussians.

use glam::{Vec2, Vec3, Vec4};
use organza_kernel::math::sigmoid;
use organza_shaders::camera::Camera as KernelCamera;
use organza_shaders::project::{FALLOFF_CUTOFF, mahalanobis, project_gaussian};
use organza_shaders::project_backward::project_gaussian_backward;
use rayon::prelude::*;

use super::Splat;
use super::harmonics::{HARMONICS, color_of, harmonics};
use crate::camera::Camera;
use crate::render::kernel_camera;

/// Side of the tiles that an image is cut into, in pixels.
const SIDE: usize = 16;
/// What viewers add to the diagonal of every projected covariance, in square pixels.
const BLUR: f32 = 0.3;
/// The largest alpha of a Gaussian.
const MOST: f32 = 0.99;
/// Alphas below this are left out.
const LEAST: f32 = 1.0 / 255.0;
/// A pixel ends where so little light is left.
const DARK: f32 = 1e-4;

/// The Gaussians in the image of a camera.
pub(super) struct View {
    camera: KernelCamera,
    size: [usize; 2],
    /// The nearest first; only those that the image can show.
    placed: Vec<Placed>,
    /// For each tile, row by row: indices into `placed`, ascending.
    tiles: Vec<Vec<u32>>,
}

/// A Gaussian in an image.
#[derive(Clone, Copy, Debug)]
struct Placed {
    gaussian: u32,
    depth: f32,
    mean: Vec2,
    conic: Vec3,
    /// Half the width and height of where alpha is at least [`LEAST`].
    extent: Vec2,
    /// The largest q of a pixel there.
    reach: f32,
    opacity: f32,
    color: [f32; 3],
}

/// The derivatives of a loss with respect to a Gaussian in an image.
#[derive(Clone, Copy, Debug, Default)]
struct Slope {
    color: [f32; 3],
    /// With respect to the opacity, not its logit.
    opacity: f32,
    mean: Vec2,
    conic: Vec3,
}

impl Slope {
    fn add(&mut self, other: &Self) {
        for (sum, value) in self.color.iter_mut().zip(other.color) {
            *sum += value;
        }
        self.opacity += other.opacity;
        self.mean += other.mean;
        self.conic += other.conic;
    }
}

impl Placed {
    fn new(camera: &KernelCamera, gaussian: usize, splat: &Splat) -> Option<Self> {
        let opacity = sigmoid(splat.opacity);
        let (position, rotation) = (Vec3::from(splat.position), Vec4::from(splat.rotation));
        let found = project_gaussian(camera, BLUR, position, rotation, splat.log_scale.into());
        if found.radius < 0.0 || opacity < LEAST {
            return None;
        }
        let basis = harmonics(camera.eye, splat.position);
        // opacity exp(-q / 2) = 1/255
        let reach = 2.0 * (opacity / LEAST).ln();
        Some(Self {
            gaussian: gaussian as u32,
            depth: camera.to_camera(position).z,
            mean: found.mean2d,
            conic: found.conic,
            extent: found.extent * (reach / FALLOFF_CUTOFF).sqrt(),
            reach,
            opacity,
            color: color_of(&splat.color, &basis).map(|channel| channel.max(0.0)),
        })
    }

    /// Alpha at a pixel, unless it is too small, and the offset from the center.
    fn alpha(&self, x: f32, y: f32) -> Option<(f32, Vec2)> {
        let offset = Vec2::new(x - self.mean.x, y - self.mean.y);
        let q = mahalanobis(self.conic, offset.x, offset.y);
        // rounding may take q of a needle below zero
        (q <= self.reach).then(|| (self.opacity * (-0.5 * q.max(0.0)).exp(), offset))
    }
}

impl View {
    pub fn new(splats: &[Splat], camera: &Camera) -> Self {
        let size = [camera.width as usize, camera.height as usize];
        let camera = kernel_camera(camera);
        let mut placed: Vec<_> = splats
            .par_iter()
            .enumerate()
            .filter_map(|(gaussian, splat)| Placed::new(&camera, gaussian, splat))
            .collect();
        let key = |placed: &Placed| (placed.depth, placed.gaussian);
        placed.par_sort_unstable_by(|a, b| {
            let ((a, first), (b, second)) = (key(a), key(b));
            a.total_cmp(&b).then(first.cmp(&second))
        });
        let counts = size.map(|side| side.div_ceil(SIDE));
        let mut tiles = vec![Vec::new(); counts[0] * counts[1]];
        for (index, Placed { mean, extent, .. }) in placed.iter().enumerate() {
            let range = |axis: usize| {
                let tile = |at: f32| (at / SIDE as f32).floor();
                let (low, high) = (mean[axis] - extent[axis], mean[axis] + extent[axis]);
                // what is outside on either side is in no tile; casts saturate
                tile(low).max(0.0) as usize
                    ..((tile(high) + 1.0).max(0.0) as usize).min(counts[axis])
            };
            for row in range(1) {
                for column in range(0) {
                    tiles[row * counts[0] + column].push(index as u32);
                }
            }
        }
        Self { camera, size, placed, tiles }
    }

    fn pixels(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// The Gaussians of a tile, and its pixels: column, row and index in the image.
    fn tile(&self, tile: usize) -> (Vec<Placed>, impl Iterator<Item = (f32, f32, usize)>) {
        let members = self.tiles[tile].iter().map(|&index| self.placed[index as usize]).collect();
        let [width, height] = self.size;
        let columns = width.div_ceil(SIDE);
        let (left, top) = (tile % columns * SIDE, tile / columns * SIDE);
        let row = move |y: usize| {
            let pixel = move |x: usize| (x as f32 + 0.5, y as f32 + 0.5, y * width + x);
            (left..(left + SIDE).min(width)).map(pixel)
        };
        (members, (top..(top + SIDE).min(height)).flat_map(row))
    }

    /// The mean squared error beside `truth`, and its derivative, as a Gaussian's number and a [`Splat`] of derivatives: of
    /// those that the image shows. A color's dependence on the position is left out.
    pub fn gradient(
        &self,
        splats: &[Splat],
        background: [f32; 3],
        truth: &[[f32; 3]],
    ) -> (Vec<(u32, Splat)>, f64) {
        let scale = 2.0 / (3 * self.pixels()) as f32;
        let tiles: Vec<_> = (0..self.tiles.len())
            .into_par_iter()
            .map(|tile| {
                let (members, pixels) = self.tile(tile);
                let mut slopes = vec![Slope::default(); members.len()];
                let (mut hits, mut error) = (Vec::new(), 0.0);
                for (x, y, at) in pixels {
                    let color = blend(&members, x, y, background, &mut hits);
                    let off: [f32; 3] = std::array::from_fn(|i| color[i] - truth[at][i]);
                    error += off.iter().map(|&off| f64::from(off * off)).sum::<f64>();
                    let off = off.map(|off| scale * off);
                    backward(&members, &hits, off, background, &mut slopes);
                }
                (slopes, error)
            })
            .collect();
        // tile after tile, so that sums have one order
        let (mut sums, mut error) = (vec![Slope::default(); self.placed.len()], 0.0);
        for ((slopes, own), members) in tiles.iter().zip(&self.tiles) {
            error += own;
            for (slope, &index) in slopes.iter().zip(members) {
                sums[index as usize].add(slope);
            }
        }
        let chain = |(placed, slope): (&Placed, &Slope)| {
            (placed.gaussian, self.chain(&splats[placed.gaussian as usize], placed, slope))
        };
        let gradient = self.placed.par_iter().zip(&sums).map(chain).collect();
        (gradient, error / (3 * self.pixels()) as f64)
    }

    /// From the derivatives in the image to those of a Gaussian's values.
    fn chain(&self, splat: &Splat, placed: &Placed, slope: &Slope) -> Splat {
        let (position, rotation) = (Vec3::from(splat.position), Vec4::from(splat.rotation));
        let geometry = project_gaussian_backward(
            &self.camera,
            BLUR,
            position,
            rotation,
            splat.log_scale.into(),
            slope.mean,
            slope.conic,
        );
        let basis = harmonics(self.camera.eye, splat.position);
        // a channel that is held above 0 has a derivative if it should be brighter
        let by_channel: [f32; 3] = std::array::from_fn(|channel| {
            let is_held = placed.color[channel] <= 0.0 && slope.color[channel] > 0.0;
            if is_held { 0.0 } else { slope.color[channel] }
        });
        let color: [[f32; 3]; HARMONICS] = basis.map(|basis| by_channel.map(|by| by * basis));
        Splat {
            position: geometry.position.into(),
            rotation: geometry.rotation.into(),
            log_scale: geometry.log_scale.into(),
            opacity: slope.opacity * placed.opacity * (1.0 - placed.opacity),
            color,
        }
    }
}

/// A Gaussian that a pixel shows.
#[derive(Clone, Copy, Debug)]
struct Hit {
    /// Index among the tile's.
    member: usize,
    /// Before it is held below [`MOST`].
    alpha: f32,
    offset: Vec2,
    /// What is left of the light in front of it.
    light: f32,
}

/// The color of a pixel: `sum light_i alpha_i c_i + light b` with `light_i = prod (1 - alpha_j)` over what is in front.
fn blend(
    members: &[Placed],
    x: f32,
    y: f32,
    background: [f32; 3],
    hits: &mut Vec<Hit>,
) -> [f32; 3] {
    hits.clear();
    let (mut color, mut light) = ([0.0; 3], 1.0);
    for (member, placed) in members.iter().enumerate() {
        let Some((alpha, offset)) = placed.alpha(x, y) else { continue };
        hits.push(Hit { member, alpha, offset, light });
        let alpha = alpha.min(MOST);
        for (sum, channel) in color.iter_mut().zip(placed.color) {
            *sum += light * alpha * channel;
        }
        light *= 1.0 - alpha;
        if light < DARK {
            break;
        }
    }
    for (sum, channel) in color.iter_mut().zip(background) {
        *sum += light * channel;
    }
    color
}

/// Adds a pixel's part to the derivatives of what it shows; `by_color` is that with respect to its color.
fn backward(
    members: &[Placed],
    hits: &[Hit],
    by_color: [f32; 3],
    background: [f32; 3],
    slopes: &mut [Slope],
) {
    let dot = |a: [f32; 3]| a.iter().zip(by_color).map(|(a, by)| a * by).sum::<f32>();
    let Some(last) = hits.last() else { return };
    // what all that lies behind adds to the loss's derivative, from the last to the first
    let mut behind = last.light * (1.0 - last.alpha.min(MOST)) * dot(background);
    for hit in hits.iter().rev() {
        let (placed, slope) = (&members[hit.member], &mut slopes[hit.member]);
        let alpha = hit.alpha.min(MOST);
        let shade = dot(placed.color);
        for (sum, by) in slope.color.iter_mut().zip(by_color) {
            *sum += by * hit.light * alpha;
        }
        let by_alpha = hit.light * shade - behind / (1.0 - alpha);
        behind += hit.light * alpha * shade;
        if hit.alpha < MOST {
            slope.opacity += by_alpha * alpha / placed.opacity;
            // alpha = opacity exp(-q / 2), q = d^T conic d, d the offset from the center
            let by_q = -0.5 * by_alpha * alpha;
            let (d, conic) = (hit.offset, placed.conic);
            let by_d = Vec2::new(conic.x * d.x + conic.y * d.y, conic.y * d.x + conic.z * d.y);
            slope.mean -= 2.0 * by_q * by_d;
            slope.conic += by_q * Vec3::new(d.x * d.x, 2.0 * d.x * d.y, d.y * d.y);
        }
    }
}

/// The image that a camera shows of some Gaussians, row by row. Values are not held to 0 to 1.
#[must_use]
pub fn render(splats: &[Splat], camera: &Camera, background: [f32; 3]) -> Vec<[f32; 3]> {
    let view = View::new(splats, camera);
    let tiles: Vec<_> = (0..view.tiles.len())
        .into_par_iter()
        .map(|tile| {
            let (members, pixels) = view.tile(tile);
            let mut hits = Vec::new();
            let pixel = |(x, y, at)| (at, blend(&members, x, y, background, &mut hits));
            pixels.map(pixel).collect::<Vec<_>>()
        })
        .collect();
    let mut image = vec![[0.0; 3]; view.pixels()];
    for (at, color) in tiles.into_iter().flatten() {
        image[at] = color;
    }
    image
}

#[cfg(test)]
mod tests {
    use super::super::VALUES;
    use super::super::harmonics::FIRST;
    use super::*;

    const SIZE: [u32; 2] = [28, 20];

    fn camera() -> Camera {
        Camera::look_at([0.0, -4.0, 0.3], [0.0; 3], [0.0, 0.0, 1.0], 0.7, SIZE).unwrap()
    }

    /// A ball of half the light at the center of the image.
    fn ball() -> Splat {
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

    /// Gaussians of several shapes, each of which all pixels see: an alpha that passes 1/255 would be a step in the loss.
    fn many() -> Vec<Splat> {
        (0..14)
            .map(|i: usize| {
                let mut next = (0..).map(|k: usize| ((i * 37 + k * 61) % 97) as f32 / 97.0 - 0.5);
                let mut value = || next.next().unwrap();
                let mut splat = ball();
                splat.position = std::array::from_fn(|_| 1.6 * value());
                splat.rotation = std::array::from_fn(|_| value() + 0.1);
                splat.log_scale = std::array::from_fn(|_| 0.6 * value() + 0.6);
                splat.opacity = 4.0 * value();
                splat.color = std::array::from_fn(|_| std::array::from_fn(|_| 0.3 * value()));
                splat
            })
            .collect()
    }

    #[test]
    fn one_behind_another() {
        let camera = camera();
        let middle = SIZE[0] as usize * (SIZE[1] as usize / 2) + SIZE[0] as usize / 2;
        let front = ball();
        let mut back = ball();
        back.position = [0.0, 5.0, -0.375];
        (back.log_scale, back.opacity) = ([1.0; 3], 1.0);
        back.color[0] = [-0.5 / FIRST, 0.0, 0.5 / FIRST];
        // the image has no pixel in its middle: the falloff of the nearest is a little below 1
        let image = render(&[back, front], &camera, [0.2, 0.4, 0.6]);
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
        // whatever their order in the file
        assert_eq!(image, render(&[front, back], &camera, [0.2, 0.4, 0.6]));
    }

    #[test]
    fn the_gradient_is_that_of_finite_differences() {
        let (splats, camera, background) = (many(), camera(), [0.9, 0.5, 0.1]);
        let truth = vec![[0.3, 0.6, 0.2]; (SIZE[0] * SIZE[1]) as usize];
        let view = View::new(&splats, &camera);
        let (gradient, error) = view.gradient(&splats, background, &truth);
        let error_of = |splats: &[Splat]| {
            let image = render(splats, &camera, background);
            let off = image.as_flattened().iter().zip(truth.as_flattened());
            off.map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>() / truth.len() as f64 / 3.0
        };
        assert!((error - error_of(&splats)).abs() < 1e-6 * error);
        assert!(gradient.len() > 10, "{}", gradient.len());
        let largest = gradient
            .iter()
            .flat_map(|(_, splat)| bytemuck::cast_ref::<_, [f32; VALUES]>(splat))
            .fold(0.0, |most: f32, value| most.max(value.abs()));
        for (gaussian, slope) in &gradient {
            let slope: &[f32; VALUES] = bytemuck::cast_ref(slope);
            // a color depends on the position by its direction, which is left out
            for (value, found) in slope.iter().enumerate().skip(3) {
                let moved = |by: f32| {
                    let mut splats = splats.clone();
                    let own = &mut splats[*gaussian as usize];
                    bytemuck::cast_mut::<_, [f32; VALUES]>(own)[value] += by;
                    error_of(&splats)
                };
                let step = 4e-3;
                let expected = (moved(step) - moved(-step)) / f64::from(2.0 * step);
                let found = f64::from(*found);
                let off = (found - expected).abs();
                assert!(
                    off < 0.02 * expected.abs() + 0.002 * f64::from(largest),
                    "{gaussian}, {value}: {found} {expected}"
                );
            }
        }
    }

    #[test]
    fn a_center_moves_with_its_gradient() {
        // of one color from all sides
        let (camera, background) = (camera(), [0.0; 3]);
        let mut splat = ball();
        splat.position = [0.1, 0.2, -0.1];
        let truth = render(&[ball()], &camera, background);
        let of =
            |splat: &Splat| View::new(&[*splat], &camera).gradient(&[*splat], background, &truth);
        let (gradient, _) = of(&splat);
        for axis in 0..3 {
            let moved = |by: f32| {
                let mut splat = splat;
                splat.position[axis] += by;
                of(&splat).1
            };
            let expected = (moved(2e-3) - moved(-2e-3)) / 4e-3;
            let found = f64::from(gradient[0].1.position[axis]);
            assert!((found - expected).abs() < 0.03 * expected.abs() + 1e-4, "{found} {expected}");
        }
    }
}
