//! `organza mesh`: the surfaces of a scene as a mesh.

use std::fs;

use glam::{DQuat, DVec3};
use organza::scene::Placement;
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
        let facts = ["triangles", file, "of memory"];
        sandbox.run(&format!("{words} -o {file}")).assert_ok().says(&facts);
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

/// Cameras that are held with some roll, and a scene that knows its up: a mesh and Gaussians of it have the same axes.
#[test]
fn files_of_a_scene_have_the_same_axes() {
    let sandbox = sandbox();
    let rolled =
        |(at, camera): (usize, Camera)| camera.moved([0.0, 0.0, 0.02 * at as f64, 0.0, 0.0, 0.0]);
    let cameras: Vec<_> = demo::turntable(6, 48).into_iter().enumerate().map(rolled).collect();
    let mut scene = demo::scene();
    scene.config.placement = Placement { up: [0.0, 0.8, 0.6], scale: 2.0, ..Placement::default() };
    scene.save(sandbox.path("placed.safetensors")).expect("a scene");
    let world = |camera: &Camera| scene.config.placement.world_camera(camera);
    Camera::save_all(sandbox.path("rolled.json"), &cameras.iter().map(world).collect::<Vec<_>>())
        .expect("cameras");
    let words = "placed.safetensors rolled.json --backend cpu";
    sandbox.run(&format!("mesh {words} --size 16 -o mesh.glb")).assert_ok();
    sandbox.run(&format!("export {words} --steps 0 --side 16 -o splats.glb")).assert_ok();
    let [mesh, splats] = ["mesh.glb", "splats.glb"].map(|name| {
        let glb = fs::read(sandbox.path(name)).expect("a file");
        let length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
        let json: Value = serde_json::from_slice(&glb[20..20 + length]).expect("JSON");
        json["nodes"][0]["rotation"].clone()
    });
    assert_eq!(mesh, splats);
    let turn = DQuat::from_array(serde_json::from_value(mesh).expect("a rotation"));
    assert!((turn * DVec3::new(0.0, 0.8, 0.6)).distance(DVec3::Y) < 1e-6, "{turn}");
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
        ("built-in.safetensors@place.json -o a.glb", "the command takes one scene"),
        ("away.json -o a.glb", "the views show no surface"),
    ] {
        let words = format!("mesh built-in.safetensors {words} --backend cpu");
        sandbox.assert_refuses(&words, &[fact]);
    }
}
