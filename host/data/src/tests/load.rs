//! Behavior that all formats share: recognizing the format, holding out frames, missing photographs.

use std::fs;

use super::colmap_files::{self, sample};
use super::*;
use organza_core::error::Error;

#[test]
fn kinds_are_told_apart_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    let kind = || load(root).unwrap().kind;
    colmap_files::write(root, &sample(), true);
    assert_eq!(kind(), DatasetKind::Colmap);
    write_image(&root.join("images/0.png"), [6, 4], [1, 2, 3]);
    write_image(&root.join("images/1.png"), [6, 4], [1, 2, 3]);
    write_json(&root.join("transforms_train.json"), &transforms(2));
    assert_eq!(kind(), DatasetKind::Blender);
    write_json(&root.join("transforms.json"), &transforms(2));
    assert_eq!(kind(), DatasetKind::Nerfstudio);
    let single = load(&root.join("transforms_train.json")).unwrap();
    assert_eq!(single.kind, DatasetKind::Blender);
    assert_eq!(load(&root.join("transforms.json")).unwrap().path, root.join("transforms.json"));
    assert_eq!(single.kind.to_string(), "Blender");
}

#[test]
fn unknown_folders_are_refused_with_the_expected_names() {
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().display().to_string();
    assert_refused(
        folder.path(),
        &[&name, "transforms.json", "transforms_train.json", "cameras.bin", "sparse/0"],
    );
    assert_refused(&folder.path().join("absent"), &["absent", "no such file"]);
}

#[test]
fn every_eighth_frame_or_third_arc_is_held_out() {
    let folder = nerfstudio_folder(&transforms(18));
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.held_out, [0, 8, 16]);
    assert_eq!(dataset.train.len(), 15);
    assert!(dataset.train.iter().all(|index| index % 8 != 0));
    let every = |hold_out_every| {
        let options = DatasetOptions { hold_out_every, ..in_the_world() };
        Dataset::load(folder.path(), &options).unwrap().held_out
    };
    assert_eq!(every(7), [0, 7, 14]);
    assert!(every(0).is_empty());
    let options = DatasetOptions { hold_out_every: 3, hold_out_length: 4, ..in_the_world() };
    let arcs = Dataset::load(folder.path(), &options).unwrap();
    assert_eq!(arcs.held_out, [0, 1, 2, 3, 12, 13, 14, 15]);
    assert_eq!(arcs.train, [4, 5, 6, 7, 8, 9, 10, 11, 16, 17]);
    let generated = Dataset::from_frames(dataset.frames.clone(), 8);
    assert_eq!((generated.held_out, generated.train), (dataset.held_out, dataset.train));
    assert_eq!(generated.kind, DatasetKind::Generated);
}

/// Cameras read without the photographs equal the frames' cameras.
#[test]
fn poses_equal_the_cameras_of_frames() {
    let mut distorted = transforms(3);
    distorted["k1"] = json!(0.01);
    let nerfstudio = nerfstudio_folder(&distorted);
    let blender = nerfstudio_folder(&transforms(3));
    fs::rename(
        blender.path().join("transforms.json"),
        blender.path().join("transforms_train.json"),
    )
    .unwrap();
    let colmap = tempfile::tempdir().unwrap();
    colmap_files::write(colmap.path(), &sample(), true);
    for folder in [nerfstudio, blender, colmap] {
        let options = DatasetOptions { downscale: 2, hold_out_every: 2, ..Default::default() };
        let dataset = Dataset::load(folder.path(), &options).unwrap();
        let poses = Poses::load(folder.path(), &options).unwrap();
        assert_eq!((poses.dataset.kind, &poses.dataset.path), (dataset.kind, &dataset.path));
        let poses = poses.cameras().unwrap();
        assert_eq!(poses.len(), dataset.frames.len());
        for (index, (pose, frame)) in poses.iter().zip(&dataset.frames).enumerate() {
            let camera =
                Camera { file_path: frame.camera.file_path.clone(), ..pose.camera.clone() };
            assert_eq!(camera, frame.camera);
            assert_eq!(pose.camera.file_path.as_ref(), Some(&frame.name));
            assert_eq!(pose.held_out, dataset.held_out.contains(&index));
            // the file's lens: of all frames, of none, or of the first camera of COLMAP's sample
            let is_distorted = match dataset.kind {
                DatasetKind::Nerfstudio => true,
                DatasetKind::Colmap => frame.name == "a.png",
                _ => pose.camera.distorted,
            };
            assert_eq!(pose.distorted, is_distorted, "{}", frame.name);
            assert!(pose.photograph.as_ref().unwrap().ends_with(&frame.name));
        }
    }
    assert_eq!(kind_of(Path::new("absent")), None);
}

