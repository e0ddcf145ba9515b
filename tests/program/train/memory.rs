//! Steps that do not fit into memory.

use organza::train::Trainer;
use organza::{Device, Renderer, Result};
use organza_tests::devices;

use super::runs::{begun, state_bits};

#[test]
fn a_step_that_does_not_fit_goes_in_parts() {
    let (config, checkpoint, dataset) = begun();
    let step = |renderer: &Renderer, refuse: &dyn Fn(&Device)| -> Result<Vec<Vec<u32>>> {
        let config = config.clone();
        let dataset = dataset.clone();
        let mut trainer = Trainer::resume(renderer, config, dataset, &checkpoint)?;
        refuse(renderer.device());
        trainer.step()?;
        Ok(state_bits(&trainer.checkpoint(0.0)?))
    };
    for (name, device) in devices::all() {
        let renderer = Renderer::new(device);
        let whole = step(&renderer, &|_| {}).expect("a step");
        let mut split = 0;
        let mut refused = 0;
        for number in (1..).step_by(4) {
            let renderer = renderer.clone().with_part_bytes(512 << 20);
            let found = step(&renderer, &|device| {
                device.refuse_one(number);
            });
            if renderer.device().refuse_one(0) {
                // there were fewer allocations
                break;
            }
            match found {
                // parts end between cameras, so their bits are those of the whole step
                Ok(bits) => {
                    split += 1;
                    assert!(bits == whole, "{name}: buffer {number}");
                }
                // an allocation outside of parts: the scene, when it is read
                Err(error) if error.is_out_of_memory() => refused += 1,
                Err(error) => panic!("{name}: buffer {number}: {error}"),
            }
        }
        assert!(split > 10 && split > 2 * refused, "{name}: {split} and {refused}");
    }
}
