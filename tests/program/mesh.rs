//! `organza mesh`: the surfaces of a scene as a mesh.

use std::fs;

use organza::{Camera, Scene, demo};
use serde_json::Value;

use crate::sandbox::Sandbox;

/// The built-in scene, and cameras around it.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    demo::scene().save(sandbox.path("built-in.safetensors")).expect("a scene");
    Camera::save_all(sandbox.path("around.json"), &demo::turntable(6, 48)).expect("cameras");
    sandbox
}

#[test]
fn all_formats_have_the_same_triangles_in_the_scene() {
    let sandbox = sandbox();
    let words = "mesh built-in.safetensors around.json --size 32 --faces 900 --backend cpu";
    for file in ["a.obj", "a.ply", "a.glb"] {
        sandbox.run(&format!("{words} -o {file}")).assert_ok().says(&[
            "triangles",
            file,
            "of memory",
        ]);
    }
    let text = fs::read_to_string(sandbox.path("a.obj")).expect("a file");
    let of_kind = |kind: &'static str| {
        let lines = text.lines().filter_map(move |line| line.strip_prefix(kind));
        let numbers = |line: &str| line.split(' ').map(|x| x.parse().expect("a number")).collect();
        lines.map(numbers).collect::<Vec<Vec<f64>>>()
    };
    let vertices = of_kind("v ");
    let faces = of_kind("f ");
    assert!((100..=900).contains(&faces.len()), "{}", faces.len());
    assert!(faces.iter().flatten().all(|&at| at >= 1.0 && at as usize <= vertices.len()));
    let scene = Scene::load(sandbox.path("built-in.safetensors")).expect("a scene");
    let [low, high] = scene.visible_box();
    let margin = 0.1 * (high[0] - low[0]);
    for vertex in &vertices {
        let place = scene.config.placement.own([vertex[0], vertex[1], vertex[2]]);
        let is_inside =
            |axis: usize| (low[axis] - margin..=high[axis] + margin).contains(&place[axis]);
        assert!((0..3).all(is_inside), "{place:?}");
    }

    let ply = fs::read(sandbox.path("a.ply")).expect("a file");
    let end = b"end_header\n";
    let body = ply.windows(end.len()).position(|window| window == end).expect("a header");
    let body = &ply[body + end.len()..];
    assert_eq!(body.len(), 15 * vertices.len() + 13 * faces.len());
    let first = f32::from_le_bytes([body[0], body[1], body[2], body[3]]);
    assert!((f64::from(first) - vertices[0][0]).abs() < 1e-6);

    let glb = fs::read(sandbox.path("a.glb")).expect("a file");
    let word = |at: usize| u32::from_le_bytes([glb[at], glb[at + 1], glb[at + 2], glb[at + 3]]);
    assert_eq!(word(8) as usize, glb.len());
    let length = word(12) as usize;
    let json: Value = serde_json::from_slice(&glb[20..20 + length]).expect("JSON");
    assert_eq!(json["accessors"][0]["count"], vertices.len());
    assert_eq!(json["accessors"][2]["count"], 3 * faces.len());
    assert_eq!(word(20 + length) as usize, 24 * vertices.len() + 12 * faces.len());
}

#[test]
fn bad_requests_of_meshes_are_refused() {
    let sandbox = sandbox();
    let away = Camera::look_at([0.0, 0.0, 50.0], [0.0, 0.0, 99.0], [0.0, 1.0, 0.0], 0.8, [8, 8]);
    Camera::save_all(sandbox.path("away.json"), &[away.expect("a camera")]).expect("cameras");
    for (words, fact) in [
        ("around.json -o a.stl", "a.stl should end in .glb, .ply or .obj"),
        ("around.json -o a.ply --faces 20", "--faces"),
        ("-o a.glb", "organza mesh SCENE CAMERAS -o FILE"),
        ("away.json -o a.glb", "the views show no surface"),
    ] {
        let words = format!("mesh built-in.safetensors {words} --backend cpu");
        sandbox.assert_refuses(&words, &[fact]);
    }
}