#[test]
fn progress_counts_every_photograph() {
    let folder = nerfstudio_folder(&transforms(5));
    let mut calls = Vec::new();
    let mut progress = |done, all| calls.push((done, all));
    let poses = Poses::load(folder.path(), &DatasetOptions::default()).unwrap();
    poses.photographs(&mut progress).unwrap();
    assert_eq!(calls, [(0, 5), (1, 5), (2, 5), (3, 5), (4, 5), (5, 5)]);
}

/// Frames must not move between training and measuring when a photograph is lost.
#[test]
fn missing_photographs_are_named_and_left_out() {
    let folder = nerfstudio_folder(&transforms(10));
    let lost = folder.path().join("images/3.png");
    fs::remove_file(&lost).unwrap();
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.missing, [lost]);
    let names = |indices: &[usize]| -> Vec<_> {
        indices.iter().map(|&index| dataset.frames[index].name.clone()).collect()
    };
    assert_eq!(names(&dataset.held_out), ["images/0.png", "images/8.png"]);
    assert_eq!(names(&dataset.train)[2..4], ["images/4.png", "images/5.png"]);
    assert_eq!(dataset.frames[3].image.color(0, 0)[0], 4.0 / 255.0);
}

#[test]
fn copies_and_stray_masks_are_named() {
    let mut file = transforms(10);
    let folder = nerfstudio_folder(&file);
    let root = folder.path();
    let note = || -> String {
        let notes = load(root).unwrap().notes;
        assert!(notes.len() < 2, "{notes:?}");
        notes.concat()
    };
    assert_eq!(note(), "");
    // a mask of no photograph, one that fits, and one of another size
    write_image(&root.join("masks/other.png"), [6, 4], [255; 3]);
    assert!(note().contains("masks is the mask of a photograph"), "{}", note());
    assert!(note().contains("0.png.png"), "{}", note());
    write_image(&root.join("masks/1.png"), [6, 4], [255; 3]);
    assert!(note().contains("no mask hides anything"), "{}", note());
    write_image(&root.join("masks/1.png"), [3, 2], [255; 3]);
    assert_refused(root, &["masks/1.png", "the mask is 3 x 2", "of its photograph"]);
    fs::remove_dir_all(root.join("masks")).unwrap();
    // a copy in training, and one that is held out
    let copy = |from: &str, to: &str| {
        fs::copy(root.join("images").join(from), root.join("images").join(to)).unwrap();
    };
    copy("1.png", "2.png");
    assert!(note().contains("images/1.png and ") && !note().contains("held out"), "{}", note());
    copy("0.png", "5.png");
    assert!(note().contains("images/5.png, and 1 more"), "{}", note());
    assert!(note().contains("one of these is held out"), "{}", note());
    copy("3.png", "2.png");
    copy("4.png", "5.png");
    copy("6.png", "3.png");
    copy("7.png", "4.png");
    write_image(&root.join("images/6.png"), [6, 4], [90; 3]);
    write_image(&root.join("images/7.png"), [6, 4], [91; 3]);
    // lenses that do not exist
    for focal in [1e5, 0.01] {
        file["frames"][3]["fl_x"] = json!(focal);
        write_json(&root.join("transforms.json"), &file);
        assert!(note().contains("3.png has a focal length of"), "{}", note());
    }
}

#[test]
fn without_photographs_there_is_no_data_set() {
    let folder = nerfstudio_folder(&transforms(3));
    fs::remove_file(folder.path().join("images/1.png")).unwrap();
    fs::remove_file(folder.path().join("images/2.png")).unwrap();
    assert_refused(folder.path(), &["held out (1)", "none is left to train on"]);
    fs::remove_file(folder.path().join("images/0.png")).unwrap();
    assert_refused(folder.path(), &["none of the 3 photographs", "0.png"]);
}

#[test]
fn options_are_checked() {
    let folder = nerfstudio_folder(&transforms(2));
    let assert_option = |options: DatasetOptions, facts: &[&str]| {
        let result = Dataset::load(folder.path(), &options);
        assert!(matches!(result, Err(Error::Argument { .. })), "{result:?}");
        assert_facts(result, facts);
    };
    let default = DatasetOptions::default;
    assert_option(DatasetOptions { downscale: 0, ..default() }, &["`downscale` is 0", "1 ("]);
    assert_option(
        DatasetOptions { hold_out_every: 1, ..default() },
        &["`hold_out_every` is 1", "2 or more, or 0"],
    );
    assert_option(
        DatasetOptions { background: Background::Color([0.0, 1.5, 0.0]), ..default() },
        &["`background`", "1.5", "0 to 1"],
    );
    assert_option(
        DatasetOptions { background: Background::Color([f32::NAN; 3]), ..default() },
        &["`background`", "NaN"],
    );
}

