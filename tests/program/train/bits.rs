//! The same settings give the same bits, also where a step waits less, or goes in parts.

use std::fs;

use organza::data::Background;
use organza::train::config::LearnExposure;
use organza::train::{CHECKPOINT, Checkpoint, TrainConfig, Trainer};
use organza::{Device, DeviceOptions, Renderer, Result, SpirvPath};
use organza_tests::devices;

use super::runs::{TINY, assert_same, assert_same_run, begun, bits, sandbox, state_bits};

#[test]
fn the_same_settings_give_the_same_bits_on_any_number_of_threads() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} one --threads 1")).assert_ok();
    sandbox.run(&format!("{TINY} two --threads 2")).assert_ok();
    sandbox.run("train --config one/config.toml --backend cpu -o again").assert_ok();
    assert_same_run(&sandbox, "two", "one");
    assert_same_run(&sandbox, "again", "one");
    assert_eq!(sandbox.text("again/config.toml"), sandbox.text("one/config.toml"));
    let read = |name: &str| TrainConfig::load(sandbox.path(name)).expect("settings");
    let mut given = read("tiny.toml");
    // settings that come from the data set are written
    given.data.path = Some(sandbox.path("views"));
    given.data.background = Background::Color([0.0; 3]);
    given.exposure.learn = LearnExposure::Off;
    assert_eq!(read("one/config.toml"), given);
}

#[test]
fn a_run_by_minutes_repeats_from_its_settings() {
    let sandbox = sandbox();
    // The first schedule, and those after the steps 1, 2 and 4 at least. A slow machine needs more time for them.
    let config = ["0.01", "0.1", "1"].into_iter().find_map(|minutes| {
        let _ = fs::remove_dir_all(sandbox.path("one"));
        sandbox.run(&format!("{TINY} one --minutes {minutes}")).assert_ok();
        let config = TrainConfig::load(sandbox.path("one/config.toml")).expect("settings");
        (config.run.schedule.len() >= 4).then_some(config)
    });
    let config = config.expect("four schedules");
    sandbox.run("train --config one/config.toml --backend cpu -o again").assert_ok();
    assert_same_run(&sandbox, "again", "one");
    assert_eq!(TrainConfig::load(sandbox.path("again/config.toml")).expect("settings"), config);
    // a fixed number of steps needs no schedule
    sandbox.run("train --config one/config.toml --backend cpu --steps 5 -o five").assert_ok();
    let five = TrainConfig::load(sandbox.path("five/config.toml")).expect("settings");
    assert_eq!((five.run.steps, five.run.schedule.len()), (5, 0));
    // and it goes on for some minutes more
    sandbox.run("train --resume five --minutes 0.01 --backend cpu").assert_ok();
    let longer = TrainConfig::load(sandbox.path("five/config.toml")).expect("settings");
    let checkpoint = Checkpoint::load(sandbox.path("five").join(CHECKPOINT)).expect("a checkpoint");
    assert!(longer.run.steps > 5 && longer.run.schedule[1][0] == 5, "{:?}", longer.run);
    assert_eq!(checkpoint.progress.step, longer.run.steps);
    sandbox.assert_refuses(&format!("{TINY} no --minutes 0"), &["minutes, such as 10"]);
}

#[test]
fn another_seed_gives_another_scene() {
    let sandbox = sandbox();
    let [a, b] = [0, 1].map(|seed| {
        sandbox.run(&format!("{TINY} {seed} --steps 5 --seed {seed}")).assert_ok();
        bits(&sandbox, &seed.to_string())
    });
    let name = "gaussians.position";
    assert_eq!(a[name].0, b[name].0);
    let same = a[name].1.iter().zip(&b[name].1).filter(|(a, b)| a == b).count();
    assert!(same < 6, "{same} of 600 coordinates are the same");
}

#[test]
fn a_gpu_repeats_the_bits() {
    if !devices::has_gpu() {
        return;
    }
    let sandbox = sandbox();
    let [first, second] = ["first", "second"].map(|run| {
        let words = "train views --config tiny.toml --backend gpu --steps 14 -o";
        let said = sandbox.run(&format!("{words} {run}")).assert_ok().stderr;
        let notes = said.matches("`--backend cpu` is faster").count();
        assert_eq!(notes, usize::from(said.contains("llvmpipe")), "{said}");
        bits(&sandbox, run)
    });
    assert!(first["gaussians.opacity"].1.len() > 200, "the scene has grown");
    assert_same("the second run", &second, &first);
}

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
            let before = device.traffic();
            trainer.step().expect("a step");
            waits.push((device.traffic() - before).waits);
        }
        match device.backend() {
            "cpu" => assert_eq!(waits, [0; 4]),
            // the first step determines the sizes of tables
            _ => assert!(waits[0] > 1 && waits[1..] == [1; 3], "{name}: {waits:?}"),
        }
        // every step is the first one on a device
        let mut state = checkpoint.clone();
        for _ in 0..4 {
            let renderer = Renderer::new(devices::named(name));
            let mut trainer = resume(&renderer, &state);
            trainer.step().expect("a step");
            state = trainer.checkpoint(0.0).expect("a state");
        }
        let found = trainer.checkpoint(0.0).expect("a state");
        assert_eq!(found.progress.step, state.progress.step);
        assert!(state_bits(&found) == state_bits(&state), "{name}");
    }
}

