//! Arguments of commands: files are recognized by their content, and a run's folder or a data set can replace a scene
//! or cameras.

use serde_json::{Value, json};

use crate::sandbox::Sandbox;
use crate::train::runs;

const SCENE: &str = "scene.safetensors";

/// A sandbox with `run`, which was trained on `data` at half size. Frame 0 of two is held out.
fn trained() -> Sandbox {
    let sandbox = runs::sandbox();
    runs::photographs(&sandbox);
    let words = "train data --config tiny.toml --backend cpu --steps 1 --downscale 2 --hold-out-every 2 -o run";
    sandbox.run(words).assert_ok();
    sandbox
}

/// The names of the pictures in a folder.
fn pictures(sandbox: &Sandbox, folder: &str) -> Vec<String> {
    sandbox.images(folder).into_keys().collect()
}

#[test]
fn the_wrong_order_is_told_by_the_content() {
    let sandbox = Sandbox::new("tiny");
    sandbox
        .run("tiles scene.safetensors cameras.json tiles.json -o batch --backend cpu")
        .assert_ok();
    sandbox.make_folder("run");
    sandbox.copy_file(SCENE, "run/checkpoint.safetensors");
    sandbox.copy_file("cameras.json", "data/transforms.json");
    let scene =
        "scene.safetensors: this is a scene; cameras (transforms.json) or a data set were expected";
    for (words, fact) in [
        ("render scene.safetensors scene.safetensors -o out", scene),
        ("render cameras.json scene.safetensors -o out", scene),
        ("explain scene.safetensors scene.safetensors --pixel 1,1", scene),
        ("render cameras.json cameras.json -o out", "this is a file of cameras; a scene"),
        ("render tiles.json cameras.json -o out", "this is a file of tiles; a scene"),
        ("render scene.safetensors tiles.json -o out", "this is a file of tiles; cameras"),
        (
            "render scene.safetensors batch -o out",
            "this is a file of tensors, but not a scene; cameras",
        ),
        ("render scene.safetensors run -o out", "this is the folder of a training run; a data set"),
        ("render data cameras.json -o out", "this is a data set; a scene"),
        (
            "tiles scene.safetensors tiles.json cameras.json -o out",
            "this is a file of cameras; tiles",
        ),
        ("tiles cameras.json tiles.json scene.safetensors -o out", "this is a scene; tiles"),
        ("tiles cameras.json tiles.json -o out", "this is a file of cameras; a scene"),
        ("bench scene.safetensors tiles.json cameras.json", "this is a file of cameras; tiles"),
        ("eval scene.safetensors scene.safetensors", "this is a scene; a data set was expected"),
        ("eval data run", "this is a data set; a scene"),
        ("train run -o out", "this is the folder of a training run; a data set was expected"),
        ("train scene.safetensors -o out", "this is a scene; a data set was expected"),
    ] {
        sandbox.assert_refuses(words, &[fact, "the order is: scene, cameras or data set, tiles"]);
    }
    // files of other programs
    sandbox.write("notes.md", "# Notes\n");
    sandbox.write("splats.ply", "ply\nformat ascii 1.0\nend_header\n");
    for (words, fact) in [
        ("train notes.md -o out", "another kind of file; a data set was expected"),
        ("render scene.safetensors notes.md -o out", "another kind of file; cameras"),
        ("view notes.md", "another kind of file; a scene (safetensors)"),
        ("view splats.ply", "`organza import splats.ply -o NEW.safetensors`"),
    ] {
        sandbox.assert_refuses(words, &[fact]);
    }
    // not a scene, under a scene's name
    sandbox.copy_file("cameras.json", SCENE);
    sandbox
        .assert_refuses("render scene.safetensors cameras.json -o out", &["another kind of file"]);
}

#[test]
fn missing_files_are_named_before_a_device_is_opened() {
    let sandbox = Sandbox::new("tiny");
    for words in [
        "eval nothing",
        "render nothing cameras.json -o out",
        "tiles scene.safetensors nothing tiles.json -o out",
        "tiles scene.safetensors cameras.json nothing -o out",
        "train nothing -o run",
        "info nothing",
    ] {
        let outcome = sandbox.run(words);
        outcome.assert_refused(&["nothing: there is no such file"]);
        assert_eq!(outcome.stderr.lines().count(), 1, "{outcome:?}");
    }
    sandbox.make_folder("empty");
    let outcome = sandbox.run("train empty -o run");
    outcome.assert_refused(&["no data set was found here"]);
    assert_eq!(outcome.stderr.lines().count(), 1, "{outcome:?}");
    for (words, advice) in [
        ("render scene.safetensors -o out", "render SCENE CAMERAS"),
        ("eval scene.safetensors", "eval SCENE DATA"),
    ] {
        let fact = "a scene file does not say what it was trained on";
        sandbox.assert_refuses(words, &["scene.safetensors", fact, advice]);
    }
    sandbox.write("empty/config.toml", "");
    sandbox.assert_refuses("render empty -o out", &["no checkpoint.safetensors yet"]);
}