/// A file of Blender's: a camera angle, no image size, and paths without extension.
fn blender(names: &[&str]) -> Value {
    let frame =
        |name: &&str| json!({"file_path": name, "rotation": 0.01, "transform_matrix": POSE});
    json!({"camera_angle_x": 1.0, "frames": names.iter().map(frame).collect::<Vec<_>>()})
}

fn write_rgba(path: &Path, color: [u8; 4]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    image::RgbaImage::from_pixel(8, 6, image::Rgba(color)).save(path).unwrap();
}

fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    write_json(&root.join("transforms_train.json"), &blender(&["./train/r_0", "./train/r_1"]));
    write_json(&root.join("transforms_test.json"), &blender(&["./test/r_0"]));
    write_rgba(&root.join("train/r_0.png"), [200, 100, 50, 128]);
    write_rgba(&root.join("train/r_1.png"), [200, 100, 50, 255]);
    write_rgba(&root.join("test/r_0.png"), [200, 100, 50, 0]);
    folder
}

#[test]
fn the_test_file_is_held_out() {
    let folder = folder();
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.kind, DatasetKind::Blender);
    assert_eq!((dataset.train, dataset.held_out), (vec![0, 1], vec![2]));
    assert_eq!(dataset.frames[2].name, "./test/r_0");
    let camera = &dataset.frames[0].camera;
    let focal = 4.0 / 0.5_f64.tan();
    assert_eq!((camera.width, camera.height), (8, 6));
    assert_eq!((camera.fl_x, camera.fl_y, camera.cx, camera.cy), (focal, focal, 4.0, 3.0));
    assert_eq!(camera.camera_to_world, POSE);
}

#[test]
fn without_a_test_file_the_option_decides() {
    let folder = folder();
    fs::remove_file(folder.path().join("transforms_test.json")).unwrap();
    let dataset = load(folder.path()).unwrap();
    assert_eq!((dataset.train, dataset.held_out), (vec![1], vec![0]));
}

#[test]
fn alpha_lets_the_background_through() {
    let folder = folder();
    for (background, expected) in [
        ([0.0; 3], [[100, 50, 25], [200, 100, 50], [0, 0, 0]]),
        // 200 * 128/255 + 255 * 127/255 = 227.4, and so on
        ([1.0; 3], [[227, 177, 152], [200, 100, 50], [255, 255, 255]]),
        ([0.0, 0.2, 1.0], [[100, 76, 152], [200, 100, 50], [0, 51, 255]]),
    ] {
        let color = Background::Color(background);
        let options = DatasetOptions { background: color, ..in_the_world() };
        let dataset = Dataset::load(folder.path(), &options).unwrap();
        assert_eq!(dataset.background, background.map(f64::from));
        let colors: Vec<_> = dataset.frames.iter().map(|frame| frame.image.pixels()[0]).collect();
        assert_eq!(colors, expected);
    }
}

/// Published tables of Blender's scenes use a white background.
#[test]
fn alpha_is_in_front_of_white_unless_told_otherwise() {
    let folder = folder();
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.background, [1.0; 3]);
    assert_eq!(dataset.frames[2].image.pixels()[0], [255; 3]);
    // nerfstudio's data sets have no such tables
    let folder = self::folder();
    write_json(&folder.path().join("transforms.json"), &blender(&["./train/r_0"]));
    let options = DatasetOptions { hold_out_every: 0, ..in_the_world() };
    let dataset = Dataset::load(folder.path(), &options).unwrap();
    assert_eq!((dataset.kind, dataset.background), (DatasetKind::Nerfstudio, [0.0; 3]));
}

#[test]
fn errors_name_the_file() {
    let folder = folder();
    write_json(&folder.path().join("transforms_test.json"), &json!({"frames": []}));
    assert_refused(folder.path(), &["transforms_test.json", "`frames` is empty"]);
    let mut file = blender(&["./train/r_0"]);
    file["camera_angle_x"] = json!(null);
    write_json(&folder.path().join("transforms_train.json"), &file);
    assert_refused(folder.path(), &["transforms_train.json", "frame 0", "`fl_x` is missing"]);
    fs::write(folder.path().join("train/r_0.png"), "no image").unwrap();
    assert_refused(folder.path(), &["r_0.png", "cannot be decoded", "JPEG and PNG"]);
}
