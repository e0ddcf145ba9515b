//! Every way in which a scene can be wrong gives an error that says so, and never a panic.

use serde_json::{Value, json};

use super::*;

/// Asserts that a message contains all the facts.
#[track_caller]
fn assert_error(result: Result<Scene>, facts: &[&str]) {
    let text = result.unwrap_err().to_string();
    for fact in facts {
        assert!(text.contains(fact), "no {fact:?} in: {text}");
    }
    // A value in memory has no file to name.
    assert!(!text.starts_with(':') && !text.contains("  "), "{text}");
}

/// Asserts that a file is refused, with a message that names it.
#[track_caller]
fn assert_refused(bytes: &[u8], facts: &[&str]) {
    let result = load(bytes);
    let text = result.as_ref().unwrap_err().to_string();
    assert!(text.starts_with("scene.safetensors"), "{text}");
    assert_error(result, facts);
}

#[test]
fn headers_are_refused_with_a_reason() {
    type Change = fn(&mut Map<String, Value>);
    let changes: [(Change, &[&str]); 7] = [
        (
            |header| drop(header.remove("__metadata__")),
            &["is not a scene", "missing", "organza.scene"],
        ),
        (|header| header["__metadata__"]["format"] = "pt".into(), &["is not a scene", "\"pt\""]),
        (
            |header| header["__metadata__"]["version"] = "2".into(),
            &["scene version", "\"2\"", "\"1\""],
        ),
        (
            |header| header["__metadata__"]["config"] = "{]".into(),
            &["JSON of the `config` metadata", "line 1"],
        ),
        (
            |header| header["gaussians.position"]["shape"] = json!([3]),
            &["gaussians.position", "has shape [3]", "[3, 3]"],
        ),
        (
            |header| {
                let info = header.remove("gaussians.opacity").unwrap();
                header.insert("gaussians.opacities".to_owned(), info);
            },
            &["gaussians.opacity`", "is missing", "[1]"],
        ),
        (
            |header| header["color.grid"]["dtype"] = "I32".into(),
            &["color.grid", "I32", "expected F32"],
        ),
    ];
    for (change, facts) in changes {
        assert_refused(&with_header(change), facts);
    }
}

#[test]
fn configurations_that_do_not_fit_are_refused_with_a_reason() {
    type Change = fn(&mut Value);
    let changes: [(Change, &[&str]); 5] = [
        (
            |config| config["color_grid"]["levels"] = 40.into(),
            &["config field `color_grid.levels`", "40", "32"],
        ),
        (
            |config| config["material"] = 2.into(),
            &["gaussians.material", "has shape [1, 1]", "[1, 2]", "config field `material`"],
        ),
        (
            |config| config["color_grid"]["log2_table"] = 8.into(),
            &["color.grid", "has shape [512, 2]", "[256, 2]", "color_grid"],
        ),
        (
            |config| config["transmittance_mlp"]["hidden"] = json!([16, 8]),
            &["transmittance.mlp.1.weight", "[16, 16]", "[8, 16]", "transmittance_mlp.hidden"],
        ),
        (
            |config| config["color_mlp"]["hidden"] = json!([16, 16, 16]),
            &["color.mlp.2.weight", "has shape [3, 16]", "[16, 16]"],
        ),
    ];
    for (change, facts) in changes {
        assert_refused(&with_config(change), facts);
    }
}

/// Saving a scene that is wrong fails, and writes no file.
#[test]
fn scenes_in_memory_are_refused_with_a_reason() {
    type Change = fn(&mut Scene);
    let changes: [(Change, &[&str]); 8] = [
        (
            |scene| scene.gaussians.log_scale[0][1] = f32::NAN,
            &["gaussians.log_scale", "holds NaN", "index 1"],
        ),
        (
            |scene| scene.color.network.layers[2].bias[2] = f32::INFINITY,
            &["color.mlp.2.bias", "holds inf", "index 2"],
        ),
        (|scene| scene.gaussians = Gaussians::default(), &["no Gaussians"]),
        (|scene| scene.gaussians.rotation.clear(), &["gaussians.rotation", "has shape", "[1, 4]"]),
        (|scene| scene.color.grid.push(0.0), &["color.grid", "has shape [1025]", "[512, 2]"]),
        (
            |scene| scene.color.network.layers.truncate(2),
            &["color.mlp.2.weight", "has shape []", "[3, 16]"],
        ),
        (
            |scene| scene.transmittance.network.layers.push(Layer::zeros(1, 1)),
            &["transmittance.mlp.3.weight", "has shape [1, 1]"],
        ),
        (
            |scene| scene.color.network.layers[0].inputs = 5,
            &["color.mlp.0.weight", "has shape [16, 5]", "[16, 4]"],
        ),
    ];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out");
    for (change, facts) in changes {
        let mut scene = tiny();
        change(&mut scene);
        assert_error(scene.save(&path).map(|()| scene), facts);
        assert!(!path.exists());
    }
    let too_many = Scene::zeros(SceneConfig { material: 256, ..tiny().config }, 1 << 23);
    assert_error(too_many, &["gaussians.material", "would hold", "2147483648"]);
}

#[test]
fn not_safetensors() {
    const BAD: &str = "is not a whole safetensors file";
    let bytes = tiny_bytes();
    assert_refused(b"", &[BAD, "0 bytes"]);
    assert_refused(b"ply\nformat binary_little_endian 1.0", &[BAD, "another kind of file"]);
    assert_refused(&u64::MAX.to_le_bytes(), &[BAD, "18446744073709551615"]);
    assert_refused(&bytes[..bytes.len() - 4], &[BAD, "cut short"]);
    assert_refused(&[bytes.as_slice(), &[0; 12]].concat(), &[BAD, "12 bytes follow"]);
    // One shape's product overflows, the other is just enormous.
    for size in [u64::MAX, 1 << 40] {
        let bytes = with_header(|header| header["color.grid"]["shape"] = json!([size, 2]));
        assert_refused(&bytes, &[BAD, "header does not parse"]);
    }
}

#[test]
fn empty_scene_file() {
    let bytes = with_header(|header| {
        let end =
            header.values().filter_map(|info| info["data_offsets"][1].as_u64()).max().unwrap();
        let position = header.remove("gaussians.position").unwrap();
        header.insert("spare".to_owned(), position);
        let info = json!({"dtype": "F32", "shape": [0, 3], "data_offsets": [end, end]});
        header.insert("gaussians.position".to_owned(), info);
    });
    assert_refused(&bytes, &["no Gaussians"]);
}
