//! `organza capture`: with ffmpeg and COLMAP, on a film that organza renders itself.

use std::fs;
use std::process::{Command, Stdio};

use glam::{DMat3, DVec3};
use organza::camera::CameraPath;
use organza::data::{DatasetOptions, Poses};
use organza::scene::{Contraction, GridConfig, MlpConfig, Scene, SceneConfig};
use organza::{Camera, demo};

use crate::sandbox::Sandbox;

/// Frames of the film.
const FRAMES: usize = 48;
/// Every second one is taken.
const TAKEN: usize = 24;

/// A hilly square of stones, `[-1, 1]` wide, which hides nothing of itself from above. COLMAP finds its way by texture.
fn stones() -> Scene {
    const SIDE: usize = 150;
    let grid =
        GridConfig { levels: 1, features: 1, log2_table: 4, base_resolution: 2.0, growth: 1.0 };
    let config = SceneConfig {
        sh_degree: 0,
        material: 3,
        extra: 1,
        color_grid: grid.clone(),
        transmittance_grid: grid,
        color_mlp: MlpConfig { hidden: vec![16] },
        transmittance_mlp: MlpConfig { hidden: vec![16] },
        step: 0.1,
        background: [0.0; 3],
        antialiased: false,
        contraction: Contraction::None,
        ..demo::config()
    };
    let mut scene = Scene::zeros(config, SIDE * SIDE).expect("a scene");
    for index in 0..SIDE * SIDE {
        let x = 2.0 * (index % SIDE) as f32 / SIDE as f32 - 1.0;
        let y = 2.0 * (index / SIDE) as f32 / SIDE as f32 - 1.0;
        let height = 0.12 * (3.1 * x + 1.0).sin() * (2.7 * y).cos() + 0.05 * (8.0 * x * y).sin();
        scene.gaussians.position[index] = [x, y, height];
        scene.gaussians.rotation[index] = [1.0, 0.0, 0.0, 0.0];
        scene.gaussians.log_scale[index] = [0.007_f32.ln(); 3];
        scene.gaussians.opacity[index] = 3.0;
        // Stones of two sizes, each of one color.
        let color = |axis: u32| {
            let [large, small] = [12.0, 37.0].map(|density| {
                hash([(x * density).floor() as i32, (y * density).floor() as i32], axis)
            });
            3.0 * (large + small) - 3.0
        };
        for axis in 0..3 {
            scene.gaussians.material[index * 3 + axis] = color(axis as u32);
        }
    }
    // The network's only work is to pass the material on, as a logit: rectified above -10.
    let [first, last] = &mut scene.color.network.layers[..] else { panic!("two layers") };
    for axis in 0..3 {
        first.weight[axis * first.inputs + first.inputs - 3 + axis] = 1.0;
        first.bias[axis] = 10.0;
        last.weight[axis * last.inputs + axis] = 1.0;
        last.bias[axis] = -10.0;
    }
    let [.., last] = &mut scene.transmittance.network.layers[..] else { panic!("layers") };
    last.bias[0] = 20.0;
    scene
}

/// A number from 0 to 1.
fn hash([x, y]: [i32; 2], axis: u32) -> f32 {
    let mut bits = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    bits = (bits ^ axis.wrapping_mul(0xc2b2_ae3d)).wrapping_mul(0x27d4_eb2f);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    (bits ^ (bits >> 12)) as f32 / u32::MAX as f32
}

