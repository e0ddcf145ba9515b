//! Losses of the caller's.

use std::fs;
use std::sync::Arc;

use organza::ranks::{Ranks, ThreadRanks};
use organza::render::{LossBatch, LossGradient, LossInputs, OwnLoss, TileLoss, image_loss};
use organza::train::{CHECKPOINT, Checkpoint, Event, RunFolder, Session, Trainer};
use organza::{Dataset, Error, Renderer, Result};
use organza_tests::devices;

use super::runs::{begun, sandbox, state_bits};

/// The caller computes the settings' own loss. Poses are refined, and on a CPU exposures are learned: what the host exposes for the
/// caller, a GPU may round differently.
#[test]
fn the_same_loss_gives_the_same_bits() {
    let (mut config, checkpoint, dataset) = begun();
    config.poses.refine = true;
    // a caller's loss sees all samples
    config.run.roulette = 0.0;
    config.run.gradient_roulette = 0.0;
    let weight = config.loss.ssim_weight;
    for (name, device) in devices::all() {
        let exposes = device.backend() == "cpu";
        config.exposure.learn = exposes.into();
        let renderer = Renderer::new(device);
        let trainer = || {
            let config = config.clone();
            let dataset = dataset.clone();
            Trainer::resume(&renderer, config, dataset, &checkpoint).expect("a trainer")
        };
        let mut plain = trainer();
        let mut own = trainer();
        let device = renderer.device();
        let mut loss = |batch: &LossBatch<'_>| {
            let inputs = LossInputs {
                image: &device.upload("tiles", &batch.rendered.data)?,
                target: &device.upload("photographs", batch.target.image)?,
                valid: &device.upload("masks", batch.target.valid)?,
                valid_pixels: batch.target.valid.iter().copied().map(f64::from).sum(),
                ssim_weight: weight,
            };
            let output = image_loss(device, batch.rendered.side, &inputs)?;
            let loss = TileLoss::total(&output.sums(device)?).value(weight);
            Ok(LossGradient { loss, grad_tiles: device.read(&output.grad_tiles)? })
        };
        // the number of Gaussians changes at step 10
        for _ in 0..6 {
            let expected = plain.step().unwrap();
            let found = own.step_with(&mut loss).unwrap();
            assert_eq!(found.loss.to_bits(), expected.loss.to_bits(), "{name}");
            assert!((found.psnr - expected.psnr).abs() < 1e-3, "{name}: {found:?} {expected:?}");
        }
        let [found, expected] = [&own, &plain].map(|trainer| trainer.checkpoint(0.0).unwrap());
        assert!(state_bits(&found) == state_bits(&expected), "{name}");
        assert_eq!(found.poses, expected.poses, "{name}");
        assert_eq!(found.exposures, expected.exposures, "{name}");
        assert_eq!(found.exposures.is_some(), exposes, "{name}");
        let moved = found.poses.expect("poses").values;
        assert!(moved.as_flattened().iter().any(|&value| value != 0.0), "{name}");
    }
}

/// Half the sum of squares, of which dL/dY is `Y - truth`.
fn squares(batch: &LossBatch<'_>) -> LossGradient {
    let area = (batch.rendered.side * batch.rendered.side) as usize;
    let pairs = batch.rendered.data.iter().zip(batch.target.image).enumerate();
    let difference = |(at, (y, truth)): (usize, (&f32, &f32))| {
        (y - truth) * batch.target.valid[at / (3 * area) * area + at % area]
    };
    let grad_tiles: Vec<f32> = pairs.map(difference).collect();
    let squares = grad_tiles.iter().map(|&d| f64::from(d) * f64::from(d));
    LossGradient { loss: 0.5 * squares.sum::<f64>(), grad_tiles }
}

