//! Models that are damaged or not supported.

use std::fs;

use super::super::colmap::{find, list};
use super::colmap_files::{
    Model, cameras_bin, images_bin, images_txt, points_bin, points_txt, sample, write_model,
};
use super::*;

fn list_folder(root: &Path) -> Result<usize> {
    let mut poses = Poses::new(root, &DatasetOptions::default())?;
    list(&mut poses, &find(root).unwrap())?;
    Ok(poses.shots.len())
}

/// Asserts that the edited model is refused with all the facts, binary and text.
#[track_caller]
fn assert_error(edit: impl FnOnce(&mut Model), facts: &[&str]) {
    let mut model = sample();
    edit(&mut model);
    for binary in [true, false] {
        let folder = tempfile::tempdir().unwrap();
        write_model(&folder.path().join("sparse/0"), &model, binary);
        assert_facts(list_folder(folder.path()), facts);
    }
}

/// Asserts that the model is refused with all the facts after a file was replaced.
#[track_caller]
fn assert_file_error(file: &str, content: &[u8], facts: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let binary = file.ends_with(".bin");
    write_model(&folder.path().join("sparse/0"), &sample(), binary);
    fs::write(folder.path().join("sparse/0").join(file), content).unwrap();
    assert_facts(list_folder(folder.path()), &[&[file], facts].concat());
}

#[test]
fn other_lenses_are_refused_by_name() {
    for (name, id) in [("FOV", 7), ("THIN_PRISM_FISHEYE", 10), ("RAD_TAN_THIN_PRISM_FISHEYE", 11)] {
        assert_error(
            |model| model.cameras[1].1 = (name, id),
            &[
                "cameras.",
                &format!("{name} is not supported"),
                "PINHOLE, SIMPLE_RADIAL",
                "undistort",
            ],
        );
    }
    let mut model = sample();
    for id in [99, -1, i32::MIN] {
        model.cameras[0].1 = ("", id);
        let facts = ["camera 7", &format!("number {id} is not supported")];
        assert_file_error("cameras.bin", &cameras_bin(&model), &facts);
    }
    assert_file_error("cameras.txt", b"1 NEW 3 4 5\n", &["line 1", "NEW is not supported"]);
}

#[test]
fn cameras_and_poses_are_checked() {
    assert_error(
        |model| model.images[1].3 = 5,
        &["images.", "image `a.png`", "camera 5", "cameras."],
    );
    assert_error(
        |model| model.images[1].1 = [0.0; 4],
        &["images.", "image `a.png`", "[0.0, 0.0, 0.0, 0.0]", "quaternion"],
    );
    assert_error(|model| model.images[1].1[2] = f64::NAN, &["image `a.png`", "NaN", "quaternion"]);
    assert_error(|model| model.images[1].2[2] = f64::NAN, &["image `a.png`", "NaN", "finite"]);
    assert_error(|model| model.cameras[0].3[0] = -1.0, &["image `a.png`", "`fl_x` is -1"]);
    assert_error(
        |model| model.cameras[0].3[5] = f64::INFINITY,
        &["cameras.", "coefficient is inf", "finite"],
    );
    for size in [[0, 48], [64, 0], [1 << 40, 48], [u64::MAX; 2]] {
        assert_error(|model| model.cameras[0].2 = size, &["65536"]);
    }
    assert_error(
        |model| model.points[0].1[1] = f64::NAN,
        &["points3D.", "point 1", "NaN", "finite"],
    );
    assert_error(|model| model.images.clear(), &["images.", "no images"]);
    assert_error(|model| model.cameras[1].0 = 7, &["cameras.", "camera 7 is there twice"]);
    assert_error(|model| model.images[2].0 = "a.png", &["images.", "image `a.png` is there twice"]);
}

