//! Files with wrong content.

use serde_json::json;

use crate::sandbox::{RENDER, Sandbox, TILES};

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

/// Commands share one place that reads a kind of file. The messages for the other ways to be wrong are tested there.
#[test]
fn damaged_files_are_refused_by_each_command() {
    let sandbox = Sandbox::new("tiny");
    let whole = sandbox.read("scene.safetensors");
    sandbox.write("scene.safetensors", &whole[..whole.len() - 1]);
    let tiles: &str = &format!("{TILES} -o out");
    let render: &str = &format!("{RENDER} -o images");
    let explain = "explain scene.safetensors cameras.json --pixel 1,1";
    for words in [tiles, render, explain, "info scene.safetensors"] {
        sandbox.assert_refuses(words, &["scene.safetensors", "cut short"]);
    }
    sandbox.write("scene.safetensors", whole);
    sandbox.edit_json("tiles.json", "/tiles/2/camera", json!(7));
    sandbox.assert_refuses(tiles, &["tiles.json", "tile 2", "camera 7, but cameras are 0 to 1"]);
    sandbox.write("cameras.json", "{\"frames\": [");
    for words in [tiles, render, explain, "info cameras.json"] {
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
