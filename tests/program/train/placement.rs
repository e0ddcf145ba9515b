//! Data sets in any units, anywhere: scenes have coordinates of their own.

use glam::{DMat3, DVec3};
use image::RgbImage;
use organza::image::to_8_bit;
use organza::scene::Placement;
use organza::splats::{Format, SplatFile};
use organza::train::CHECKPOINT;
use organza::{Camera, Scene, splats};
use organza_tests::cases;
use serde_json::{Value, json};

use super::runs::{TINY, built_in, sandbox};
use crate::sandbox::Sandbox;

/// Moves a sandbox's photographs: `world = offset + scale R old`, where R exchanges the axes if `is_turned`.
fn move_world(sandbox: &Sandbox, scale: f64, offset: [f64; 3], is_turned: bool) {
    let mut file = sandbox.read_json("views/transforms.json");
    for frame in file["frames"].as_array_mut().unwrap() {
        let old = frame["transform_matrix"].clone();
        for row in 0..3 {
            let from = if is_turned { (row + 1) % 3 } else { row };
            for column in 0..4 {
                let value = old[from][column].as_f64().unwrap();
                let moved = if column == 3 { offset[row] + scale * value } else { value };
                frame["transform_matrix"][row][column] = json!(moved);
            }
        }
    }
    sandbox.write("views/transforms.json", file.to_string());
}

#[test]
fn a_world_is_learned_alike_in_any_units_and_anywhere() {
    let psnr = |scale: f64, offset: [f64; 3], is_turned: bool| {
        let sandbox = sandbox();
        move_world(&sandbox, scale, offset, is_turned);
        sandbox.run(&format!("{TINY} run --json")).json()["psnr"].as_f64().unwrap()
    };
    let expected = psnr(1.0, [0.0; 3], false);
    for (scale, offset, is_turned) in [
        (1e-4, [0.0; 3], false),
        (1e4, [0.0; 3], false),
        (1.0, [512_345.25, 4_612_345.5, 312.0], false),
        (1e-3, [3_782_000.0, 902_000.0, 5_038_000.0], true),
    ] {
        let found = psnr(scale, offset, is_turned);
        println!("{scale:e} {offset:?} {is_turned}: {found} dB, and {expected} dB at home");
        assert!((found - expected).abs() < 0.5, "{scale}, {offset:?}: {found}, not {expected}");
    }
}

/// Few Gaussians of the built-in scene, which are larger.
fn few() -> Scene {
    let mut scene = cases::thinned(16, 4_f32.ln());
    scene.config.step = built_in().config.step;
    scene
}

/// Takes the photographs of a file's Gaussians, as a viewer that sorts shows them.
fn photograph(sandbox: &Sandbox, file: &str) {
    let file = splats::load(sandbox.path(file)).unwrap();
    let placement = file.placement;
    let cameras = placement.load_cameras(sandbox.path("views/transforms.json")).unwrap();
    let shown = file.into_own(&placement).unwrap();
    let background = built_in().config.background.map(|value| value as f32);
    for camera in &cameras {
        let pixels = splats::render(&shown, camera, background, false).into_iter();
        let bytes: Vec<_> = pixels.flat_map(|color| color.map(to_8_bit)).collect();
        let image = RgbImage::from_raw(camera.width, camera.height, bytes).unwrap();
        let name = camera.file_path.as_deref().unwrap();
        let path = sandbox.path("views").join(name).with_extension("png");
        assert!(path.exists(), "{path:?}");
        image.save(path).unwrap();
    }
}

