//! Every way in which a scene can be wrong gives an error that says so, and never a panic.

use proptest::prelude::*;
use serde_json::{Value, json};

use super::*;
use crate::input::nasty::{nasty_value, replace_value};

/// Asserts the kind of the error, and that its message contains all the facts.
#[track_caller]
fn assert_error(result: Result<Scene>, kind: fn(&Error) -> bool, facts: &[&str]) {
    let error = result.unwrap_err();
    assert!(kind(&error), "{error:?}");
    let text = error.to_string();
    for fact in facts {
        assert!(text.contains(fact), "no {fact:?} in: {text}");
    }
    // A value in memory has no file to name.
    assert!(!text.starts_with(':') && !text.contains("  "), "{text}");
}

/// Loads a bad file. Its error must name the file.
#[track_caller]
fn load_bad(bytes: &[u8]) -> Result<Scene> {
    let result = load(bytes);
    let text = result.as_ref().unwrap_err().to_string();
    assert!(text.starts_with("scene.safetensors"), "{text}");
    result
}

#[test]
fn metadata_errors() {
    let wrong_format = |error: &Error| matches!(error, Error::WrongFormat { .. });
    assert_error(
        load_bad(&with_header(|header| drop(header.remove("__metadata__")))),
        wrong_format,
        &["missing", "organza.scene"],
    );
    assert_error(
        load_bad(&with_header(|header| header["__metadata__"]["format"] = "pt".into())),
        wrong_format,
        &["\"pt\""],
    );
    assert_error(
        load_bad(&with_header(|header| header["__metadata__"]["version"] = "2".into())),
        |error| matches!(error, Error::UnknownVersion { .. }),
        &["\"2\"", "\"1\""],
    );
    assert_error(
        load_bad(&with_header(|header| header["__metadata__"]["config"] = "{]".into())),
        |error| matches!(error, Error::BadJson { .. }),
        &["config", "line 1"],
    );
    assert_error(
        load_bad(&with_config(|config| config["color_grid"]["levels"] = 40.into())),
        |error| matches!(error, Error::BadConfig { .. }),
        &["color_grid.levels", "40", "32"],
    );
}

#[test]
fn shape_errors() {
    let wrong_shape = |error: &Error| matches!(error, Error::WrongShape { .. });
    assert_error(
        load_bad(&with_config(|config| config["material"] = 2.into())),
        wrong_shape,
        &["gaussians.material", "[1, 1]", "[1, 2]", "config field `material`"],
    );
    assert_error(
        load_bad(&with_config(|config| config["color_grid"]["log2_table"] = 8.into())),
        wrong_shape,
        &["color.grid", "[512, 2]", "[256, 2]", "color_grid"],
    );
    assert_error(
        load_bad(&with_config(|config| config["transmittance_mlp"]["hidden"] = json!([16, 8]))),
        wrong_shape,
        &["transmittance.mlp.1.weight", "[16, 16]", "[8, 16]", "transmittance_mlp.hidden"],
    );
    assert_error(
        load_bad(&with_config(|config| config["color_mlp"]["hidden"] = json!([16, 16, 16]))),
        wrong_shape,
        &["color.mlp.2.weight", "[3, 16]", "[16, 16]"],
    );
    assert_error(
        load_bad(&with_header(|header| header["gaussians.position"]["shape"] = json!([3]))),
        wrong_shape,
        &["gaussians.position", "[3]", "[3, 3]"],
    );
}

#[test]
fn tensor_errors() {
    assert_error(
        load_bad(&with_header(|header| {
            let info = header.remove("gaussians.opacity").unwrap();
            header.insert("gaussians.opacities".to_owned(), info);
        })),
        |error| matches!(error, Error::MissingTensor { .. }),
        &["gaussians.opacity`", "[1]"],
    );
    assert_error(
        load_bad(&with_header(|header| header["color.grid"]["dtype"] = "I32".into())),
        |error| matches!(error, Error::WrongDtype { .. }),
        &["color.grid", "I32", "F32"],
    );
}

/// Asserts that saving an edited scene fails, and that no file is written.
#[track_caller]
fn check(edit: fn(&mut Scene), kind: fn(&Error) -> bool, facts: &[&str]) {
    let mut scene = tiny();
    edit(&mut scene);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out");
    assert_error(scene.save(&path).map(|()| scene), kind, facts);
    assert!(!path.exists());
}