/// A software GPU that gets a card's portions, and a trainer on it.
fn on_a_card() -> Option<(Renderer, impl Fn(&Renderer) -> Trainer)> {
    if !devices::has_gpu() {
        return None;
    }
    let (mut config, checkpoint, dataset) = begun();
    // the number of Gaussians changes at steps 10 and 20
    config.run.steps = 40;
    config.exposure.learn = LearnExposure::On;
    let options = DeviceOptions::gpu(SpirvPath::Passthrough).like_a_card(true);
    let renderer = Renderer::new(organza::open_device(&options).expect("a GPU"));
    let trainer = move |renderer: &Renderer| {
        let config = config.clone();
        let dataset = dataset.clone();
        Trainer::resume(renderer, config, dataset, &checkpoint).expect("a trainer")
    };
    Some((renderer, trainer))
}

#[test]
fn a_card_waits_for_no_step_and_gets_no_photograph() {
    let Some((renderer, trainer)) = on_a_card() else { return };
    let mut trainer = trainer(&renderer);
    let run = trainer.config().run.clone();
    let pixels = u64::from(run.tiles_per_step * run.tile_size.pow(2));
    for _ in 0..3 {
        trainer.advance(None, 2).expect("a step");
    }
    let before = renderer.device().traffic();
    trainer.advance(None, 2).expect("a step");
    let step = renderer.device().traffic() - before;
    assert_eq!(step.waits, 0, "{step:?}");
    assert!(step.submissions <= 3 && step.dispatches < 125, "{step:?}");
    // 256 bytes for each dispatch, and what is not 16 bytes a pixel: cameras, tiles and their places
    assert!(step.bytes_up < 256 * step.dispatches + 4 * pixels, "{step:?}");
    // the next one changes the number of Gaussians, and reads all of them at once
    let before = renderer.device().traffic();
    let reports = trainer.advance(None, 2).expect("a step");
    assert!(reports.last().is_some_and(|report| report.densified.is_some()), "{reports:?}");
    assert_eq!((renderer.device().traffic() - before).waits, 1);
}

/// Whatever happens to a step in flight: too little room, memory that ends, or a stop.
#[test]
fn steps_in_flight_have_the_bits_of_single_steps() {
    let Some((renderer, trainer)) = on_a_card() else { return };
    const STEPS: usize = 20;
    let mut one_by_one = trainer(&renderer);
    let mut states = Vec::new();
    let mut losses = Vec::new();
    for _ in 0..STEPS {
        losses.push(one_by_one.step().expect("a step").loss);
        let state = one_by_one.checkpoint(0.0).expect("a state");
        states.push((state_bits(&state), state.exposures.expect("exposures")));
    }
    for ahead in [0, 1, 2, 5] {
        let mut trainer = trainer(&renderer);
        let begin = trainer.steps();
        let mut reports = Vec::new();
        for (step, expected) in states.iter().enumerate() {
            match step % 5 {
                1 => renderer.shrink_predictions(0.5),
                // masks fit, samples do not
                2 if ahead == 1 => renderer.shrink_predictions(0.9),
                3 => drop(renderer.device().refuse_one(10 + 7 * step as u64)),
                _ => {}
            }
            reports.extend(trainer.advance(None, ahead).expect("a step"));
            assert!(reports.len() + ahead > step, "{} reports after step {step}", reports.len());
            if step % 7 == 6 || step + 1 == STEPS {
                renderer.device().refuse_one(0);
                reports.extend(trainer.finish_steps().expect("steps"));
                let found = trainer.checkpoint(0.0).expect("a state");
                assert!(state_bits(&found) == expected.0, "step {step}, {ahead} ahead");
                assert_eq!(found.exposures.expect("exposures"), expected.1, "step {step}");
            }
        }
        let found: Vec<_> = reports.iter().map(|report| report.loss).collect();
        assert_eq!(found, losses, "{ahead} ahead");
        let steps: Vec<_> = reports.iter().map(|report| report.step).collect();
        assert_eq!(steps, (begin + 1..=begin + STEPS as u32).collect::<Vec<_>>());
    }
}

#[test]
fn a_step_in_flight_whose_loss_is_not_finite_changes_nothing() {
    let Some((renderer, trainer)) = on_a_card() else { return };
    let device = renderer.device();
    let mut trainer = trainer(&renderer);
    for _ in 0..4 {
        trainer.advance(None, 2).expect("a step");
    }
    trainer.finish_steps().expect("steps");
    // of all Gaussians, so that each step sees it
    let opacity = &trainer.scene().tensors().gaussians.opacity;
    device.write(opacity, 0, &vec![f32::NAN; opacity.len()]).expect("memory");
    let bits = |trainer: &Trainer| {
        let scene = trainer.scene().download(device).expect("a scene");
        let values = scene.tensors().into_iter().flat_map(|(_, values)| values.to_vec());
        values.map(f32::to_bits).collect::<Vec<_>>()
    };
    let before = bits(&trainer);
    let step = trainer.steps();
    let mut error = None;
    for _ in 0..4 {
        if let Err(found) = trainer.advance(None, 2) {
            error.get_or_insert(found);
        }
    }
    let error = error.expect("an error").to_string();
    assert!(error.contains(&format!("the loss of step {step} is NaN")), "{error}");
    let _ = trainer.finish_steps();
    assert_eq!(trainer.steps(), step);
    assert!(bits(&trainer) == before);
}

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
                // parts end between cameras, so they give the bits of the whole step
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
