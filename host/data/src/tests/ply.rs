use std::fs;

use super::super::ply::read;
use super::*;
use organza_core::error::Error;

const HEADER: &str = "comment made by hand\nelement camera 1\nproperty list uchar int views\n\
                      element vertex 2\nproperty double x\nproperty float y\nproperty short z\n\
                      property uchar red\nproperty uchar green\nproperty uchar blue\n\
                      property float quality\nelement face 1\n\
                      property list uchar int vertex_indices\nend_header\n";

fn text() -> Vec<u8> {
    format!(
        "ply\nformat ascii 1.0\n{HEADER}2 7 8\n0.1 2.5 -3 1 2 3 0.5\n4 5 6 255 0 9 0\n3 0 1 0\n"
    )
    .into_bytes()
}

fn binary() -> Vec<u8> {
    let mut bytes = format!("ply\nformat binary_little_endian 1.0\n{HEADER}").into_bytes();
    bytes.push(2);
    bytes.extend([7_i32, 8].map(i32::to_le_bytes).as_flattened());
    for (x, y, z, color) in [(0.1_f64, 2.5_f32, -3_i16, [1_u8, 2, 3]), (4.0, 5.0, 6, [255, 0, 9])] {
        bytes.extend(x.to_le_bytes());
        bytes.extend(y.to_le_bytes());
        bytes.extend(z.to_le_bytes());
        bytes.extend(color);
        bytes.extend(0.5_f32.to_le_bytes());
    }
    bytes
}

#[track_caller]
fn assert_error(content: &[u8], facts: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ply");
    fs::write(&path, content).unwrap();
    let result = read(&path);
    assert!(matches!(result, Err(Error::Invalid { .. })), "{result:?}");
    assert_facts(result, &[&["a.ply"], facts].concat());
}

#[test]
fn text_and_binary_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ply");
    let expected = [
        Point { position: [0.1, 2.5, -3.0], color: Some([1, 2, 3]) },
        Point { position: [4.0, 5.0, 6.0], color: Some([255, 0, 9]) },
    ];
    for content in [text(), binary()] {
        fs::write(&path, content).unwrap();
        assert_eq!(read(&path).unwrap(), expected);
    }
    let bare = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                property float z\nproperty float red\nend_header\n1 2 3 0.5\n";
    fs::write(&path, bare).unwrap();
    assert_eq!(read(&path).unwrap(), [Point { position: [1.0, 2.0, 3.0], color: None }]);
}

#[test]
fn files_cut_short_anywhere_are_errors() {
    // The face after the vertices is not read.
    let text = text();
    let end = text.len() - "5 6 255 0 9 0\n3 0 1 0\n".len();
    for length in 0..end {
        assert_error(&text[..length], &[]);
    }
    let binary = binary();
    for length in 0..binary.len() {
        assert_error(&binary[..length], &[]);
    }
}

#[test]
fn bad_files_are_refused_with_a_reason() {
    let header = |elements: &str| format!("ply\nformat ascii 1.0\n{elements}end_header\n1 2 3\n");
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    assert_error(b"something else\n", &["not a whole PLY file"]);
    assert_error(header("element face 0\n").as_bytes(), &["no `vertex`", "point cloud"]);
    assert_error(
        header("element vertex 1\nproperty float x\nproperty float y\n").as_bytes(),
        &["no property `z`"],
    );
    let many = header(&format!("element vertex {}\n{xyz}", 1_u64 << 60));
    assert_error(many.as_bytes(), &["1152921504606846976 of `vertex`", "cut short"]);
    let far = header(&format!("element vertex 1\n{xyz}")).replace("1 2 3", "1 2e39 3");
    assert_error(far.as_bytes(), &["vertex 0", "inf", "finite"]);
    let mut nan = binary();
    let x = nan.len() - 2 * (8 + 4 + 2 + 3 + 4);
    nan[x..x + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    assert_error(&nan, &["vertex 0", "NaN", "finite"]);
    let list = header(
        "element vertex 1\nproperty list uchar float x\nproperty float y\n\
                       property float z\n",
    );
    assert_error(list.as_bytes(), &["not a whole PLY file"]);
    let empty = header(&format!("element face 1000000000\nelement vertex 1\n{xyz}"));
    assert_error(empty.as_bytes(), &["1000000000 of `face`", "no properties"]);
    assert_error(header(&format!("element vertex 4000000000\n{xyz}")).as_bytes(), &["more than"]);
    let one = header(&format!("element vertex 1\n{xyz}"));
    let long = one.replace("element", &format!("comment {}\nelement", "1".repeat(3 << 20)));
    assert_error(long.as_bytes(), &["header is longer than 1048576"]);
    assert_facts(read(Path::new("absent.ply")), &["absent.ply", "no such file"]);
}
