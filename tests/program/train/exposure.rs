//! Photographs with different exposures, and with an alpha channel.

use std::fs;
use std::sync::Arc;

use organza::data::{Background, Photograph};
use organza::train::config::Rate;
use organza::train::metrics::Record;
use organza::train::{TrainConfig, Trainer};
use organza::{Dataset, Renderer};
use organza_tests::devices;

use super::runs::{
    TINY, assert_same, begun, bits, built_in, photographed, photographs, records, sandbox, stopped,
    without_times,
};

/// Gains of the photograph at `index` among those to train on. The geometric mean of three successive ones is 1.
fn gains(index: usize) -> [f64; 3] {
    const GAINS: [f64; 3] = [0.6, 1.0, 1.0 / 0.6];
    [0, 1, 2].map(|channel| GAINS[(index + channel) % 3])
}

/// A darker image with gains, so that no gain saturates.
fn exposed(image: &Photograph, gains: [f64; 3]) -> Photograph {
    let shown = |(value, gain): (u8, f64)| (0.6 * f64::from(value) * gain).round() as u8;
    let pixel = |pixel: &[u8; 3]| [0, 1, 2].map(|channel| shown((pixel[channel], gains[channel])));
    let pixels = image.pixels().iter().map(pixel).collect();
    Photograph::new([image.width(), image.height()], pixels, None).expect("a photograph")
}

/// The scene's own colors must be found, though no photograph shows them.
#[test]
fn exposures_are_learned_and_held_out_views_keep_their_colors() {
    let (mut config, _, _) = begun();
    config.run.steps = 150;
    config.run.tiles_per_step = 8;
    config.optimizer.exposure = Rate { first: 0.03, last: 0.003 };
    let renderer = Renderer::new(devices::cpu(None));
    let mut dataset = photographed(&renderer, &built_in(), 13, 4);
    let train = dataset.train.clone();
    let held_out = dataset.held_out.clone();
    let shown = train.iter().enumerate().map(|(index, &frame)| (frame, gains(index)));
    for (frame, gains) in shown.chain(held_out.iter().map(|&frame| (frame, [1.0; 3]))) {
        let image = &mut dataset.frames[frame].image;
        *image = exposed(image, gains);
    }
    let dataset: Arc<Dataset> = Arc::new(dataset);
    let [without, with] = [false, true].map(|learn| {
        let mut config = config.clone();
        config.exposure.learn = learn.into();
        let mut trainer = Trainer::start(&renderer, config, dataset.clone()).expect("a trainer");
        while !trainer.is_finished() {
            trainer.step().expect("a step");
        }
        let exposures = trainer.checkpoint(0.0).expect("a checkpoint").exposures;
        let scores = trainer.evaluate().expect("views").mean;
        assert_eq!(scores.psnr_fitted.is_some(), learn);
        (scores.psnr.expect("a score"), exposures)
    });
    assert!(without.1.is_none());
    let exposures = with.1.expect("exposures");
    let errors = exposures.values.iter().enumerate().flat_map(|(index, values)| {
        let gains = gains(index);
        [0, 1, 2].map(|channel| (f64::from(values[2 * channel]) - gains[channel].ln()).abs())
    });
    let worst = errors.fold(0.0, f64::max);
    // measured after 300 steps: 22.0 and 16.9 dB
    assert!(with.0 > without.0 + 1.0, "{} dB with exposures, {} without", with.0, without.0);
    // without learning, it would be ln(1 / 0.6) = 0.51
    assert!(worst < 0.4, "{worst}");
    for at in 0..6 {
        let mean = exposures.values.iter().map(|values| values[at]).sum::<f32>() / 9.0;
        assert!(mean.abs() < 1e-6, "{at}: {mean}");
    }
}

/// A run that learns exposures, and is killed or stopped, must have the bits of one without interruption.
#[test]
fn a_resumed_run_has_the_bits_of_one_that_never_stopped() {
    let sandbox = sandbox();
    let settings = "--set exposure.learn=on";
    sandbox.run(&format!("{TINY} whole {settings}")).assert_ok();
    stopped(&sandbox, "cut", "whole", 13);
    let resumed = sandbox.run("train --resume cut --backend cpu --json").assert_ok();
    // the console's line, the log and the result name the same score
    let ended: serde_json::Value = serde_json::from_str(&resumed.stdout).expect("JSON");
    let fitted = ended["psnr_fitted"].as_f64().expect("a score");
    let line = format!(" dB, {fitted:.2} dB after each photograph's exposure is fitted, SSIM ");
    assert!(resumed.stderr.contains(&line), "{}", resumed.stderr);
    assert!(records(&sandbox.path("cut")).iter().any(|record| {
        matches!(record, Record::Evaluation { mean, .. } if mean.psnr_fitted == Some(fitted))
    }));
    let expected = bits(&sandbox, "whole");
    assert!(expected["train.exposure"].1.iter().any(|&bits| bits << 1 != 0));
    assert_same("resumed", &bits(&sandbox, "cut"), &expected);
    // the run and `eval` say how close its views are after a fit, and alike
    let table = sandbox.text("cut/evaluations.csv");
    assert!(table.starts_with("step,view,psnr,ssim,psnr_fitted\n"), "{table}");
    let again = sandbox.run("eval cut --backend cpu --json").json();
    let view = again["views"].as_array().and_then(|views| views.last()).expect("a view");
    let mut last = vec![view["name"].as_str().expect("a name").to_owned()];
    let scores = ["psnr", "ssim", "psnr_fitted"].map(|key| view[key].as_f64().expect("a score"));
    last.extend(scores.map(|score| score.to_string()));
    let row = table.lines().last().and_then(|row| row.split_once(',')).expect("a row").1;
    assert_eq!(row, last.join(","));
    let [whole, cut] = ["whole", "cut"].map(|run| {
        let records = without_times(&records(&sandbox.path(run)));
        records.into_iter().filter(|record| record.starts_with("step")).collect::<Vec<_>>()
    });
    assert_eq!(whole, cut);
}

#[test]
fn blenders_photographs_with_alpha_are_in_front_of_white() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let data = sandbox.path("data");
    fs::rename(data.join("transforms.json"), data.join("transforms_train.json")).unwrap();
    for file in fs::read_dir(data.join("images")).unwrap() {
        let path = file.unwrap().path();
        // the list of pictures is in the same folder
        if path.extension().is_none_or(|extension| extension != "png") {
            continue;
        }
        let mut image = image::open(&path).expect("a picture").to_rgba8();
        image.put_pixel(0, 0, image::Rgba([0; 4]));
        image.save(&path).unwrap();
    }
    let train =
        "train data --config tiny.toml --downscale 2 --hold-out-every 2 --backend cpu --steps 5";
    let background = |run: &str| {
        TrainConfig::load(sandbox.path(run).join("config.toml")).expect("settings").data.background
    };
    sandbox.run(&format!("{train} -o white")).assert_ok().says(&["the background is white"]);
    assert_eq!(background("white"), Background::Color([1.0; 3]));
    let info = sandbox.run("info white/checkpoint.safetensors --json").json();
    assert_eq!(info["config"]["background"], serde_json::json!([1.0, 1.0, 1.0]), "{info}");
    sandbox.run("train --resume white --backend cpu").assert_ok();
    for (color, expected) in [("black", [0.0; 3]), ("0,0.5,1", [0.0, 0.5, 1.0])] {
        sandbox
            .run(&format!("{train} --background {color} -o {color}"))
            .assert_ok()
            .says_not(&["the background is"]);
        assert_eq!(background(color), Background::Color(expected));
    }
}
