//! Steps that do not fit into memory.

use organza::train::{CHECKPOINT, Checkpoint, TrainConfig, Trainer, built_in};
use organza::{Device, Error, Renderer, Result};
use organza_tests::devices;

use crate::runs::{TINY, sandbox};

/// What a step leaves, as bits.
fn bits(state: &Checkpoint) -> Vec<Vec<u32>> {
    let [first, second] = &state.moments;
    let scenes = [&state.scene, first, second];
    let values = scenes.into_iter().flat_map(|scene| scene.tensors());
    let mut bits: Vec<Vec<u32>> =
        values.map(|(_, values)| values.iter().map(|value| value.to_bits()).collect()).collect();
    bits.push(state.statistics.iter().flatten().map(|value| value.to_bits()).collect());
    bits
}

#[test]
fn a_step_that_does_not_fit_goes_in_parts() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
    let config = TrainConfig::load(sandbox.path("run/config.toml")).expect("settings");
    let checkpoint = Checkpoint::load(sandbox.path("run").join(CHECKPOINT)).expect("a checkpoint");
    let cpu = Renderer::new(devices::cpu(None));
    let (views, side) = (config.data.built_in_views, config.data.built_in_side);
    let dataset = built_in::dataset(&cpu, views, side, config.data.hold_out_every, &|_, _| {});
    let dataset = dataset.expect("views");
    let step = |renderer: &Renderer, refuse: &dyn Fn(&Device)| -> Result<Vec<Vec<u32>>> {
        let frames = dataset.train.iter().map(|&index| &dataset.frames[index]).collect();
        let mut trainer = Trainer::new(renderer, &config, frames, &checkpoint)?;
        refuse(renderer.device());
        trainer.step()?;
        Ok(bits(&trainer.checkpoint(0.0)?))
    };
    for (name, device) in devices::all() {
        let renderer = Renderer::new(device);
        let in_parts_of = |bytes: u64| renderer.clone().with_part_bytes(bytes);
        let whole = step(&renderer, &|_| {}).expect("a step");
        // the largest parts that are not the whole
        let in_parts = (0..30)
            .map(|halvings| step(&in_parts_of((512 << 20) >> halvings), &|_| {}).expect("a step"))
            .find(|bits| *bits != whole)
            .expect("sums in another order");
        let (mut split, mut refused) = (0, 0);
        for number in (1..).step_by(4) {
            let renderer = in_parts_of(512 << 20);
            let found = step(&renderer, &|device| {
                device.refuse_one(number);
            });
            if renderer.device().refuse_one(0) {
                // there were not so many
                break;
            }
            match found {
                Ok(bits) => {
                    split += 1;
                    assert!(bits == in_parts, "{name}: buffer {number}");
                }
                // what is not a part's: the scene, when it is read
                Err(Error::OutOfMemory { .. }) => refused += 1,
                Err(error) => panic!("{name}: buffer {number}: {error}"),
            }
        }
        assert!(split > 10 && split > 2 * refused, "{name}: {split} and {refused}");
    }
}
