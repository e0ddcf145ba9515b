use std::fs;

use super::colmap_files::{Model, cameras_txt, sample, write, write_model};
use super::*;
use crate::lens::Projection;
use glam::DVec3;

fn dataset(model: &Model, binary: bool) -> Dataset {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), model, binary);
    Dataset { path: PathBuf::new(), points_file: None, ..load(folder.path()).unwrap() }
}

/// The pixel position of a point in organza's camera.
fn project(camera: &Camera, point: [f64; 3]) -> [f64; 2] {
    let offset = DVec3::from(point) - DVec3::from(camera.eye());
    let seen = camera.axes().map(|axis| axis.dot(offset));
    [camera.fl_x * seen[0] / seen[2] + camera.cx, camera.fl_y * seen[1] / seen[2] + camera.cy]
}

/// COLMAP's own computation: rotates the point by the quaternion, translates it, and projects it without distortion.
fn colmap_project(
    quaternion: [f64; 4],
    translation: [f64; 3],
    [f_x, f_y, cx, cy]: [f64; 4],
    point: [f64; 3],
) -> [f64; 2] {
    let length = quaternion.iter().map(|value| value * value).sum::<f64>().sqrt();
    let [w, x, y, z] = quaternion.map(|value| value / length);
    let [axis, point, translation] = [[x, y, z], point, translation].map(DVec3::from);
    let twice = 2.0 * axis.cross(point);
    let seen = point + w * twice + axis.cross(twice) + translation;
    [f_x * seen[0] / seen[2] + cx, f_y * seen[1] / seen[2] + cy]
}

#[test]
fn points_are_seen_where_colmap_sees_them() {
    let model = sample();
    let dataset = dataset(&model, true);
    for (image, index) in [(1, 0), (0, 1), (2, 2)] {
        let (name, rotation, translation, camera) = model.images[image];
        let frame = &dataset.frames[index];
        assert_eq!(frame.name, name);
        let intrinsics =
            if camera == 7 { [60.5, 61.5, 31.0, 25.0] } else { [100.0, 100.0, 32.0, 24.0] };
        for point in [[1.0, 2.0, 10.0], [-3.0, 0.5, 4.0], [0.0, 7.0, -2.5]] {
            let found = project(&frame.camera, point);
            let expected = colmap_project(rotation, translation, intrinsics, point);
            let is_near = |(a, b): (&f64, f64)| (a - b).abs() < 1e-9 * b.abs().max(1.0);
            assert!(found.iter().zip(expected).all(is_near), "{name}: {found:?} {expected:?}");
        }
    }
}

#[test]
fn binary_and_text_are_the_same() {
    let binary = dataset(&sample(), true);
    assert_eq!(binary, dataset(&sample(), false));
    assert_eq!(binary.kind, DatasetKind::Colmap);
    let names: Vec<_> = binary.frames.iter().map(|frame| frame.name.as_str()).collect();
    assert_eq!(names, ["a.png", "b c.png", "sub/c.png"]);
    assert_eq!((binary.held_out, binary.train), (vec![0], vec![1, 2]));
    // By their ids, 12 and 90.
    let points = [
        Point { position: [4.0, 5.0, 6.0], color: Some([7, 8, 9]) },
        Point { position: [0.1, -0.2, 0.3], color: Some([255, 0, 1]) },
    ];
    assert_eq!(binary.points, points);
    let [bent, straight, _] = binary.frames.as_slice() else { panic!() };
    assert!(!bent.image.all_valid() && straight.image.all_valid());
    assert!(!bent.camera.distorted);
}

/// Programs that compute with floats write these numbers with a point, or colors from 0 to 1.
#[test]
fn numbers_of_other_programs_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let model = sample();
    colmap_files::write(folder.path(), &model, false);
    let expected = load(folder.path()).unwrap();
    let file = |name: &str| folder.path().join("sparse/0").join(name);
    let cameras = std::fs::read_to_string(file("cameras.txt")).unwrap();
    assert!(cameras.contains(" 64 48 "));
    std::fs::write(file("cameras.txt"), cameras.replace(" 64 48 ", " 64.0 4.8e1 ")).unwrap();
    for (max, digits) in [(255.0, 1), (255.0, 4), (1.0, 6)] {
        let line = |(id, [x, y, z], color): &(u64, [f64; 3], [u8; 3])| {
            let [r, g, b] = color.map(|value| f64::from(value) * max / 255.0);
            format!("{id}.0 {x} {y} {z} {r:.digits$} {g:.digits$} {b:.digits$} nan 1 0\n")
        };
        let lines: String = model.points.iter().map(line).collect();
        std::fs::write(file("points3D.txt"), lines).unwrap();
        let found = load(folder.path()).unwrap();
        assert_eq!(found.points, expected.points);
        assert_eq!(found.frames, expected.frames);
    }
}

