//! Results, files and messages of the program when all is well.

use organza::image::to_8_bit;
use organza::scene::read_tensors;
use organza::{DeviceOptions, Renderer};
use organza_tests::cases::{self, Case};
use organza_tests::compare::assert_close;
use serde_json::{Value, json};

use crate::sandbox::{RENDER, Sandbox, TILES};

/// The names of the cases in the repository.
fn names() -> Vec<String> {
    let folders = cases::subfolders(&cases::folder());
    folders.iter().map(|folder| folder.file_name().unwrap().to_str().unwrap().to_owned()).collect()
}

#[test]
fn tiles_match_the_reference() {
    let sandbox = Sandbox::new("basic");
    let outcome = sandbox.run(&format!("{TILES} -o out.safetensors --verbose")).assert_ok();
    let found = read_tensors(sandbox.path("out.safetensors")).unwrap();
    let expected = read_tensors(cases::folder().join("basic/expected.safetensors")).unwrap();
    assert_eq!(found.keys().collect::<Vec<_>>(), ["tiles"]);
    assert_eq!(found["tiles"].shape, [4, 3, 16, 16]);
    assert_close("tiles", &found["tiles"].data, &expected["tiles"].data, 2e-4);
    assert_eq!(outcome.stdout, "");
    for fact in [
        "CPU, ",
        "detail: cpu: ",
        "4 tiles of 16 x 16",
        " pairs",
        " samples",
        " part,",
        "out.safetensors",
    ] {
        assert!(outcome.stderr.contains(fact), "{fact}: {outcome:?}");
    }
}

#[test]
fn half_grids_are_close_and_have_no_gradients() {
    let sandbox = Sandbox::new("basic");
    sandbox.run(&format!("{TILES} -o full.safetensors")).assert_ok();
    sandbox.run(&format!("{TILES} --half-grids -o half.safetensors")).assert_ok();
    let [full, half] = ["full", "half"].map(|name| {
        read_tensors(sandbox.path(&format!("{name}.safetensors"))).unwrap()["tiles"].data.clone()
    });
    assert!(full != half, "nothing was rounded");
    assert_close("tiles", &half, &full, 2e-4);
    let words = "--half-grids --grad-tiles full.safetensors --grad grad.safetensors";
    sandbox.assert_refuses(&format!("{TILES} {words}"), &["--half-grids", "--grad"]);
    let bench = "bench scene.safetensors cameras.json tiles.json --half-grids";
    sandbox.assert_refuses(bench, &["--half-grids", "--forward"]);
}

#[test]
fn a_pixel_is_explained_as_it_is_rendered() {
    for name in names() {
        let sandbox = Sandbox::new(&name);
        sandbox.run(&format!("{TILES} -o out.safetensors")).assert_ok();
        let case = Case::load(&cases::folder().join(&name));
        let tiles = &case.tiles.tiles;
        let side = case.tiles.side as usize;
        let rendered =
            read_tensors(sandbox.path("out.safetensors")).unwrap().remove("tiles").unwrap();
        let column = 5;
        let row = 3;
        for (place, tile) in tiles.iter().enumerate().take(2) {
            let pixel = format!("{},{}", tile.origin[0] + column, tile.origin[1] + row);
            let words = format!(
                "explain scene.safetensors cameras.json --view {} --pixel {pixel}",
                tile.camera
            );
            let text = sandbox.run(&words).assert_ok().stdout;
            let json = sandbox.run(&format!("{words} --json")).json();
            let at = |channel: usize| {
                ((place * 3 + channel) * side + row as usize) * side + column as usize
            };
            let expected: Vec<f32> = (0..3).map(|channel| rendered.data[at(channel)]).collect();
            let found: Vec<f32> = serde_json::from_value(json["color"].clone()).unwrap();
            assert_eq!(found, expected, "{name}, {words}");
            let [r, g, b] = [0, 1, 2].map(|channel| to_8_bit(expected[channel]));
            assert_eq!(json["color_8_bit"], json!([r, g, b]));
            assert!(
                text.contains(&format!("in 8 bits {r} {g} {b} (#{r:02x}{g:02x}{b:02x})")),
                "{text}"
            );
        }
    }
}

