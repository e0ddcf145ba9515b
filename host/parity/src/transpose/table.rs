//! The rows whose slopes are differences, and what they need to say.

use glam::Vec4;
use muslin_check::prelude::*;
use muslin_check::{assert_transpose, devices};
use muslin_device::Device;

/// A backward kernel beside its forward kernel, with the inputs of its case.
pub trait Row: Parity {
    /// The largest difference that is allowed, as a part of the terms' sizes.
    const ALLOWED: f64 = 1e-4;
    /// How far the inputs are moved, as a part of their direction.
    const STEP: f64 = 1.0 / 64.0;

    /// Whether a set is one that this row can take.
    fn is_usual(&self, name: &str) -> bool {
        name.starts_with("random") && !name.contains(" 0 items")
    }

    /// The numbers that are differentiated.
    fn point(&self) -> Vec<f32>;

    /// How far a number moves at most: 0 for one that the backward kernel holds constant.
    fn reach(&self, index: usize) -> f64 {
        let _ = index;
        1.0
    }

    /// The outputs of the forward kernel for these numbers.
    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64>;

    /// u: the derivatives by what the forward kernel makes.
    fn slopes(&self) -> Vec<f64>;

    /// Sets an element of u to 0, where the forward kernel has a kink or a jump.
    fn leave_out(&mut self, output: usize) {
        panic!("`{}` has no kinks, but output {output} has one", Self::KERNEL);
    }

    /// J^T u, of what the case's kernel gives.
    fn gradient(&self, cpu: &Device) -> Vec<f64>;
}

/// An output of a case on the CPU.
pub fn output<P: Parity>(cpu: &Device, set: &P, name: &str) -> Vec<f64> {
    let outputs = set.run(&KernelRunner::new(cpu, P::KERNEL)).expect("the kernel runs");
    let found = outputs.iter().find(|output| output.name == name);
    found.unwrap_or_else(|| panic!("`{}` has no output `{name}`", P::KERNEL)).to_f64()
}

pub fn wide(values: impl IntoIterator<Item = f32>) -> Vec<f64> {
    values.into_iter().map(f64::from).collect()
}

pub fn flat(vectors: &[Vec4]) -> impl Iterator<Item = f32> {
    vectors.iter().flat_map(Vec4::to_array)
}

pub fn vectors(numbers: &[f32]) -> Vec<Vec4> {
    numbers.chunks_exact(4).map(Vec4::from_slice).collect()
}

/// Differences of the forward kernel along v, over one step and over two.
fn differences<R: Row>(set: &R, cpu: &Device, point: &[f32], v: &[f64]) -> [Vec<f64>; 2] {
    [1.0, 2.0].map(|steps| {
        let step = steps * R::STEP;
        let at = |step: f64| -> Vec<f64> {
            let moved = point.iter().zip(v).map(|(&x, v)| (f64::from(x) + step * v) as f32);
            set.forward(cpu, &moved.collect::<Vec<_>>())
        };
        let ahead = at(step);
        let behind = at(-step);
        ahead.iter().zip(behind).map(|(a, b)| (a - b) / (2.0 * step)).collect()
    })
}

/// Checks all usual sets of a row.
pub fn compare<R: Row>() {
    let cpu = devices::cpu(None);
    let sets: Vec<_> = R::sets().into_iter().filter(|(name, set)| set.is_usual(name)).collect();
    assert!(!sets.is_empty(), "`{}` has no usual sets", R::KERNEL);
    for (name, mut set) in sets {
        let point = set.point();
        let mut random = Random::new(point.len() as u64);
        let v: Vec<_> = (0..point.len())
            .map(|index| f64::from(random.between(-1.0, 1.0)) * set.reach(index))
            .collect();
        let [one, two] = differences(&set, &cpu, &point, &v);
        let mean = one.iter().map(|x| x.abs()).sum::<f64>() / one.len() as f64;
        // a smooth output's slope hardly depends on the step
        let is_smooth = |(one, two): (&f64, &f64)| (one - two).abs() <= 0.05 * (mean + one.abs());
        let kinks: Vec<_> = one.iter().zip(&two).map(is_smooth).collect();
        let left_out = (0..kinks.len()).filter(|&output| !kinks[output]).collect::<Vec<_>>();
        assert!(4 * left_out.len() <= one.len(), "{name}: most outputs have kinks");
        left_out.into_iter().for_each(|output| set.leave_out(output));
        // Richardson's extrapolation: what is left is of the fourth order
        let found: Vec<_> = one.iter().zip(&two).map(|(a, b)| (4.0 * a - b) / 3.0).collect();
        let name = format!("{}, {name}", R::KERNEL);
        assert_transpose(&name, [&found, &set.slopes()], [&v, &set.gradient(&cpu)], R::ALLOWED);
    }
}

/// A test for each row.
macro_rules! table {
    ($($test:ident: $row:ty;)*) => {$(
        #[test]
        fn $test() {
            compare::<$row>();
        }
    )*};
}

table! {
    expose: crate::exposure::ExposeBackward;
    color_head: crate::color_backward::ColorHeadBackward;
    color_inputs: crate::color_backward::MaterialBackward;
    segment_product: crate::transmittance_backward::SegmentProductBackward;
    transmittance_inputs: crate::transmittance_backward::ExtraBackward;
    gaussians_of_pairs: crate::pair::PairSum;
    dense_weights: crate::dense_backward::DenseWeightBackward;
    project: crate::project_backward::ProjectBackward;
    camera_of_project: crate::pose_backward::PoseBackward;
    splat: crate::splat::SplatBackward;
    ssim_rows: crate::ssim::SsimRowsBackward;
    loss: crate::loss::LossGradient;
    composite: crate::composite_backward::CompositeBackward;
}
