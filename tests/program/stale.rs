//! Folders with files: nothing is removed, and other files are refused unless the user says that they may stay.

use std::fs;

use crate::sandbox::Sandbox;

const RENDER: &str = "render scene.safetensors cameras.json --backend cpu -o out";

#[test]
fn views_of_the_same_cameras_add_up() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("{RENDER} --views 0 --channels depth")).assert_ok();
    sandbox.run(&format!("{RENDER} --views 1")).assert_ok();
    for name in ["0000.png", "0000.depth.png", "0001.png"] {
        assert!(sandbox.path("out").join(name).exists(), "{name}");
    }
}

#[test]
fn other_files_are_refused_unless_they_may_stay() {
    let sandbox = Sandbox::new("tiny");
    let film = "film scene.safetensors cameras.json --backend cpu -o out --frames 2";
    fs::create_dir(sandbox.path("out")).unwrap();
    for name in ["0000.png", "mine.png"] {
        fs::write(sandbox.path("out").join(name), "mine").unwrap();
    }
    for words in [RENDER, film] {
        sandbox.assert_refuses(words, &["out has other files, such as ", "--overwrite"]);
        sandbox.run(&format!("{words} --overwrite")).assert_ok();
        assert_eq!(fs::read(sandbox.path("out/mine.png")).unwrap(), b"mine");
    }
    let image = fs::read(sandbox.path("out/0000.png")).unwrap();
    assert!(image.starts_with(b"\x89PNG"), "the image is not replaced");
}
