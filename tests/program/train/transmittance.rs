//! The steps that train T.

use organza::scene::TensorSpec;
use organza::train::{Checkpoint, Trainer};
use organza::{Renderer, Scene};
use organza_tests::devices;

use super::runs::begun;

/// The names and the bits of a scene's tensors.
fn bits(scene: &Scene) -> Vec<(String, Vec<u32>)> {
    let bits = |(spec, values): (TensorSpec, &[f32])| {
        (spec.name, values.iter().map(|value| value.to_bits()).collect())
    };
    scene.tensors().into_iter().map(bits).collect()
}

/// T moves at every third step alone, and all other tensors at every step.
#[test]
fn t_is_trained_at_every_nth_step() {
    let (mut config, checkpoint, dataset) = begun();
    config.optimizer.transmittance_every = 3;
    let begin = Checkpoint::begin(checkpoint.scene, &config).expect("a start");
    let renderer = Renderer::new(devices::cpu(None));
    let trainer = Trainer::resume(&renderer, config, dataset, &begin);
    let mut trainer = trainer.expect("a trainer");
    let mut before = bits(&begin.scene);
    for step in 0..4 {
        trainer.step().expect("a step");
        let after = bits(&trainer.checkpoint(0.0).expect("a state").scene);
        for (after, before) in after.iter().zip(&before) {
            let name = &after.0;
            let is_of_t = name.starts_with("transmittance") || name == "gaussians.extra";
            let moves = !is_of_t || step % 3 == 0;
            assert_eq!(after != before, moves, "{name} in step {step}");
        }
        before = after;
    }
}
