//! Files with wrong content.

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
    sandbox.edit_tensors("scene.safetensors", edit);
    assert_scene_refused(&sandbox, facts);
}

#[test]
fn missing_files() {
    for name in ["scene.safetensors", "cameras.json", "tiles.json"] {
        let sandbox = Sandbox::new("tiny");
        sandbox.remove(name);
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

/// The messages for all the other ways to be wrong are tested where each kind of file is read, in `host/core`.
#[test]
fn scenes_of_each_kind_of_damage() {
    let whole = Sandbox::new("tiny").read("scene.safetensors");
    let flipped = [&whole[..8], b"!", &whole[9..]].concat();
    for (bytes, fact) in [
        (&[][..], "0 bytes, too few"),
        (&whole[..whole.len() - 1], "cut short"),
        (&flipped, "header does not parse"),
    ] {
        let sandbox = Sandbox::new("tiny");
        sandbox.write("scene.safetensors", bytes);
        assert_scene_refused(&sandbox, &[fact]);
    }
    assert_edit_refused(&["`color.grid`", "[1024, 1]", "[512, 2]"], |_, tensors| {
        tensors.get_mut("color.grid").expect("a tensor").0 = vec![1024, 1];
    });
    for (value, text) in [(f32::NAN, "NaN"), (f32::INFINITY, "inf"), (f32::NEG_INFINITY, "-inf")] {
        let facts = ["`transmittance.grid`", text, "flat index 3"];
        assert_edit_refused(&facts, |_, tensors| {
            let (_, bytes) = tensors.get_mut("transmittance.grid").expect("a tensor");
            bytes[12..16].copy_from_slice(&value.to_le_bytes());
        });
    }
    assert_edit_refused(&["`step`", "0"], |metadata, _| {
        let mut config: Value = serde_json::from_str(&metadata["config"]).unwrap();
        config["step"] = json!(0);
        metadata.insert("config".to_owned(), config.to_string());
    });
}

#[test]
fn bad_cameras_and_tiles() {
    let singular = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]);
    let pose = "/frames/1/transform_matrix";
    for (file, pointer, value, facts) in [
        ("cameras.json", pose, singular, ["frame 1", "singular"]),
        ("cameras.json", "/w", json!(0), ["frame 0", "`w` is 0"]),
        ("tiles.json", "/tiles/2/camera", json!(7), ["tile 2", "camera 7, but cameras are 0 to 1"]),
        ("tiles.json", "/side", json!(1.5), ["`side` is 1.5", "1 to 4096"]),
    ] {
        let sandbox = Sandbox::new("tiny");
        sandbox.edit_json(file, pointer, value);
        let info = format!("info {file}");
        // only together with the cameras is it known which of them there are
        let alone = if pointer.ends_with("camera") { TILES } else { &info };
        for words in [TILES, alone] {
            sandbox.assert_refuses(words, &[facts[0], facts[1], file]);
        }
    }
    let sandbox = Sandbox::new("tiny");
    sandbox.write("cameras.json", "{\"frames\": [");
    for words in [TILES, RENDER, "info cameras.json"] {
        sandbox.assert_refuses(words, &["cameras.json", "line 1 column 12"]);
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
        sandbox.write("a.txt", content);
        sandbox.assert_refuses("info a.txt", &["a.txt", fact]);
    }
    sandbox.write("a.zip", b"PK\x03\x04\0\0\0\0");
    sandbox.assert_refuses("info a.zip", &["a.zip", "a ZIP archive: unpack it"]);
}