#[cfg(target_os = "linux")]
#[test]
fn folders_of_the_system_take_no_files() {
    let sandbox = Sandbox::new("tiny");
    for output in ["/proc/x", "/proc/x/y"] {
        let words = format!("render scene.safetensors cameras.json --backend cpu -o {output}");
        sandbox.assert_refuses(&words, &["cannot write /proc/x: ", "/proc takes no new files"]);
    }
}

/// Commands take a data set's cameras as training does: with `--downscale`, they have the smaller size.
#[test]
fn a_run_is_rendered_from_its_own_views() {
    let sandbox = trained();
    let render = |words: &str| sandbox.run(&format!("render {words} --backend cpu")).assert_ok();
    render("run -o all");
    assert_eq!(pictures(&sandbox, "all"), ["0000.png", "0001.png"]);
    render("run -o held --split held-out");
    assert_eq!(pictures(&sandbox, "held"), ["0000.png"]);
    render("run data -o seen --split train");
    assert_eq!(pictures(&sandbox, "seen"), ["0001.png"]);
    render("run/checkpoint.safetensors data -o file --downscale 2");

    // half the pixels, at half the focal length
    for key in ["fl_x", "fl_y", "cx", "cy", "w", "h"] {
        let half = sandbox.read_json("cameras.json")[key].as_f64().unwrap() / 2.0;
        sandbox.edit_json("cameras.json", &format!("/{key}"), json!(half));
    }
    render("run cameras.json -o half");
    for name in ["0000.png", "0001.png"] {
        let half = sandbox.read(&format!("half/{name}"));
        let image = image::load_from_memory(&half).unwrap();
        assert_eq!((image.width(), image.height()), (48, 40));
        assert!(sandbox.read(&format!("all/{name}")) == half, "{name}");
        assert!(sandbox.read(&format!("file/{name}")) == half, "{name}");
    }
    assert!(sandbox.read("held/0000.png") == sandbox.read("half/0000.png"));
    assert!(sandbox.read("seen/0001.png") == sandbox.read("half/0001.png"));
    let facts = ["photograph", "another folder"];
    sandbox.assert_refuses("render run -o data/images --backend cpu", &facts);
    let facts = ["no view 1", "views 0 to 0"];
    sandbox.assert_refuses("render run -o new --split train --views 1 --backend cpu", &facts);
}

#[test]
fn every_command_takes_a_run_for_a_scene() {
    let sandbox = trained();
    sandbox.edit_json("tiles.json", "/side", json!(48));
    sandbox.edit_json("tiles.json", "/tiles", json!([{"camera": 0, "origin": [0, 0]}]));
    let tiles = |words: &str| {
        sandbox.run(&format!("tiles {words} -o out --backend cpu")).assert_ok();
        sandbox.read("out")
    };
    let own = tiles("run tiles.json --split train");
    assert!(
        own == tiles(
            "run/checkpoint.safetensors data tiles.json --split train --downscale 2 --hold-out-every 2"
        )
    );
    assert!(own != tiles("run data tiles.json --split held-out"), "another view");
    sandbox.edit_json("tiles.json", "/tiles/0/camera", json!(1));
    assert!(own == tiles("run tiles.json"), "the second of all is the first to train on");

    let json = |words: &str| sandbox.run(words).json();
    let [run, file] =
        ["run", "run/checkpoint.safetensors"].map(|path| json(&format!("info {path} --json")));
    assert_eq!(run, file);
    let data = json("info data --json");
    assert_eq!([&data["kind"], &data["format"]], ["data set", "nerfstudio"]);
    assert_eq!((&data["cameras"][1]["distorted"], &data["missing"]), (&json!(false), &json!([])));
    assert_eq!(
        [0, 1].map(|view| data["cameras"][view]["held_out"].clone()),
        [json!(true), json!(false)]
    );
    // a lens, and a photograph that is lost
    let kept = sandbox.read("data/transforms.json");
    let mut bent: Value = serde_json::from_slice(&kept).unwrap();
    bent["k1"] = json!(0.1);
    bent["camera_model"] = json!("OPENCV");
    bent["frames"][0]["file_path"] = json!("images/lost.png");
    sandbox.write("data/transforms.json", bent.to_string());
    let bent = json("info data --json");
    assert_eq!(bent["cameras"][0]["distorted"], true);
    assert_eq!(bent["missing"].as_array().map(Vec::len), Some(1));
    let text = sandbox.run("info data").assert_ok().stdout;
    assert!(text.contains("1 photograph missing") && text.contains("distorting lens"), "{text}");
    sandbox.write("data/transforms.json", kept);
    let explain = |words: &str| json(&format!("explain {words} --pixel 20,20 --json"));
    let seen = explain("run --split train");
    assert_eq!(seen["color"], explain("run --view 1")["color"]);
    assert_eq!(
        seen["color"],
        explain("run/checkpoint.safetensors data --downscale 2 --view 1")["color"]
    );
    let bench = json("bench run data tiles.json --forward --repeat 1 --backend cpu --json");
    assert_eq!(bench["gaussians"], run["gaussians"]);
}