#[test]
fn every_model_that_is_known_is_read() {
    for (name, id, values, expected) in [
        ("SIMPLE_PINHOLE", 0, vec![9.0, 3.5, 2.5], [9.0, 9.0, 3.5, 2.5]),
        ("PINHOLE", 1, vec![9.0, 8.0, 3.5, 2.5], [9.0, 8.0, 3.5, 2.5]),
        ("SIMPLE_RADIAL", 2, vec![9.0, 3.5, 2.5, 3.0], [9.0, 9.0, 3.5, 2.5]),
        ("RADIAL", 3, vec![9.0, 3.5, 2.5, 3.0, 0.1], [9.0, 9.0, 3.5, 2.5]),
        ("OPENCV", 4, vec![9.0, 8.0, 3.5, 2.5, 3.0, 0.1, 0.01, 0.02], [9.0, 8.0, 3.5, 2.5]),
        ("OPENCV_FISHEYE", 5, vec![9.0, 8.0, 3.5, 2.5, 3.0, 0.1, 0.01, 0.02], [9.0, 8.0, 3.5, 2.5]),
        (
            "FULL_OPENCV",
            6,
            vec![9.0, 8.0, 3.5, 2.5, 3.0, 0.1, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06],
            [9.0, 8.0, 3.5, 2.5],
        ),
        ("SIMPLE_RADIAL_FISHEYE", 8, vec![9.0, 3.5, 2.5, 3.0], [9.0, 9.0, 3.5, 2.5]),
        ("RADIAL_FISHEYE", 9, vec![9.0, 3.5, 2.5, 3.0, 0.1], [9.0, 9.0, 3.5, 2.5]),
    ] {
        let mut model = sample();
        model.cameras =
            vec![(7, (name, id), [8, 6], values.clone()), (2, (name, id), [8, 6], values)];
        let binary = dataset(&model, true);
        assert_eq!(binary, dataset(&model, false));
        let Camera { fl_x, fl_y, cx, cy, .. } = binary.frames[0].camera;
        assert_eq!([fl_x, fl_y, cx, cy], expected, "{name}");
        assert_eq!(binary.frames[0].image.all_valid(), id < 2, "{name}");
    }
}

/// The parameters in COLMAP's order, each with a different number.
#[test]
fn parameters_are_where_colmap_has_them() {
    use super::super::colmap::lens_of;
    let values = |count: u32| (1..=count).map(f64::from).collect::<Vec<_>>();
    let full = Lens {
        radial: [5.0, 6.0, 9.0, 0.0],
        denominator: [10.0, 11.0, 12.0],
        tangential: [7.0, 8.0],
        ..Lens::default()
    };
    assert_eq!(lens_of("FULL_OPENCV", &values(12)).unwrap(), full);
    let fisheye =
        Lens { projection: Projection::Fisheye, radial: [5.0, 6.0, 7.0, 8.0], ..Lens::default() };
    assert_eq!(lens_of("OPENCV_FISHEYE", &values(8)).unwrap(), fisheye);
    assert_eq!(lens_of("OPENCV", &values(8)).unwrap(), lens([5.0, 6.0, 0.0], [7.0, 8.0]));
    assert_eq!(lens_of("FISHEYE", &values(4)).unwrap().projection, Projection::Fisheye);
    assert!(lens_of("FULL_OPENCV", &values(11)).unwrap_err().contains("12 parameters, not 11"));
    assert!(lens_of("FOV", &values(5)).unwrap_err().contains("not supported"));
}

#[test]
fn models_and_images_are_found_where_they_may_be() {
    let places =
        ["sparse/0", "sparse", "colmap/sparse/0", "colmap_sparse/0", "colmap_text", "colmap", ""];
    for place in places {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        write(root, &sample(), true);
        fs::remove_dir_all(root.join("sparse")).unwrap();
        write_model(&root.join(place), &sample(), false);
        // Photographs may be in the folder itself, and in another format than they had.
        fs::rename(root.join("images/a.png"), root.join("a.PNG")).unwrap();
        fs::rename(root.join("images/sub/c.png"), root.join("images/sub/c.JPG")).unwrap();
        fs::remove_file(root.join("images/b c.png")).unwrap();
        let dataset = load(root).unwrap();
        assert_eq!(dataset.frames.len(), 2, "{place}");
        assert_eq!(dataset.missing, [root.join("images/b c.png")]);
    }
}

