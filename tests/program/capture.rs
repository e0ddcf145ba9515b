//! `organza capture`: with ffmpeg and COLMAP, on a film of the still life that `organza demo --photographs` takes.

use std::fs;
use std::process::{Command, Stdio};

use glam::{DMat3, DVec3};
use organza::Camera;
use organza::data::{DatasetOptions, Poses};
use organza::still_life::StillLife;
use serde_json::Value;

use crate::sandbox::Sandbox;

/// Frames of the film.
const FRAMES: usize = 60;
/// Every second one is taken.
const TAKEN: usize = 30;

fn is_there(program: &str) -> bool {
    let mut command = Command::new(program);
    command.arg("-h").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok()
}

/// World to camera, and the camera's place.
fn pose(camera: &Camera) -> (DMat3, DVec3) {
    let rows = camera.world_to_camera_opencv().map(|[x, y, z, ..]| DVec3::new(x, y, z));
    (DMat3::from_cols(rows[0], rows[1], rows[2]).transpose(), DVec3::from(camera.eye()))
}

#[test]
#[ignore = "takes minutes, and colmap and ffmpeg; .ci/nightly runs it"]
fn the_poses_of_a_film_are_found() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("demo --photographs -o walk --views {FRAMES} --size 640")).assert_ok();
    sandbox
        .shell("ffmpeg -v error -i walk/images/%05d.jpg -crf 12 -pix_fmt yuv420p film.mp4")
        .assert_ok();
    let capture = format!("capture film.mp4 -o data --frames {TAKEN} --exhaustive");
    let outcome = sandbox.run(&capture).assert_ok();
    assert!(outcome.stderr.contains("taking the 30 sharpest of 60 frames"), "{outcome:?}");
    assert!(outcome.stderr.contains("30 of 30 images have a pose"), "{outcome:?}");
    assert!(outcome.stderr.contains("next: organza train data -o data-run"), "{outcome:?}");

    let film = Camera::load_all(sandbox.path("walk/transforms.json")).unwrap();
    let found = Poses::load(&sandbox.path("data"), &DatasetOptions::default()).unwrap();
    let found: Vec<_> = found.cameras().unwrap().into_iter().map(|pose| pose.camera).collect();
    let truth = found.iter().map(|camera| {
        let name = camera.file_path.as_deref().expect("a name");
        let frame = name.split(['-', '.']).rev().nth(1).expect("frame-000012.png");
        let frame = frame.parse::<usize>().expect("a number");
        assert!(!StillLife::is_shaken(frame), "frame {frame} is not sharp");
        &film[frame]
    });
    let pairs: Vec<_> =
        found.iter().zip(truth).map(|(found, truth)| (pose(found), pose(truth))).collect();
    // COLMAP chooses its own scale and axes. Distances between cameras, in units of their mean, and turns from one
    // camera to another do not depend on these.
    let mut distances = Vec::new();
    let mut turns = Vec::new();
    for (a, (found_a, truth_a)) in pairs.iter().enumerate() {
        for (found_b, truth_b) in &pairs[..a] {
            distances.push([found_a.1.distance(found_b.1), truth_a.1.distance(truth_b.1)]);
            let [found, truth] =
                [(found_a, found_b), (truth_a, truth_b)].map(|(a, b)| a.0 * b.0.transpose());
            let turn = (found * truth.transpose()).to_cols_array();
            let cosine = (turn[0] + turn[4] + turn[8] - 1.0) / 2.0;
            turns.push(cosine.min(1.0).acos());
        }
    }
    let mean =
        |of: usize| distances.iter().map(|pair| pair[of]).sum::<f64>() / distances.len() as f64;
    let means = [mean(0), mean(1)];
    let worst = distances.iter().map(|pair| (pair[0] / means[0] - pair[1] / means[1]).abs());
    let worst = worst.fold(0.0, f64::max);
    let turned = turns.iter().sum::<f64>() / turns.len() as f64;
    println!("cameras are turned by {turned:.4} radians in the mean");
    println!("distances between cameras are off by {worst:.5} of their mean at most");
    assert!(turned < 0.01, "cameras are turned by {turned} radians in the mean");
    assert!(worst < 0.01, "distances between cameras are off by {worst} of their mean");
    for camera in &found {
        let off = camera.fl_x / f64::from(camera.width) / (film[0].fl_x / f64::from(film[0].width));
        assert!((off - 1.0).abs() < 0.01, "a focal length of {off} times the true one");
    }

    // The same call again does nothing, and other options do not mix with what is there.
    let again = sandbox.run(&capture).assert_ok();
    assert!(again.stderr.contains("data is there from an earlier call"), "{again:?}");
    sandbox.assert_refuses("capture film.mp4 -o data --frames 10", &["other inputs or options"]);
    // The folder of the images names the data set, too.
    let trained =
        sandbox.run("train data/images -o run --steps 2 --max-gaussians 2000 --backend cpu");
    trained.assert_ok();
}

