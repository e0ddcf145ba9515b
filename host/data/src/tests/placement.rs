//! A data set in coordinates of its own.

use super::*;

/// Three poses around the origin, far away and in other units, and a point between them.
fn folder(scale: f64, offset: f64) -> TempDir {
    let mut file = transforms(3);
    for (index, frame) in file["frames"].as_array_mut().unwrap().iter_mut().enumerate() {
        let angle = index as f64;
        let eye = [4.0 * angle.cos(), 4.0 * angle.sin(), 1.0].map(|x| offset + scale * x);
        let camera = Camera::look_at(eye, [offset; 3], [0.0, 0.0, 1.0], 0.8, [6, 4]).unwrap();
        frame["transform_matrix"] = json!(camera.camera_to_world);
    }
    file["ply_file_path"] = json!("points.ply");
    let folder = nerfstudio_folder(&file);
    let place = offset + 0.5 * scale;
    let text = format!(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n\
         {place} {place} {place}\n"
    );
    std::fs::write(folder.path().join("points.ply"), text).unwrap();
    folder
}

#[test]
fn units_and_origin_of_the_files_do_not_matter() {
    let load = |folder: &TempDir| Dataset::load(folder.path(), &DatasetOptions::default()).unwrap();
    let home = load(&folder(1.0, 0.0));
    for (scale, offset) in [(1e-4, 0.0), (1e4, 0.0), (1.0, 4.6e6)] {
        let files = folder(scale, offset);
        let found = load(&files);
        assert!((found.placement.scale / home.placement.scale / scale - 1.0).abs() < 1e-7);
        let places = |dataset: &Dataset| -> Vec<[f64; 3]> {
            let eyes = dataset.frames.iter().map(|frame| frame.camera.eye());
            eyes.chain(dataset.points.iter().map(|point| point.position)).collect()
        };
        for (found, expected) in places(&found).iter().zip(places(&home)) {
            for axis in 0..3 {
                assert!((found[axis] - expected[axis]).abs() < 1e-7, "{found:?}, {expected:?}");
            }
        }
        // the poses and the fingerprint are the files'
        let world = super::load(files.path()).unwrap();
        let given: Vec<_> = world.frames.iter().map(|frame| frame.camera.camera_to_world).collect();
        assert_eq!(found.poses, given);
        assert_eq!(found.fingerprint, world.fingerprint);
        assert_eq!(world.placed(found.placement), found);
    }
}

#[test]
fn a_data_set_takes_the_coordinates_of_a_scene() {
    let files = folder(1.0, 0.0);
    let placement = Placement { offset: [1.0, 2.0, 3.0], scale: 2.0, ..Placement::default() };
    let options = DatasetOptions { placement: Some(placement), ..Default::default() };
    let found = Dataset::load(files.path(), &options).unwrap();
    assert_eq!(found.frames[0].camera.eye(), [1.5, -1.0, -1.0]);
    assert_eq!(found.points[0].position, [-0.25, -0.75, -1.25]);
}
