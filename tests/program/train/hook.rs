//! Hooks between a step's gradient and the optimizer.

use std::fs;

use organza::scene::TensorSpec;
use organza::train::{
    CHECKPOINT, Checkpoint, Event, GradientHook, RunFolder, Session, StepGradient, StepHooks,
    Trainer,
};
use organza::{Error, Renderer, Result, Scene};
use organza_tests::devices;

use super::runs::{begun, sandbox, state_bits};

/// The names and the bits of a scene's tensors.
fn bits(scene: &Scene) -> Vec<(String, Vec<u32>)> {
    let bits = |(spec, values): (TensorSpec, &[f32])| {
        (spec.name, values.iter().map(|value| value.to_bits()).collect())
    };
    scene.tensors().into_iter().map(bits).collect()
}

#[test]
fn a_tensor_whose_gradient_is_zeroed_stays_as_it_is() {
    let (mut config, checkpoint, dataset) = begun();
    // weight decay and moments would change it, too
    config.optimizer.transmittance_decay = 0.0;
    let begin = Checkpoint::begin(checkpoint.scene, &config).expect("a start");
    for (device, renderer) in devices::all() {
        let renderer = Renderer::new(renderer);
        let step = |hook: &mut GradientHook<'_>| {
            let trainer = Trainer::resume(&renderer, config.clone(), dataset.clone(), &begin);
            let mut trainer = trainer.expect("a trainer");
            trainer.step_with(&mut StepHooks::new().gradient(hook)).expect("a step");
            bits(&trainer.checkpoint(0.0).expect("a state").scene)
        };
        let mut names = Vec::new();
        let moved = step(&mut |step| {
            names = step.gradient.tensors().iter().map(|(name, _)| name).collect();
            Ok(())
        });
        assert_eq!(names.len(), 10);
        for zeroed in names {
            let found = step(&mut |step| {
                let mut tensors = step.gradient.tensors().iter();
                let (_, tensor) = tensors.find(|(name, _)| *name == zeroed).expect("a tensor");
                tensor.write(step.device, &vec![0.0; tensor.range.len()])
            });
            let mut still = 0;
            let tensors = found.iter().zip(&moved).zip(bits(&begin.scene));
            for ((found, moved), before) in tensors {
                let what = format!("{device}: {} without the gradient of {zeroed}", found.0);
                if found.0.starts_with(zeroed) {
                    still += 1;
                    assert!(*found == before, "{what} has moved");
                    assert!(*moved != before, "{what} moves with it");
                } else {
                    assert!(found == moved, "{what} differs");
                }
            }
            assert!(still > 0, "{zeroed} is a tensor of the scene");
        }
    }
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

/// Acts like a sum over processes, with a single process.
fn write_back(step: &StepGradient<'_>) -> Result<()> {
    for (_, tensor) in step.gradient.tensors().iter() {
        tensor.write(step.device, &tensor.read(step.device)?)?;
    }
    Ok(())
}

#[test]
fn a_gradient_that_is_written_back_or_a_hook_that_failed_changes_nothing() {
    let (config, checkpoint, dataset) = begun();
    for (device, renderer) in devices::all() {
        let renderer = Renderer::new(renderer);
        let trainer = || {
            let trainer = Trainer::resume(&renderer, config.clone(), dataset.clone(), &checkpoint);
            trainer.expect("a trainer")
        };
        let state = |trainer: &Trainer| -> Checkpoint { trainer.checkpoint(0.0).unwrap() };
        let mut plain = trainer();
        let mut hooked = trainer();
        let mut fail = StepHooks::new()
            .gradient(|_| Err(Error::Argument { reason: "the hook's own".to_owned() }));
        let mut write_back = StepHooks::new().gradient(write_back);
        // the number of Gaussians changes at step 10
        for _ in 0..6 {
            plain.step().expect("a step");
            let error = hooked.step_with(&mut fail).expect_err("the hook fails").to_string();
            assert!(error.contains("the hook's own"), "{error}");
            hooked.step_with(&mut write_back).expect("a step");
        }
        assert_eq!(hooked.steps(), plain.steps());
        assert!(state_bits(&state(&hooked)) == state_bits(&state(&plain)), "{device}");
    }
}

#[test]
fn a_run_calls_its_hook_every_step_and_lends_the_scene() {
    let (mut config, _, dataset) = begun();
    config.run.steps = 3;
    let sandbox = sandbox();
    let renderer = Renderer::new(devices::cpu(None));
    let folder = sandbox.path("run");
    fs::create_dir(&folder).unwrap();
    let folder = RunFolder::lock(&folder, false).expect("it is free");
    let session = Session::new(&renderer, &config, &dataset, &folder);
    let mut hooked = Vec::new();
    let mut scenes = Vec::new();
    let mut watch = |event: Event<'_>| {
        if let Event::Step { scene, .. } = event {
            scenes.push(scene.download(renderer.device())?);
        }
        Ok(())
    };
    let mut hooks = StepHooks::new().gradient(|step| {
        hooked.push((step.step, step.scene.download(step.device)?));
        Ok(())
    });
    session.run_with(false, &mut watch, &mut hooks).expect("it trains");
    drop(hooks);
    let (steps, before): (Vec<_>, Vec<_>) = hooked.into_iter().unzip();
    assert_eq!(steps, [0, 1, 2]);
    // a hook sees the scene after the previous step
    assert!(before[1..] == scenes[..2] && scenes.windows(2).all(|pair| pair[0] != pair[1]));
    let saved = Checkpoint::load(folder.path().join(CHECKPOINT)).expect("a checkpoint");
    assert!(scenes[2] == saved.scene);
}
