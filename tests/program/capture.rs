//! `organza capture`: with ffmpeg and COLMAP, on a film of the still life that `organza demo --photographs` takes.

use std::fmt::Write as _;
use std::fs;
use std::ops::Range;
use std::process::{Command, Stdio};

use glam::{DMat3, DVec3};
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, ImageEncoder, ImageReader};
use organza::Camera;
use organza::data::{DatasetOptions, Poses};
use organza::still_life;
use serde_json::Value;

use crate::sandbox::{Outcome, Sandbox};

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
    (camera.to_world().transpose(), DVec3::from(camera.eye()))
}

#[test]
#[ignore = "takes minutes, and colmap and ffmpeg; .ci/nightly runs it"]
fn the_poses_of_a_film_are_found() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("demo --photographs -o walk --views {FRAMES} --size 640")).assert_ok();
    sandbox
        .shell("ffmpeg -v error -i walk/images/%05d.jpg -crf 12 -pix_fmt yuv420p film.mp4")
        .assert_ok();
    let capture = format!("capture film.mp4 -o data --frames {TAKEN} --matcher exhaustive");
    sandbox.run(&capture).assert_ok().says(&[
        "taking the 30 sharpest of 60 frames",
        "30 of 30 images have a pose",
        "next: organza train data -o data-run",
    ]);

    let film = Camera::load_all(sandbox.path("walk/transforms.json")).unwrap();
    let found = Poses::load(&sandbox.path("data"), &DatasetOptions::default()).unwrap();
    let found: Vec<_> = found.cameras().unwrap().into_iter().map(|pose| pose.camera).collect();
    let truth = found.iter().map(|camera| {
        let name = camera.file_path.as_deref().expect("a name");
        let frame = name.split(['-', '.']).rev().nth(1).expect("frame-000012.png");
        let frame = frame.parse::<usize>().expect("a number");
        assert!(!still_life::is_shaken(frame), "frame {frame} is not sharp");
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
    sandbox.run(&capture).assert_ok().says(&["data is there from an earlier call"]);
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
    sandbox.write("walk/images.part/00009.jpg", "half");
    let outcome = sandbox.run(&format!("{words} --json")).assert_ok().says(&["CC0 1.0"]);
    let made: Value = serde_json::from_str(&outcome.stdout).unwrap();
    assert_eq!(made["images"].as_array().unwrap().len(), 6);
    assert_eq!(fs::read_dir(sandbox.path("walk/images")).unwrap().count(), 6);
    assert!(!sandbox.path("walk/images.part").exists());
    // A file's pixels are the photograph's, but for what JPEG loses.
    let cameras = still_life::cameras(6, [64, 48]).unwrap();
    let file = image::open(sandbox.path("walk/images/00004.jpg")).unwrap().to_rgb8();
    let photograph = still_life::photograph(&cameras[4], 4).unwrap();
    let pairs = file.as_raw().iter().zip(photograph.pixels().as_flattened());
    let off: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    assert!(off < 4 * file.as_raw().len() as u64, "{off}");
    sandbox.assert_refuses(words, &["walk has images already", "choose another folder"]);
    sandbox.run("train walk -o run --steps 2 --max-gaussians 2000 --backend cpu").assert_ok();
}

#[test]
fn bad_inputs_are_refused() {
    let sandbox = Sandbox::new("tiny");
    for name in ["one.jpg", "notes.txt", "phone/IMG_1.HEIC"] {
        sandbox.write(name, "not a photograph");
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
    sandbox.write("run/config.toml", "");
    sandbox.assert_refuses("capture notes.txt -o run", &["run holds a training run"]);
    let outcome = sandbox.shell("PATH=/nowhere \"$ORGANZA\" capture notes.txt -o data");
    outcome.assert_refused(&["not installed: ffmpeg colmap", "apt install ffmpeg colmap"]);
    sandbox.write_program("ffmpeg", "#!/bin/sh\n");
    let outcome = sandbox.shell("PATH=\"$PWD/bin\" \"$ORGANZA\" capture notes.txt -o data");
    outcome.assert_refused(&["not installed: colmap. colmap finds", "https://colmap.github.io"]);
    assert!(!outcome.stderr.contains("ffmpeg"), "{outcome:?}");
    assert!(!sandbox.path("data").exists());
    if ["colmap", "ffmpeg"].into_iter().all(is_there) {
        sandbox.assert_refuses(
            "capture notes.txt -o data",
            &["ffmpeg failed", "Is notes.txt a video?"],
        );
    }
    // Training looks at them in the same way.
    sandbox.assert_refuses("train phone -o run-2", &["HEIC", "convert them to JPEG first"]);
    sandbox.write("photos/1.jpg", "");
    sandbox.assert_refuses("train photos -o run-2", &["photos: 1 photograph, expected 3 or more"]);
    sandbox.write("beer.mp4", "not a video");
    let outcome = sandbox.shell("PATH=/nowhere \"$ORGANZA\" train beer.mp4 -o run-2");
    outcome.assert_refused(&["not installed: ffmpeg colmap"]);
    // Poses of LLFF are there.
    sandbox.write("llff/poses_bounds.npy", "");
    sandbox.copy_file("photos/1.jpg", "llff/images_8/1.jpg");
    let facts = ["poses_bounds.npy, are not read", "llff -o NEW` finds the poses"];
    sandbox.assert_refuses("train llff -o run-2", &facts);
    // A folder of data sets is none of photographs.
    sandbox.copy_file("cameras.json", "sets/one/transforms.json");
    sandbox.copy_file("photos/1.jpg", "sets/one/1.jpg");
    sandbox.assert_refuses("train sets -o run-2", &["sets/one is a data set"]);
    sandbox.assert_refuses("eval scene.safetensors beer.mp4", &["organza capture"]);
}

/// Stands in for COLMAP: it refuses options that are not in the file `known`. Its mapper finds the models of the folder
/// `found-1`, then `found-2`.
const COLMAP: &str = include_str!("stand_ins/colmap.sh");

/// Stands in for ffmpeg, for a video of 60 frames. The last 20 have the size that the file `second-size` says.
const FFMPEG: &str = include_str!("stand_ins/ffmpeg.sh");

/// Options that ffmpeg 5.1 to 9.0 and COLMAP 4.1 know, by their sources and helps.
const KNOWN: &str = include_str!("stand_ins/known.txt");

/// Versions of COLMAP after which names changed, and what older versions have instead of a part of the newest names.
const VERSIONS: [[&str; 3]; 3] = [
    ["3.8", "Feature", "Sift"],
    ["3.13.0", "FeatureExtraction.max", "SiftExtraction.max"],
    ["4.1.1", "Feature", "Feature"],
];

/// Makes COLMAP be of this version.
fn write_known(sandbox: &Sandbox, [colmap, newest, name]: [&str; 3]) {
    sandbox.write("known", format!("colmap {colmap}\n{}", KNOWN.replace(newest, name)));
}

/// An image with a pose, as COLMAP finds it.
struct PosedImage {
    name: String,
    eye: DVec3,
    focal: f64,
}

/// A walk around something in steps of 30 degrees.
fn walk(names: impl Iterator<Item = String>) -> Vec<PosedImage> {
    let found = |(step, name): (usize, String)| {
        let (y, x) = (30.0 * step as f64).to_radians().sin_cos();
        PosedImage { name, eye: DVec3::new(4.0 * x, 4.0 * y, 1.0), focal: 500.0 }
    };
    names.enumerate().map(found).collect()
}

fn photos(count: usize) -> impl Iterator<Item = String> {
    (0..count).map(|photo| format!("{photo:02}.png"))
}

/// The names that a film's frames get.
fn frames(frames: Range<usize>) -> impl Iterator<Item = String> + Clone {
    frames.map(|frame| format!("frame-{frame:06}.png"))
}

/// Writes a model of 400 points, each with an error, in pixels, and in a number of images.
fn write_model(sandbox: &Sandbox, folder: &str, found: &[PosedImage], error: f64, track: usize) {
    let [mut cameras, mut images, mut points] = [const { String::new() }; 3];
    for (id, PosedImage { name, eye, focal }) in found.iter().enumerate() {
        writeln!(cameras, "{id} SIMPLE_RADIAL 640 480 {focal} 320 240 0.01").unwrap();
        writeln!(images, "{id} 1 0 0 0 {} {} {} {id} {name}\n", -eye.x, -eye.y, -eye.z).unwrap();
    }
    for id in 0..400 {
        writeln!(points, "{id} 0 0 0.5 9 9 9 {error}{}", " 1 0".repeat(track)).unwrap();
    }
    for (name, text) in [("cameras", cameras), ("images", images), ("points3D", points)] {
        sandbox.write(&format!("{folder}/{name}.txt"), text);
    }
}

/// A sandbox with the newest of the programs above, and with 12 photographs.
fn with_programs() -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    sandbox.write_program("colmap", COLMAP);
    sandbox.write_program("ffmpeg", FFMPEG);
    write_known(&sandbox, VERSIONS[2]);
    for (photo, name) in photos(12).enumerate() {
        write_photo(&sandbox, &format!("photos/{name}"), [8, 6], photo);
    }
    sandbox
}

/// Writes a photograph of a color of its own.
fn write_photo(sandbox: &Sandbox, name: &str, [width, height]: [u32; 2], photo: usize) {
    let color = image::Rgb([20 * photo as u8, 90, 30]);
    let path = sandbox.path(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    image::RgbImage::from_pixel(width, height, color).save(path).unwrap();
}

fn capture(sandbox: &Sandbox, words: &str) -> Outcome {
    organza(sandbox, &format!("capture {words}"))
}

/// Runs organza, with the programs in `bin`, whose calls are counted anew.
fn organza(sandbox: &Sandbox, words: &str) -> Outcome {
    sandbox.shell(&format!("rm -f calls.txt; PATH=\"$PWD/bin:$PATH\" \"$ORGANZA\" {words}"))
}

/// The calls of the programs in `bin`, by the last run of organza.
fn called(sandbox: &Sandbox) -> String {
    sandbox.text("calls.txt")
}

#[test]
#[ignore = "takes ffmpeg; .ci/nightly runs it"]
fn frames_keep_the_shape_of_their_video() {
    // The third film has pixels that are 4/3 as wide as high.
    let films = [
        ("640x360", "1", [301, 169]),
        ("360x640", "1", [169, 301]),
        ("240x180", "4/3", [301, 169]),
        ("640x640", "1", [301, 301]),
        ("90x60", "1", [90, 60]),
    ];
    for (size, shape, expected) in films {
        let sandbox = with_programs();
        sandbox.remove("bin/ffmpeg");
        let film = format!("testsrc=size={size}:rate=1:duration=3 -vf setsar={shape} film.mp4");
        sandbox.shell(&format!("ffmpeg -v error -f lavfi -i {film}")).assert_ok();
        write_model(&sandbox, "found-1/0", &walk(frames(0..3)), 0.7, 20);
        capture(&sandbox, "film.mp4 -o data --side 301").assert_ok();
        for name in frames(0..3) {
            let found = image::image_dimensions(sandbox.path("data/images").join(name)).unwrap();
            assert_eq!([found.0, found.1], expected, "{film}");
        }
    }
}

/// Every option that a capture passes is one that the installed version has.
#[test]
fn each_version_of_colmap_is_asked_for_its_options() {
    for version in VERSIONS {
        let sandbox = with_programs();
        write_known(&sandbox, version);
        let [colmap, ..] = version;
        sandbox.write("film.mp4", "a film");
        write_model(&sandbox, "found-1/0", &walk(frames(0..60)), 0.7, 20);
        let found = format!("with ffmpeg 5.1.9-0+deb12u1 and colmap {colmap}");
        let outcome = capture(&sandbox, "film.mp4 -o data").assert_ok();
        outcome.says(&[&found, "60 of 60"]).says_not(&["warning"]);
    }
    // A version that nobody has seen yet.
    let sandbox = with_programs();
    write_model(&sandbox, "found-1/0", &walk(photos(12)), 0.7, 20);
    sandbox.shell("sed -i '/ExhaustiveMatching/d' known").assert_ok();
    capture(&sandbox, "photos -o data")
        .assert_ok()
        .says(&["no option `--ExhaustiveMatching.block_size`, so it is left out"]);
}

/// A cover picture comes before the film, which gets other frames than it began with.
#[test]
#[ignore = "takes ffmpeg; .ci/nightly runs it"]
fn frames_are_the_films_own() {
    let sandbox = with_programs();
    sandbox.remove("bin/ffmpeg");
    // Gray of a growing brightness: 4 wide frames, and then 6 high ones.
    let make = "ffmpeg -v error -f lavfi -i \"color=black:s=$1:r=5:d=$2,format=yuv420p,geq=lum='40+15*(N+$3)':cb=128:cr=128\" \
                -c:v libx264 -qp 0 $1.h264";
    sandbox.write("make.sh", make);
    sandbox.shell("sh make.sh 64x36 0.8 0 && sh make.sh 36x64 1.2 4").assert_ok();
    sandbox.shell("cat 64x36.h264 36x64.h264 > film.h264").assert_ok();
    let names = frames(4..10);
    write_model(&sandbox, "found-1/0", &walk(names.clone()), 0.7, 20);
    capture(&sandbox, "film.h264 -o data")
        .assert_ok()
        .says(&["36 x 64 pixels are used, and 4 of 10 are left out"]);
    for (frame, name) in names.enumerate() {
        let image = image::open(sandbox.path("data/images").join(&name)).unwrap().to_rgb8();
        assert_eq!(image.dimensions(), (36, 64));
        // Luma of 16 to 235 is gray of 0 to 255.
        let gray = (40.0 + 15.0 * (frame + 4) as f64 - 16.0) * 255.0 / 219.0;
        assert!((f64::from(image.get_pixel(18, 32)[0]) - gray).abs() < 2.0, "{name}: {gray}");
    }

    let film = "-f lavfi -i color=red:s=64x36:r=5:d=1 -i photos/01.png -map 1 -map 0 -c:v:0 copy -disposition:v:0 attached_pic";
    sandbox.shell(&format!("ffmpeg -v error {film} covered.mp4")).assert_ok();
    write_model(&sandbox, "found-1/0", &walk(frames(0..5)), 0.7, 20);
    capture(&sandbox, "covered.mp4 -o covered")
        .assert_ok()
        .says(&["taking the 5 sharpest of 5 frames"]);
    let image = image::open(sandbox.path("covered/images/frame-000000.png")).unwrap();
    assert_eq!([image.width(), image.height()], [64, 36]);
}

/// Gray of HLG, as ITU-R BT.2100 shows it with 1,000 candelas per square meter and BT.1886 with 203: E / sqrt(3) of it.
#[test]
#[ignore = "takes ffmpeg; .ci/nightly runs it"]
fn colors_of_hlg_fit_a_screen() {
    let sandbox = with_programs();
    sandbox.remove("bin/ffmpeg");
    let gray =
        "color=black:s=64x36:r=5:d=1,format=yuv420p10le,geq=lum='64+876*0.1*N':cb=512:cr=512";
    let tags =
        "-color_primaries bt2020 -color_trc arib-std-b67 -colorspace bt2020nc -color_range tv";
    sandbox
        .shell(&format!("ffmpeg -v error -f lavfi -i \"{gray}\" -c:v ffv1 {tags} film.mkv"))
        .assert_ok();
    let names = frames(0..5);
    write_model(&sandbox, "found-1/0", &walk(names.clone()), 0.7, 20);
    capture(&sandbox, "film.mkv -o data")
        .assert_ok()
        .says(&["mapping the colors of HLG to a screen's"])
        .says_not(&["warning"]);
    for (frame, name) in names.enumerate() {
        let image = image::open(sandbox.path("data/images").join(&name)).unwrap().to_rgb8();
        // The inverse of HLG is E^2 / 3 here, its display makes that a power of 1.2, and another one has a gamma of 2.4.
        let linear = 1000.0 / 203.0 * ((0.1 * frame as f64).powi(2) / 3.0).powf(1.2);
        let expected = 255.0 * linear.powf(1.0 / 2.4);
        let found = f64::from(image.get_pixel(30, 18)[0]);
        assert!((found - expected).abs() < 2.0, "{name}: {found}, expected {expected}");
    }
}

#[test]
fn sound_poses_lead_to_training() {
    let sandbox = with_programs();
    // COLMAP's first model is a part that it could not join to the other one.
    write_model(&sandbox, "found-1/0", &walk(photos(3)), 0.7, 6);
    write_model(&sandbox, "found-1/1", &walk(photos(12)), 0.7, 6);
    let words = [
        "12 of 12 images have a pose",
        "400 points: 6.0 images see each in the mean, 0.70 pixels off; an image shows 200",
        "the poses are sound",
        "next: organza train data -o data-run",
    ];
    capture(&sandbox, "photos -o data").assert_ok().says(&words).says_not(&["warning", "mend"]);
    let calls = called(&sandbox);
    for call in ["camera_model SIMPLE_RADIAL", "exhaustive_matcher", "models/1"] {
        assert!(calls.contains(call), "no `{call}`: {calls}");
    }
    capture(&sandbox, "photos -o data").assert_ok().says(&words).says_not(&["warning"]);
    assert!(!sandbox.path("data/.organza-capture").exists());
}

/// In one line from photographs or a video to a scene, and again after each way to stop.
#[test]
fn training_captures_first() {
    let sandbox = with_programs();
    for (photo, name) in photos(12).enumerate() {
        write_photo(&sandbox, &format!("photos/{name}"), [640, 480], photo);
    }
    write_model(&sandbox, "found-1/0", &walk(photos(12)), 0.7, 6);
    let train = "train photos -o run --steps 2 --max-gaussians 300 --backend cpu";
    sandbox.write("broken", "");
    organza(&sandbox, train).assert_refused(&["colmap failed"]);
    organza(&sandbox, "train --resume run")
        .assert_refused(&["run has no training yet", "VIDEO|PHOTOS -o run"]);
    sandbox.remove("broken");
    let outcome = organza(&sandbox, train).assert_ok();
    let words = [
        "wrote run/data: 12 of 12",
        "the poses are sound",
        "12 photographs (COLMAP)",
        "next: organza view run",
    ];
    outcome.says(&words).says_not(&["next: organza train"]);
    let images = sandbox.read_json("run/data/capture.json")["images"].clone();
    assert_eq!(images, 12);
    organza(&sandbox, "eval run --backend cpu").assert_ok();
    organza(&sandbox, train).assert_refused(&["run holds a run already", "`--resume`"]);
    organza(&sandbox, "train --resume run --steps 3 --backend cpu").assert_ok();
    // Settings are wrong before anything is made, and a capture that is there is taken.
    organza(&sandbox, &format!("{train} --set run.stesp=5")).assert_refused(&["run.steps"]);
    capture(&sandbox, "photos -o new/data").assert_ok();
    let outcome = organza(&sandbox, &train.replace("-o run", "-o new")).assert_ok();
    outcome
        .says(&["new/data is there from an earlier call", "the poses are sound"])
        .says_not(&["with colmap"]);

    write_model(&sandbox, "found-1/0", &walk(photos(12).take(5)), 0.7, 6);
    sandbox.copy_file("photos/00.png", "photos/zz.png");
    let poor = organza(&sandbox, "train photos -o poor --steps 2 --backend cpu");
    let facts = ["not worth training", "mend the capture", "`organza train poor/data -o NEW`"];
    poor.assert_refused(&facts);
    poor.says(&["5 of 13 images have a pose", "no pose: "]).says_not(&["next"]);
    assert!(!sandbox.path("poor/config.toml").exists());
}

#[test]
fn each_fault_of_poses_has_words() {
    let sandbox = with_programs();
    let mut found = walk(photos(12));
    found.remove(11);
    found[2].focal = 700.0;
    found[6].eye *= 9.0;
    write_model(&sandbox, "found-1/0", &found, 1.8, 2);
    let outcome = capture(&sandbox, "photos -o data --camera-model RADIAL").assert_ok();
    let words = [
        "no pose: 11.png. Add images",
        "an image shows only 73 points, expected 100 or more",
        "only 2.0 images see a point, expected 2.5 or more",
        "points are 1.8 pixels off, expected 1.5 or fewer",
        "another focal length than most: 02.png. Use one lens",
        "the camera jumps at 06.png, 07.png. If it did not",
        "these poses are not worth training",
        "next: mend the capture",
    ];
    // All pairs were compared.
    outcome.says(&words).says_not(&["organza train", "--matcher"]);
    let calls = called(&sandbox);
    assert!(calls.contains("camera_model RADIAL"), "{calls}");
}

#[test]
fn too_few_poses_are_not_worth_training() {
    for (posed, is_trainable) in [(8, true), (7, false)] {
        let sandbox = with_programs();
        write_model(&sandbox, "found-1/0", &walk(photos(posed)), 0.7, 6);
        let outcome = capture(&sandbox, "photos -o data").assert_ok();
        let words = [
            "this can be trained, but what a warning names",
            "next: organza train data -o data-run",
        ];
        match is_trainable {
            true => outcome.says(&words).says_not(&["next: mend"]),
            false => outcome
                .says(&["no pose: 07.png, 08.png, 09.png, 10.png, 11.png.", "next: mend"])
                .says_not(&words),
        };
    }
}

#[test]
fn neighbors_alone_are_not_the_last_word() {
    let sandbox = with_programs();
    sandbox.write("film.mp4", "a film");
    write_model(&sandbox, "found-1/0", &walk(frames(0..40)), 0.7, 20);
    write_model(&sandbox, "found-2/0", &walk(frames(0..60)), 0.7, 20);
    let outcome = capture(&sandbox, "film.mp4 -o data").assert_ok();
    let words = [
        "only 40 of 60 images have a pose, so each is now",
        "60 of 60 images have a pose",
        "sound",
    ];
    outcome.says(&words).says_not(&["warning"]);
    let calls = called(&sandbox);
    let matchers: Vec<_> = calls.lines().filter(|call| call.contains("_matcher ")).collect();
    assert!(matchers.len() == 2 && matchers[0].starts_with("sequential"), "{calls}");
    assert!(calls.contains("camera_model OPENCV"), "{calls}");

    // Who chooses a matcher has chosen.
    let outcome = capture(&sandbox, "film.mp4 -o other --matcher sequential").assert_ok();
    let words =
        ["40 of 60", "no pose: frame-000040.png, ", " and 15 more", "`--matcher exhaustive`"];
    outcome.says(&words).says_not(&["is now"]);
}

#[test]
fn a_fisheyes_photographs_stay_as_they_are_and_panoramas_are_warned_about() {
    let sandbox = with_programs();
    write_photo(&sandbox, "photos/03.png", [64, 32], 3);
    write_model(&sandbox, "found-1/0", &walk(photos(12)), 0.7, 20);
    let warning = ["1 image twice as wide as high", "into flat views first"];
    capture(&sandbox, "photos -o data").assert_ok().says(&warning);
    // organza cuts them when it reads them
    let words = "photos -o fisheye --camera-model OPENCV_FISHEYE";
    capture(&sandbox, words).assert_ok().says_not(&["twice as wide"]);
    let calls = called(&sandbox);
    assert!(!calls.contains("undistorter"), "{calls}");
    assert!(sandbox.path("fisheye/sparse/0/cameras.txt").exists());
}

/// Writes a photograph of a camera that was held on its side: its right half, which is to be below, is white.
fn write_turned(mut encoder: impl ImageEncoder) {
    // A TIFF header, and one entry: tag 0x112 (orientation) is one short, 6. The top is at the right.
    let exif = b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
    encoder.set_exif_metadata(exif.to_vec()).unwrap();
    let pixel = |x: u32, _| image::Rgb([255 * u8::from(x >= 16); 3]);
    image::RgbImage::from_fn(32, 16, pixel).write_with_encoder(encoder).unwrap();
}

#[test]
fn photographs_that_are_to_be_shown_turned_are_turned() {
    let sandbox = with_programs();
    sandbox.shell("rm photos/*").assert_ok();
    let create = |name: &str| fs::File::create(sandbox.path("photos").join(name)).unwrap();
    let names = ["1.jpg", "2.jpg", "3.png"];
    names[..2].iter().for_each(|name| write_turned(JpegEncoder::new(create(name))));
    write_turned(PngEncoder::new(create(names[2])));
    write_model(&sandbox, "found-1/0", &walk(names.into_iter().map(str::to_owned)), 0.7, 6);
    // Twice as wide as high is not twice as high as wide.
    capture(&sandbox, "photos -o data")
        .assert_ok()
        .says(&["3 of 3 images have a pose"])
        .says_not(&["panoramas"]);
    for name in names {
        let reader = ImageReader::open(sandbox.path("data/images").join(name)).unwrap();
        let mut decoder = reader.into_decoder().unwrap();
        assert_eq!(decoder.orientation().unwrap(), Orientation::NoTransforms);
        assert!(decoder.exif_metadata().unwrap().is_some());
        let turned = DynamicImage::from_decoder(decoder).unwrap().to_rgb8();
        assert_eq!(turned.dimensions(), (16, 32));
        let [top, bottom] = [4, 27].map(|y| turned.get_pixel(8, y)[0]);
        assert!(top < 5 && bottom > 250, "{top} {bottom}");
    }
}

#[test]
fn an_unfinished_capture_continues_and_takes_no_others() {
    let sandbox = with_programs();
    write_model(&sandbox, "found-1/0", &walk(photos(12)), 0.7, 6);
    sandbox.write("broken", "");
    capture(&sandbox, "photos -o data").assert_refused(&["colmap failed"]);
    let others = "cp -r photos others && cp photos/01.png others/00.png && rm calls.txt";
    sandbox.shell(others).assert_ok();
    let before = sandbox.files();
    for words in ["others -o data", "photos -o data --side 640"] {
        capture(&sandbox, words).assert_refused(&[
            "data holds an unfinished capture of other images or options",
            "the command that began it",
            "remove data/.organza-capture",
        ]);
    }
    assert!(before == sandbox.files());
    sandbox.remove("broken");
    // Photographs are their content, wherever they are.
    sandbox.shell("cp -r photos moved && touch -d '2 days ago' moved/*").assert_ok();
    capture(&sandbox, "./moved/ -o data").assert_ok().says(&["12 of 12"]);
    capture(&sandbox, "photos/*.png -o data")
        .assert_ok()
        .says(&["data is there from an earlier call"]);

    let film = vec![7; 40 << 20];
    sandbox.write("film.mp4", &film);
    sandbox.write("broken", "");
    capture(&sandbox, "film.mp4 -o film").assert_refused(&["colmap failed"]);
    sandbox.shell("mv film.mp4 other.mp4 && touch -d '2 days ago' other.mp4").assert_ok();
    capture(&sandbox, "other.mp4 -o film").assert_refused(&["colmap failed"]);
    sandbox.write("other.mp4", [&film[1..], &[8]].concat());
    capture(&sandbox, "other.mp4 -o film").assert_refused(&["film holds an unfinished capture"]);
}

/// What `train` refuses is refused before hours of work, and named as the user named it.
#[test]
fn photographs_are_checked_as_training_checks_them() {
    let sandbox = with_programs();
    write_model(&sandbox, "found-1/0", &walk(photos(12)), 0.7, 6);
    // macOS leaves these beside files on disks of others.
    sandbox.write("photos/._00.png", b"\0\x05\x16\x07");
    // The content decides, not the name.
    let jpeg = |name: &str| {
        let image =
            image::RgbImage::from_fn(80, 60, |x, y| image::Rgb([(x * y) as u8, x as u8, y as u8]));
        image.save_with_format(sandbox.path(name), image::ImageFormat::Jpeg).unwrap();
    };
    jpeg("photos/05.png");
    capture(&sandbox, "photos -o data").assert_ok().says(&["12 of 12"]).says_not(&["warning"]);

    let whole = sandbox.read("photos/05.png");
    sandbox.write("photos/05.png", &whole[..whole.len() / 2]);
    capture(&sandbox, "photos -o cut")
        .assert_refused(&["photos/05.png: the photograph was cut short"]);
    sandbox.write("photos/05.png", b"RIFF\x10\0\0\0WEBPVP8 ");
    capture(&sandbox, "photos -o cut")
        .assert_refused(&["photos/05.png: ", "JPEG and PNG are read"]);
    assert!(!sandbox.path("cut/.organza-capture").exists());

    sandbox.copy_file("photos/04.png", "photos/05.png");
    capture(&sandbox, "photos -o copies")
        .assert_ok()
        .says(&["warning: the same photograph is there twice: photos/04.png and photos/05.png."])
        .says_not(&["more such"]);
}

#[test]
fn numbers_in_names_are_in_their_natural_order() {
    let sandbox = with_programs();
    let names = || (0..24).map(|photo| format!("Photo ({photo}).png"));
    for (photo, name) in names().enumerate() {
        write_photo(&sandbox, &format!("walk/{name}"), [8, 6], photo % 12);
    }
    // Far out and back, in steps of one: in the order of letters, the camera would jump.
    let mut found = walk(names());
    for (step, found) in found.iter_mut().enumerate() {
        found.eye = DVec3::new(step as f64, 0.0, 0.0);
    }
    write_model(&sandbox, "found-1/0", &found, 0.7, 20);
    capture(&sandbox, "walk -o data").assert_ok().says(&["24 of 24"]).says_not(&["jumps", "zeros"]);
    // COLMAP looks for neighbors in the order of letters.
    for PosedImage { name, .. } in &mut found {
        *name = name.replace("(", if name.len() == 13 { "(0" } else { "(" });
    }
    write_model(&sandbox, "found-1/0", &found, 0.7, 20);
    capture(&sandbox, "walk -o neighbors --matcher sequential")
        .assert_ok()
        .says(&["Photo (0).png becomes Photo (00).png", "24 of 24"])
        .says_not(&["jumps"]);
}

#[test]
fn photographs_are_found_in_the_folders_of_a_camera() {
    let sandbox = with_programs();
    let mut photo = 0;
    for folder in ["100APPLE", "101APPLE"] {
        for name in ["IMG_1.png", "IMG_2.png"] {
            photo += 1;
            write_photo(&sandbox, &format!("card/DCIM/{folder}/{name}"), [8, 6], photo);
        }
    }
    let names = ["100APPLE", "101APPLE"]
        .map(|folder| [1, 2].map(|photo| format!("DCIM-{folder}-IMG_{photo}.png")));
    write_model(&sandbox, "found-1/0", &walk(names.into_iter().flatten()), 0.7, 20);
    capture(&sandbox, "card -o data")
        .assert_ok()
        .says(&[
            "taking 4 photographs of folders within, such as card/DCIM/100APPLE/IMG_1.png",
            "4 of 4",
        ])
        .says_not(&["warning"]);
    // Beside others, they may be edited or small ones.
    write_photo(&sandbox, "photos/edited/small.png", [4, 3], 0);
    sandbox.write("photos/12.heic", "HEIC");
    write_photo(&sandbox, "photos/03.png.mask.png", [8, 6], 0);
    write_model(&sandbox, "found-1/0", &walk(photos(12)), 0.7, 20);
    sandbox.shell("mkdir set && cp -r photos set/images && cp -r photos set/masks").assert_ok();
    capture(&sandbox, "set -o set-data")
        .assert_ok()
        .says(&["of set/images, and of no folder beside", "12 of 12"]);
    capture(&sandbox, "photos -o other").assert_ok().says(&[
        "not taking 1 photograph: HEIC, TIFF, AVIF",
        "masks are not used, such as photos/03.png.mask.png",
        "not taking 1 photograph of folders within, such as photos/edited/small.png",
        "12 of 12",
    ]);
}

#[test]
fn frames_of_another_size_and_of_more_brightness_are_said() {
    let sandbox = with_programs();
    sandbox.write("film.mp4", "a film");
    sandbox.write("second-size", "540x960");
    sandbox.write("transfer", "arib-std-b67");
    write_model(&sandbox, "found-1/0", &walk(frames(0..40)), 0.7, 20);
    let outcome = capture(&sandbox, "film.mp4 -o '100% of it'").assert_ok();
    let words = [
        "the frames of film.mp4 change their size: 960 x 540 pixels are used, and 20 of 60 are left out",
        "taking the 40 sharpest of 60 frames",
        "film.mp4 has colors of HLG, and this ffmpeg has no filter `zscale`",
        "40 of 40",
        "organza train '100% of it' -o '100% of it-run'",
    ];
    outcome.says(&words);
    let calls = called(&sandbox);
    assert!(
        calls.contains("eq(n,39)',scale=960:540 -fps_mode") && !calls.contains("eq(n,40)"),
        "{calls}"
    );
    assert!(calls.matches("-map 0:V:0").count() == 2, "{calls}");
}
