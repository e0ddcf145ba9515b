use std::path::Path;

use serde_json::{Value, json};

use super::*;

const IDENTITY: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 2.0], [0.0, 1.0, 0.0, 3.0], [0.0, 0.0, 1.0, 4.0], [0.0, 0.0, 0.0, 1.0]];

fn file() -> Value {
    json!({"camera_model": "PINHOLE", "w": 96, "h": 80, "fl_x": 90.0, "fl_y": 88.0, "cx": 47.5,
        "cy": 40.5, "frames": [
            {"file_path": "a.png", "transform_matrix": IDENTITY},
            {"fl_x": 70, "w": 64.0, "transform_matrix": IDENTITY}]})
}

fn parse(value: &Value) -> Result<Vec<Camera>> {
    parse::cameras(value, Path::new("cameras.json"))
}

/// Asserts that the edited file fails with all the facts.
#[track_caller]
fn assert_error(edit: impl FnOnce(&mut Value), facts: &[&str]) {
    let mut value = file();
    edit(&mut value);
    let text = parse(&value).unwrap_err().to_string();
    for fact in facts.iter().chain(&["cameras.json"]) {
        assert!(text.contains(fact), "no {fact:?} in: {text}");
    }
}

#[test]
fn frame_goes_before_file() {
    let cameras = parse(&file()).unwrap();
    let [first, second] = cameras.as_slice() else { panic!("{cameras:?}") };
    assert_eq!((first.fl_x, first.fl_y, first.cx, first.cy), (90.0, 88.0, 47.5, 40.5));
    assert_eq!((first.width, first.height), (96, 80));
    assert_eq!(first.file_path.as_deref(), Some("a.png"));
    assert_eq!((second.fl_x, second.fl_y, second.width), (70.0, 88.0, 64));
    assert_eq!(second.file_path, None);
    assert_eq!(first.eye(), [2.0, 3.0, 4.0]);
}

#[test]
fn opencv_axes_are_down_and_forward() {
    let camera = &parse(&file()).unwrap()[0];
    assert_eq!(camera.axes(), [DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z]);
}

/// A point of the scene keeps its place relative to the image's middle, in units of the limiting side.
#[test]
fn another_size_shows_the_same_and_more() {
    let camera = &parse(&file()).unwrap()[0];
    assert_eq!(&camera.with_size([96, 80]), camera);
    let double = camera.with_size([192, 160]);
    assert_eq!((double.fl_x, double.fl_y, double.cx, double.cy), (180.0, 176.0, 95.0, 81.0));
    // wider: as high, with more at the sides
    let wide = camera.with_size([200, 80]);
    assert_eq!((wide.fl_x, wide.fl_y, wide.cx, wide.cy), (90.0, 88.0, 99.5, 40.5));
    let high = camera.with_size([48, 80]);
    assert_eq!((high.fl_x, high.fl_y, high.cx, high.cy), (45.0, 44.0, 23.75, 40.25));
    assert_eq!((high.width, high.height), (48, 80));
}

/// The cameras of the cases look at the origin, so it lies on the optical axis at their distance.
#[test]
fn case_cameras_see_the_origin() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases");
    for case in ["basic", "crowded", "narrow", "tiny", "wide"] {
        let cameras = Camera::load_all(cases.join(case).join("cameras.json")).unwrap();
        assert_eq!(cameras.len(), 2);
        for camera in cameras {
            assert!(!camera.distorted);
            let eye = camera.eye();
            let seen = camera.axes().map(|axis| -axis.dot(eye.into()));
            let distance = DVec3::from(eye).length();
            assert!(seen[0].abs() < 1e-12 && seen[1].abs() < 1e-12, "{seen:?}");
            assert!((seen[2] - distance).abs() < 1e-12, "{seen:?}");
        }
    }
}

#[test]
fn look_at_agrees_with_the_case() {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases/tiny/cameras.json");
    let expected = &Camera::load_all(case).unwrap()[0];
    let camera = Camera::look_at(expected.eye(), [0.0; 3], [0.0, 0.0, 1.0], 0.9, [96, 80]).unwrap();
    for (found, expected) in
        camera.camera_to_world.iter().flatten().zip(expected.camera_to_world.iter().flatten())
    {
        assert!((found - expected).abs() < 1e-12, "{camera:?}");
    }
    assert!((2.0 * (48.0 / camera.fl_x).atan() - 0.9).abs() < 1e-12);
    for (target, up, angle) in [
        (expected.eye(), [0.0, 0.0, 1.0], 0.9),
        ([0.0; 3], expected.eye(), 0.9),
        ([0.0; 3], [0.0, 0.0, 1.0], 4.0),
    ] {
        let result = Camera::look_at(expected.eye(), target, up, angle, [96, 80]);
        assert!(matches!(result, Err(Error::Invalid { .. })), "{result:?}");
    }
}

