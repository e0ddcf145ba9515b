//! The case of `project`, and cameras for the others.

use glam::{DVec3, DVec4, Vec2, Vec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::pinhole::NEAR_PLANE;
use organza_shaders::project::{
    BEHIND, DEGENERATE, ELSEWHERE, EVERYWHERE, FALLOFF_CUTOFF, ProjectKernel, ProjectParams,
    WINDOW, rotation_columns,
};

use super::exact::project::{Gaussian, Projected, View, project};

/// Three cameras around the origin, the first of them axis-parallel.
pub fn cameras(random: &mut Random) -> Vec<Camera> {
    let camera = |index: u32, random: &mut Random| {
        let q = Vec4::from_slice(&random.values(4, 0.1, 1.0));
        let axes = rotation_columns(if index == 0 { Vec4::X } else { q });
        Camera {
            rotation: axes,
            eye: axes[2] * -random.between(2.5, 5.0) + Vec3::splat(0.1),
            focal: Vec2::from_slice(&random.values(2, 90.0, 900.0)),
            center: Vec2::new(310.0, 245.5),
            size: Vec2::new(640.0, 480.0),
        }
    };
    (0..3).map(|index| camera(index, random)).collect()
}

/// Inputs of `project`.
#[derive(Clone)]
pub struct Project {
    pub(super) gaussians: u32,
    pub(super) blur: f32,
    /// The cameras.
    pub cameras: Vec<Camera>,
    /// The part of their images that is needed.
    window: [f32; WINDOW],
    pub(super) position: Vec<f32>,
    pub(super) rotation: Vec<f32>,
    pub(super) log_scale: Vec<f32>,
}

impl Project {
    fn new(n: u32, fill: Fill, blur: f32, log_scale: [f32; 2], random: &mut Random) -> Self {
        let len = n as usize;
        let mut set = Self {
            gaussians: n,
            blur,
            cameras: cameras(random),
            window: EVERYWHERE,
            position: fill.values(random, 3 * len, [-2.0, 2.0], 1e30),
            rotation: fill.values(random, 4 * len, [-1.0, 1.0], 1e15),
            log_scale: fill.values(random, 3 * len, log_scale, 1e30),
        };
        for gaussian in 0..len {
            if set.quaternion(gaussian).length() < 1e-12 {
                // the one length that a rotation may not have
                set.rotation[4 * gaussian..][..4].copy_from_slice(&random.values(4, 0.1, 1.0));
            }
            let cameras = 0..set.cameras.len();
            while cameras.clone().any(|at| set.sensitivity(at, gaussian).is_undecided) {
                set.position[3 * gaussian..][..3].copy_from_slice(&random.values(3, -2.0, 2.0));
                set.log_scale[3 * gaussian..][..3].copy_from_slice(&random.values(3, -5.0, 0.0));
            }
        }
        set
    }

    /// The sets that need all of their images.
    pub(super) fn everywhere() -> Vec<(String, Self)> {
        let usual = [-5.0, 0.0];
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, fill, 0.3, usual, random));
        for (name, blur, log_scale) in [
            ("no blur", 0.0, usual),
            ("much blur", 100.0, usual),
            ("needles", 0.3, [-14.0, 1.0]),
            ("tiny", 0.3, [-110.0, -30.0]),
            ("large", 0.3, [0.0, 90.0]),
        ] {
            let set = Self::new(ITEMS, Fill::Random, blur, log_scale, &mut Random::new(41));
            sets.push((name.into(), set));
        }
        sets.push(("on the near plane".into(), Self::on_near_plane()));
        sets
    }

    /// Most Gaussians end before the window.
    fn in_a_window() -> Self {
        let random = &mut Random::new(43);
        let mut set = Self::new(20 * ITEMS, Fill::Random, 0.3, [-7.0, -2.0], random);
        set.window = [260.0, 180.0, 300.0, 240.0];
        set
    }

    /// Gaussians at the near plane, before and behind it, where depths are exact and rounding decides nothing.
    fn on_near_plane() -> Self {
        let mut set = Self::new(ITEMS, Fill::Random, 0.3, [-5.0, 0.0], &mut Random::new(42));
        set.cameras.truncate(1);
        set.cameras[0].eye = Vec3::ZERO;
        for (index, depth) in set.position.iter_mut().skip(2).step_by(3).enumerate() {
            *depth = [NEAR_PLANE.next_down(), NEAR_PLANE, NEAR_PLANE.next_up()][index % 3];
        }
        set
    }

    /// Cameras as they lie in a buffer.
    pub(super) fn packed_cameras(&self) -> Vec<f32> {
        self.cameras.iter().flat_map(Camera::pack).collect()
    }

    /// Two of three pairs of a camera and a Gaussian, as `camera * gaussians + gaussian`.
    pub(super) fn some_slots(&self, random: &mut Random) -> Vec<u32> {
        let slots = 0..self.cameras.len() as u32 * self.gaussians;
        slots.filter(|_| random.below(3) > 0).collect()
    }

    /// The camera and the Gaussian of `camera * gaussians + gaussian`.
    pub(super) fn slot(&self, slot: u32) -> (View, usize) {
        let camera = &self.cameras[(slot / self.gaussians) as usize];
        (View::from_camera(camera), (slot % self.gaussians) as usize)
    }

    /// A Gaussian's position.
    pub fn center(&self, gaussian: usize) -> DVec3 {
        Vec3::from_slice(&self.position[3 * gaussian..]).as_dvec3()
    }

    /// A Gaussian's rotation: w, x, y, z.
    pub fn quaternion(&self, gaussian: usize) -> DVec4 {
        Vec4::from_slice(&self.rotation[4 * gaussian..]).as_dvec4()
    }

    /// Logarithms of a Gaussian's axes.
    pub fn log_axes(&self, gaussian: usize) -> DVec3 {
        Vec3::from_slice(&self.log_scale[3 * gaussian..]).as_dvec3()
    }

    /// The projected Gaussian, in f64.
    pub fn gaussian(&self, gaussian: usize) -> Gaussian<f64> {
        Gaussian::read(&self.position, &self.rotation, &self.log_scale, gaussian)
    }

    /// The projection of a Gaussian; `None` where it depends on how far the kernel's numbers reach.
    pub(super) fn fate(&self, camera: usize, gaussian: usize) -> Option<Fate> {
        let view = View::from_camera(&self.cameras[camera]);
        let Some(found) = project(&view, f64::from(self.blur), &self.gaussian(gaussian)) else {
            return Some(Fate::Behind);
        };
        let [xx, xy, yy] = found.covariance;
        let numbers = [found.mean[0], found.mean[1], xx, xy, yy];
        let is_f32 = |x: &f64| x.abs() <= f64::from(f32::MAX);
        if !numbers.iter().all(is_f32) || found.determinant <= 0.0 {
            return Some(Fate::Degenerate);
        }
        if self.window != EVERYWHERE {
            let [far, near] = self.distance_to_window(gaussian, &found);
            // rounding decides
            if (far - near).abs() < 1e-4 * (far + near) {
                return None;
            }
            if far > near {
                return Some(Fate::Elsewhere);
            }
        }
        // the determinant has squares of these
        (xx.max(yy) < 1e15).then_some(Fate::Projected(found))
    }

    /// The squared distance of a Gaussian's center to the window, in pixels, and the one above which it is left out.
    fn distance_to_window(&self, gaussian: usize, found: &Projected<f64>) -> [f64; 2] {
        let [left, top, right, bottom] = self.window.map(f64::from);
        let [x, y] = found.mean;
        let [dx, dy] = [x - x.clamp(left, right), y - y.clamp(top, bottom)];
        let jacobian = found.jacobian.map(|row| DVec3::from(row).length_squared());
        let longest = self.log_axes(gaussian).max_element().exp();
        let most = (jacobian[0] + jacobian[1]) * longest * longest + f64::from(self.blur);
        [dx * dx + dy * dy, 1.02 * f64::from(FALLOFF_CUTOFF) * most + 0.02]
    }

    pub(super) fn sensitivity(&self, camera: usize, gaussian: usize) -> Sensitivity {
        let gaussian = self.limited(gaussian);
        Sensitivity::new(&View::from_camera(&self.cameras[camera]), f64::from(self.blur), &gaussian)
    }

    /// A Gaussian whose axes f64 can multiply: far beyond f32 they are all the same.
    pub(super) fn limited(&self, gaussian: usize) -> Gaussian<f64> {
        let gaussian = self.gaussian(gaussian);
        Gaussian { log_scale: gaussian.log_scale.map(|x| x.clamp(-200.0, 200.0)), ..gaussian }
    }
}

