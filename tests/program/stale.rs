//! Files from earlier calls: images of another scene or of other cameras are removed, and the user's files stay.

use std::fs;

use serde_json::json;

use crate::sandbox::Sandbox;

const RENDER: &str = "render scene.safetensors cameras.json --backend cpu -o out";

fn has(sandbox: &Sandbox, name: &str) -> bool {
    sandbox.path(name).exists()
}

#[test]
fn a_smaller_demo_leaves_no_view_of_the_larger_one() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run("demo -o demo --views 4 --size 16 --backend cpu").assert_ok();
    fs::write(sandbox.path("demo/0004.png"), "mine").unwrap();
    fs::write(sandbox.path("demo/0002.png"), "painted over").unwrap();
    let outcome = sandbox.run("demo -o demo --views 2 --size 16 --backend cpu").assert_ok();
    assert!(outcome.stderr.contains("removed 1 image of an earlier call from demo"), "{outcome:?}");
    assert!(
        outcome.stderr.contains(
            "warning: changed since an earlier call wrote them, so kept: 1 image in demo"
        ),
        "{outcome:?}"
    );
    assert!(!has(&sandbox, "demo/0003.png"));
    for name in
        ["0000.png", "0001.png", "0002.png", "0004.png", "turntable.png", "scene.safetensors"]
    {
        assert!(has(&sandbox, &format!("demo/{name}")), "{name}");
    }
    let outcome = sandbox.run("demo -o demo --views 2 --size 16 --backend cpu").assert_ok();
    assert!(!outcome.stderr.contains("earlier call"), "{outcome:?}");
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

/// Anyone may have written the list. It must only remove files directly in the folder, with the listed content.
#[test]
fn a_hostile_list_removes_nothing_else() {
    let sandbox = Sandbox::new("tiny");
    fs::create_dir_all(sandbox.path("out/folder")).unwrap();
    for name in ["precious", "out/mine.png", "out/folder/deep.png"] {
        fs::write(sandbox.path(name), "").unwrap();
    }
    #[cfg(unix)]
    std::os::unix::fs::symlink(sandbox.path("precious"), sandbox.path("out/link.png")).unwrap();
    let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
    let absolute = sandbox.path("precious").display().to_string();
    let names = ["../precious", &absolute, "folder/deep.png", "folder", "link.png", "..", ""];
    let entries = names.map(|name| (name.to_owned(), json!({"content": empty, "source": "x"})));
    let mut list = serde_json::Map::from_iter(entries);
    list.insert("mine.png".to_owned(), json!({"content": "another", "source": "x"}));
    fs::write(sandbox.path("out/.organza-files.json"), json!(list).to_string()).unwrap();
    sandbox.run(RENDER).assert_ok();
    for name in ["precious", "out/mine.png", "out/folder/deep.png", "out/link.png"] {
        assert!(sandbox.path(name).symlink_metadata().is_ok(), "{name}");
    }
    for damaged in ["", "[]", "{\"0000.png\": 3}"] {
        fs::write(sandbox.path("out/.organza-files.json"), damaged).unwrap();
        sandbox.run(RENDER).assert_ok();
    }
}
