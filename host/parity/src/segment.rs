//! The case of `segment`.

use glam::{DVec3, Vec3};
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::segment::{SEGMENT_VECTORS, SegmentInputs, SegmentParams};
use organza_shaders::unit_cube::SceneBox;

use super::color::BOXES;
use super::exact::segment::{contracted_ray, segment};
use super::exact::unit_cube::unit;
use super::project;

/// Rays up to this size have coordinates of two f32.
const NEAR: f64 = 8.0;

// the cameras and the box that the inputs are made of
case!(pub Segment(SegmentInputs) { cameras: Vec<Camera>, aabb: [[f64; 3]; 2] });

impl Segment {
    fn new(
        pairs: u32,
        fill: Fill,
        step: f32,
        (aabb, is_contracted): ([[f64; 3]; 2], bool),
        random: &mut Random,
    ) -> Self {
        let gaussians = 60;
        let mut cameras = project::cameras(random);
        let middle = [0, 1, 2].map(|axis| ((aabb[0][axis] + aabb[1][axis]) / 2.0) as f32);
        // one within the box
        cameras[1].eye = Vec3::from_array(middle) + Vec3::splat(0.013);
        let position = (0..3 * gaussians).map(|at| {
            let axis = at as usize % 3;
            let low = aabb[0][axis] as f32;
            let high = aabb[1][axis] as f32;
            // far behind the box, and beside it
            let far = [0.0, 0.0, 3.0, 100.0][at as usize / 3 % 4];
            let margin = if is_contracted { far } else { 0.3 } * (high - low);
            fill.values(random, 1, [low - margin, high + margin], 1e30)[0]
        });
        let inputs = SegmentInputs {
            params: SegmentParams { pairs: 0, gaussians, step, contracted: is_contracted.into() },
            pair: Vec::new(),
            camera: cameras.iter().flat_map(Camera::pack).collect(),
            scene_box: SceneBox::new(aabb, is_contracted).pack().to_vec(),
            position: position.collect(),
            segment: Vec::new(),
            count: Vec::new(),
        };
        let mut set = Self { inputs, cameras, aabb };
        let slots = 0..gaussians * set.cameras.len() as u32;
        let decided: Vec<u32> = slots.filter(|&slot| !set.is_undecided(slot)).collect();
        let pairs = if decided.is_empty() { 0 } else { pairs };
        let some = |_| decided[random.below(decided.len() as u32) as usize];
        set.params.pairs = pairs;
        set.pair = (0..pairs).map(some).collect();
        set.segment = unwritten((SEGMENT_VECTORS * pairs) as usize);
        set.count = unwritten(pairs as usize);
        set
    }

    fn is_contracted(&self) -> bool {
        self.params.contracted == 1
    }

    fn step(&self) -> f64 {
        self.params.step.into()
    }

    /// The place of a pair's Gaussian.
    fn position(&self, slot: u32) -> [f32; 3] {
        let gaussian = (slot % self.params.gaussians) as usize;
        self.inputs.position.as_chunks().0[gaussian]
    }

    /// A pair's Gaussian and camera in the unit cube's space.
    fn ends(&self, slot: u32) -> [[Rounded; 3]; 2] {
        let eye = self.cameras[(slot / self.params.gaussians) as usize].eye.to_array();
        [self.position(slot), eye]
            .map(|point| unit(point.map(Rounded::from), self.aabb, self.is_contracted()))
    }

    /// Whether rounding decides on the steps of a pair.
    fn is_undecided(&self, slot: u32) -> bool {
        let [p, eye] = self.ends(slot);
        let count = match self.is_contracted() {
            true => contracted_ray(p, eye, self.step()).count,
            false => segment(p, eye, self.step()).count,
        };
        count.error > 0.0
    }

    /// The values of an output. `place` gives the tolerance of a coordinate, for a ray that is not contracted and has this size.
    fn known(&self, output: &str, place: impl Fn(Rounded, f64) -> Rounded) -> Vec<Option<Rounded>> {
        let of = |&slot: &u32| {
            let [p, eye] = self.ends(slot);
            let (count, values) = if self.is_contracted() {
                let ray = contracted_ray(p, eye, self.step());
                let [a, b, c] = ray.foot;
                let [d, e, f] = ray.direction;
                let [begin, end] = ray.ends;
                let known = [a, b, c, ray.factor, d, e, f, ray.radius, begin, end - begin];
                (
                    ray.count,
                    [&known[..], &[0.into(); 5], &[Rounded::exact(ray.count.value)]].concat(),
                )
            } else {
                let found = segment(p, eye, self.step());
                let [from, to] = [p, eye].map(|end| DVec3::from(end.map(|x| x.value)));
                let size = 1.0 + from.length() + from.distance(to);
                let [[a, b, c], [d, e, f]] =
                    [found.start, found.w].map(|of| of.map(|x| place(x, size)));
                (
                    found.count,
                    vec![a, b, c, found.factor, d, e, f, Rounded::exact(found.count.value)],
                )
            };
            if output == "count" { vec![Rounded::exact(count.value)] } else { values }
        };
        listed(self.pair.iter().flat_map(of))
    }
}

impl Parity for Segment {
    fn sets() -> Vec<(String, Self)> {
        let first = (BOXES[0], false);
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, fill, 0.013, first, random));
        let new =
            |step, space, seed| Self::new(ITEMS, Fill::Random, step, space, &mut Random::new(seed));
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [1.7, 0.1, 0.004] {
                sets.push((format!("step {step}, box {index}"), new(step, (aabb, false), 31)));
            }
        }
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [0.3, 0.03] {
                let name = format!("contracted, step {step}, box {index}");
                sets.push((name, new(step, (aabb, true), 34)));
            }
        }
        // steps are capped
        sets.push(("step 1e-6".into(), new(1e-6, first, 32)));
        let mut set = new(0.1, first, 33);
        let eye = set.cameras[0].eye.to_array();
        set.position[..3].copy_from_slice(&eye);
        set.pair.fill(0);
        sets.push(("Gaussian at the camera".into(), set));
        sets
    }

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        if !self.is_contracted() {
            // coarse and fine parts: s and `s_factor`, w and K
            let (segments, _) = outputs[0].values.as_chunks::<16>();
            let sums = segments.iter().flat_map(|of| (0..8).map(|at| of[at] + of[at + 8]));
            outputs[0].values = sums.collect();
        }
        outputs
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        self.known(output, |x, size| match size < NEAR {
            true => Rounded::within(x.value, 2e-9 * size + f64::from(TINY)),
            false => x,
        })
    }

    /// Places on a ray are one f32.
    fn exact_regrouped(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        self.known(output, |x, _| x)
    }
}
