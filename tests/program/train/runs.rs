//! Runs that take seconds, and their files.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::{fs, io};

use image::RgbImage;
use organza::data::{Dataset, Frame, Photograph};
use organza::scene::read_tensors;
use organza::train::evaluate::ViewScore;
use organza::train::metrics::{MetricsLog, Record};
use organza::train::report::Reporter;
use organza::train::{
    CHECKPOINT, CONFIG, Checkpoint, Event, METRICS, Outcome, RunFolder, Session, TrainConfig,
};
use organza::{Camera, Renderer, Scene, demo};
use organza_tests::devices;

use crate::sandbox::Sandbox;

/// A run of 40 steps on the photographs of [`sandbox`].
pub const TINY: &str = "train views --config tiny.toml --backend cpu -o";

/// Five steps on the built-in scene, whose views take long to render.
pub const BUILT_IN: &str = "train --config tiny.toml --backend cpu --steps 5 \
    --set data.built_in_side=16 -o";

/// Number of photographs in a sandbox's folder `views`, and their width and height in pixels.
pub const VIEWS: u32 = 6;
pub const SIDE: u32 = 32;

/// A sandbox that has `tiny.toml`, and photographs in `views`.
pub fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    sandbox.write("tiny.toml", include_str!("tiny.toml"));
    for (name, content) in views() {
        sandbox.write(&format!("views/{name}"), content);
    }
    sandbox
}

/// Names and contents of the files of a data set of the built-in scene. Rendering takes longer than a run, so all
/// tests share the images.
fn views() -> &'static [(String, Vec<u8>)] {
    static FILES: OnceLock<Vec<(String, Vec<u8>)>> = OnceLock::new();
    FILES.get_or_init(|| {
        let renderer = Renderer::new(devices::cpu(None));
        let dataset = photographed(&renderer, &built_in(), VIEWS as usize, 0);
        let folder = tempfile::tempdir().expect("a folder");
        let camera = |Frame { name, camera, .. }: &Frame| Camera {
            file_path: Some(name.clone()),
            ..camera.clone()
        };
        let cameras: Vec<_> = dataset.frames.iter().map(camera).collect();
        Camera::save_all(folder.path().join("transforms.json"), &cameras).expect("cameras");
        for frame in &dataset.frames {
            let pixels = frame.image.pixels().as_flattened().to_vec();
            let image = RgbImage::from_raw(SIDE, SIDE, pixels).expect("all pixels");
            image.save(folder.path().join(&frame.name).with_extension("png")).expect("a picture");
        }
        let file = |entry: io::Result<fs::DirEntry>| {
            let entry = entry.unwrap();
            (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap())
        };
        fs::read_dir(folder.path()).unwrap().map(file).collect()
    })
}

/// Adds copies of a sandbox's photographs under other names, until there are `count`.
pub fn add_views(sandbox: &Sandbox, count: u32) {
    let mut json = sandbox.read_json("views/transforms.json");
    let frames = json["frames"].as_array_mut().expect("a list");
    for index in VIEWS..count {
        let mut frame = frames[(index % VIEWS) as usize].clone();
        let name = frame["file_path"].as_str().expect("a name").to_owned();
        let to = format!("view-{index:03}");
        sandbox.copy_file(&format!("views/{name}.png"), &format!("views/{to}.png"));
        frame["file_path"] = to.into();
        frames.push(frame);
    }
    sandbox.write("views/transforms.json", json.to_string());
}

/// The photographs of [`sandbox`], read with a run's settings.
pub fn dataset(sandbox: &Sandbox, config: &TrainConfig) -> Arc<Dataset> {
    Arc::new(Dataset::load(sandbox.path("views"), &config.data.options()).expect("photographs"))
}

/// The built-in scene with longer steps: most of the time would go into samples.
pub fn built_in() -> Scene {
    let mut scene = demo::scene();
    scene.config.step *= 8.0;
    scene
}

/// Photographs of a scene from around it. Every `hold_out_every`-th is held out.
pub fn photographed(
    renderer: &Renderer,
    scene: &Scene,
    views: usize,
    hold_out_every: usize,
) -> Dataset {
    let uploaded = renderer.upload(scene).expect("memory");
    let frame = |(index, camera): (usize, Camera)| {
        let image = renderer.render_view(&uploaded, &camera).expect("an image");
        Frame { name: format!("view-{index:03}"), camera, image: Photograph::from(&image) }
    };
    let frames = demo::turntable(views, SIDE).into_iter().enumerate().map(frame).collect();
    let mut dataset = Dataset::from_frames(frames, hold_out_every);
    dataset.background = scene.config.background;
    dataset
}

/// A run after five steps: its settings, its state, and its data.
pub fn begun() -> (TrainConfig, Checkpoint, Arc<Dataset>) {
    static BEGUN: OnceLock<(TrainConfig, Checkpoint, Arc<Dataset>)> = OnceLock::new();
    let begun = BEGUN.get_or_init(|| {
        let sandbox = sandbox();
        sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
        let config = TrainConfig::load(sandbox.path("run").join(CONFIG)).expect("settings");
        let checkpoint = sandbox.path("run").join(CHECKPOINT);
        let checkpoint = Checkpoint::load(checkpoint).expect("a checkpoint");
        let dataset = dataset(&sandbox, &config);
        (config, checkpoint, dataset)
    });
    begun.clone()
}