#[test]
fn photographs_of_the_still_life_are_a_data_set() {
    let sandbox = Sandbox::new("tiny");
    let words = "demo --photographs -o walk --views 6 --size 64";
    // A call that was stopped has left this.
    fs::create_dir_all(sandbox.path("walk/images.part")).unwrap();
    fs::write(sandbox.path("walk/images.part/00009.jpg"), "half").unwrap();
    let outcome = sandbox.run(&format!("{words} --json")).assert_ok();
    assert!(outcome.stderr.contains("CC0 1.0"), "{outcome:?}");
    let made: Value = serde_json::from_str(&outcome.stdout).unwrap();
    assert_eq!(made["images"].as_array().unwrap().len(), 6);
    assert_eq!(fs::read_dir(sandbox.path("walk/images")).unwrap().count(), 6);
    assert!(!sandbox.path("walk/images.part").exists());
    // A file's pixels are the photograph's, but for what JPEG loses.
    let walk = StillLife::new(6, [64, 48]).unwrap();
    let file = image::open(sandbox.path("walk/images/00004.jpg")).unwrap().to_rgb8();
    let photograph = walk.photograph(4).unwrap();
    let pairs = file.as_raw().iter().zip(photograph.pixels().as_flattened());
    let off: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    assert!(off < 4 * file.as_raw().len() as u64, "{off}");
    sandbox.assert_refuses(words, &["walk has images already", "choose another folder"]);
    let train = "train walk -o run --steps 2 --max-gaussians 2000 --backend cpu";
    sandbox.run(train).assert_ok();
}

#[test]
fn bad_inputs_are_refused() {
    let sandbox = Sandbox::new("tiny");
    for name in ["one.jpg", "notes.txt", "phone/IMG_1.HEIC"] {
        let path = sandbox.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "not a photograph").unwrap();
    }
    sandbox.assert_refuses("capture nowhere.mp4 -o data", &["nowhere.mp4"]);
    sandbox
        .assert_refuses("capture one.jpg -o data", &["one.jpg: 1 photograph, expected 3 or more"]);
    sandbox.assert_refuses(
        "capture one.jpg notes.txt -o data",
        &["notes.txt is neither JPEG nor PNG"],
    );
    sandbox.assert_refuses("capture phone -o data", &["HEIC", "convert them to JPEG first"]);
    sandbox
        .assert_refuses("capture phone phone -o data", &["phone is a folder among other inputs"]);
    fs::create_dir(sandbox.path("run")).unwrap();
    fs::write(sandbox.path("run/config.toml"), "").unwrap();
    sandbox.assert_refuses("capture notes.txt -o run", &["run holds a training run"]);
    let outcome = sandbox.shell("PATH=/nowhere \"$ORGANZA\" capture notes.txt -o data");
    outcome.assert_refused(&["not installed: ffmpeg colmap", "apt install ffmpeg colmap"]);
    assert!(!sandbox.path("data").exists());
    if ["colmap", "ffmpeg"].into_iter().all(is_there) {
        sandbox.assert_refuses(
            "capture notes.txt -o data",
            &["ffmpeg fails", "Is notes.txt a video?"],
        );
    }
    // Videos and photographs without poses lead here.
    fs::write(sandbox.path("beer.mp4"), "not JSON").unwrap();
    sandbox.assert_refuses("train beer.mp4 -o run", &["beer.mp4", "organza capture"]);
    fs::create_dir(sandbox.path("photos")).unwrap();
    fs::write(sandbox.path("photos/1.jpg"), "").unwrap();
    sandbox.assert_refuses("train photos -o run", &["organza capture"]);
}
