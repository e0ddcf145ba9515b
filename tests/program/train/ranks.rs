//! Trainings that ranks share: the same bits for any number of ranks.

use std::sync::Arc;

use organza::ranks::{Ranks, ThreadRanks};
use organza::train::{Checkpoint, TrainConfig, Trainer};
use organza::{Dataset, Error, Renderer};
use organza_tests::devices;

use super::runs::{TINY, assert_same, assert_same_run, begun, bits, sandbox, state_bits};

type Begun = (TrainConfig, Checkpoint, Arc<Dataset>);

/// The state after so many more steps, on one of some ranks or alone.
fn trained(
    (config, checkpoint, dataset): &Begun,
    renderer: &Renderer,
    ranks: Option<ThreadRanks>,
    steps: u32,
) -> Checkpoint {
    let trainer = Trainer::resume(renderer, config.clone(), dataset.clone(), checkpoint);
    let mut trainer = trainer.expect("a trainer");
    if let Some(ranks) = ranks {
        trainer = trainer.with_ranks(Arc::new(ranks));
    }
    for _ in 0..steps {
        trainer.step().expect("a step");
    }
    trainer.checkpoint(0.0).expect("a state")
}

/// A run after nine of 40 steps. It grows after the next one.
fn begun_of_40() -> Begun {
    let mut begun = begun();
    begun.0.run.steps = 40;
    begun.1 = trained(&begun, &Renderer::new(devices::cpu(None)), None, 4);
    assert_eq!(begun.1.progress.step, 9);
    begun
}

/// Four tiles per step are at most four units, so with more ranks, some have no work. Without ranks, they are one
/// part, or several: a part of this size has all tiles of a camera, and at most two cameras.
#[test]
fn any_number_of_ranks_and_parts_gives_the_same_bits_on_every_device() {
    let begun = begun_of_40();
    for (name, _) in devices::all() {
        let renderer = || Renderer::new(devices::named(name));
        let alone = trained(&begun, &renderer(), None, 2);
        assert_eq!(alone.progress.step, 11);
        assert!(alone.scene.gaussians.len() > 200, "{name}: the scene has grown");
        let parts = trained(&begun, &renderer().with_part_bytes(20_000), None, 2);
        assert!(state_bits(&parts) == state_bits(&alone), "{name}: in parts");
        // a software GPU is slow
        let sizes = if name == "cpu" { &[1, 2, 3, 5][..] } else { &[3] };
        for &size in sizes {
            let rank = |ranks| trained(&begun, &renderer(), Some(ranks), 2);
            let states = ThreadRanks::run(size, rank);
            for (rank, state) in states.iter().enumerate() {
                assert!(state_bits(state) == state_bits(&alone), "{name}: rank {rank} of {size}");
            }
        }
    }
}

#[test]
fn a_run_of_ranks_is_one_run() {
    let sandbox = sandbox();
    let run = |name: &str, words: &str| {
        sandbox.run(&format!("{TINY} {name} --steps 24 {words}")).assert_ok();
    };
    run("one", "");
    let pictures = |run: &str| sandbox.contents(&format!("{run}/pictures"));
    run("of-3", "--ranks 3 --threads 1");
    assert_same_run(&sandbox, "of-3", "one");
    assert!(pictures("of-3") == pictures("one"), "the pictures");
    run("exposed", "--set exposure.learn=on");
    run("exposed-of-3", "--set exposure.learn=on --ranks 3 --threads 1");
    assert_same_run(&sandbox, "exposed-of-3", "exposed");
    // stopped, and continued with another number of ranks
    run("other", "--ranks 4 --time-limit 1");
    sandbox.run("train --resume other --ranks 2 --backend cpu").assert_ok();
    assert_same("resumed", &bits(&sandbox, "other"), &bits(&sandbox, "one"));
    sandbox.assert_refuses(&format!("{TINY} no --ranks 0"), &["1 to 64, or `mpi`"]);
    sandbox.assert_refuses(&format!("{TINY} no --mixed"), &["--ranks"]);
}

#[test]
fn a_rank_that_fails_ends_all_with_its_message() {
    let (config, checkpoint, dataset) = begun();
    let mut ranks = ThreadRanks::new(2).into_iter();
    let first = ranks.next().unwrap();
    let second = ranks.next().unwrap();
    let thread = std::thread::spawn(move || second.fail("out of memory"));
    let renderer = Renderer::new(devices::cpu(None));
    let trainer = Trainer::resume(&renderer, config, dataset, &checkpoint).expect("a trainer");
    let mut trainer = trainer.with_ranks(Arc::new(first));
    match trainer.step() {
        Err(Error::Rank { rank: 1, message }) => assert_eq!(message, "out of memory"),
        other => panic!("{other:?}"),
    }
    thread.join().expect("a thread");
}

/// Ranks with different rounding are refused before the first step.
#[test]
fn ranks_of_other_devices_must_be_allowed() {
    let (_, _, dataset) = begun();
    let meet = |mixed: bool| {
        let sets = ["scalar", "best"];
        ThreadRanks::run(2, |ranks| {
            let set = (sets[ranks.rank()] == "scalar").then_some(organza::InstructionSet::Scalar);
            let options = organza::DeviceOptions::cpu(Some(1)).instruction_set(set);
            let renderer = Renderer::new(organza::open_device(&options).expect("a CPU"));
            let ranks: Arc<dyn Ranks> = Arc::new(ranks);
            // rank 0 is not there to lead, so the error comes from here
            organza::train::follow(&renderer, &dataset, &ranks, mixed, None)
                .unwrap_err()
                .to_string()
        })
    };
    let refused = meet(false);
    assert!(
        refused.iter().all(|text| text.contains("scalar") && text.contains("--mixed")),
        "{refused:?}"
    );
    let allowed = meet(true);
    assert!(!allowed.iter().any(|text| text.contains("--mixed")), "{allowed:?}");
}