/// Begins a run with another one's settings, and stops it after `steps` steps.
pub fn stopped(sandbox: &Sandbox, run: &str, settings_of: &str, steps: u32) {
    let path = sandbox.path(run);
    fs::create_dir(&path).expect("a folder");
    let folder = RunFolder::lock(&path, false).expect("a folder of its own");
    let config = sandbox.path(settings_of).join(CONFIG);
    let config = TrainConfig::load(config).expect("settings");
    let renderer = Renderer::new(devices::cpu(None));
    let dataset = dataset(sandbox, &config);
    let stop = AtomicBool::new(false);
    let mut session = Session::new(&renderer, &config, &dataset, &folder);
    session.stop = &stop;
    let mut reporter = Reporter::new(&folder);
    let outcome = session.run(false, &mut |event| {
        reporter.see(&event)?;
        if matches!(event, Event::Step { step, .. } if step == steps) {
            stop.store(true, Ordering::Relaxed);
        }
        Ok(())
    });
    assert_eq!(outcome.expect("a run"), Outcome::Stopped);
}

/// The bits of all values in a state.
pub fn state_bits(state: &Checkpoint) -> Vec<Vec<u32>> {
    let [first, second] = &state.moments;
    let scenes = [&state.scene, first, second];
    let values = scenes.into_iter().flat_map(|scene| scene.tensors());
    let mut bits: Vec<Vec<u32>> =
        values.map(|(_, values)| values.iter().map(|value| value.to_bits()).collect()).collect();
    bits.push(state.statistics.iter().flatten().map(|value| value.to_bits()).collect());
    bits
}

/// Writes photographs of a case's scene to the folder `data`, at full size.
pub fn photographs(sandbox: &Sandbox) {
    sandbox.run("render scene.safetensors cameras.json -o data/images --backend cpu").assert_ok();
    sandbox.copy_file("cameras.json", "data/transforms.json");
}

/// Shape and bits of each tensor in a run's checkpoint: the scene, Adam's moments, and statistics for densification.
pub type Bits = BTreeMap<String, (Vec<usize>, Vec<u32>)>;

/// The final bits of a run.
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

/// Asserts that two runs have the same bits.
#[track_caller]
pub fn assert_same(what: &str, found: &Bits, expected: &Bits) {
    assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>(), "{what}");
    for (name, expected) in expected {
        assert!(found[name] == *expected, "{what}: `{name}` differs");
    }
}

/// Asserts that two runs have the same bits and the same log, but for times.
#[track_caller]
pub fn assert_same_run(sandbox: &Sandbox, found: &str, expected: &str) {
    assert_same(found, &bits(sandbox, found), &bits(sandbox, expected));
    let told = |run: &str| without_times(&records(&sandbox.path(run)));
    let expected = told(expected);
    // A run that ends at its time limit is measured there once more.
    let is_more = |record: &String| record.starts_with("evaluation") && !expected.contains(record);
    let found_records: Vec<_> = told(found).into_iter().filter(|record| !is_more(record)).collect();
    assert_eq!(found_records, expected, "{found}");
}

/// Asserts that every existing file of a run can be read.
pub fn assert_readable(folder: &Path) {
    if folder.join(CONFIG).exists() {
        TrainConfig::load(folder.join(CONFIG)).expect("settings");
    }
    if folder.join(METRICS).exists() {
        let _ = records(folder);
    }
    if folder.join(CHECKPOINT).exists() {
        Checkpoint::load(folder.join(CHECKPOINT)).expect("a checkpoint");
    }
}

/// A run's records.
#[track_caller]
pub fn records(folder: &Path) -> Vec<Record> {
    MetricsLog::read(folder.join(METRICS)).expect("every line is a record")
}

/// Step, mean PSNR and views of each evaluation of a run.
#[track_caller]
pub fn evaluations(sandbox: &Sandbox, run: &str) -> Vec<(u64, f64, Vec<ViewScore>)> {
    let evaluation = |record| match record {
        Record::Evaluation { step, mean, views, .. } => {
            Some((step, mean.psnr.expect("a score"), views))
        }
        _ => None,
    };
    records(&sandbox.path(run)).into_iter().filter_map(evaluation).collect()
}

/// The parts of a log that do not depend on the clock: numbers of each step, changes of the Gaussians, evaluations.
pub fn without_times(records: &[Record]) -> Vec<String> {
    let told = |record: &Record| match record {
        Record::Step { step, loss, l1, ssim, psnr, gaussians, rates, .. } => {
            Some(format!("step {step} {loss} {l1} {ssim} {psnr} {gaussians} {rates:?}"))
        }
        Record::Evaluation { step, mean, views, .. } => {
            Some(format!("evaluation {step} {mean:?} {views:?}"))
        }
        Record::Densification { .. } | Record::Change(_) => Some(format!("{record:?}")),
        Record::Session { .. } | Record::Timing { .. } => None,
    };
    records.iter().filter_map(told).collect()
}
