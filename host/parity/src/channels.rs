//! The case of `pair_channels`.

use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::channels::{PairChannelsKernel, PairChannelsParams};

use super::exact::channels::{depth, normal};
use super::exact::project::View;
use super::project::Project;

/// Inputs of `pair_channels`.
#[derive(Clone)]
pub struct PairChannels {
    /// The Gaussians and the cameras.
    pub scene: Project,
    /// `camera * gaussians + gaussian`
    pub pair: Vec<u32>,
    /// `[pairs]`
    pub transmittance: Vec<f32>,
}

impl PairChannels {
    fn new(mut scene: Project) -> Self {
        // a GPU may flush denormals before it compares them
        let flushed = |length: f32| if length.is_subnormal() { 0.0 } else { length };
        scene.log_scale.iter_mut().for_each(|length| *length = flushed(*length));
        let mut random = Random::new(7);
        let slots = scene.cameras.len() as u32 * scene.gaussians;
        let pair: Vec<_> = (0..slots).filter(|_| random.below(3) > 0).collect();
        let transmittance = random.values(pair.len(), 0.0, 1.0);
        Self { scene, pair, transmittance }
    }

    /// The camera and the Gaussian of a pair.
    fn camera_and_gaussian(&self, pair: usize) -> (View, usize) {
        let slot = self.pair[pair] as usize;
        let gaussians = self.scene.gaussians as usize;
        (View::from_camera(&self.scene.cameras[slot / gaussians]), slot % gaussians)
    }
}

impl Parity for PairChannels {
    const KERNEL: &'static str = "pair_channels";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of a sum of three products, and of a normalized quaternion with a square root of 3 ulp; \
        no normal that is across the ray to within 1e-5, where rounding decides its side";

    fn sets() -> Vec<(String, Self)> {
        let sets = Project::everywhere().into_iter();
        sets.map(|(name, scene)| (name, Self::new(scene))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let packed: Vec<_> = self.scene.cameras.iter().flat_map(Camera::pack).collect();
        let pairs = self.pair.len();
        let kernel = PairChannelsKernel {
            params: PairChannelsParams { pairs: pairs as u32, gaussians: self.scene.gaussians },
            pair: &self.pair,
            camera: &packed,
            position: &self.scene.position,
            rotation: &self.scene.rotation,
            log_scale: &self.scene.log_scale,
            transmittance: &self.transmittance,
            measure: &unwritten(3 * pairs),
            normals: &unwritten(3 * pairs),
        };
        let mut outputs = runner.run(&kernel, pairs as u32, 1)?;
        // a normal across the ray has two sides
        let mut found = outputs[1].floats().to_vec();
        for pair in 0..pairs {
            let (view, gaussian) = self.camera_and_gaussian(pair);
            if normal(&view, &self.scene.gaussian(gaussian)).1 < 1e-5 {
                found[3 * pair..][..3].fill(0.0);
            }
        }
        outputs[1].values = Values::Float(found);
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let of = |pair: usize| {
            let (view, gaussian) = self.camera_and_gaussian(pair);
            let gaussian = self.scene.gaussian(gaussian);
            if output == "measure" {
                let transmittance = f64::from(self.transmittance[pair]);
                return [depth(&view, &gaussian), transmittance, 0.0];
            }
            let (normal, cosine) = normal(&view, &gaussian);
            if cosine < 1e-5 { [0.0; 3] } else { normal }
        };
        (0..self.pair.len()).flat_map(of).map(Some).collect()
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let pair = index / 3;
        if cpu.name == "measure" && !index.is_multiple_of(3) {
            return Bound::EXACT;
        }
        if cpu.name == "normals" {
            return Bound::relative_to(1.0);
        }
        let (view, gaussian) = self.camera_and_gaussian(pair);
        let terms = (0..3).map(|i| {
            let size = self.scene.center(gaussian)[i].abs() + view.eye[i].abs();
            size * view.axes[2][i].abs()
        });
        Bound::relative_to(terms.sum())
    }
}
