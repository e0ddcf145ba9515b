//! How often a step waits for the device.

use organza::Renderer;
use organza::train::{CHECKPOINT, Checkpoint, TrainConfig, Trainer, built_in};
use organza_tests::devices;

use crate::runs::{TINY, sandbox};

/// What a scene's tensors have, as bits.
fn bits(checkpoint: &Checkpoint) -> Vec<Vec<u32>> {
    let tensors = checkpoint.scene.tensors();
    tensors.iter().map(|(_, values)| values.iter().map(|value| value.to_bits()).collect()).collect()
}

#[test]
fn a_step_waits_once_and_that_changes_nothing() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
    let config = TrainConfig::load(sandbox.path("run/config.toml")).expect("settings");
    let checkpoint = Checkpoint::load(sandbox.path("run").join(CHECKPOINT)).expect("a checkpoint");
    let cpu = Renderer::new(devices::cpu(None));
    let (views, side) = (config.data.built_in_views, config.data.built_in_side);
    let dataset = built_in::dataset(&cpu, views, side, config.data.hold_out_every, &|_, _| {});
    let dataset = dataset.expect("views");
    let frames = || dataset.train.iter().map(|&index| &dataset.frames[index]).collect();
    for (name, device) in devices::all() {
        let renderer = Renderer::new(device);
        let device = renderer.device();
        let mut trainer =
            Trainer::new(&renderer, &config, frames(), &checkpoint).expect("a trainer");
        let mut waits = Vec::new();
        for _ in 0..4 {
            let before = device.waits();
            trainer.step().expect("a step");
            waits.push(device.waits() - before);
        }
        match device.backend() {
            "cpu" => assert_eq!(waits, [0; 4]),
            // the first one learns how much room there must be
            _ => assert!(waits[0] > 1 && waits[1..] == [1; 3], "{name}: {waits:?}"),
        }
        // every step the first one of a device
        let mut state = checkpoint.clone();
        for _ in 0..4 {
            let (_, device) =
                devices::all().into_iter().find(|(other, _)| *other == name).expect("it was there");
            let renderer = Renderer::new(device);
            let mut trainer =
                Trainer::new(&renderer, &config, frames(), &state).expect("a trainer");
            trainer.step().expect("a step");
            state = trainer.checkpoint(0.0).expect("a state");
        }
        let found = trainer.checkpoint(0.0).expect("a state");
        assert_eq!(found.progress.step, state.progress.step);
        assert!(bits(&found) == bits(&state), "{name}");
    }
}
