//! Wrong results must be refused, with a message that names the place.

use image::{Rgb, RgbImage};

use super::compare::{Tolerance, compare_pictures};
use super::picture::{self, Montage};
use super::tensors::Tensors;

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-5, relative: 1e-4 };

fn tensors(name: &str, shape: &[usize], values: &[f32]) -> Tensors {
    let mut tensors = Tensors::default();
    tensors.push(name, shape, values);
    tensors
}

/// Two tiles of side 4 with values from 0 to 1.
fn tiles() -> Vec<f32> {
    (0..2 * 3 * 16).map(|index| index as f32 / 96.0).collect()
}

/// The values as bytes of a picture.
fn bytes(values: &[f32]) -> Vec<u8> {
    values.iter().map(|value| (value * 255.0).round() as u8).collect()
}

#[test]
fn text_holds_tensors() {
    let mut all = tensors("a", &[2, 3], &[1.0, -0.5, 1e-12, 3.402_823_5e38, f32::INFINITY, 0.0]);
    all.push_counts("k", &[3], &[0, 7, 4_000_000]);
    all.push("none", &[0, 4], &[]);
    all.push("one", &[], &[0.123_456_79]);
    let text = all.to_string();
    assert!(text.contains("# k [3] exact\n0 7 4000000\n"), "{text}");
    assert!(text.contains("0.1234568\n"), "{text}");
    let parsed = Tensors::parse(&text).expect("its own text");
    assert!(TOLERANCE.compare(&all, &parsed).is_ok());
    for (broken, reason) in [
        ("# a [2]\n1", "`a` of shape [2] has 1 values"),
        ("# a [2\n1 2", "no header"),
        ("# a [1]\none", "no number: `one`"),
    ] {
        let error = Tensors::parse(broken).expect_err("it is broken");
        assert!(error.contains(reason), "{error}");
    }
}

#[test]
fn tensors_are_held_to_both_tolerances() {
    let expected = tensors("a", &[2, 2], &[0.0, 1.0, -100.0, f32::INFINITY]);
    let compare = |values: &[f32]| TOLERANCE.compare(&expected, &tensors("a", &[2, 2], values));
    assert!(compare(&[0.9e-5, 1.0001, -100.009, f32::INFINITY]).is_ok());
    for (values, place) in [
        ([1.1e-5, 1.0, -100.0, f32::INFINITY], "[0, 0]: 0.00001"),
        ([0.0, 1.0002, -100.0, f32::INFINITY], "[0, 1]: 1.0002"),
        ([0.0, 1.0, -100.015, f32::INFINITY], "[1, 0]: -100.0"),
        ([0.0, 1.0, -100.0, 1.0], "[1, 1]: 1 for inf"),
        ([0.0, f32::NAN, -100.0, f32::INFINITY], "[0, 1]: NaN for 1"),
    ] {
        let message = compare(&values).expect_err("beyond the tolerance");
        assert!(message.contains(place) && message.contains("1 of 4 values"), "{message}");
    }
    let three = |values: [f32; 3]| {
        let mut tensors = Tensors::default();
        for (name, value) in ["x", "y", "z"].iter().zip(values) {
            tensors.push(name, &[1], &[value]);
        }
        tensors
    };
    let found = TOLERANCE.compare(&three([1.0; 3]), &three([1.0, 2.0, 3.0]));
    let message = found.expect_err("two of three differ");
    assert!(message.contains("`y`") && message.contains("differing after it: `z`"), "{message}");
    let nan = tensors("a", &[1], &[f32::NAN]);
    assert!(TOLERANCE.compare(&nan, &nan).is_err(), "NaN is never right");
}

