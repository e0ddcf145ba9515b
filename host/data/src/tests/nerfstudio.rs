use std::fs;

use super::*;
use crate::lens::Projection;
use crate::transforms::lens_of as transforms_lens;

/// Asserts that the edited file fails with all the facts.
#[track_caller]
fn assert_error(edit: impl FnOnce(&mut Value), facts: &[&str]) {
    let mut file = transforms(2);
    let folder = nerfstudio_folder(&file);
    edit(&mut file);
    write_json(&folder.path().join("transforms.json"), &file);
    assert_refused(folder.path(), facts);
}

#[test]
fn frames_match_the_file() {
    let mut file = transforms(3);
    file["frames"][1]["fl_x"] = json!(16.0);
    file["frames"][2]["file_path"] = json!("images/another.jpg");
    let folder = nerfstudio_folder(&file);
    let dataset = load(folder.path()).unwrap();
    let cameras = Camera::load_all(folder.path().join("transforms.json")).unwrap();
    let found: Vec<_> = dataset.frames.iter().map(|frame| frame.camera.clone()).collect();
    assert_eq!(found, cameras);
    let names: Vec<_> = dataset.frames.iter().map(|frame| frame.name.as_str()).collect();
    assert_eq!(names, ["images/0.png", "images/1.png", "images/another.jpg"]);
    assert_eq!(found[1].fl_x, 16.0);
    assert_eq!(dataset.frames[1].image.pixels(), [[1, 20, 30]; 24]);
    assert!(dataset.points.is_empty() && dataset.missing.is_empty());
}

#[test]
fn paths_may_lack_an_extension_or_come_from_windows() {
    let mut file = transforms(2);
    let folder = nerfstudio_folder(&file);
    file["frames"][0]["file_path"] = json!("./images/0");
    file["frames"][1]["file_path"] = json!("images\\1.png");
    file["frames"][1]["mask_path"] = json!("hidden\\1.png");
    fs::create_dir(folder.path().join("hidden")).unwrap();
    let pixel = |x: u32, _| image::Luma([if x == 5 { 0 } else { 255 }]);
    image::GrayImage::from_fn(6, 4, pixel).save(folder.path().join("hidden/1.png")).unwrap();
    write_json(&folder.path().join("transforms.json"), &file);
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.frames[1].name, "images\\1.png");
    assert_eq!(dataset.masked, 1);
    assert_eq!(dataset.frames[1].image.color(0, 0)[0], 1.0 / 255.0);
}

/// ScanNet++ marks frames that cannot be used. The others keep their turn of being held out.
#[test]
fn bad_frames_are_left_out() {
    let mut file = transforms(10);
    let folder = nerfstudio_folder(&file);
    file["frames"][0]["is_bad"] = json!(true);
    file["frames"][3]["is_bad"] = json!(false);
    file["frames"][5]["is_bad"] = json!(true);
    write_json(&folder.path().join("transforms.json"), &file);
    let dataset = load(folder.path()).unwrap();
    assert_eq!((dataset.frames.len(), &*dataset.held_out), (8, &[6][..]));
    let [note] = &*dataset.notes else { panic!("{:?}", dataset.notes) };
    assert!(note.contains("left out: 2, such as") && note.contains("images/0.png"), "{note}");
    // and photographs without a frame
    file["frames"].as_array_mut().unwrap().truncate(8);
    write_json(&folder.path().join("transforms.json"), &file);
    let notes = load(folder.path()).unwrap().notes;
    assert!(notes[0].contains("2 of 10 photographs have no camera"), "{notes:?}");
}

#[test]
fn lenses_are_undone() {
    let mut file = transforms(2);
    file["k1"] = json!(2.0);
    file["frames"][1]["k1"] = json!(0.0);
    let folder = nerfstudio_folder(&file);
    let dataset = load(folder.path()).unwrap();
    let [bent, straight] = dataset.frames.as_slice() else { panic!("{dataset:?}") };
    assert!(!bent.camera.distorted && !straight.camera.distorted);
    assert!(!bent.image.all_valid() && straight.image.all_valid());
    // Coefficients that a pinhole does not have are ignored.
    file["camera_model"] = json!("PINHOLE");
    write_json(&folder.path().join("transforms.json"), &file);
    assert!(load(folder.path()).unwrap().frames[0].image.all_valid());
    // Without a model, the coefficients decide.
    file["camera_model"] = json!(null);
    write_json(&folder.path().join("transforms.json"), &file);
    assert!(!load(folder.path()).unwrap().frames[0].image.all_valid());
}

