//! The classic for comparison: the same Gaussians, sorted by depth and blended front to back, as in 3D Gaussian
//! splatting (Kerbl et al., 2023). Also organza's own sum, in which footprints need not end.

use organza::{Camera, DeviceScene, Renderer, Scene};
use organza_shaders::project::falloff;

/// The largest alpha of a Gaussian, as in 3D Gaussian splatting.
const MOST: f32 = 0.99;

/// A projected Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Splat {
    /// Depth of the center along the camera's axis.
    pub depth: f64,
    /// Center in pixels.
    pub mean: [f32; 2],
    /// Inverse of the projected covariance: xx, xy, yy.
    pub conic: [f32; 3],
    /// Support radius in pixels.
    pub radius: f32,
    /// Opacity at the center.
    pub opacity: f32,
    /// Color as the camera sees it.
    pub color: [f32; 3],
    /// T of Eq. 11.
    pub transmittance: f32,
}

/// The end of footprints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Footprint {
    /// At a falloff of 1/255, as in organza and in 3D Gaussian splatting.
    Cut,
    /// At a falloff that is 0 in 32 bits.
    Whole,
}

impl Footprint {
    fn falloff(self, q: f32) -> f32 {
        match self {
            Self::Cut => falloff(q),
            Self::Whole => (-0.5 * q.max(0.0)).exp(),
        }
    }

    /// Extent in support radii, which are 3.3 standard deviations each.
    fn reach(self) -> f32 {
        if self == Self::Cut { 1.0 } else { 2.5 }
    }
}

/// The Gaussians that a camera sees, projected and colored by organza's own stages. `uploaded` is the scene on the
/// device.
pub fn splats(
    renderer: &Renderer,
    scene: &Scene,
    uploaded: &DeviceScene,
    camera: &Camera,
) -> Vec<Splat> {
    let stages = renderer.stages(uploaded, camera).expect("it renders");
    let position = &scene.gaussians.position;
    let (color, _) = stages.color.as_chunks::<3>();
    let splat = |gaussian: usize| Splat {
        depth: camera.depth(position[gaussian].map(f64::from)),
        mean: stages.mean2d[gaussian],
        conic: stages.conic[gaussian],
        radius: stages.radius[gaussian],
        opacity: organza_kernel::math::sigmoid(scene.gaussians.opacity[gaussian]),
        color: color[gaussian],
        transmittance: stages.transmittance[gaussian],
    };
    let seen = (0..position.len()).filter(|gaussian| stages.radius[*gaussian] >= 0.0);
    seen.map(splat).collect()
}

/// Sums splats one after the other. `add` gets a pixel, a splat and its falloff there.
fn draw<T: Clone>(
    splats: &[Splat],
    [width, height]: [usize; 2],
    footprint: Footprint,
    empty: T,
    add: impl Fn(&mut T, &Splat, f32),
) -> Vec<T> {
    let mut pixels = vec![empty; width * height];
    for splat in splats {
        let [columns, rows] = [(0, width), (1, height)].map(|(axis, size)| {
            let radius = footprint.reach() * splat.radius + 1.0;
            let end = |side: f32| (splat.mean[axis] + side * radius).floor();
            end(-1.0).clamp(0.0, size as f32) as usize..end(1.0).clamp(0.0, size as f32) as usize
        });
        for row in rows {
            for column in columns.clone() {
                let x = column as f32 + 0.5 - splat.mean[0];
                let y = row as f32 + 0.5 - splat.mean[1];
                let [xx, xy, yy] = splat.conic;
                let q = xx * x * x + 2.0 * xy * x * y + yy * y * y;
                add(&mut pixels[row * width + column], splat, footprint.falloff(q));
            }
        }
    }
    pixels
}

/// The image `[height * width]`, row by row, of splats in any order: `sum T_i alpha_i c_i + T b`, where `T_i = prod
/// (1 - alpha_j)` over the splats in front.
pub fn blend(
    splats: &[Splat],
    size: [usize; 2],
    background: [f32; 3],
    footprint: Footprint,
) -> Vec<[f32; 3]> {
    let mut splats = splats.to_vec();
    splats.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let add = |(color, through): &mut ([f32; 3], f32), splat: &Splat, falloff: f32| {
        let alpha = (splat.opacity * falloff).min(MOST);
        for (sum, channel) in color.iter_mut().zip(splat.color) {
            *sum += *through * alpha * channel;
        }
        *through *= 1.0 - alpha;
    };
    let pixels = draw(&splats, size, footprint, ([0.0; 3], 1.0), add);
    let over = |(color, through): ([f32; 3], f32)| {
        std::array::from_fn(|channel| color[channel] + through * background[channel])
    };
    pixels.into_iter().map(over).collect()
}

/// The image of Eq. 12 and 13.
pub fn sum(
    splats: &[Splat],
    size: [usize; 2],
    background: [f32; 3],
    footprint: Footprint,
) -> Vec<[f32; 3]> {
    let add = |(color, weight): &mut ([f32; 3], f32), splat: &Splat, falloff: f32| {
        let alpha = splat.opacity * splat.transmittance * falloff;
        for (sum, channel) in color.iter_mut().zip(splat.color) {
            *sum += alpha * channel;
        }
        *weight += alpha;
    };
    let over = |(color, weight): ([f32; 3], f32)| {
        let divided = |channel: usize| match weight > 1.0 {
            true => color[channel] / weight,
            false => color[channel] + (1.0 - weight) * background[channel],
        };
        std::array::from_fn(divided)
    };
    draw(splats, size, footprint, ([0.0; 3], 0.0), add).into_iter().map(over).collect()
}
