//! The case of `pair_channels`.

use muslin_check::prelude::*;
use organza_shaders::channels::{PairChannelsInputs, PairChannelsParams};

use super::exact::channels::{depth, normal};
use super::exact::project::{Gaussian, View};
use super::project::Project;

/// The Gaussians and the cameras in f64 come from the scene.
#[derive(Clone)]
pub struct PairChannels {
    scene: Project,
    inputs: PairChannelsInputs,
}

impl PairChannels {
    fn new(mut scene: Project) -> Self {
        // a GPU may flush denormals before it compares them
        let flushed = |length: f32| if length.is_subnormal() { 0.0 } else { length };
        scene.log_scale.iter_mut().for_each(|length| *length = flushed(*length));
        let mut random = Random::new(7);
        let pair = scene.some_slots(&mut random);
        let inputs = PairChannelsInputs {
            params: PairChannelsParams { pairs: pair.len() as u32, gaussians: scene.gaussians },
            camera: scene.packed_cameras(),
            position: scene.position.clone(),
            rotation: scene.rotation.clone(),
            log_scale: scene.log_scale.clone(),
            transmittance: random.values(pair.len(), 0.0, 1.0),
            measure: unwritten(3 * pair.len()),
            normals: unwritten(3 * pair.len()),
            pair,
        };
        Self { scene, inputs }
    }

    /// The camera and the Gaussian of a pair.
    fn view_and_gaussian(&self, pair: usize) -> (View, Gaussian<f64>) {
        let (view, gaussian) = self.scene.slot(self.inputs.pair[pair]);
        (view, self.scene.gaussian(gaussian))
    }
}

impl Parity for PairChannels {
    const KERNEL: &'static str = "pair_channels";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of a sum of three products, and of a normalized quaternion with a square root of 3 ulp; \
        no normal that is across the ray to within 1e-5, where rounding decides its side";

    fn sets() -> Vec<(String, Self)> {
        Project::everywhere().into_iter().map(|(name, scene)| (name, Self::new(scene))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let pairs = self.inputs.pair.len();
        let mut outputs = runner.run(&self.inputs.kernel(), pairs as u32, 1)?;
        // a normal across the ray has two sides
        let mut found = outputs[1].floats().to_vec();
        for pair in 0..pairs {
            let (view, gaussian) = self.view_and_gaussian(pair);
            if normal(&view, &gaussian).1 < 1e-5 {
                found[3 * pair..][..3].fill(0.0);
            }
        }
        outputs[1].values = Values::Float(found);
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let of = |pair: usize| {
            let (view, gaussian) = self.view_and_gaussian(pair);
            if output == "measure" {
                let transmittance = f64::from(self.inputs.transmittance[pair]);
                return [depth(&view, &gaussian), transmittance, 0.0];
            }
            let (normal, cosine) = normal(&view, &gaussian);
            if cosine < 1e-5 { [0.0; 3] } else { normal }
        };
        (0..self.inputs.pair.len()).flat_map(of).map(Some).collect()
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        if cpu.name == "measure" && !index.is_multiple_of(3) {
            return Bound::EXACT;
        }
        if cpu.name == "normals" {
            return Bound::relative_to(1.0);
        }
        let (view, gaussian) = self.view_and_gaussian(index / 3);
        let terms = (0..3).map(|i| {
            let size = gaussian.position[i].abs() + view.eye[i].abs();
            size * view.axes[2][i].abs()
        });
        Bound::relative_to(terms.sum())
    }
}