#[test]
fn lenses_are_those_that_the_file_names() {
    let coefficients =
        [("k1", 0.1), ("k2", 0.2), ("k3", 0.3), ("k4", 0.4), ("k5", 0.5), ("p1", 0.6)];
    let lens_of = |edit: &[(&str, Value)]| {
        let mut file = json!({});
        coefficients.iter().for_each(|&(key, value)| file[key] = json!(value));
        edit.iter().for_each(|(key, value)| file[*key] = value.clone());
        transforms_lens(&file).unwrap()
    };
    let radial = [0.1, 0.2, 0.3, 0.4];
    let brown = Lens { radial, tangential: [0.6, 0.0], ..Lens::default() };
    assert_eq!(lens_of(&[]), brown);
    assert_eq!(lens_of(&[("camera_model", json!("OPENCV"))]), brown);
    let fisheye = Lens { projection: Projection::Fisheye, radial, ..Lens::default() };
    assert_eq!(lens_of(&[("camera_model", json!("OPENCV_FISHEYE"))]), fisheye);
    assert_eq!(lens_of(&[("is_fisheye", json!(true))]), fisheye);
    let radial = [0.1, 0.2, 0.3, 0.0];
    let denominator = [0.4, 0.5, 0.0];
    let full = Lens { radial, denominator, tangential: [0.6, 0.0], ..Lens::default() };
    assert_eq!(lens_of(&[("camera_model", json!("FULL_OPENCV"))]), full);
    assert_eq!(lens_of(&[("camera_model", json!("PINHOLE"))]), Lens::default());
}

#[test]
fn points_come_from_the_named_cloud() {
    let mut file = transforms(2);
    file["ply_file_path"] = json!("sparse_pc.ply");
    let folder = nerfstudio_folder(&file);
    assert_refused(folder.path(), &["sparse_pc.ply", "no such file"]);
    let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                property float z\nproperty uint8 red\nproperty uint8 green\n\
                property uint8 blue\nend_header\n1 2 -3.5 10 20 255\n";
    fs::write(folder.path().join("sparse_pc.ply"), text).unwrap();
    let expected = Point { position: [1.0, 2.0, -3.5], color: Some([10, 20, 255]) };
    assert_eq!(load(folder.path()).unwrap().points, [expected]);
    // programs on Windows, and on other machines
    fs::create_dir(folder.path().join("sparse")).unwrap();
    fs::copy(folder.path().join("sparse_pc.ply"), folder.path().join("sparse/a.ply")).unwrap();
    for path in ["sparse\\a.ply", "D:\\scans\\sparse\\a.ply", "/home/someone/sparse_pc.ply"] {
        file["ply_file_path"] = json!(path);
        write_json(&folder.path().join("transforms.json"), &file);
        assert_eq!(load(folder.path()).unwrap().points, [expected], "{path}");
    }
    file["ply_file_path"] = json!(null);
    write_json(&folder.path().join("transforms.json"), &file);
    let dataset = load(folder.path()).unwrap();
    assert!(dataset.points.is_empty());
    let names = ["sparse/a.ply", "sparse_pc.ply"];
    let is_named =
        |(note, name): (&String, &str)| note.contains(name) && note.contains("`ply_file_path`");
    assert!(dataset.notes.iter().zip(names).all(is_named), "{:?}", dataset.notes);
    // Blender's files name a cloud alike
    file["ply_file_path"] = json!("sparse_pc.ply");
    write_json(&folder.path().join("transforms_train.json"), &file);
    fs::remove_file(folder.path().join("transforms.json")).unwrap();
    assert_eq!(load(folder.path()).unwrap().points, [expected]);
    assert_error(
        |file| file["ply_file_path"] = json!(3),
        &["transforms.json", "`ply_file_path` is a number"],
    );
}

#[test]
fn lens_errors() {
    let model = |model: Value| move |file: &mut Value| file["camera_model"] = model;
    assert_error(
        model(json!("VR180_L")),
        &["transforms.json", "frame 0", "VR180_L is not supported", "undistort", "RADIAL"],
    );
    assert_error(model(json!("EQUIRECTANGULAR")), &["frame 0", "6 x 4", "twice as wide as high"]);
    assert_error(model(json!(4)), &["frame 0", "`camera_model` is a number"]);
    assert_error(|file| file["frames"][1]["k4"] = json!([]), &["frame 1", "`k4` is an array"]);
    assert_error(|file| file["frames"][1]["mask_path"] = json!(1), &["frame 1", "`mask_path`"]);
    assert_error(|file| file["k2"] = json!("x"), &["frame 0", "`k2` is a string"]);
}

#[test]
fn frame_errors() {
    let path = |value: Value| move |file: &mut Value| file["frames"][1]["file_path"] = value;
    assert_error(path(json!(1)), &["transforms.json", "frame 1", "`file_path` is a number"]);
    assert_error(path(json!("")), &["frame 1", "`file_path` is empty"]);
    assert_error(
        |file| drop(file["frames"][1].as_object_mut().unwrap().remove("file_path")),
        &["frame 1", "`file_path` is missing"],
    );
    assert_error(|file| file["frames"] = json!([]), &["`frames` is empty"]);
    assert_error(|file| file["frames"] = json!(null), &["`frames` is null"]);
    assert_error(|file| file["fl_x"] = json!(-1), &["frame 0", "`fl_x` is -1"]);
    assert_error(|file| file["fl_x"] = json!(null), &["frame 0", "`fl_x` is missing"]);
    let folder = nerfstudio_folder(&transforms(2));
    fs::write(folder.path().join("transforms.json"), "{").unwrap();
    assert_refused(folder.path(), &["transforms.json", "line 1"]);
}