/// An exported file says where it lies: its offset, its unit and its axes.
#[test]
fn exported_gaussians_come_back_to_their_photographs() {
    let sandbox = sandbox();
    let offset = [512_345.25, 4_612_345.5, 312.0];
    move_world(&sandbox, 3.0, offset, true);
    let mut scene = few();
    let [up, right] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    scene.config.placement = Placement { offset, scale: 3.0, up, right, meters: None };
    scene.save(sandbox.path("scene.safetensors")).unwrap();
    sandbox.run("edit scene.safetensors -o meters.safetensors --scale 0.02").assert_ok();
    let expected: Vec<_> = positions(&scene);
    let assert_placed = |name: &str| {
        let found = Scene::load(sandbox.path(name)).unwrap();
        for place in positions(&found) {
            let apart = |other: &[f64; 3]| (0..3).map(|i| (place[i] - other[i]).abs()).sum::<f64>();
            let nearest = expected.iter().map(apart).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.03, "{name}: {place:?} is {nearest} from any");
        }
    };
    let export = |from: &str, to: &str| {
        let words = format!("export {from}.safetensors views -o {to} --steps 0 --side 16");
        sandbox.run(&format!("{words} --backend cpu")).assert_ok().stderr
    };
    let start = |file: &str, run: &str| {
        let words = format!("train views --config tiny.toml --backend cpu --steps 1 -o {run}");
        sandbox.run(&format!("{words} --start {file} --max-gaussians 4000"))
    };
    export("scene", "a.ply");
    photograph(&sandbox, "a.ply");
    for (index, file) in ["a.ply", "a.spz", "a.sog", "a.glb"].iter().enumerate() {
        let text = export(if index % 2 == 0 { "scene" } else { "meters" }, file);
        assert!(text.contains("as it says itself") && text.contains("back to a scene"), "{text}");
        start(file, &format!("run-{index}")).assert_ok().says_not(&["Gaussians are"]);
        assert_placed(&format!("run-{index}/{CHECKPOINT}"));
    }
    let words = "import a.glb views -o back.safetensors --steps 1 --side 16 --backend cpu";
    sandbox.run(words).assert_ok().says_not(&["warning"]);
    assert_placed("back.safetensors");
    sandbox.run("import a.ply -o around.safetensors --steps 1 --side 16 --backend cpu").assert_ok();
    assert_placed("around.safetensors");
    // a format without room
    let text = export("scene", "a.splat");
    assert!(!text.contains("as it says itself") && !text.contains("back to a scene"), "{text}");
    start("a.splat", "none").assert_refused(&["a.splat", "see none", "512345.", "4612345."]);
    sandbox.assert_refuses(
        "import a.splat views -o none.safetensors --steps 1 --backend cpu",
        &["a.splat", "see none"],
    );
}

/// The places of a scene's Gaussians in the world.
fn positions(scene: &Scene) -> Vec<[f64; 3]> {
    let place = |place: &[f32; 3]| scene.config.placement.world(place.map(f64::from));
    scene.gaussians.position.iter().map(place).collect()
}

/// Files of other programs may have other axes than the data set, as libspz turns COLMAP's.
#[test]
fn photographs_tell_the_axes_of_a_file() {
    let sandbox = sandbox();
    few().save(sandbox.path("scene.safetensors")).unwrap();
    let words = "export scene.safetensors views -o a.ply --steps 0 --side 16 --backend cpu";
    sandbox.run(words).assert_ok();
    photograph(&sandbox, "a.ply");
    let file = splats::load(sandbox.path("a.ply")).unwrap();
    let save = |name: &str, file: &SplatFile| {
        let path = sandbox.path(name);
        splats::save(&file.splats, path, Format::Spz2, [0.0; 3], &Placement::default()).unwrap();
    };
    save("right.spz", &file);
    let half = DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0));
    save("turned.spz", &file.clone().turned(half));
    let mut large = file.clone();
    large.splats.iter_mut().for_each(|splat| splat.position = splat.position.map(|x| 2.0 * x));
    save("large.spz", &large);
    let words = "train views --config tiny.toml --backend cpu --steps 1 --max-gaussians 4000";
    let scene = |name: &str, fact: Option<&str>| {
        let outcome = sandbox.run(&format!("{words} --start {name}.spz -o {name}")).assert_ok();
        assert_eq!(outcome.stderr.contains("warning"), fact.is_some(), "{outcome:?}");
        assert!(fact.is_none_or(|fact| outcome.stderr.contains(fact)), "{outcome:?}");
        positions(&Scene::load(sandbox.path(name).join(CHECKPOINT)).unwrap())
    };
    let expected = scene("right", None);
    let turned = scene("turned", Some("turned: x, y, z become x, -y, -z"));
    for (a, b) in expected.iter().zip(turned) {
        // but for a step of training
        assert!((0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-2), "{a:?} {b:?}");
    }
    scene("large", Some("show something else where its Gaussians are"));
    let words = "import turned.spz views -o back.safetensors --steps 1 --side 16 --backend cpu";
    sandbox.run(words).assert_ok().says(&["become x, -y, -z"]);
}