/// Asserts that a batch is compared with its photographs.
fn assert_shows(batch: &LossBatch<'_>, dataset: &Dataset) {
    let side = batch.rendered.side;
    let area = (batch.rendered.side * batch.rendered.side) as usize;
    for (index, tile) in batch.batch.tiles.iter().enumerate() {
        let photograph = &dataset.frames[dataset.train[tile.camera]].image;
        // the first pixel that is in the photograph
        let [x, y] = tile.origin.map(|origin| origin.max(0));
        let at = (y - tile.origin[1]) * side as i32 + (x - tile.origin[0]);
        let pixel = photograph.pixels()[(y * photograph.width() as i32 + x) as usize];
        for (channel, value) in pixel.into_iter().enumerate() {
            let found = batch.target.image[(3 * index + channel) * area + at as usize];
            assert!((found - f32::from(value) / 255.0).abs() < 1e-6, "tile {index}");
        }
    }
}

/// For the loss's dL/dY, the step's gradient must equal [`Renderer::gradient`]'s, in one part and in many. Adam's first moment shows it:
/// after the first step, it is `(1 - beta1) g`.
#[test]
fn a_loss_on_the_host_sees_the_whole_batch_and_reaches_every_tensor() {
    let (config, checkpoint, dataset) = begun();
    let checkpoint = Checkpoint::begin(checkpoint.scene, &config).expect("a start");
    let cameras: Vec<_> = dataset.train_frames().map(|frame| frame.camera.clone()).collect();
    for (name, device) in devices::all() {
        let renderer = Renderer::new(device);
        for part_bytes in [512 << 20, 1] {
            let what = format!("{name}, parts of {part_bytes} bytes");
            let renderer = renderer.clone().with_part_bytes(part_bytes);
            let trainer = Trainer::resume(&renderer, config.clone(), dataset.clone(), &checkpoint);
            let mut trainer = trainer.expect("a trainer");
            let mut seen = Vec::new();
            let loss = |batch: &LossBatch<'_>| {
                assert_shows(batch, &dataset);
                let found = squares(batch);
                seen.push((batch.batch.clone(), batch.rendered.data.clone(), found.clone()));
                Ok(found)
            };
            let report = trainer.step_with(loss).expect("a step");
            let [moments, _] = trainer.checkpoint(0.0).expect("a state").moments;
            let [(batch, rendered, found)] = &seen[..] else { panic!("{what}: {}", seen.len()) };
            assert_eq!((report.tiles, report.loss), (batch.tiles.len(), found.loss));
            let scene = renderer.upload(&checkpoint.scene).unwrap();
            let expected = renderer.render(&scene, &cameras, batch).unwrap();
            assert_eq!(expected.report.parts > 1, part_bytes == 1, "{what}");
            assert!(*rendered == expected.data, "{what}: the tiles");
            let expected = renderer.gradient(&scene, &cameras, batch, &found.grad_tiles).unwrap();
            let rest = 1.0 - config.optimizer.beta1 as f32;
            for ((spec, moment), (_, gradient)) in
                moments.tensors().into_iter().zip(expected.tensors())
            {
                let mut pairs = moment.iter().zip(gradient);
                // a GPU may flush what is smaller
                let is_near = |(moment, gradient): (&f32, &f32)| {
                    (moment - rest * gradient).abs() <= f32::MIN_POSITIVE
                };
                assert!(pairs.all(is_near), "{what}: the gradient of {}", spec.name);
            }
            assert!(expected.gaussians.opacity.iter().any(|&slope| slope != 0.0), "{what}");
            // the squares that the loss sums
            let squared = f64::powf(10.0, -report.psnr / 10.0);
            let values = 2.0 * found.loss / squared;
            let max = found.grad_tiles.len() as f64;
            assert!(values <= 1.001 * max && values > 0.2 * max, "{what}: {values} of {max}");
        }
    }
}

