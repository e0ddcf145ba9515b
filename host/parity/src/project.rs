//! The case of `project`, and cameras for the others.

use glam::{Vec2, Vec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::pinhole::NEAR_PLANE;
use organza_shaders::project::{
    BEHIND, DEGENERATE, ELSEWHERE, EVERYWHERE, ProjectInputs, ProjectParams, WINDOW,
    rotation_columns,
};

use super::exact::numeric::dot;
use super::exact::project::{Gaussian, NEAR, Projected, View, cutoff, project};

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

/// The projection of a Gaussian in a camera, or the negative radius that says why there is none.
type Fate = std::result::Result<Projected<Rounded>, f32>;

case!(pub Project(ProjectInputs) {
    /// The cameras.
    pub cameras: Vec<Camera>,
});

impl Project {
    fn new(n: u32, fill: Fill, blur: f32, log_scale: [f32; 2], random: &mut Random) -> Self {
        let len = n as usize;
        let cameras = cameras(random);
        let slots = cameras.len() * len;
        let inputs = ProjectInputs {
            params: ProjectParams { gaussians: n, blur },
            camera: cameras.iter().flat_map(Camera::pack).collect(),
            window: EVERYWHERE.repeat(cameras.len()),
            position: fill.values(random, 3 * len, [-2.0, 2.0], 1e30),
            rotation: fill.values(random, 4 * len, [-1.0, 1.0], 1e15),
            log_scale: fill.values(random, 3 * len, log_scale, 1e30),
            projection: unwritten(2 * slots),
            degenerate: vec![0],
        };
        let mut set = Self { inputs, cameras };
        for gaussian in 0..len {
            let rotation = &mut set.rotation[4 * gaussian..][..4];
            if Vec4::from_slice(rotation).as_dvec4().length() < 1e-12 {
                // zero is the only length that a rotation must not have
                rotation.copy_from_slice(&random.values(4, 0.1, 1.0));
            }
            let cameras = 0..set.cameras.len();
            while cameras.clone().any(|at| set.is_undecided(at, gaussian)) {
                set.position[3 * gaussian..][..3].copy_from_slice(&random.values(3, -2.0, 2.0));
                set.log_scale[3 * gaussian..][..3].copy_from_slice(&random.values(3, -5.0, 0.0));
            }
        }
        set
    }

    /// Whether rounding decides if a Gaussian is visible, or if an f32 overflows.
    fn is_undecided(&self, camera: usize, gaussian: usize) -> bool {
        let is_large = |x: f64| (1e35..1e42).contains(&x.abs());
        let Gaussian { log_scale, .. } = self.gaussian(gaussian);
        // far beyond f32 they are all the same
        let log_scale = log_scale.map(|x| Rounded::exact(x.value.clamp(-200.0, 200.0)));
        let limited = Gaussian { log_scale, ..self.gaussian(gaussian) };
        let view = View::from_camera(&self.cameras[camera]);
        let [x, y, z] = view.place(limited.position);
        if z.is_above(NEAR).is_none() || [x, y, z].iter().any(|x| is_large(x.value)) {
            return true;
        }
        let Some(found) = project(&view, self.params.blur.into(), &limited) else { return false };
        let [xx, _, yy] = found.covariance.map(Number::value);
        let determinant = found.determinant.value;
        let longest = limited.axes().into_iter().map(Number::value).fold(0.0, f64::max);
        let stretch = found.jacobian.as_flattened().iter().map(|x| x.value.abs());
        let stretch = stretch.fold(0.0, f64::max);
        let sizes = [longest, stretch * longest, (stretch * longest).powi(2)];
        let sizes = sizes.into_iter().chain([xx, yy, xx * xx, yy * yy, determinant]);
        let sizes = sizes.chain([1.0 / determinant]).chain(found.conic().map(Number::value));
        sizes.chain(found.mean.map(Number::value)).any(is_large) || determinant < 1e-34
    }

    /// The sets without a window: each Gaussian may lie anywhere in its images.
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
        set.window = [260.0, 180.0, 300.0, 240.0].repeat(set.cameras.len());
        set
    }

    /// Gaussians at the near plane, before and behind it, where depths are exact and rounding decides nothing.
    fn on_near_plane() -> Self {
        let mut set = Self::new(ITEMS, Fill::Random, 0.3, [-5.0, 0.0], &mut Random::new(42));
        set.cameras.truncate(1);
        set.cameras[0].eye = Vec3::ZERO;
        set.camera = set.cameras[0].pack().to_vec();
        set.window.truncate(WINDOW);
        set.projection.truncate(2 * ITEMS as usize);
        for (index, depth) in set.position.iter_mut().skip(2).step_by(3).enumerate() {
            *depth = [NEAR_PLANE.next_down(), NEAR_PLANE, NEAR_PLANE.next_up()][index % 3];
        }
        set
    }

    /// Two of three pairs of a camera and a Gaussian, as `camera * gaussians + gaussian`.
    pub(super) fn some_slots(&self, random: &mut Random) -> Vec<u32> {
        let slots = 0..self.cameras.len() as u32 * self.params.gaussians;
        slots.filter(|_| random.below(3) > 0).collect()
    }

    /// The camera and the Gaussian of `camera * gaussians + gaussian`.
    pub(super) fn slot(&self, slot: u32) -> (View<Rounded>, usize) {
        let camera = &self.cameras[(slot / self.params.gaussians) as usize];
        (View::from_camera(camera), (slot % self.params.gaussians) as usize)
    }

    /// A Gaussian.
    pub fn gaussian(&self, gaussian: usize) -> Gaussian<Rounded> {
        Gaussian::read(&self.position, &self.rotation, &self.log_scale, gaussian)
    }

    /// The projection of a Gaussian; `None` if rounding decides whether it ends before the window, or if the kernel's numbers may
    /// overflow.
    pub(super) fn fate(&self, camera: usize, gaussian: usize) -> Option<Fate> {
        let view = View::from_camera(&self.cameras[camera]);
        let gaussian = self.gaussian(gaussian);
        let Some(found) = project(&view, self.params.blur.into(), &gaussian) else {
            return Some(Err(BEHIND));
        };
        let [xx, xy, yy] = found.covariance;
        let numbers = [found.mean[0], found.mean[1], xx, xy, yy];
        let is_f32 = |x: &Rounded| x.value.abs() <= f64::from(f32::MAX);
        if !numbers.iter().all(is_f32) || found.determinant.value <= 0.0 {
            return Some(Err(DEGENERATE));
        }
        if self.window[..WINDOW] != EVERYWHERE && self.ends_before_the_window(&gaussian, &found)? {
            return Some(Err(ELSEWHERE));
        }
        // the determinant has squares of these
        (xx.value.max(yy.value) < 1e15).then_some(Ok(found))
    }

    /// Whether the longest axis does not reach from a Gaussian's center to the window; `None` if rounding decides.
    fn ends_before_the_window(
        &self,
        gaussian: &Gaussian<Rounded>,
        found: &Projected<Rounded>,
    ) -> Option<bool> {
        let window = [0, 1, 2, 3].map(|at| Rounded::from(self.window[at]));
        let zero = Rounded::exact(0.0);
        let outside = |axis: usize| {
            let x = found.mean[axis];
            (window[axis] - x).max(x - window[axis + 2]).max(zero)
        };
        let [dx, dy] = [outside(0), outside(1)];
        let [across, down] = found.jacobian.map(|row| dot(row, row));
        let longest = gaussian.axes().into_iter().fold(zero, Number::max);
        let max = (across + down) * longest * longest + self.params.blur.into();
        let reach = Rounded::from(1.02 * cutoff()) * max + 0.02.into();
        (dx * dx + dy * dy - reach).is_above(0.0)
    }
}

