//! Photographs of different exposures.

use std::sync::Arc;

use organza::data::Photograph;
use organza::train::config::ExposureMethod;
use organza::train::{Trainer, built_in};
use organza::{Dataset, Renderer};
use organza_tests::devices;

use super::runs::{TINY, assert_same, begun, bits, records, sandbox, without_times};

/// What a camera makes of red, green and blue in the photograph at `index`: gains of 0.7 to 1.4. Their geometric mean
/// over three photographs in a row is 1.
fn exposed(index: usize, pixel: [u8; 3]) -> [u8; 3] {
    let gains = [[0.7, 1.0, 1.0 / 0.7], [1.0 / 0.7, 0.7, 1.0], [1.0, 1.0 / 0.7, 0.7]][index % 3];
    let shown = |(value, gain): (u8, f64)| (f64::from(value) * gain).round().min(255.0) as u8;
    [0, 1, 2].map(|channel| shown((pixel[channel], gains[channel])))
}

/// The scene's own colors are found, though no photograph shows them.
#[test]
fn exposures_are_learned_and_held_out_views_keep_their_colors() {
    let (mut config, _, _) = begun();
    config.run.steps = 200;
    config.run.tiles_per_step = 8;
    let renderer = Renderer::new(devices::cpu(None));
    let mut dataset = built_in::dataset(&renderer, 13, 32, 4).expect("views");
    let train = dataset.train.clone();
    for (index, &frame) in train.iter().enumerate() {
        let image = &mut dataset.frames[frame].image;
        let pixels = image.pixels().iter().map(|&pixel| exposed(index, pixel)).collect();
        *image = Photograph::new([32, 32], pixels, None).expect("a photograph");
    }
    let dataset: Arc<Dataset> = Arc::new(dataset);
    let [without, with] = [ExposureMethod::None, ExposureMethod::Affine].map(|method| {
        let mut config = config.clone();
        config.exposure.method = method;
        let mut trainer = Trainer::start(&renderer, config, dataset.clone()).expect("a trainer");
        while !trainer.is_finished() {
            trainer.step().expect("a step");
        }
        let exposures = trainer.checkpoint(0.0).expect("a checkpoint").exposures;
        (trainer.evaluate().expect("views").mean.psnr.expect("a score"), exposures)
    });
    assert!(without.1.is_none());
    assert!(with.0 > without.0 + 2.0, "{} dB with exposures, {} without", with.0, without.0);
    let exposures = with.1.expect("exposures");
    for (index, values) in exposures.values.iter().enumerate() {
        let known = [255, 0, 0].map(|_| 100);
        let expected = exposed(index, known).map(|value| f64::from(value) / 100.0);
        let found = [0, 2, 4].map(|at| f64::from(values[at]).exp());
        println!("{index}: {found:.3?} {expected:.3?} {values:.3?}");
    }
    for at in 0..6 {
        let mean = exposures.values.iter().map(|values| values[at]).sum::<f32>() / 9.0;
        assert!(mean.abs() < 1e-6, "{at}: {mean}");
    }
    panic!("{} {}", with.0, without.0);
}

/// A run that learns exposures and is killed, or stopped, goes on as if it had not been.
#[test]
fn a_resumed_run_has_the_bits_of_one_that_never_stopped() {
    let sandbox = sandbox();
    let settings = "--set exposure.method=affine";
    sandbox.run(&format!("{TINY} whole {settings}")).assert_ok();
    sandbox.run(&format!("{TINY} cut {settings} --time-limit 0.001")).assert_ok();
    sandbox.run("train --resume cut --time-limit 1000 --backend cpu").assert_ok();
    let expected = bits(&sandbox, "whole");
    assert!(expected["train.exposure"].1.iter().any(|&bits| bits << 1 != 0));
    assert_same("resumed", &bits(&sandbox, "cut"), &expected);
    let [whole, cut] = ["whole", "cut"].map(|run| {
        let records = without_times(&records(&sandbox.path(run)));
        records.into_iter().filter(|record| record.starts_with("step")).collect::<Vec<_>>()
    });
    assert_eq!(whole, cut);
}

#[test]
fn ranks_say_that_they_cannot() {
    let sandbox = sandbox();
    let run = format!("{TINY} run --ranks 2 --set exposure.method=affine");
    sandbox.assert_refuses(&run, &["ranks cannot learn exposures: set `exposure.method` to none"]);
}