#[test]
fn gaussians_without_effect_are_hidden_unless_asked_for() {
    let sandbox = Sandbox::new("crowded");
    let explain = |more: &str| -> Value {
        let words = format!("explain scene.safetensors cameras.json --pixel 48,40 --json {more}");
        sandbox.run(&words).json()
    };
    let some = explain("");
    let all = explain("--all");
    let number = |json: &Value| json["gaussians"].as_array().unwrap().len() as u64;
    assert!(number(&some) > 0 && number(&some) < number(&all));
    assert_eq!(number(&some) + some["hidden"].as_u64().unwrap(), number(&all));
    assert_eq!(some["color"], all["color"]);
}

#[test]
fn info_describes_every_file() {
    let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(Some(1))).unwrap());
    for name in names() {
        let sandbox = Sandbox::new(&name);
        let case = Case::load(&cases::folder().join(&name));
        sandbox.run(&format!("{TILES} -o out")).assert_ok();
        let info = |file: &str, facts: &[&str]| -> Value {
            let text = sandbox.run(&format!("info {file}")).assert_ok().stdout;
            for fact in facts {
                assert!(text.contains(fact), "{name}: {fact} is not in\n{text}");
            }
            sandbox.run(&format!("info {file} --json")).json()
        };
        let scene = info("scene.safetensors", &["Gaussians", "gaussians.log_scale", "level"]);
        assert_eq!(scene["gaussians"], json!(case.scene.gaussians.len()));
        assert_eq!(scene["device_bytes"], json!(renderer.upload(&case.scene).unwrap().bytes()));
        assert_eq!(scene["unused_tensors"], json!([]));
        let cameras = info("cameras.json", &["2 views of 96 x 80", "images/0001.png"]);
        assert_eq!(cameras["cameras"][1]["width"], json!(96));
        let tiles = info("tiles.json", &["4 tiles of"]);
        assert_eq!(tiles["side"], json!(case.tiles.side));
        let rendered = info("out", &["rendered batch", "4 tiles of"]);
        assert_eq!(rendered["tensors"][0]["shape"], json!(case.tiles.output_shape()));
    }
}

/// Other commands read the files of the demonstration.
#[test]
fn the_demonstration_needs_no_files_and_makes_some() {
    let sandbox = Sandbox::new("tiny");
    let demo = "demo -o demo --backend cpu";
    sandbox
        .run(&format!("{demo} --views 3 --size 40"))
        .assert_ok()
        .says(&["then try\n  organza info demo/scene.safetensors"]);
    let scene = "demo/scene.safetensors";
    let cameras = "demo/cameras.json";
    sandbox
        .run(&format!("tiles {scene} {cameras} demo/tiles.json -o out --backend cpu"))
        .assert_ok();
    sandbox.run(&format!("render {scene} {cameras} -o images --views 2 --backend cpu")).assert_ok();
    // The files differ in what they say of their options.
    let read = |name: &str| image::open(sandbox.path(name)).unwrap();
    assert!(read("images/0002.png") == read("demo/0002.png"));
    // again into its own folder, but not into another one
    sandbox.run(&format!("{demo} --views 1 --size 8")).assert_ok();
    // suggested commands are quoted for a shell
    let quoted = sandbox.run("demo -o it's --views 1 --size 8 --backend cpu");
    quoted.assert_ok().says(&["organza info \"it's/scene.safetensors\""]);
    sandbox.copy_file("scene.safetensors", scene);
    sandbox.assert_refuses(demo, &["holds a scene.safetensors", "another folder"]);
}

#[test]
fn a_device_is_named_and_with_details_also_why_it_is_taken() {
    let sandbox = Sandbox::new("tiny");
    let words = "tiles scene.safetensors cameras.json tiles.json -o out";
    let count = |words: &str, is: fn(&&str) -> bool| {
        sandbox.run(words).assert_ok().stderr.lines().filter(is).count()
    };
    let is_name = |line: &&str| line.starts_with("CPU, ") || line.starts_with("GPU, ");
    let is_choice = |line: &&str| line.starts_with("detail: ") && line.contains("pu: ");
    assert_eq!([count(words, is_name), count(words, is_choice)], [1, 0]);
    assert_eq!(count(&format!("{words} -v"), is_choice), 1);
    let alone = sandbox.run(&format!("{words} --backend cpu --threads 1")).assert_ok();
    assert!(alone.stderr.starts_with("CPU, 1 thread\n"), "{alone:?}");
    assert_eq!(sandbox.run(&format!("{words} --backend cpu --quiet")).assert_ok().stderr, "");
}

