//! The number of times that a step waits for the device.

use organza::Renderer;
use organza::train::{Checkpoint, Trainer};
use organza_tests::devices;

use super::runs::{begun, state_bits};

#[test]
fn a_step_waits_once_and_that_changes_nothing() {
    let (config, checkpoint, dataset) = begun();
    let resume = |renderer: &Renderer, state: &Checkpoint| {
        Trainer::resume(renderer, config.clone(), dataset.clone(), state).expect("a trainer")
    };
    for (name, device) in devices::all() {
        let renderer = Renderer::new(device);
        let device = renderer.device();
        let mut trainer = resume(&renderer, &checkpoint);
        let mut waits = Vec::new();
        for _ in 0..4 {
            let before = device.waits();
            trainer.step().expect("a step");
            waits.push(device.waits() - before);
        }
        match device.backend() {
            "cpu" => assert_eq!(waits, [0; 4]),
            // the first step determines the sizes of tables
            _ => assert!(waits[0] > 1 && waits[1..] == [1; 3], "{name}: {waits:?}"),
        }
        // every step is the first one on a device
        let mut state = checkpoint.clone();
        for _ in 0..4 {
            let (_, device) =
                devices::all().into_iter().find(|(other, _)| *other == name).expect("it was there");
            let renderer = Renderer::new(device);
            let mut trainer = resume(&renderer, &state);
            trainer.step().expect("a step");
            state = trainer.checkpoint(0.0).expect("a state");
        }
        let found = trainer.checkpoint(0.0).expect("a state");
        assert_eq!(found.progress.step, state.progress.step);
        assert!(state_bits(&found) == state_bits(&state), "{name}");
    }
}