/// On each rank, a loss sees all tiles as they were exposed.
#[test]
fn ranks_share_a_loss_of_the_callers() {
    let (mut config, checkpoint, dataset) = begun();
    config.exposure.learn = true.into();
    let train = |ranks: Option<Arc<dyn Ranks>>| {
        let renderer = Renderer::new(devices::cpu(Some(1)));
        let trainer = Trainer::resume(&renderer, config.clone(), dataset.clone(), &checkpoint);
        let mut trainer = trainer.expect("a trainer");
        if let Some(ranks) = ranks {
            trainer = trainer.with_ranks(ranks);
        }
        let mut step = || trainer.step_with(|batch| Ok(squares(batch))).expect("a step").loss;
        let losses = [step(), step()];
        (losses, trainer.checkpoint(0.0).expect("a state"))
    };
    let (losses, alone) = train(None);
    for (found, state) in ThreadRanks::run(2, |ranks| train(Some(Arc::new(ranks)))) {
        let pairs = found.iter().zip(&losses);
        assert!(pairs.clone().all(|(a, b)| (a / b - 1.0).abs() < 1e-9), "{found:?} {losses:?}");
        assert!(state_bits(&state) == state_bits(&alone));
        assert_eq!(state.exposures, alone.exposures);
    }
}

#[test]
fn a_run_calls_its_loss_every_step_and_lends_the_scene() {
    let (mut config, _, dataset) = begun();
    config.run.steps = 3;
    let sandbox = sandbox();
    let renderer = Renderer::new(devices::cpu(None));
    let folder = sandbox.path("run");
    fs::create_dir(&folder).unwrap();
    let folder = RunFolder::lock(&folder, false).expect("it is free");
    let session = Session::new(&renderer, &config, &dataset, &folder);
    let mut scenes = Vec::new();
    let mut watch = |event: Event<'_>| {
        if let Event::Step { scene, .. } = event {
            scenes.push(scene.download(renderer.device())?);
        }
        Ok(())
    };
    let mut calls = 0;
    let mut own: OwnLoss<'_> = Box::new(|batch| {
        calls += 1;
        Ok(squares(batch))
    });
    session.run_with(false, &mut watch, Some(&mut own)).expect("it trains");
    drop(own);
    assert_eq!((calls, scenes.len()), (3, 3));
    assert!(scenes.windows(2).all(|pair| pair[0] != pair[1]));
    let saved = Checkpoint::load(folder.path().join(CHECKPOINT)).expect("a checkpoint");
    assert!(scenes[2] == saved.scene);
}

#[test]
fn a_loss_that_fails_or_is_of_another_size_leaves_the_trainer_as_it_was() {
    let (config, checkpoint, dataset) = begun();
    let renderer = Renderer::new(devices::cpu(None));
    let trainer = || Trainer::resume(&renderer, config.clone(), dataset.clone(), &checkpoint);
    let mut plain = trainer().expect("a trainer");
    let mut failed = trainer().expect("a trainer");
    let mut fail = |loss: &mut dyn FnMut(&LossBatch<'_>) -> Result<LossGradient>| {
        let error = failed.step_with(loss).expect_err("it fails").to_string();
        assert_eq!(failed.steps(), checkpoint.progress.step, "{error}");
        error
    };
    let own = || Error::Argument { reason: "the loss's own".to_owned() };
    let error = fail(&mut |_| Err(own()));
    assert!(error.contains("the loss's own"), "{error}");
    let one = || Ok(LossGradient { loss: 1.0, grad_tiles: vec![1.0] });
    let error = fail(&mut |_| one());
    assert!(error.contains("1 values of `grad_tiles`, expected "), "{error}");
    let error = fail(&mut |batch| {
        Ok(LossGradient { loss: f64::NAN, grad_tiles: vec![0.0; batch.rendered.data.len()] })
    });
    assert!(error.contains("the loss of step 5 is NaN"), "{error}");
    plain.step().expect("a step");
    failed.step().expect("a step");
    let [found, expected] = [&failed, &plain].map(|trainer| trainer.checkpoint(0.0).unwrap());
    assert!(state_bits(&found) == state_bits(&expected));
}