/// Tries every length. Each must give an error: no panic, no hang, and no allocation of the size that a count claims.
#[test]
fn binary_files_cut_short_anywhere_are_errors() {
    let model = sample();
    let folder = tempfile::tempdir().unwrap();
    write_model(&folder.path().join("sparse/0"), &model, true);
    list_folder(folder.path()).unwrap();
    for (file, content) in [
        ("cameras.bin", cameras_bin(&model)),
        ("images.bin", images_bin(&model)),
        ("points3D.bin", points_bin(&model)),
    ] {
        let path = folder.path().join("sparse/0").join(file);
        for length in 0..content.len() {
            fs::write(&path, &content[..length]).unwrap();
            assert_facts(list_folder(folder.path()), &[file, "cut short", "copy it again"]);
        }
        fs::write(&path, [content.as_slice(), &[0]].concat()).unwrap();
        assert_facts(list_folder(folder.path()), &[file, "1 bytes follow the last"]);
        fs::write(&path, content).unwrap();
    }
}

#[test]
fn counts_are_not_believed() {
    for (file, content, fields) in [
        ("cameras.bin", cameras_bin(&sample()), [0, 0].as_slice()),
        // The first image: its id, pose and camera, and 8 bytes of name, before its observations.
        ("images.bin", images_bin(&sample()), &[0, 8 + 4 + 56 + 4 + 8]),
        // The first point: its id, position, color and error before its track.
        ("points3D.bin", points_bin(&sample()), &[0, 8 + 8 + 24 + 3 + 8]),
    ] {
        for &field in fields {
            for count in [1_u64 << 60, u64::MAX, 1 << 40, 1 << 61] {
                let mut content = content.clone();
                content[field..field + 8].copy_from_slice(&count.to_le_bytes());
                assert_file_error(file, &content, &["cut short"]);
            }
        }
    }
}

#[test]
fn names_must_be_text() {
    let mut content = images_bin(&sample());
    content[8 + 4 + 56 + 4] = 0xff;
    assert_file_error("images.bin", &content, &["image 1", "not UTF-8"]);
}

#[test]
fn text_errors_say_where() {
    let cameras = |text: &str, facts: &[&str]| {
        assert_file_error("cameras.txt", text.as_bytes(), facts);
    };
    cameras("# a\n\n1 PINHOLE 8 6 1 2 3\n", &["line 3", "PINHOLE has 4 parameters, not 3"]);
    cameras("1 PINHOLE 8 6 1 2 3 4 5\n", &["line 1", "4 parameters, not 5"]);
    cameras("1 PINHOLE 8\n", &["line 1", "HEIGHT is missing"]);
    cameras("1 PINHOLE 8 six 1 2 3 4\n", &["HEIGHT is `six`", "a number"]);
    cameras("one PINHOLE 8 6 1 2 3 4\n", &["CAMERA_ID is `one`"]);
    cameras("1 PINHOLE 8 6 1 2 3 x\n", &["PARAMS[] is `x`"]);
    let images = images_txt(&sample());
    let edit = |from: &str, to: &str, facts: &[&str]| {
        assert_file_error("images.txt", images.replace(from, to).as_bytes(), facts);
    };
    edit(" 2 b c.png", " 2", &["line 2", "NAME is missing"]);
    edit(" 7 a.png", " x a.png", &["line 4", "CAMERA_ID is `x`"]);
    edit("0.9 -0.1", "0.9 minus", &["line 4", "QX is `minus`"]);
    let points = points_txt(&sample());
    assert_file_error(
        "points3D.txt",
        points.replace("255", "256").as_bytes(),
        &["line 2", "R is `256`"],
    );
    let channel = |value: &str| format!("1 0 0 0 {value} 0 0 0\n");
    for bad in ["255.5", "-1", "nan", "red"] {
        let fact = format!("R is `{}`", if bad == "nan" { "NaN" } else { bad });
        assert_file_error("points3D.txt", channel(bad).as_bytes(), &["line 1", &fact]);
    }
    assert_file_error(
        "points3D.txt",
        b"0.5 1 2 10 20 30 0.1\n",
        &["POINT3D_ID is `0.5`", "left out"],
    );
    assert_file_error("points3D.txt", b"1 2 3\n", &["line 1", "Z is missing"]);
    assert_file_error("points3D.txt", b"\xff\xff\n", &["UTF-8"]);
    // an image's observations may be a long line
    let long = "1 ".repeat(1 << 20);
    let edited = images.replace("\n\n", &format!("\n{long}\n")).replace(" 7 a.png", " x a.png");
    assert_file_error("images.txt", edited.as_bytes(), &["line 4", "CAMERA_ID is `x`"]);
}