impl Parity for Project {
    const KERNEL: &'static str = "project";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of sums, divisions and square roots of 3 ulp, exp, scaled by \
        how the f64 projection is conditioned; what is culled has zeros; no Gaussian within 1e-5 \
        of the near plane, none whose products overflow on some devices only (1e35 to 1e42)";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = Self::everywhere();
        sets.push(("in a window".into(), Self::in_a_window()));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let windows = self.window.repeat(self.cameras.len());
        let slots = self.cameras.len() * self.gaussians as usize;
        let kernel = ProjectKernel {
            params: ProjectParams { gaussians: self.gaussians, blur: self.blur },
            camera: &self.packed_cameras(),
            window: &windows,
            position: &self.position,
            rotation: &self.rotation,
            log_scale: &self.log_scale,
            projection: &unwritten(2 * slots),
            degenerate: &vec![0],
        };
        let mut outputs = runner.run(&kernel, self.gaussians, self.cameras.len() as u32)?;
        let projection = outputs.remove(0);
        let places = projection.floats().as_chunks::<8>().0;
        let places = places.iter().map(|place| place.map(|x| x as f32));
        let class = |p: [f32; 8]| match p[2] {
            BEHIND => 1,
            DEGENERATE => 2,
            ELSEWHERE => 3,
            radius if radius >= 0.0 => 0,
            _ => 4,
        };
        outputs.extend([
            Output::exact("class", places.clone().map(class).collect()),
            Output::float("mean2d", places.clone().flat_map(|p| [p[0], p[1]])),
            // a negative one is a class
            Output::float("radius", places.clone().map(|p| p[2].max(0.0))),
            Output::float("conic", places.clone().flat_map(|p| [p[4], p[5], p[6]])),
            Output::float("extent", places.flat_map(|p| [p[3], p[7]])),
        ]);
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let gaussians = self.gaussians as usize;
        let slots = (0..self.cameras.len() * gaussians)
            .map(|slot| self.fate(slot / gaussians, slot % gaussians));
        if output == "degenerate" {
            let told: Option<Vec<_>> = slots.collect();
            let is_culled = |fate: &&Fate| matches!(fate, Fate::Degenerate);
            return vec![told.map(|fates| fates.iter().filter(is_culled).count() as f64)];
        }
        let of = |fate: Fate| match (output, fate) {
            ("class", Fate::Projected(_)) => vec![0.0],
            ("class", Fate::Behind) => vec![1.0],
            ("class", Fate::Degenerate) => vec![2.0],
            ("class", Fate::Elsewhere) => vec![3.0],
            ("mean2d", Fate::Projected(found)) => found.mean.to_vec(),
            ("radius", Fate::Projected(found)) => vec![found.radius()],
            ("conic", Fate::Projected(found)) => found.conic().to_vec(),
            (_, Fate::Projected(found)) => found.extent().to_vec(),
            _ => vec![0.0; width(output)],
        };
        let given = |fate: Option<Fate>| match fate {
            Some(fate) => of(fate).into_iter().map(Some).collect(),
            None => vec![None; width(output)],
        };
        slots.flat_map(given).collect()
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let width = width(cpu.name);
        let slot = index / width;
        let part = index % width;
        let gaussians = self.gaussians as usize;
        let sensitivity = self.sensitivity(slot / gaussians, slot % gaussians);
        Bound::relative_to(match cpu.name {
            "radius" | "extent" => sensitivity.radius,
            "mean2d" => sensitivity.mean2d[part],
            _ => sensitivity.conic,
        })
    }
}

