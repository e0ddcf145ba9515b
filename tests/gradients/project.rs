//! The projection: centers and conics, of positions, rotations and scales.

use glam::{DMat3, DQuat, DVec3, DVec4, Vec3, Vec4};
use organza::Device;
use organza::parity::inputs::Random;
use organza::parity::lens::ExactLens;
use organza::parity::project::cameras;
use organza_kernels::camera::Camera;
use organza_kernels::project_backward::{ProjectBackwardKernel, ProjectBackwardParams};

use super::numeric::{central, everywhere, hold};

/// The parts of `gradient [11 N]`.
const PARTS: [(&str, usize); 4] =
    [("position", 3), ("rotation", 4), ("log_scale", 3), ("opacity", 1)];

struct Inputs {
    blur: f32,
    cameras: Vec<Camera>,
    /// `[N, 11]`: position, rotation, log_scale, opacity.
    gaussian: Vec<[f32; 11]>,
    pair_mask: Vec<u32>,
    first_pair: Vec<u32>,
    pair_gradient: Vec<[Vec4; 3]>,
    radius: Vec<f32>,
}

impl Inputs {
    fn new(blur: f32, log_scale: [f32; 2]) -> Self {
        let mut random = Random::new(5);
        let cameras = cameras(&mut random);
        let count = 70;
        // the cameras are 2.5 to 5 from the origin: some Gaussians are behind them, some beside the image
        let gaussian: Vec<[f32; 11]> = (0..count)
            .map(|index| {
                let far = if index % 3 == 0 { 6.0 } else { 1.5 };
                let mut values = [0.0; 11];
                values[..3].copy_from_slice(&random.values(3, -far, far));
                let length = [0.01, 1.0, 40.0][index % 3];
                values[3..7].copy_from_slice(&random.values(4, -length, length));
                values[7..10].copy_from_slice(&random.values(3, log_scale[0], log_scale[1]));
                values[10] = random.between(0.5, 2.0);
                values
            })
            .collect();
        let mut inputs = Self {
            blur,
            cameras,
            gaussian,
            pair_mask: Vec::new(),
            first_pair: Vec::new(),
            pair_gradient: Vec::new(),
            radius: random.values(3 * count, 0.0, 50.0),
        };
        for camera in 0..3 {
            for word in 0..3 {
                let needed = |bit: &u32| {
                    let gaussian = (32 * word + bit) as usize;
                    random.below(4) > 0 && gaussian < count && inputs.depth(camera, gaussian) > 0.05
                };
                let bits: u32 = (0..32).filter(needed).map(|bit| 1 << bit).sum();
                inputs.first_pair.push(inputs.pair_gradient.len() as u32);
                inputs.pair_mask.push(bits);
                for _ in 0..bits.count_ones() {
                    let [a, b] = [0, 1].map(|_| Vec4::from_slice(&random.values(4, -1.0, 1.0)));
                    inputs.pair_gradient.push([a, b, Vec4::ONE]);
                }
            }
        }
        inputs
    }

    fn depth(&self, camera: usize, gaussian: usize) -> f32 {
        let camera = &self.cameras[camera];
        camera.rotation[2].dot(Vec3::from_slice(&self.gaussian[gaussian]) - camera.eye)
    }

    fn pair(&self, camera: usize, gaussian: usize) -> Option<usize> {
        let word = 3 * camera + gaussian / 32;
        let (bits, bit) = (self.pair_mask[word], gaussian % 32);
        let below = (bits & ((1 << bit) - 1)).count_ones();
        (bits >> bit & 1 == 1).then_some((self.first_pair[word] + below) as usize)
    }

    /// Some values of all Gaussians.
    fn part(&self, range: std::ops::Range<usize>) -> Vec<f32> {
        self.gaussian.iter().flat_map(|values| values[range.clone()].to_vec()).collect()
    }

