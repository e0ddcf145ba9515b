//! Command lines that cannot be fulfilled.

use crate::sandbox::{RENDER, Sandbox, TILES};

const EXPLAIN: &str = "explain scene.safetensors cameras.json";

#[test]
fn numbers_out_of_range() {
    let sandbox = Sandbox::new("tiny");
    for (words, facts) in [
        (format!("{TILES} -o out --threads 0"), ["'0'", "--threads"]),
        (format!("{TILES} -o out --threads 1000000"), ["'1000000'", "--threads"]),
        (format!("{RENDER} -o out --views 99"), ["no view 99", "views 0 to 1"]),
        (format!("{RENDER} -o out --views -1"), ["--views", "list such as"]),
        (format!("{EXPLAIN} --pixel 96,0"), ["pixel 96,0", "96 x 80"]),
        (format!("{EXPLAIN} --pixel 0,80"), ["pixel 0,80", "96 x 80"]),
        (format!("{EXPLAIN} --pixel -1,0"), ["pixel -1,0", "96 x 80"]),
        (format!("{EXPLAIN} --pixel 5"), ["--pixel", "X,Y"]),
        (format!("{EXPLAIN} --pixel 0,0 --view 2"), ["no view 2", "views 0 to 1"]),
        ("demo -o out --views 0".to_owned(), ["'0'", "--views"]),
        ("demo -o out --size 100000".to_owned(), ["'100000'", "--size"]),
    ] {
        sandbox.assert_refuses(&words, &facts);
    }
}

#[test]
fn options_that_contradict_each_other() {
    let sandbox = Sandbox::new("tiny");
    let tiles = "tiles scene.safetensors cameras.json tiles.json -o out";
    for (words, fact) in [
        ("--backend cpu --adapter Arc", "`--backend` is cpu"),
        ("--backend cpu --variants best", "`--backend` is cpu"),
        ("--backend cpu --spirv naga", "`--backend` is cpu"),
        ("--backend gpu --threads 2", "`--backend` is gpu"),
        ("--adapter nobody-has-this", "no usable GPU"),
        ("--backend vulkan", "'vulkan'"),
    ] {
        sandbox.assert_refuses(&format!("{tiles} {words}"), &[fact]);
    }
    sandbox.assert_refuses("paint", &["'paint'"]);
    sandbox.assert_refuses(TILES, &["required"]);
}

#[test]
fn places_that_cannot_be_written() {
    let sandbox = Sandbox::new("tiny");
    sandbox.write("file", "precious");
    sandbox.make_folder("folder");
    sandbox.make_folder("views/0000.png");
    for (words, facts) in [
        (format!("{TILES} -o absent/out.safetensors"), ["absent", "does not exist"]),
        (format!("{TILES} -o file/out.safetensors"), ["file", "not a folder"]),
        (format!("{TILES} -o folder"), ["folder", "expected a file"]),
        (format!("{RENDER} -o file"), ["file", "expected a folder"]),
        (format!("{RENDER} -o file/images"), ["file", "not a folder"]),
        (format!("{RENDER} -o views"), ["0000.png", "expected a file"]),
        ("demo -o file".to_owned(), ["file", "expected a folder"]),
    ] {
        sandbox.assert_refuses(&words, &facts);
    }
}

#[test]
fn inputs_are_not_replaced() {
    let sandbox = Sandbox::new("tiny");
    sandbox.make_folder("images");
    for name in ["scene.safetensors", "./cameras.json", "images/../tiles.json"] {
        sandbox.assert_refuses(&format!("{TILES} -o {name}"), &[name, "would replace the input"]);
    }
    // the photograph of view 1, which may be the only copy
    sandbox.write("images/0001.png", "a photograph");
    let facts = ["images/0001.png", "photograph", "another folder"];
    sandbox.assert_refuses(&format!("{RENDER} -o images"), &facts);
    sandbox.assert_refuses("demo -o images --backend cpu", &["0001.png", "another folder"]);
    sandbox.assert_refuses("demo -o . --backend cpu", &["scene.safetensors", "another folder"]);
}

#[test]
fn views_of_the_same_cameras_add_up() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("{RENDER} -o out --views 0 --channels depth")).assert_ok();
    sandbox.run(&format!("{RENDER} -o out --views 1")).assert_ok();
    for name in ["0000.png", "0000.depth.png", "0001.png"] {
        assert!(sandbox.path("out").join(name).exists(), "{name}");
    }
}

#[test]
fn other_files_are_refused_unless_they_may_stay() {
    let sandbox = Sandbox::new("tiny");
    let film = "film scene.safetensors cameras.json --backend cpu -o out --frames 2";
    for (words, image) in [(&*format!("{RENDER} -o out"), "out/0000.png"), (film, "out/00001.png")]
    {
        sandbox.write(image, "mine");
        sandbox.write("out/mine.png", "mine");
        sandbox.assert_refuses(words, &["out has other files, such as ", "--overwrite"]);
        sandbox.run(&format!("{words} --overwrite")).assert_ok();
        assert_eq!(sandbox.read("out/mine.png"), b"mine");
        assert!(sandbox.read(image).starts_with(b"\x89PNG"), "{image} is not replaced");
    }
}
