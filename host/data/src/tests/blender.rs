use std::fs;

use super::*;

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
    // without alpha there is nothing to composite
    for name in ["train/r_0.png", "train/r_1.png", "test/r_0.png"] {
        image::RgbImage::new(8, 6).save(folder.path().join(name)).unwrap();
    }
    assert_eq!(load(folder.path()).unwrap().background, [0.0; 3]);
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
