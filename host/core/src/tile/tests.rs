use super::*;
use serde_json::json;

fn file() -> Value {
    json!({"side": 16, "tiles": [
        {"camera": 0, "origin": [32, 24]}, {"camera": 1, "origin": [-5, 0.0]}]})
}

#[track_caller]
fn assert_error(edit: impl FnOnce(&mut Value), facts: &[&str]) {
    let mut value = file();
    edit(&mut value);
    let text = TileBatch::parse(&value, Path::new("tiles.json")).unwrap_err().to_string();
    for fact in facts.iter().chain(&["tiles.json"]) {
        assert!(text.contains(fact), "no {fact:?} in: {text}");
    }
}

#[test]
fn cases_load_and_fit_their_cameras() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases");
    for (case, side) in [("basic", 16), ("tiny", 8), ("wide", 32)] {
        let batch = TileBatch::load(cases.join(case).join("tiles.json")).unwrap();
        assert_eq!(batch.output_shape(), [4, 3, side, side]);
        assert_eq!(batch.tiles[3], Tile { camera: 1, origin: [-5, 0] });
        let cameras = Camera::load_all(cases.join(case).join("cameras.json")).unwrap();
        batch.validate(&cameras).unwrap();
        let text = batch.validate(&cameras[..1]).unwrap_err().to_string();
        assert!(text.contains("tile 1") && text.contains("camera 1"), "{text}");
        assert!(batch.validate(&[]).is_err());
    }
}

#[test]
fn save_and_load() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tiles.json");
    let batch = TileBatch::parse(&file(), Path::new("tiles.json")).unwrap();
    batch.save(&path).unwrap();
    assert_eq!(TileBatch::load(&path).unwrap(), batch);
    assert!(TileBatch { side: 0, ..batch }.save(&path).is_err());
}

#[test]
fn cover_is_row_major_and_complete() {
    let batch = TileBatch::cover(3, 96, 80, 32).unwrap();
    let origins: Vec<_> = batch.tiles.iter().map(|tile| tile.origin).collect();
    assert_eq!(origins.len(), 9);
    assert_eq!(origins[..4], [[0, 0], [32, 0], [64, 0], [0, 32]]);
    assert_eq!(origins[8], [64, 64]); // rows 64 to 95 hang over the edge at 80
    assert!(batch.tiles.iter().all(|tile| tile.camera == 3));
    assert_eq!(TileBatch::cover(0, 5, 5, 5).unwrap().tiles.len(), 1);
}

#[test]
fn cover_refuses_nonsense() {
    for (width, height, side) in [
        (96, 80, 0),
        (96, 80, 4097),
        (0, 80, 16),
        (u32::MAX, 1, 4096),
        (u32::MAX, u32::MAX, 1),
        (2_000_000, 1, 1),
    ] {
        assert!(TileBatch::cover(0, width, height, side).is_err(), "{width} x {height} by {side}");
    }
}

#[test]
fn output_is_limited() {
    // 3 * 4096^2 values each: 42 fit below 2^31, 43 do not.
    let batch =
        |count| TileBatch { side: 4096, tiles: vec![Tile { camera: 0, origin: [0; 2] }; count] };
    batch(42).check().unwrap();
    let text = batch(43).check().unwrap_err().to_string();
    for fact in ["43 tiles of side 4096", "8.06 GiB", "8.00 GiB", "at most 42"] {
        assert!(text.contains(fact), "no {fact:?} in: {text}");
    }
}

#[test]
fn batch_errors() {
    assert_error(|file| file["side"] = json!(0), &["`side` is 0", "4096"]);
    assert_error(|file| file["side"] = json!(10000), &["`side` is 10000", "4096"]);
    assert_error(|file| file["side"] = json!(1.5), &["`side` is 1.5"]);
    assert_error(|file| file["side"] = json!(-1), &["`side` is -1"]);
    assert_error(|file| *file = json!({"tiles": []}), &["`side` is missing"]);
    assert_error(|file| *file = json!({"side": 8}), &["`tiles` is missing"]);
    assert_error(|file| file["tiles"] = json!([]), &["no tiles"]);
    assert_error(|file| file["tiles"] = json!("all"), &["`tiles` is a string"]);
}

#[test]
fn tile_errors() {
    let tile = |value: Value| move |file: &mut Value| file["tiles"][1] = value;
    let origin = |value: Value| tile(json!({"camera": 0, "origin": value}));
    assert_error(tile(json!(3)), &["tile 1", "is a number"]);
    assert_error(tile(json!({"origin": [0, 0]})), &["tile 1", "`camera` is missing"]);
    assert_error(tile(json!({"camera": 0})), &["tile 1", "`origin` is missing"]);
    assert_error(tile(json!({"camera": -1, "origin": [0, 0]})), &["`camera` is -1"]);
    assert_error(origin(json!([1.5, 0])), &["tile 1", "[1.5,0]", "whole numbers"]);
    assert_error(origin(json!([1])), &["tile 1", "[1]"]);
    assert_error(origin(json!([1, 2, 3])), &["[1,2,3]"]);
    assert_error(origin(json!([1_000_001, 0])), &["1000001", "1000000"]);
    assert_error(origin(json!([i64::MIN, 0])), &["1000000"]);
    assert_error(origin(json!("here")), &["here"]);
}

#[test]
fn cover_reaches_each_edge() {
    for (width, height) in (1..20_000).step_by(331).zip((1..20_000).step_by(337).rev()) {
        for side in [59, 64, 100, 1021, 4096] {
            let batch = TileBatch::cover(0, width, height, side).unwrap();
            let last = batch.tiles[batch.tiles.len() - 1].origin.map(|value| value as u32);
            assert!(last[0] < width && last[0] + side >= width, "{width} by {side}");
            assert!(last[1] < height && last[1] + side >= height, "{height} by {side}");
        }
    }
}