/// The projection of a Gaussian in a camera.
pub(super) enum Fate {
    /// It lies behind the near plane.
    Behind,
    /// It has no place, no finite covariance or no inverse of it.
    Degenerate,
    /// It ends before the window.
    Elsewhere,
    /// It lies there.
    Projected(Projected<f64>),
}

/// Values of a slot in an output.
fn width(output: &str) -> usize {
    match output {
        "mean2d" | "extent" => 2,
        "conic" => 3,
        _ => 1,
    }
}

/// How much roundings show in a projection, from f64.
#[derive(Default)]
pub(super) struct Sensitivity {
    /// Whether rounding decides if the Gaussian is visible.
    is_undecided: bool,
    mean2d: [f64; 2],
    pub conic: f64,
    radius: f64,
}

impl Sensitivity {
    fn new(view: &View, blur: f64, gaussian: &Gaussian<f64>) -> Self {
        let offset = DVec3::from(gaussian.position) - DVec3::from(view.eye);
        let above_near = view.place(gaussian.position)[2] - f64::from(NEAR_PLANE);
        let is_near =
            above_near.abs() < 1e-5 * (1.0 + offset.length()) || is_large(offset.length());
        let Some(found) = project(view, blur, gaussian) else {
            return Self { is_undecided: is_near, ..Self::default() };
        };
        let [u, v] = found.footprint.map(DVec3::from);
        let rows = found.jacobian.map(|row| DVec3::from(row).length());
        let t = DVec3::from(found.place);
        let log_axes = DVec3::from(gaussian.log_scale);
        let mut axes = gaussian.axes();
        axes.sort_by(f64::total_cmp);
        // the sizes of the terms of u and v, before they cancel
        let [uu, vv] = rows.map(|row| (row * axes[2]).powi(2));
        let lengths = u.length_squared() + v.length_squared();
        let cross = u.cross(v).length();
        let determinant = cross * cross + blur * (lengths + blur);
        let terms = cross * rows[0] * rows[1] * axes[2] * axes[1] + blur * (uu + vv + blur);
        let conic =
            (uu.max(vv) + blur + (lengths + blur) * (1.0 + terms / determinant)) / determinant;
        // cancellation in t, and the argument of exp
        let depth = 1.0 + offset.length() / t.z;
        let grade = depth * (1.0 + log_axes.abs().max_element().min(200.0));
        let ratio = 1.0 + t.x.abs().max(t.y.abs()) / t.z;
        let mean2d = [0, 1].map(|axis| view.focal[axis] * depth * ratio + 500.0);
        let sizes = [uu, vv, uu * uu, vv * vv, determinant, 1.0 / determinant, conic, axes[2]];
        let overflows = sizes.into_iter().chain(mean2d).any(is_large) || determinant < 1e-34;
        let radius = (uu + vv + blur) / (lengths + blur).sqrt();
        Self {
            is_undecided: is_near || overflows,
            mean2d,
            conic: conic * grade,
            radius: f64::from(FALLOFF_CUTOFF).sqrt() * 2.0 * radius * grade,
        }
    }
}

/// Whether an f32 may overflow on one device and not on another.
fn is_large(x: f64) -> bool {
    (1e35..1e42).contains(&x.abs())
}