#[test]
fn memory_errors() {
    let wrong_shape = |error: &Error| matches!(error, Error::WrongShape { .. });
    check(
        |scene| scene.gaussians.log_scale[0][1] = f32::NAN,
        |error| matches!(error, Error::NotFinite { index: 1, .. }),
        &["gaussians.log_scale", "NaN", "index 1"],
    );
    check(
        |scene| scene.color.network.layers[2].bias[2] = f32::INFINITY,
        |error| matches!(error, Error::NotFinite { index: 2, .. }),
        &["color.mlp.2.bias", "inf"],
    );
    check(
        |scene| scene.gaussians = Gaussians::default(),
        |error| matches!(error, Error::EmptyScene { .. }),
        &["no Gaussians"],
    );
    check(|scene| scene.gaussians.rotation.clear(), wrong_shape, &["gaussians.rotation", "[1, 4]"]);
    check(|scene| scene.color.grid.push(0.0), wrong_shape, &["color.grid", "[1025]", "[512, 2]"]);
    check(
        |scene| scene.color.network.layers.truncate(2),
        wrong_shape,
        &["color.mlp.2.weight", "[]", "[3, 16]"],
    );
    check(
        |scene| scene.transmittance.network.layers.push(Layer::zeros(1, 1)),
        wrong_shape,
        &["transmittance.mlp.3.weight", "[1, 1]"],
    );
    check(
        |scene| scene.color.network.layers[0].inputs = 5,
        wrong_shape,
        &["color.mlp.0.weight", "[16, 5]", "[16, 4]"],
    );
    let too_many = Scene::zeros(SceneConfig { material: 256, ..tiny().config }, 1 << 23);
    assert_error(
        too_many,
        |error| matches!(error, Error::TooManyValues { .. }),
        &["gaussians.material", "2147483648"],
    );
}

#[test]
fn not_safetensors() {
    let bad = |error: &Error| matches!(error, Error::BadSafetensors { .. });
    assert_error(load_bad(b""), bad, &["0 bytes"]);
    assert_error(load_bad(b"ply\nformat binary_little_endian 1.0"), bad, &["another kind of file"]);
    assert_error(load_bad(&u64::MAX.to_le_bytes()), bad, &["18446744073709551615"]);
    let bytes = tiny_bytes();
    assert_error(load_bad(&bytes[..bytes.len() - 4]), bad, &["cut short"]);
    assert_error(load_bad(&[bytes.as_slice(), &[0; 12]].concat()), bad, &["12 bytes follow"]);
    // One shape's product overflows, the other is just enormous.
    for size in [u64::MAX, 1 << 40] {
        let bytes = with_header(|header| header["color.grid"]["shape"] = json!([size, 2]));
        assert_error(load_bad(&bytes), bad, &["header does not parse"]);
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
    assert_error(
        load_bad(&bytes),
        |error| matches!(error, Error::EmptyScene { .. }),
        &["no Gaussians"],
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn truncated_files_are_errors(keep in 0_f64..1.0) {
        let bytes = tiny_bytes();
        let length = (keep * bytes.len() as f64) as usize;
        prop_assert!(load(&bytes[..length]).is_err());
    }

    /// Replaces any one value of the header or the configuration by a nasty one.
    #[test]
    fn nasty_values_load_validly_or_fail(
        place in any::<prop::sample::Index>(),
        nasty in nasty_value(),
        in_config in any::<bool>(),
    ) {
        let bytes = if in_config {
            with_config(|config| replace_value(config, place, nasty))
        } else {
            with_header(|header| {
                let mut value = Value::Object(std::mem::take(header));
                replace_value(&mut value, place, nasty);
                *header = value.as_object().cloned().unwrap_or_default();
            })
        };
        if let Ok(scene) = load(&bytes) {
            prop_assert!(scene.validate().is_ok());
        }
    }

    #[test]
    fn damaged_files_load_validly_or_fail(
        flips in prop::collection::vec((any::<prop::sample::Index>(), 1_u8..), 1..8),
        in_header in any::<bool>(),
    ) {
        let mut bytes = tiny_bytes();
        // Most of the file is data, but damage is dangerous in the header.
        let length = if in_header { 2600 } else { bytes.len() };
        for (index, flip) in flips {
            bytes[index.index(length)] ^= flip;
        }
        if let Ok(scene) = load(&bytes) {
            prop_assert!(scene.validate().is_ok());
            // A scene that loads must not cause a panic.
            let _ = scene.warnings();
        }
    }
}