#[test]
fn shapes_names_and_counts_are_held_to_equality() {
    let expected = tensors("a", &[2, 2], &[0.0; 4]);
    for other in [
        tensors("a", &[4], &[0.0; 4]),
        tensors("b", &[2, 2], &[0.0; 4]),
        tensors("a", &[2, 3], &[0.0; 6]),
        Tensors::default(),
    ] {
        let message = TOLERANCE.compare(&expected, &other).expect_err("another shape");
        assert!(message.contains("shapes differ") && message.contains("a [2, 2]"), "{message}");
    }
    let counts = |counts: &[u32]| {
        let mut tensors = Tensors::default();
        tensors.push_counts("k", &[2], counts);
        tensors
    };
    let found = TOLERANCE.compare(&counts(&[1_000_000, 3]), &counts(&[1_000_001, 3]));
    let message = found.expect_err("a count is exact");
    assert!(message.contains("[0]: 1000001 for 1000000; it must be equal"), "{message}");
}

#[test]
fn a_difference_is_told_with_its_place() {
    let montage = Montage { tiles: 2, side: 4, columns: 2, scale: 4 };
    let mut wrong = tiles();
    // tile 1, blue, row 1, column 2; and a smaller one elsewhere
    wrong[48 + 32 + 4 + 2] -= 10.0 / 255.0;
    wrong[5] += 1.0 / 255.0;
    let drawn = |values: &[f32]| {
        let png = picture::encode(&montage.draw(&bytes(values)));
        picture::decode(&png).expect("its own PNG")
    };
    let tiles = tiles();
    let shape = [2, 3, 4, 4];
    let of_tensors =
        TOLERANCE.compare(&tensors("tiles", &shape, &tiles), &tensors("tiles", &shape, &wrong));
    let of_pictures = compare_pictures(&montage, &drawn(&tiles), &drawn(&wrong));
    for (found, parts) in [
        (of_tensors, ["3.922e-2 apart at tile 1, channel blue, row 1, column 2", "2 of 96 values"]),
        (of_pictures, ["10 of 255 steps apart at tile 1, channel blue, row 1", "1 of 32 pixels"]),
    ] {
        let message = found.expect_err("it is wrong");
        assert!(parts.iter().all(|part| message.contains(part)), "{message}");
    }
    assert!(picture::decode(b"no picture").is_err());
}

#[test]
fn pictures_may_be_off_by_a_step_and_at_edges_by_two() {
    let montage = Montage { tiles: 1, side: 32, columns: 1, scale: 2 };
    // 102 of 255
    let base = vec![0.4; 3 * 32 * 32];
    let with = |pixels: usize, steps: f32| {
        let mut values = base.clone();
        values[..pixels].iter_mut().for_each(|value| *value += steps / 255.0);
        compare_pictures(&montage, &montage.draw(&bytes(&base)), &montage.draw(&bytes(&values)))
    };
    assert!(with(1024, 1.0).is_ok(), "every pixel may be rounded otherwise");
    assert!(with(2, 2.0).is_ok(), "two of 1,024 pixels lie on an edge");
    assert!(with(3, 2.0).is_err(), "three are too many");
    assert!(with(1, 3.0).is_err(), "no edge is that high");
    let small = Montage { side: 31, ..montage };
    let message =
        compare_pictures(&montage, &montage.draw(&bytes(&base)), &small.draw(&bytes(&base)));
    assert!(message.expect_err("another size").contains("sizes differ"));
}

#[test]
fn a_difference_is_shown_beside_both_pictures() {
    let expected = RgbImage::from_pixel(4, 2, Rgb([10, 20, 30]));
    let mut found = RgbImage::from_pixel(4, 3, Rgb([10, 20, 30]));
    found.put_pixel(1, 1, Rgb([10, 25, 30]));
    let panels = picture::difference(&expected, &found);
    assert_eq!(panels.dimensions(), (28, 3));
    let colors =
        [(0, 0), (13, 1), (25, 1), (24, 1), (24, 2)].map(|(x, y)| panels.get_pixel(x, y).0);
    assert_eq!(colors, [[10, 20, 30], [10, 25, 30], [0, 255, 0], [0; 3], [255, 0, 255]]);
}
