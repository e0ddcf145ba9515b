//! The case of `pair_channels`.

use muslin_check::prelude::*;
use organza_shaders::channels::{PairChannelsInputs, PairChannelsParams};

use super::exact::channels::{depth, normal};
use super::project::Project;

case!(pub PairChannels(PairChannelsInputs) { scene: Project });

impl PairChannels {
    fn new(mut scene: Project) -> Self {
        // a GPU may flush denormals before it compares them
        let flushed = |length: f32| if length.is_subnormal() { 0.0 } else { length };
        scene.log_scale.iter_mut().for_each(|length| *length = flushed(*length));
        let mut random = Random::new(7);
        let pair = scene.some_slots(&mut random);
        let inputs = PairChannelsInputs {
            params: PairChannelsParams {
                pairs: pair.len() as u32,
                gaussians: scene.params.gaussians,
            },
            camera: scene.camera.clone(),
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
}

impl Parity for PairChannels {
    fn sets() -> Vec<(String, Self)> {
        Project::everywhere().into_iter().map(|(name, scene)| (name, Self::new(scene))).collect()
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let of = |(&slot, &transmittance): (&u32, &f32)| {
            let (view, gaussian) = self.scene.slot(slot);
            let gaussian = self.scene.gaussian(gaussian);
            match output {
                "measure" => [depth(&view, &gaussian), transmittance.into(), 0.0.into()],
                _ => normal(&view, &gaussian),
            }
        };
        listed(self.pair.iter().zip(&self.transmittance).flat_map(of))
    }
}