    /// Runs the kernel on top of `gradient` and `statistics`.
    fn run(&self, device: &Device, gradient: f32, statistics: Vec4) -> (Vec<f32>, Vec<Vec4>) {
        let count = self.gaussian.len();
        let packed: Vec<_> = self.cameras.iter().flat_map(Camera::pack).collect();
        let projection: Vec<_> =
            self.radius.iter().flat_map(|&radius| [Vec4::ONE.with_z(radius), Vec4::ONE]).collect();
        let gradient = device.upload("gradient", &vec![gradient; 11 * count]).unwrap();
        let statistics = device.upload("statistics", &vec![statistics; count]).unwrap();
        let kernel = ProjectBackwardKernel {
            params: ProjectBackwardParams {
                gaussians: count as u32,
                words: 3,
                cameras: 3,
                blur: self.blur,
            },
            camera: &device.upload("cameras", &packed).unwrap(),
            position: &device.upload("position", &self.part(0..3)).unwrap(),
            rotation: &device.upload("rotation", &self.part(3..7)).unwrap(),
            log_scale: &device.upload("log_scale", &self.part(7..10)).unwrap(),
            projection: &device.upload("projection", &projection).unwrap(),
            pair_mask: &device.upload("masks", &self.pair_mask).unwrap(),
            first_pair: &device.upload("first pairs", &self.first_pair).unwrap(),
            pair_gradient: &device.upload("gradient", self.pair_gradient.as_flattened()).unwrap(),
            gradient: &gradient,
            statistics: &statistics,
        };
        device.run(&kernel, count as u32, 1).unwrap();
        (device.read(&gradient).unwrap(), device.read(&statistics).unwrap())
    }

    /// What all pairs of a Gaussian have in the loss.
    fn loss(&self, gaussian: usize, base: &[f64], values: &[f64]) -> f64 {
        let of = |camera: usize| {
            let Some(pair) = self.pair(camera, gaussian) else { return 0.0 };
            let [geometry, conic, _] = self.pair_gradient[pair].map(|v| v.as_dvec4());
            let (mean2d, found) =
                project(&self.cameras[camera], f64::from(self.blur), base, values);
            geometry.x * mean2d[0]
                + geometry.y * mean2d[1]
                + geometry.z * values[10]
                + conic.truncate().dot(found)
        };
        (0..3).map(of).sum()
    }

    /// `[N, 11]`
    fn expected(&self) -> Vec<Vec<f64>> {
        let one = |gaussian: usize| {
            let values = self.gaussian[gaussian].map(f64::from);
            central(&values, 1e-5, |moved| self.loss(gaussian, &values, moved))
        };
        (0..self.gaussian.len()).map(one).collect()
    }
}

/// Center and conic as in conventions.md, with covariances as whole matrices.  Ratios are clamped as at `base`.
fn project(camera: &Camera, blur: f64, base: &[f64], values: &[f64]) -> ([f64; 2], DVec3) {
    let world_to_camera =
        DMat3::from_cols_array_2d(&camera.rotation.map(|row| row.as_dvec3().to_array()))
            .transpose();
    let eye = camera.eye.as_dvec3();
    let t = world_to_camera * (DVec3::from_slice(values) - eye);
    let at_base = world_to_camera * (DVec3::from_slice(base) - eye);
    let lens = ExactLens::of(camera);
    let jacobian = lens.jacobian(t, at_base);
    let q = DVec4::from_slice(&values[3..]).normalize();
    let turn = DMat3::from_quat(DQuat::from_xyzw(q.y, q.z, q.w, q.x));
    let m = world_to_camera * turn * DMat3::from_diagonal(DVec3::from_slice(&values[7..]).exp());
    let sigma = m * m.transpose();
    let [xx, xy, yy] = [(0, 0), (0, 1), (1, 1)].map(|(i, j)| jacobian[i].dot(sigma * jacobian[j]));
    let (xx, yy) = (xx + blur, yy + blur);
    let determinant = xx * yy - xy * xy;
    (lens.pixel(t).to_array(), DVec3::new(yy, -xy, xx) / determinant)
}