#[test]
fn binary_goes_before_text_and_points_are_not_needed() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    write(root, &sample(), true);
    fs::write(root.join("sparse/0/cameras.txt"), "nonsense").unwrap();
    assert_eq!(load(root).unwrap().points.len(), 2);
    fs::remove_file(root.join("sparse/0/points3D.bin")).unwrap();
    assert!(load(root).unwrap().points.is_empty());
    fs::remove_file(root.join("sparse/0/cameras.bin")).unwrap();
    fs::write(root.join("sparse/0/cameras.txt"), cameras_txt(&sample())).unwrap();
    assert_refused(root, &["images.txt", "no such file"]);
}

/// People write such files by hand, some programs leave the lines out, and some editors the last end of a line.
#[test]
fn lines_of_observations_may_be_missing() {
    let model = sample();
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &model, false);
    let path = folder.path().join("sparse/0/images.txt");
    let text = fs::read_to_string(&path).unwrap();
    // poses have ten values at least, and observations are triples
    let poses = |keep: fn(usize) -> bool| {
        let lines = text
            .lines()
            .enumerate()
            .filter(|(at, line)| line.starts_with('#') || line.contains(".png") || keep(*at));
        lines.map(|(_, line)| format!("{line}\n")).collect::<String>()
    };
    for text in [
        poses(|_| false),
        poses(|at| at % 4 == 0),
        poses(|at| at % 4 > 0),
        poses(|_| false).trim_end().to_owned(),
        format!("\u{feff}{text}"),
    ] {
        fs::write(&path, &text).unwrap();
        let names: Vec<_> =
            load(folder.path()).unwrap().frames.into_iter().map(|frame| frame.name).collect();
        let mut expected: Vec<_> = model.images.iter().map(|image| image.0).collect();
        expected.sort_unstable();
        assert_eq!(names, expected, "{text}");
    }
}

/// COLMAP numbers the parts of a scene that it could not join by when it found them.
#[test]
fn the_model_with_the_most_photographs_is_used() {
    for binary in [true, false] {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        write(root, &sample(), binary);
        let mut small = sample();
        small.images.truncate(1);
        for (place, model) in [("sparse/0", &small), ("sparse/1", &sample()), ("sparse/10", &small)]
        {
            write_model(&root.join(place), model, binary);
        }
        let dataset = load(root).unwrap();
        assert_eq!(dataset.frames.len(), 3);
        let [note] = &dataset.notes[..] else { panic!("{:?}", dataset.notes) };
        for fact in ["sparse/1 has 3", "sparse/0 1", "sparse/10 1"] {
            assert!(note.contains(fact), "{fact}: {note}");
        }
    }
}

#[test]
fn points_beside_a_model_may_be_a_ply_file() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    write(root, &sample(), true);
    let expected = load(root).unwrap().points;
    let text: String = expected
        .iter()
        .map(|Point { position: [x, y, z], color }| {
            let [red, green, blue] = color.unwrap();
            format!("{x} {y} {z} {red} {green} {blue}\n")
        })
        .collect();
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n{text}"
    );
    fs::remove_file(root.join("sparse/0/points3D.bin")).unwrap();
    assert!(load(root).unwrap().notes.is_empty());
    // elsewhere, it is named
    fs::write(root.join("fused.ply"), &ply).unwrap();
    let dataset = load(root).unwrap();
    assert!(dataset.points.is_empty());
    assert!(dataset.notes[0].contains("fused.ply is not used"), "{:?}", dataset.notes);
    fs::write(root.join("sparse/0/points3D.ply"), &ply).unwrap();
    let dataset = load(root).unwrap();
    assert_eq!((dataset.points, dataset.notes), (expected, Vec::new()));
}

