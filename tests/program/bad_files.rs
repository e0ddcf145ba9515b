//! Files with wrong content.

use std::fs;

use serde_json::{Value, json};

use crate::sandbox::{Metadata, Sandbox, Tensors};

const TILES: &str =
    "tiles scene.safetensors cameras.json tiles.json -o out.safetensors --backend cpu";
const RENDER: &str = "render scene.safetensors cameras.json -o images --backend cpu";

/// Asserts that every command that reads the scene refuses it, with these facts in the message.
#[track_caller]
fn assert_scene_refused(sandbox: &Sandbox, facts: &[&str]) {
    let mut facts = facts.to_vec();
    facts.push("scene.safetensors");
    let explain = "explain scene.safetensors cameras.json --pixel 1,1";
    for words in [TILES, RENDER, explain, "info scene.safetensors"] {
        sandbox.assert_refuses(words, &facts);
    }
}

#[track_caller]
fn assert_edit_refused(facts: &[&str], edit: impl FnOnce(&mut Metadata, &mut Tensors)) {
    let sandbox = Sandbox::new("tiny");
    sandbox.edit_scene(edit);
    assert_scene_refused(&sandbox, facts);
}

fn tensor<'a>(tensors: &'a mut Tensors, name: &str) -> &'a mut (String, Vec<usize>, Vec<u8>) {
    tensors.iter_mut().find(|tensor| tensor.0 == name).expect("a tensor")
}

#[test]
fn missing_files() {
    for name in ["scene.safetensors", "cameras.json", "tiles.json"] {
        let sandbox = Sandbox::new("tiny");
        fs::remove_file(sandbox.path(name)).unwrap();
        sandbox.assert_refuses(TILES, &[name, "no such file"]);
        sandbox.assert_refuses(&format!("info {name}"), &[name, "no such file"]);
    }
}

#[test]
fn folders_and_devices_are_no_files() {
    let sandbox = Sandbox::new("tiny");
    let words = "render . cameras.json -o images --backend cpu";
    for words in [words, "info ."] {
        sandbox.assert_refuses(words, &["the folder has no checkpoint.safetensors", "scene file"]);
    }
    if cfg!(unix) {
        sandbox.assert_refuses("info /dev/zero", &["device", "expected a regular file"]);
    }
}

#[test]
fn truncated_scenes() {
    let whole = fs::read(Sandbox::new("tiny").path("scene.safetensors")).unwrap();
    for (length, fact) in [
        (0, "0 bytes, too few"),
        (7, "7 bytes, too few"),
        (100, "cut short"),
        (whole.len() / 2, "cut short"),
        (whole.len() - 1, "cut short"),
    ] {
        let sandbox = Sandbox::new("tiny");
        fs::write(sandbox.path("scene.safetensors"), &whole[..length]).unwrap();
        assert_scene_refused(&sandbox, &[fact]);
    }
}

#[test]
fn corrupt_scenes() {
    let whole = fs::read(Sandbox::new("tiny").path("scene.safetensors")).unwrap();
    let with = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = whole.clone();
        change(&mut bytes);
        bytes
    };
    let another = fs::read(Sandbox::new("tiny").path("cameras.json")).unwrap();
    for (bytes, fact) in [
        (with(&|bytes| bytes[..8].fill(255)), "announce a header of 18446744073709551615 bytes"),
        (with(&|bytes| bytes[8] = b'!'), "header does not parse"),
        (with(&|bytes| bytes.push(0)), "1 bytes follow the last tensor"),
        (another, "another kind of file"),
    ] {
        let sandbox = Sandbox::new("tiny");
        fs::write(sandbox.path("scene.safetensors"), bytes).unwrap();
        assert_scene_refused(&sandbox, &[fact]);
    }
}

