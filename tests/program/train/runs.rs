//! Runs of seconds, and what they leave.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use organza::Renderer;
use organza::data::Dataset;
use organza::scene::read_tensors;
use organza::train::metrics::{MetricsLog, Record};
use organza::train::{
    CHECKPOINT, CONFIG, Checkpoint, Event, METRICS, Outcome, RunFolder, Session, TrainConfig,
    built_in,
};
use organza_tests::devices;

use crate::sandbox::Sandbox;

/// A run of 40 steps.
pub const TINY: &str = "train --config tiny.toml --backend cpu -o";

/// A sandbox that has `tiny.toml`.
pub fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    fs::write(sandbox.path("tiny.toml"), include_str!("tiny.toml")).unwrap();
    sandbox
}

/// A run after five steps: its settings, its state, and what it is trained on.
pub fn begun() -> (TrainConfig, Checkpoint, Arc<Dataset>) {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
    let config = TrainConfig::load(sandbox.path("run/config.toml")).expect("settings");
    let checkpoint = Checkpoint::load(sandbox.path("run").join(CHECKPOINT)).expect("a checkpoint");
    let cpu = Renderer::new(devices::cpu(None));
    let (views, side) = (config.data.built_in_views, config.data.built_in_side);
    let dataset = built_in::dataset(&cpu, views, side, config.data.hold_out_every);
    (config, checkpoint, Arc::new(dataset.expect("views")))
}

/// Begins a run with the settings of another, and stops it after some steps.
pub fn stopped(sandbox: &Sandbox, run: &str, settings_of: &str, steps: u32) {
    let path = sandbox.path(run);
    fs::create_dir(&path).expect("a folder");
    let folder = RunFolder::lock(&path, false).expect("a folder of its own");
    let config = sandbox.path(settings_of).join(CONFIG);
    let config = TrainConfig::load(config).expect("settings");
    let renderer = Renderer::new(devices::cpu(None));
    let (views, side) = (config.data.built_in_views, config.data.built_in_side);
    let dataset = built_in::dataset(&renderer, views, side, config.data.hold_out_every);
    let (dataset, stop) = (Arc::new(dataset.expect("views")), AtomicBool::new(false));
    let session = Session::new(&renderer, &config, &dataset, &folder).with_stop(&stop);
    let outcome = session.run(false, &mut |event| {
        if matches!(event, Event::Step { step, .. } if step == steps) {
            stop.store(true, Ordering::Relaxed);
        }
    });
    assert_eq!(outcome.expect("a run"), Outcome::Stopped);
}

/// All that a state has, as bits.
pub fn state_bits(state: &Checkpoint) -> Vec<Vec<u32>> {
    let [first, second] = &state.moments;
    let scenes = [&state.scene, first, second];
    let values = scenes.into_iter().flat_map(|scene| scene.tensors());
    let mut bits: Vec<Vec<u32>> =
        values.map(|(_, values)| values.iter().map(|value| value.to_bits()).collect()).collect();
    bits.push(state.statistics.iter().flatten().map(|value| value.to_bits()).collect());
    bits
}

/// Photographs of a case's scene, downscaled by nobody yet, in the folder `data`.
pub fn photographs(sandbox: &Sandbox) {
    sandbox.run("render scene.safetensors cameras.json -o data/images --backend cpu").assert_ok();
    fs::copy(sandbox.path("cameras.json"), sandbox.path("data/transforms.json")).unwrap();
}

/// The shape and the bits of each tensor of a run's checkpoint: the scene, Adam's moments, what growth goes by.
pub type Bits = BTreeMap<String, (Vec<usize>, Vec<u32>)>;

/// What a run has come to.
#[track_caller]
pub fn bits(sandbox: &Sandbox, run: &str) -> Bits {
    let tensors = read_tensors(sandbox.path(run).join(CHECKPOINT)).expect("a checkpoint");
    let bits: Bits = tensors
        .into_iter()
        .map(|(name, tensor)| {
            (name, (tensor.shape, tensor.data.into_iter().map(f32::to_bits).collect()))
        })
        .collect();
    for part in ["gaussians.position", "adam.first.", "adam.second.", "train.statistics"] {
        assert!(bits.keys().any(|name| name.starts_with(part)), "{part}: {:?}", bits.keys());
    }
    bits
}

/// Two runs came to the same bits.
#[track_caller]
pub fn assert_same(what: &str, found: &Bits, expected: &Bits) {
    assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>(), "{what}");
    for (name, expected) in expected {
        assert!(found[name] == *expected, "{what}: `{name}` differs");
    }
}

/// A run's records.
#[track_caller]
pub fn records(folder: &Path) -> Vec<Record> {
    MetricsLog::read(folder.join(METRICS)).expect("every line is a record")
}

/// What does not depend on the clock: each step's numbers, each change of the Gaussians, each evaluation.
pub fn without_times(records: &[Record]) -> Vec<String> {
    let told = |record: &Record| match record {
        Record::Step { step, loss, l1, ssim, psnr, gaussians, rates, .. } => {
            Some(format!("step {step} {loss} {l1} {ssim} {psnr} {gaussians} {rates:?}"))
        }
        Record::Evaluation { step, psnr, ssim, views, .. } => {
            Some(format!("evaluation {step} {psnr:?} {ssim:?} {views:?}"))
        }
        Record::Growth { .. } | Record::Change(_) => Some(format!("{record:?}")),
        Record::Session { .. } | Record::Timing { .. } => None,
    };
    records.iter().filter_map(told).collect()
}