#[test]
fn distorted_lenses_are_warned_about() {
    let sandbox = Sandbox::new("tiny");
    sandbox.edit_json("cameras.json", "/camera_model", json!("OPENCV_FISHEYE"));
    let explain = "explain scene.safetensors cameras.json --pixel 1,1";
    for words in [&format!("{TILES} -o out"), &format!("{RENDER} -o images"), explain] {
        let outcome = sandbox.run(words).assert_ok();
        assert_eq!(outcome.stderr.matches("warning: ").count(), 1, "{outcome:?}");
        assert!(outcome.stderr.contains("distort"), "{outcome:?}");
    }
}

/// The levels of a 16-bit PNG.
fn levels(sandbox: &Sandbox, name: &str) -> (image::ColorType, Vec<u16>) {
    let image = image::open(sandbox.path(name)).unwrap();
    let levels = match &image {
        image::DynamicImage::ImageLuma16(image) => image.as_raw().clone(),
        image::DynamicImage::ImageRgb16(image) => image.as_raw().clone(),
        other => panic!("{name} is {:?}", other.color()),
    };
    (image.color(), levels)
}

#[test]
fn channels_are_written_beside_the_color() {
    let sandbox = Sandbox::new("basic");
    let case = Case::load(&cases::folder().join("basic"));
    let [width, height] = [case.cameras[0].width, case.cameras[0].height].map(|n| n as usize);
    let tiles = serde_json::to_vec(
        &json!({"side": width.max(height), "tiles": [{"camera": 0, "origin": [0, 0]}]}),
    );
    sandbox.write("view.json", tiles.unwrap());
    let all = "depth,alpha,visibility,normal";
    let words = "tiles scene.safetensors cameras.json view.json --backend cpu -o view.safetensors";
    sandbox.run(&format!("{words} --channels {all}")).assert_ok();
    let tensors = read_tensors(sandbox.path("view.safetensors")).unwrap();
    assert_eq!(
        tensors.keys().collect::<Vec<_>>(),
        ["alpha", "depth", "normal", "tiles", "visibility"]
    );

    sandbox.run(&format!("{RENDER} -o plain --views 0")).assert_ok();
    let words = format!("{RENDER} -o views --views 0 --channels {all}");
    sandbox.run(&format!("{words} --depth-scale 100")).assert_ok();
    let (name, color) = sandbox.images("plain").pop_first().unwrap();
    let stem = name.trim_end_matches(".png");
    // The files differ in what they say of their options.
    let same = image::open(sandbox.path(&format!("views/{stem}.png"))).unwrap();
    assert!(image::load_from_memory(&color).unwrap() == same, "channels change the color");
    for (name, planes, to_unit) in [
        ("depth", 1, (|v| v * 100.0 / 65_535.0) as fn(f32) -> f32),
        ("alpha", 1, |v| v),
        ("visibility", 1, |v| v),
        ("normal", 3, |v| 0.5 * v + 0.5),
    ] {
        let tensor = &tensors[name];
        let side = tensor.shape[2];
        assert_eq!(tensor.shape, [1, planes, side, side], "{name}");
        let value = |x, y, plane| tensor.data[(plane * side + y) * side + x];
        let (kind, found) = levels(&sandbox, &format!("views/{stem}.{name}.png"));
        assert_eq!(kind.channel_count() as usize, planes);
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            for plane in 0..planes {
                let level = found[(y * width + x) * planes + plane];
                let expected = to_unit(value(x, y, plane)).clamp(0.0, 1.0) * 65_535.0;
                assert!(
                    (f32::from(level) - expected).abs() <= 0.6,
                    "{name} at {x}, {y}: {level} for {expected}"
                );
            }
        }
    }
    sandbox
        .run(&format!("{words} --channels depth --depth-scale 1e6"))
        .assert_ok()
        .says(&["deeper than a PNG holds"]);
    sandbox.assert_refuses(&format!("{RENDER} -o images --channels color"), &["color", "depth"]);
    sandbox.assert_refuses(&format!("{RENDER} -o images --depth-scale 9"), &["--channels"]);
    sandbox.assert_refuses(
        &format!("{RENDER} -o images --channels depth --depth-scale 0"),
        &["above 0"],
    );
}