#[test]
fn tensors_that_do_not_fit() {
    assert_edit_refused(&["`gaussians.opacity`", "missing", "[1]"], |_, tensors| {
        tensors.retain(|(name, ..)| name != "gaussians.opacity");
    });
    assert_edit_refused(&["`color.grid`", "[1024, 1]", "[512, 2]"], |_, tensors| {
        tensor(tensors, "color.grid").1 = vec![1024, 1];
    });
    assert_edit_refused(&["`color.mlp.1.bias`", "[15]", "[16]"], |_, tensors| {
        let (_, shape, bytes) = tensor(tensors, "color.mlp.1.bias");
        *shape = vec![15];
        bytes.truncate(60);
    });
    assert_edit_refused(&["no Gaussians"], |_, tensors| {
        for (name, shape, bytes) in tensors {
            if name.starts_with("gaussians.") {
                shape[0] = 0;
                bytes.clear();
            }
        }
    });
}

#[test]
fn values_that_are_no_numbers() {
    for (value, text) in [(f32::NAN, "NaN"), (f32::INFINITY, "inf"), (f32::NEG_INFINITY, "-inf")] {
        let facts = ["`transmittance.grid`", text, "flat index 3"];
        assert_edit_refused(&facts, |_, tensors| {
            let bytes = &mut tensor(tensors, "transmittance.grid").2;
            bytes[12..16].copy_from_slice(&value.to_le_bytes());
        });
    }
}

#[test]
fn metadata_of_something_else() {
    assert_edit_refused(&["version \"2\"", "reads version \"1\""], |metadata, _| {
        metadata["version"] = json!("2");
    });
    assert_edit_refused(&["not a scene", "\"another\""], |metadata, _| {
        metadata["format"] = json!("another");
    });
    assert_edit_refused(&["`step`", "0"], |metadata, _| {
        let mut config: Value = serde_json::from_str(metadata["config"].as_str().unwrap()).unwrap();
        config["step"] = json!(0);
        metadata["config"] = json!(config.to_string());
    });
}

#[test]
fn bad_cameras() {
    let singular = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]);
    for (pointer, value, facts) in [
        ("/fl_x", Value::Null, ["frame 0", "`fl_x` is missing"]),
        ("/frames/1/transform_matrix", singular, ["frame 1", "singular"]),
        ("/frames/1/transform_matrix", json!([]), ["frame 1", "0 rows"]),
        ("/frames", json!([]), ["`frames` is empty", ""]),
        ("/w", json!(0), ["frame 0", "`w` is 0"]),
    ] {
        let sandbox = Sandbox::new("tiny");
        sandbox.edit_json("cameras.json", pointer, value);
        for words in [TILES, RENDER, "info cameras.json"] {
            sandbox.assert_refuses(words, &[facts[0], facts[1], "cameras.json"]);
        }
    }
    let sandbox = Sandbox::new("tiny");
    fs::write(sandbox.path("cameras.json"), "{\"frames\": [").unwrap();
    sandbox.assert_refuses(TILES, &["cameras.json", "line 1 column 12"]);
    sandbox.assert_refuses("info cameras.json", &["cameras.json", "line 1 column 12"]);
}

#[test]
fn bad_tiles() {
    for (pointer, value, facts) in [
        ("/tiles/2/camera", json!(7), ["tile 2", "camera 7, but cameras are 0 to 1"]),
        ("/tiles/0/camera", json!(-1), ["tile 0", "`camera` is -1"]),
        ("/tiles/1/origin", json!([0, 1e9]), ["tile 1", "1000000"]),
        ("/side", json!(0), ["`side` is 0", "1 to 4096"]),
        ("/side", json!(10000), ["`side` is 10000", "1 to 4096"]),
        ("/side", json!(1.5), ["`side` is 1.5", "1 to 4096"]),
        ("/tiles", json!([]), ["no tiles", ""]),
    ] {
        let sandbox = Sandbox::new("tiny");
        sandbox.edit_json("tiles.json", pointer, value);
        sandbox.assert_refuses(TILES, &[facts[0], facts[1], "tiles.json"]);
    }
}

#[test]
fn files_of_no_known_kind() {
    let sandbox = Sandbox::new("tiny");
    for (content, fact) in [
        ("hello, world", "neither safetensors nor a JSON object"),
        ("[1, 2]", "neither safetensors nor a JSON object"),
        ("{\"a\": 1}", "neither the `frames`"),
        ("", "neither safetensors nor a JSON object"),
    ] {
        fs::write(sandbox.path("a.txt"), content).unwrap();
        sandbox.assert_refuses("info a.txt", &["a.txt", fact]);
    }
}