impl Parity for Project {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = Self::everywhere();
        sets.push(("in a window".into(), Self::in_a_window()));
        sets
    }

    /// A negative radius says why there is none: it is a class, which must be equal.
    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        let mut radii: Vec<_> = outputs[0].values.iter_mut().skip(2).step_by(8).collect();
        let classes = Output::exact("class", radii.iter().map(|radius| -radius.min(0.0)));
        radii.iter_mut().for_each(|radius| **radius = radius.max(0.0));
        outputs.push(classes);
        outputs
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let gaussians = self.params.gaussians as usize;
        let slots = (0..self.cameras.len() * gaussians)
            .map(|slot| self.fate(slot / gaussians, slot % gaussians));
        if output == "degenerate" {
            let known: Option<Vec<_>> = slots.collect();
            let count = |fates: Vec<_>| {
                fates.iter().filter(|fate| matches!(fate, Err(DEGENERATE))).count() as u32
            };
            return listed([known.map_or(Rounded::UNKNOWN, |fates| count(fates).into())]);
        }
        let of = |fate: Option<Fate>| match (output, fate) {
            ("class", Some(fate)) => vec![(-fate.err().unwrap_or_default()).into()],
            ("class", None) => vec![Rounded::UNKNOWN],
            (_, Some(Ok(found))) => {
                let [x, y] = found.mean;
                let [xx, xy, yy] = found.conic();
                let [width, height] = found.extent();
                vec![x, y, found.radius(), width, xx, xy, yy, height]
            }
            (_, Some(Err(_))) => vec![Rounded::exact(0.0); 8],
            (_, None) => vec![Rounded::UNKNOWN; 8],
        };
        listed(slots.flat_map(of))
    }
}