/// Holds each of the parts on its own, and of each Gaussian: their gradients are of very different sizes.
fn hold_parts(what: &str, found: &[f32], expected: &[Vec<f64>], each: f64) {
    let count = expected.len();
    let mut first = 0;
    for (name, width) in PARTS {
        let found = &found[first * count..(first + width) * count];
        let exact: Vec<f64> =
            expected.iter().flat_map(|values| values[first..first + width].to_vec()).collect();
        hold(&format!("{what}: {name}"), found, &exact);
        for (index, (a, b)) in found.chunks(width).zip(exact.chunks(width)).enumerate() {
            let size = b.iter().map(|x| x * x).sum::<f64>().sqrt();
            let apart = a.iter().zip(b).map(|(&a, b)| (f64::from(a) - b).powi(2)).sum::<f64>();
            let relative = apart.sqrt() / size.max(1e-6);
            assert!(relative <= each, "{what}: {name} of {index}: {relative:.1e}, {a:?} for {b:?}");
        }
        first += width;
    }
}

#[test]
fn project_backward() {
    for (what, blur, log_scale) in [
        ("usual", 0.3, [-4.0, -1.0]),
        ("no blur", 0.0, [-4.0, -1.0]),
        ("much blur", 100.0, [-4.0, -1.0]),
        ("needles", 0.3, [-9.0, 0.0]),
        ("tiny", 0.3, [-12.0, -8.0]),
    ] {
        let inputs = Inputs::new(blur, log_scale);
        let expected = inputs.expected();
        for (name, device) in everywhere() {
            let (found, _) = inputs.run(&device, 0.0, Vec4::ZERO);
            hold_parts(&format!("{name}, {what}"), &found, &expected, 1e-2);
        }
    }
}

/// Some ratios are clamped on either side, and some are not.
#[test]
fn ratios_are_clamped_and_free() {
    let inputs = Inputs::new(0.3, [-4.0, -1.0]);
    let mut seen = [[0; 3]; 2];
    for camera in 0..3 {
        for gaussian in 0..inputs.gaussian.len() {
            if inputs.pair(camera, gaussian).is_none() {
                continue;
            }
            let view = &inputs.cameras[camera];
            let offset = Vec3::from_slice(&inputs.gaussian[gaussian]) - view.eye;
            for (axis, seen) in seen.iter_mut().enumerate() {
                let ratio = view.rotation[axis].dot(offset) / inputs.depth(camera, gaussian);
                let x = (ratio * view.focal[axis] + view.center[axis]) / view.size[axis];
                seen[if x < -0.15 { 0 } else { usize::from(x > 1.15) + 1 }] += 1;
            }
        }
    }
    assert!(seen.as_flattened().iter().all(|&count| count > 3), "{seen:?}");
}

/// Parts of a batch accumulate, and Gaussians without pairs stay as they are.
#[test]
fn gradients_and_statistics_add_up() {
    let inputs = Inputs::new(0.3, [-4.0, -1.0]);
    for (name, device) in everywhere() {
        let (once, _) = inputs.run(&device, 0.0, Vec4::ZERO);
        let (added, statistics) = inputs.run(&device, 2.0, Vec4::new(1.0, 2.0, 20.0, 7.0));
        for (once, added) in once.iter().zip(&added) {
            assert_eq!(2.0 + once, *added, "{name}");
        }
        for (gaussian, found) in statistics.iter().enumerate() {
            let count = inputs.gaussian.len();
            let mut expected = Vec4::new(1.0, 2.0, 20.0, 7.0);
            for camera in 0..3 {
                if let Some(pair) = inputs.pair(camera, gaussian) {
                    let [geometry, ..] = inputs.pair_gradient[pair];
                    expected.x += geometry.truncate().truncate().length();
                    expected.y += 1.0;
                    expected.z = expected.z.max(inputs.radius[camera * count + gaussian]);
                }
            }
            let apart = (*found - expected).abs().max_element();
            assert!(apart <= 1e-6, "{name}: {found} for {expected}");
        }
    }
}