/// What goes in and comes out has the coordinates of the data set.
#[test]
fn commands_speak_of_the_world() {
    let sandbox = sandbox();
    let offset = [100.0, -200.0, 300.0];
    move_world(&sandbox, 30.0, offset, true);
    sandbox.run(&format!("{TINY} run --refine-poses")).assert_ok();
    let given = Camera::load_all(sandbox.path("views/transforms.json")).unwrap();
    let refined = Camera::load_all(sandbox.path("run/cameras.json")).unwrap();
    for (given, refined) in given.iter().zip(&refined) {
        let apart = (0..3).map(|axis| (given.eye()[axis] - refined.eye()[axis]).abs());
        assert!(apart.fold(0.0, f64::max) < 3.0, "{given:?}, {refined:?}");
    }
    assert_eq!(given[0].camera_to_world, refined[0].camera_to_world);

    // the same view by its own name and from a file of the world; depths are in the world's units
    let depth = "--channels depth --backend cpu --views 1";
    sandbox.run(&format!("render run -o by-run {depth}")).assert_ok();
    sandbox.run(&format!("render run run/cameras.json -o by-file {depth}")).assert_ok();
    assert!(sandbox.read("by-run/view-001.png") == sandbox.read("by-file/view-001.png"));
    let scene = Scene::load(sandbox.path("run").join(CHECKPOINT)).unwrap();
    let placement = scene.config.placement;
    let center = placement.world([0.0; 3]);
    assert!((0..3).all(|axis| (center[axis] - offset[axis]).abs() < 6.0), "{center:?}");
    // z has become y
    assert!(placement.up[1] > 0.99, "{placement:?}");
    for camera in &given {
        let apart = (0..3).map(|axis| (camera.eye()[axis] - center[axis]).powi(2)).sum::<f64>();
        let units = apart.sqrt() / placement.scale;
        assert!((units - 4.0).abs() < 0.6, "{units}");
    }

    // Gaussians of the scene, in the world
    sandbox.run("export run -o run.ply --steps 0 --backend cpu").assert_ok();
    let written = splats::load(sandbox.path("run.ply")).unwrap().splats;
    let places: Vec<_> = scene.gaussians.position.iter().collect();
    for splat in &written {
        let own = placement.own(splat.position.map(f64::from)).map(|x| x as f32);
        let near = places.iter().any(|place| (0..3).all(|i| (place[i] - own[i]).abs() < 1e-3));
        assert!(near, "{own:?}");
    }

    let info = sandbox.run("info run --json").json();
    let corner: Vec<f64> = serde_json::from_value(info["corners"][0].clone()).unwrap();
    assert_eq!(corner, placement.world(scene.config.aabb[0]));
    // the box of the scene keeps all that is in it, and one around the origin nothing
    let corners = info["corners"].as_array().unwrap();
    let corners = corners.iter().flat_map(|corner| corner.as_array().unwrap());
    let corners: Vec<_> = corners.map(Value::to_string).collect();
    let words = format!("edit run -o cut.safetensors --box {} --json", corners.join(","));
    let [lo, hi] = scene.config.aabb;
    let inside = places
        .iter()
        .filter(|place| (0..3).all(|i| (lo[i] as f32..=hi[i] as f32).contains(&place[i])));
    assert_eq!(sandbox.run(&words).json()["gaussians"], inside.count());
    sandbox
        .run("edit run -o none.safetensors --box -50,-50,-50,50,50,50")
        .assert_refused(&["nothing would be left"]);

    // a file in meters, at 2 cm a unit
    sandbox.run("edit run -o scaled.safetensors --scale 0.02").assert_ok();
    sandbox
        .run("export scaled.safetensors views/transforms.json -o m.ply --steps 0 --backend cpu")
        .assert_ok();
    sandbox.run("export run views/transforms.json -o w.ply --steps 0 --backend cpu").assert_ok();
    let [meters, world] =
        ["m.ply", "w.ply"].map(|name| splats::load(sandbox.path(name)).unwrap().splats);
    for (meters, world) in meters.iter().zip(&world) {
        let apart = (0..3).map(|i| (meters.position[i] - 0.02 * world.position[i]).abs());
        assert!(apart.fold(0.0, f32::max) < 1e-4, "{meters:?}, {world:?}");
    }
    for bad in ["--scale 0", "--scale x"] {
        sandbox.run(&format!("edit run -o bad.safetensors {bad}")).assert_refused(&["expected"]);
    }
}