/// nerfstudio's file with a data set's cameras rotated by 90 degrees about z, twice as far apart, and moved.
fn moved_transforms(dataset: &Dataset) -> Value {
    let frame = |frame: &Frame| {
        let Camera { camera_to_world, fl_x, fl_y, cx, cy, width, height, .. } = &frame.camera;
        let [x, y, z, last] = camera_to_world;
        let row = |axis: [f64; 4], sign: f64, offset: f64| {
            [sign * axis[0], sign * axis[1], sign * axis[2], 2.0 * sign * axis[3] + offset]
        };
        let pose = [row(*y, -1.0, 3.0), row(*x, 1.0, -1.0), row(*z, 1.0, 0.5), *last];
        json!({"file_path": format!("images/{}", frame.name), "transform_matrix": pose, "w": width,
            "h": height, "fl_x": fl_x, "fl_y": fl_y, "cx": cx, "cy": cy})
    };
    json!({"camera_model": "PINHOLE", "frames": dataset.frames.iter().map(frame).collect::<Vec<_>>()})
}

#[test]
fn a_models_points_follow_the_cameras_of_a_transforms_file_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &sample(), true);
    let model = load(folder.path()).unwrap();
    let mut file = moved_transforms(&model);
    let path = folder.path().join("transforms.json");
    write_json(&path, &file);
    let dataset = load(folder.path()).unwrap();
    assert_eq!((dataset.kind, dataset.points.len()), (DatasetKind::Nerfstudio, 2));
    for (point, other) in dataset.points.iter().zip(&model.points) {
        let [x, y, z] = other.position;
        let expected = [3.0 - 2.0 * y, 2.0 * x - 1.0, 2.0 * z + 0.5];
        let is_near = |(a, b): (&f64, f64)| (a - b).abs() < 1e-9;
        assert!(point.position.iter().zip(expected).all(is_near), "{point:?} {expected:?}");
        assert_eq!(point.color, other.color);
    }
    // the photographs need not be where the model expects them, and folders may repeat their names
    let elsewhere = folder.path().join("fotos/left");
    fs::create_dir_all(elsewhere.parent().unwrap()).unwrap();
    fs::rename(folder.path().join("images"), &elsewhere).unwrap();
    let mut two = sample();
    two.images.push(("right/a.png", [0.1, 0.7, 0.0, 0.2], [9.0; 3], 2));
    write_model(&folder.path().join("sparse/0"), &two, true);
    for frame in file["frames"].as_array_mut().unwrap() {
        let name = frame["file_path"].as_str().unwrap().replace("images", "fotos/left");
        frame["file_path"] = json!(name);
    }
    write_json(&path, &file);
    let found = load(folder.path()).unwrap();
    assert_eq!((&found.points, found.notes.len()), (&dataset.points, 0));
    // cameras at other places belong to another model
    let x = file["frames"][1]["transform_matrix"][0][3].take();
    file["frames"][1]["transform_matrix"][0][3] = json!(40.0);
    write_json(&path, &file);
    assert_unused(folder.path(), &["sparse/0", "stand elsewhere"]);
    file["frames"][1]["transform_matrix"][0][3] = x;
    write_json(&path, &file);
    fs::write(folder.path().join("sparse/0/points3D.bin"), [7; 20]).unwrap();
    assert_unused(folder.path(), &["sparse/0", "points3D.bin"]);
    two.images.drain(..2);
    write_model(&folder.path().join("sparse/0"), &two, true);
    assert_unused(folder.path(), &["sparse/0", "only 2 of its 2"]);
}

/// Asserts that there are no points, and that one note has all the facts.
#[track_caller]
fn assert_unused(folder: &Path, facts: &[&str]) {
    let dataset = load(folder).unwrap();
    assert!(dataset.points.is_empty());
    let [note] = &dataset.notes[..] else { panic!("{:?}", dataset.notes) };
    facts.iter().for_each(|fact| assert!(note.contains(fact), "{fact}: {note}"));
}

/// Both points are 0.75 pixels off. One and two images see them; in text, two each.
#[test]
fn the_largest_model_says_what_holds_its_points() {
    for (binary, mean_track) in [(true, 1.5), (false, 2.0)] {
        let folder = tempfile::tempdir().unwrap();
        assert!(SparseModel::largest(folder.path()).unwrap().is_none());
        let small = Model { images: sample().images[..1].to_vec(), ..sample() };
        write_model(&folder.path().join("0"), &small, binary);
        write_model(&folder.path().join("1"), &sample(), binary);
        let model = SparseModel::largest(folder.path()).unwrap().unwrap();
        assert_eq!(model.folder, folder.path().join("1"));
        let names: Vec<_> = model.cameras.iter().filter_map(|c| c.file_path.as_deref()).collect();
        assert_eq!(names, ["a.png", "b c.png", "sub/c.png"]);
        assert_eq!((model.points, model.mean_track, model.mean_error), (2, mean_track, 0.75));
    }
}