#[test]
fn save_and_load() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("transforms.json");
    let mut cameras = parse(&file()).unwrap();
    Camera::save_all(&path, &cameras).unwrap();
    assert_eq!(Camera::load_all(&path).unwrap(), cameras);
    // Equal intrinsics move up to the file.
    cameras.truncate(1);
    Camera::save_all(&path, &cameras).unwrap();
    assert_eq!(Camera::load_all(&path).unwrap(), cameras);
    assert_eq!(read_json(&path).unwrap()["fl_x"], json!(90.0));
    assert!(matches!(Camera::save_all(&path, &[]), Err(Error::Invalid { .. })));
    cameras[0].fl_x = f64::NAN;
    let error = Camera::save_all(&path, &cameras).unwrap_err().to_string();
    assert!(error.contains("camera frame 0"), "{error}");
}

#[test]
fn blender_angles_stand_in_for_intrinsics() {
    let mut value = json!({"camera_angle_x": 1.0, "w": 100, "h": 50,
        "frames": [{"transform_matrix": IDENTITY}]});
    let camera = &parse(&value).unwrap()[0];
    let focal = 50.0 / 0.5_f64.tan();
    assert_eq!((camera.fl_x, camera.fl_y), (focal, focal));
    assert_eq!((camera.cx, camera.cy), (50.0, 25.0));
    value["camera_angle_y"] = json!(0.6);
    value["cx"] = json!(48.0);
    let camera = &parse(&value).unwrap()[0];
    assert_eq!((camera.fl_x, camera.fl_y, camera.cx), (focal, 25.0 / 0.3_f64.tan(), 48.0));
    value["camera_angle_x"] = json!(3.2);
    assert!(parse(&value).unwrap_err().to_string().contains("camera angle is 3.2"));
}

#[test]
fn three_rows_are_enough() {
    let mut value = file();
    value["frames"][0]["transform_matrix"].as_array_mut().unwrap().pop();
    assert_eq!(parse(&value).unwrap()[0].camera_to_world, IDENTITY);
}

#[test]
fn distortion_is_noticed() {
    for (model, coefficient, expected) in [
        (json!("PINHOLE"), 0.1, false),
        (json!("OPENCV"), 0.0, false),
        (json!("OPENCV"), 0.1, true),
        (json!("OPENCV_FISHEYE"), 0.0, true),
        (json!(null), 0.1, true),
        (json!(null), 0.0, false),
    ] {
        let mut value = file();
        value["camera_model"] = model;
        value["k1"] = json!(coefficient);
        assert_eq!(parse(&value).unwrap()[0].distorted, expected, "{value}");
    }
}

#[test]
fn file_errors() {
    assert_error(|file| *file = json!([1, 2]), &["`frames` is missing"]);
    assert_error(|file| file["frames"] = json!({}), &["`frames` is an object"]);
    assert_error(|file| file["frames"] = json!([]), &["empty"]);
    assert_error(|file| file["frames"][1] = json!(3), &["frame 1", "is a number"]);
}

#[test]
fn intrinsics_errors() {
    for key in ["fl_x", "w", "h"] {
        let facts = ["frame 0", &format!("`{key}` is missing")];
        assert_error(|file| file[key] = json!(null), &facts);
    }
    assert_error(
        |file| file["frames"][1]["fl_x"] = json!("wide"),
        &["frame 1", "`fl_x` is a string"],
    );
    assert_error(|file| file["fl_y"] = json!(0), &["`fl_y` is 0", "positive"]);
    assert_error(|file| file["fl_y"] = json!(-3.0), &["`fl_y` is -3", "positive"]);
    assert_error(|file| file["cx"] = json!(1e300), &["`cx`", "finite"]);
    assert_error(|file| file["w"] = json!(96.5), &["`w` is 96.5", "65536"]);
    assert_error(|file| file["h"] = json!(0), &["`h` is 0", "65536"]);
    assert_error(|file| file["h"] = json!(65537), &["`h` is 65537", "65536"]);
    assert_error(|file| file["h"] = json!(-1), &["`h` is -1"]);
}

