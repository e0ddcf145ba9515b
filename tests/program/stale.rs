//! Files from earlier calls: images of another scene or of other cameras are removed, and the user's files stay.

use std::fs;

use serde_json::json;

use crate::sandbox::Sandbox;

const RENDER: &str = "render scene.safetensors cameras.json --backend cpu -o out";

fn has(sandbox: &Sandbox, name: &str) -> bool {
    sandbox.path(name).exists()
}

/// Changes a pixel of an image, as a program does that keeps what the image says of its origin.
fn paint(sandbox: &Sandbox, name: &str) {
    let mut file = fs::read(sandbox.path(name)).unwrap();
    let data = file.len() - 40;
    file[data] ^= 1;
    fs::write(sandbox.path(name), file).unwrap();
}

#[test]
fn a_smaller_demo_leaves_no_view_of_the_larger_one() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run("demo -o demo --views 6 --size 16 --backend cpu").assert_ok();
    fs::write(sandbox.path("demo/0004.png"), "mine").unwrap();
    paint(&sandbox, "demo/0002.png");
    fs::rename(sandbox.path("demo/0005.png"), sandbox.path("demo/best.png")).unwrap();
    let outcome = sandbox.run("demo -o demo --views 2 --size 16 --backend cpu").assert_ok();
    assert!(outcome.stderr.contains("removed 1 image of an earlier call from demo"), "{outcome:?}");
    let kept =
        "warning: changed or renamed since an earlier call wrote them, so kept: 2 images in demo";
    assert!(outcome.stderr.contains(kept), "{outcome:?}");
    assert!(!has(&sandbox, "demo/0003.png"));
    for name in [
        "0000.png",
        "0001.png",
        "0002.png",
        "0004.png",
        "best.png",
        "turntable.png",
        "scene.safetensors",
    ] {
        assert!(has(&sandbox, &format!("demo/{name}")), "{name}");
    }
}

#[test]
fn views_of_one_scene_add_up_until_it_changes() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("{RENDER} --views 0")).assert_ok();
    sandbox.run(&format!("{RENDER} --views 1")).assert_ok();
    assert!(has(&sandbox, "out/0000.png") && has(&sandbox, "out/0001.png"));
    // another scene, as when training writes it again
    sandbox.edit_scene(|metadata, _| {
        metadata.insert("train".to_owned(), json!("1"));
    });
    let outcome = sandbox.run(&format!("{RENDER} --views 1")).assert_ok();
    assert!(outcome.stderr.contains("removed 1 image of an earlier call from out"), "{outcome:?}");
    assert!(!has(&sandbox, "out/0000.png") && has(&sandbox, "out/0001.png"));
    // other cameras
    sandbox.edit_json("cameras.json", "/fl_x", json!(91.0));
    sandbox.run(&format!("{RENDER} --views 0")).assert_ok();
    assert!(has(&sandbox, "out/0000.png") && !has(&sandbox, "out/0001.png"));
}

/// A folder from somebody else may have anything in it. Only images that the program wrote go, from this folder alone.
#[test]
fn a_hostile_folder_removes_nothing_else() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(RENDER).assert_ok();
    fs::copy(sandbox.path("out/0000.png"), sandbox.path("precious.png")).unwrap();
    fs::create_dir_all(sandbox.path("out/folder.png")).unwrap();
    for name in ["out/folder.png/0000.png", "out/0000.png.bak"] {
        fs::copy(sandbox.path("out/0000.png"), sandbox.path(name)).unwrap();
    }
    fs::write(sandbox.path("out/mine.png"), "").unwrap();
    fs::write(sandbox.path("out/cut.png"), &fs::read(sandbox.path("out/0000.png")).unwrap()[..150])
        .unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(sandbox.path("precious.png"), sandbox.path("out/0009.png")).unwrap();
    // Versions before kept a list of images, with their hashes, and removed what it named.
    let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
    let list = json!({"mine.png": {"content": empty, "source": "x"}});
    fs::write(sandbox.path("out/.organza-files.json"), list.to_string()).unwrap();
    sandbox.edit_scene(|metadata, _| {
        metadata.insert("train".to_owned(), json!("1"));
    });
    let outcome = sandbox.run(&format!("{RENDER} --views 1")).assert_ok();
    assert!(outcome.stderr.contains("removed 1 image of an earlier call"), "{outcome:?}");
    assert!(!has(&sandbox, "out/0000.png") && has(&sandbox, "out/0001.png"));
    for name in [
        "precious.png",
        "out/0009.png",
        "out/mine.png",
        "out/cut.png",
        "out/0000.png.bak",
        "out/folder.png/0000.png",
    ] {
        assert!(sandbox.path(name).symlink_metadata().is_ok(), "{name}");
    }
}