fn keys() -> Vec<Camera> {
    (0..4)
        .map(|key| {
            let angle = 0.45 * f64::from(key) - 0.7;
            let eye = [2.0 * angle.sin(), -2.0 * angle.cos(), 1.9 + 0.1 * f64::from(key % 2)];
            Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.9, [640, 480]).expect("a camera")
        })
        .collect()
}

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
#[ignore = "takes a minute, and colmap and ffmpeg; .ci/nightly runs it"]
fn the_poses_of_a_film_are_found() {
    let sandbox = Sandbox::new("tiny");
    stones().save(sandbox.path("stones.safetensors")).unwrap();
    let keys = keys();
    Camera::save_all(sandbox.path("keys.json"), &keys).unwrap();
    sandbox
        .run(&format!(
            "film stones.safetensors keys.json -o film.mp4 --frames {FRAMES} --backend cpu"
        ))
        .assert_ok();
    let capture = format!("capture film.mp4 -o data --frames {TAKEN} --exhaustive");
    let outcome = sandbox.run(&capture).assert_ok();
    assert!(outcome.stderr.contains("taking the 24 sharpest of 48 frames"), "{outcome:?}");
    assert!(outcome.stderr.contains("24 of 24 images have a pose"), "{outcome:?}");
    assert!(outcome.stderr.contains("next: organza train data -o run"), "{outcome:?}");

    let film = CameraPath::through(&keys, false).unwrap().cameras(FRAMES);
    let found = Poses::load(&sandbox.path("data"), &DatasetOptions::default()).unwrap();
    let found: Vec<_> = found.cameras().unwrap().into_iter().map(|pose| pose.camera).collect();
    let truth = found.iter().map(|camera| {
        let name = camera.file_path.as_deref().expect("a name");
        let frame = name.split(['-', '.']).rev().nth(1).expect("frame-000012.png");
        &film[frame.parse::<usize>().expect("a number")]
    });
    let pairs: Vec<_> =
        found.iter().zip(truth).map(|(found, truth)| (pose(found), pose(truth))).collect();
    // COLMAP chooses its own scale and axes. Distances between cameras, in units of their mean, and turns from one
    // camera to another do not depend on these.
    let mut distances = Vec::new();
    for (a, (found_a, truth_a)) in pairs.iter().enumerate() {
        for (found_b, truth_b) in &pairs[..a] {
            distances.push([found_a.1.distance(found_b.1), truth_a.1.distance(truth_b.1)]);
            let [found, truth] =
                [(found_a, found_b), (truth_a, truth_b)].map(|(a, b)| a.0 * b.0.transpose());
            let turn = (found * truth.transpose()).to_cols_array();
            let cosine = (turn[0] + turn[4] + turn[8] - 1.0) / 2.0;
            assert!(cosine.min(1.0).acos() < 0.01, "turned by {} radians", cosine.acos());
        }
    }
    let mean =
        |of: usize| distances.iter().map(|pair| pair[of]).sum::<f64>() / distances.len() as f64;
    let means = [mean(0), mean(1)];
    let worst = distances.iter().map(|pair| (pair[0] / means[0] - pair[1] / means[1]).abs());
    let worst = worst.fold(0.0, f64::max);
    println!("distances between cameras are off by {worst:.5} of their mean");
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
fn what_cannot_be_captured_is_refused() {
    let sandbox = Sandbox::new("tiny");
    for name in ["one.jpg", "notes.txt", "phone/IMG_1.HEIC"] {
        let path = sandbox.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "not a photograph").unwrap();
    }
    sandbox.assert_refuses("capture nowhere.mp4 -o data", &["nowhere.mp4"]);
    sandbox.assert_refuses("capture one.jpg -o data", &["1 photograph, expected 3 or more"]);
    sandbox.assert_refuses(
        "capture one.jpg notes.txt -o data",
        &["notes.txt is neither JPEG nor PNG"],
    );
    sandbox.assert_refuses("capture phone -o data", &["HEIC", "convert them to JPEG first"]);
    let outcome = sandbox.shell("PATH=/nowhere \"$ORGANZA\" capture notes.txt -o data");
    outcome.assert_refused(&["not installed: ffmpeg colmap", "apt install ffmpeg colmap"]);
    assert!(!sandbox.path("data").exists());
    if ["colmap", "ffmpeg"].into_iter().all(is_there) {
        sandbox.assert_refuses("capture notes.txt -o data", &["ffmpeg fails", "notes.txt"]);
    }
    // Videos and photographs without poses lead here.
    fs::write(sandbox.path("beer.mp4"), "not JSON").unwrap();
    sandbox.assert_refuses("train beer.mp4 -o run", &["beer.mp4", "organza capture"]);
    fs::create_dir(sandbox.path("photos")).unwrap();
    fs::write(sandbox.path("photos/1.jpg"), "").unwrap();
    sandbox.assert_refuses("train photos -o run", &["organza capture"]);
}