/// As instant-ngp reads such files.
#[test]
fn pixels_are_square_and_the_axis_is_in_the_middle_unless_the_file_says_otherwise() {
    let mut value = file();
    for key in ["fl_y", "cx", "cy"] {
        value.as_object_mut().unwrap().remove(key);
        value["frames"].as_array_mut().unwrap().iter_mut().for_each(|frame| {
            frame.as_object_mut().unwrap().remove(key);
        });
    }
    for camera in parse(&value).unwrap() {
        assert_eq!(camera.fl_y, camera.fl_x);
        let middle = [camera.width, camera.height].map(|side| 0.5 * f64::from(side));
        assert_eq!([camera.cx, camera.cy], middle);
    }
}

#[test]
fn a_scale_of_all_axes_and_rounding_to_three_digits_are_taken_out() {
    let expected = Camera::look_at([3.0, -2.0, 1.5], [0.1; 3], [0.0, 0.0, 1.0], 0.8, [96, 72]);
    let expected = expected.unwrap().camera_to_world;
    let changed = |change: fn(f64) -> f64| {
        let mut value = file();
        let mut pose = expected;
        pose.iter_mut().take(3).for_each(|row| {
            row[..3].iter_mut().for_each(|value| *value = change(*value));
        });
        value["frames"][0]["transform_matrix"] = json!(pose);
        parse(&value).map(|cameras| cameras[0].camera_to_world)
    };
    let apart = |found: [[f64; 4]; 4]| {
        let pairs = found.as_flattened().iter().zip(expected.as_flattened());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    for change in [|value| 33.0 * value, |value| 0.02 * value] {
        assert!(apart(changed(change).unwrap()) < 1e-12);
    }
    // a rotation that is exact enough stays as it is in the file
    assert_eq!(changed(|value| value).unwrap(), expected);
    assert!(apart(changed(|value| (1e3 * value).round() / 1e3).unwrap()) < 6e-4);
    assert!(changed(|value| (1e2 * value).round() / 1e2).is_err());
}

/// A homogeneous matrix means the same when all of it is multiplied.
#[test]
fn a_matrix_is_divided_by_its_last_entry() {
    let pose = Camera::look_at([3.0, -2.0, 1.5], [0.1; 3], [0.0, 0.0, 1.0], 0.8, [96, 72]);
    let pose = pose.unwrap().camera_to_world;
    for factor in [2.0, -0.25] {
        let mut value = file();
        let multiplied = pose.map(|row| row.map(|value| factor * value));
        value["frames"][0]["transform_matrix"] = json!(multiplied);
        // powers of two are exact
        assert_eq!(parse(&value).unwrap()[0].camera_to_world, pose);
    }
}

#[test]
fn pose_errors() {
    let pose = |row: usize, column: usize, value: f64| {
        move |file: &mut Value| file["frames"][1]["transform_matrix"][row][column] = json!(value)
    };
    assert_error(pose(0, 0, 0.0), &["frame 1", "singular pose"]);
    assert_error(pose(0, 0, 2.0), &["frame 1", "no rotation", "orthonormal"]);
    assert_error(pose(0, 1, 0.01), &["no rotation"]);
    assert_error(pose(2, 2, -1.0), &["mirrors"]);
    assert_error(pose(3, 0, 2.0), &["last row", "transposed"]);
    assert_error(pose(3, 3, 0.0), &["last row"]);
    assert_error(pose(1, 3, 1e39), &["finite"]);
    let matrix =
        |value: Value| move |file: &mut Value| file["frames"][0]["transform_matrix"] = value;
    assert_error(matrix(json!("identity")), &["frame 0", "0 rows", "4x4"]);
    assert_error(matrix(json!([[1, 0], [0, 1]])), &["2 rows"]);
    assert_error(matrix(json!([[1, 0, 0], [0, 1, 0], [0, 0, 1]])), &["row 0", "four numbers"]);
    assert_error(
        |file| drop(file["frames"][0].as_object_mut().unwrap().remove("transform_matrix")),
        &["frame 0", "`transform_matrix` is missing"],
    );
}
