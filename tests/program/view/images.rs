//! Images and numbers of the page must equal other commands'.

use organza::scene::{Contraction, SceneConfig};
use organza::{Camera, Scene};
use serde_json::{Value, json};

use super::client::{Viewer, pixels};
use crate::sandbox::Sandbox;
use crate::train::runs::photographs;

// even with `--quiet`, the user needs the page's address
const VIEW: &str = "view scene.safetensors cameras.json --port 0 --backend cpu --quiet";

#[test]
fn images_at_rest_are_the_bytes_of_render() {
    let sandbox = Sandbox::new("basic");
    sandbox.run("render scene.safetensors cameras.json -o images --backend cpu").assert_ok();
    let viewer = Viewer::start(&sandbox, VIEW);
    let scene = viewer.scene();
    let views = scene["views"].as_array().expect("views");
    let images = sandbox.images("images");
    assert!(images.len() == views.len() && views.len() > 1);
    for (index, (view, (name, image))) in views.iter().zip(&images).enumerate() {
        let camera = &view["camera"];
        // for a new client, the pace is not known yet
        let moving = viewer.frame(camera, "moving", &json!({ "client": 10 + index })).ok();
        assert!(moving.body.starts_with(b"\xff\xd8") && moving.about()["steps"] != 1);
        let size = [&camera["w"], &camera["h"]].map(|side| side.as_u64().unwrap().div_ceil(2));
        assert_eq!(moving.about()["size"], json!(size));
        let exact = viewer.frame(camera, "exact", &json!({})).ok();
        assert!(pixels(&exact.body) == pixels(image), "{name}");
        assert!(exact.about()["samples"].as_u64().unwrap() > 0);
        // values that do not depend on the direction are kept
        let mut turned = camera.clone();
        let pose: [[f64; 4]; 4] =
            serde_json::from_value(camera["camera_to_world"].clone()).unwrap();
        turned["camera_to_world"] =
            pose.map(|[x, y, z, w]| json!([y, -x, z, w])).into_iter().collect();
        turned["camera_to_world"][3] = json!([0.0, 0.0, 0.0, 1.0]);
        viewer.frame(&turned, "exact", &json!({})).ok();
        let again = viewer.frame(camera, "exact", &json!({})).ok();
        assert_eq!(again.about()["samples"], 0);
        assert!(again.body == exact.body);
    }
}

/// Compares numbers of the page with the command's. Rays of the second case are not straight.
#[test]
fn a_pixel_is_explained_with_the_numbers_of_explain() {
    ["basic", "contracted"].into_iter().for_each(assert_explained);
}

/// The equations of docs/pipeline.md that map a place of the world to the unit cube.
fn in_the_cube(config: &SceneConfig, place: [f64; 3]) -> [f64; 3] {
    let [low, high] = config.aabb;
    let part = |axis: usize| (place[axis] - low[axis]) / (high[axis] - low[axis]);
    if config.contraction == Contraction::None {
        return [0, 1, 2].map(|axis| 0.05 + 0.9 * part(axis));
    }
    let q = [0, 1, 2].map(|axis| 0.5 * part(axis) - 0.25);
    let n = q.iter().fold(0.25, |n: f64, q| n.max(q.abs()));
    q.map(|q| 0.5 + q * (0.5 - 1.0 / (16.0 * n)) / n)
}

fn assert_explained(case: &str) {
    let sandbox = Sandbox::new(case);
    let scene = Scene::load(sandbox.path("scene.safetensors")).unwrap();
    let cameras = Camera::load_all(sandbox.path("cameras.json")).unwrap();
    let viewer = Viewer::start(&sandbox, VIEW);
    let camera = viewer.scene()["views"][0]["camera"].clone();
    for pixel in ["20,17", "30,30", "24,24"] {
        let words =
            format!("explain scene.safetensors cameras.json --view 0 --pixel {pixel} --json");
        let expected = sandbox.run(&words).json();
        let at: Value = serde_json::from_str(&format!("[{pixel}]")).unwrap();
        let found = viewer.post("/explain", &json!({"camera": camera, "pixel": at})).json();
        for name in ["color_sum", "alpha_sum", "background", "divided", "color", "color_8_bit"] {
            assert_eq!(found[name], expected[name], "{pixel}: {name}");
        }
        let rows = expected["gaussians"].as_array().unwrap();
        assert_eq!(found["all"].as_u64().unwrap() as usize, rows.len());
        assert!(!rows.is_empty());
        for row in rows {
            let same = |other: &&Value| other["gaussian"] == row["gaussian"];
            let other = found["gaussians"].as_array().unwrap().iter().find(same).expect("listed");
            for (name, value) in row.as_object().unwrap() {
                assert_eq!(other[name], *value, "{pixel}: {name}");
            }
            // the ray ends with the T that the composite used
            let ray = other["transmittances"].as_array().unwrap();
            assert_eq!(ray.len() as u64, row["samples"].as_u64().unwrap());
            let last = ray.last().map_or(1.0, |value| value.as_f64().unwrap());
            let t = row["transmittance"].as_f64().unwrap();
            assert!((last - t).abs() <= 1e-5 * t, "{pixel}: {last} and {t}");
            // and goes from the Gaussian to the eye, or to the border of the cube
            let places: Vec<[f64; 3]> = serde_json::from_value(other["places"].clone()).unwrap();
            let gaussian = row["gaussian"].as_u64().unwrap() as usize;
            let position = scene.gaussians.position[gaussian].map(f64::from);
            let is_contracted = scene.config.contraction != Contraction::None;
            assert_eq!(places.len(), if is_contracted { ray.len() + 1 } else { 2 });
            let ends = [(places[0], position), (places[places.len() - 1], cameras[0].eye())];
            for (found, end) in ends {
                let expected = in_the_cube(&scene.config, end);
                let is_inside = expected.iter().all(|x| (0.0..=1.0).contains(x));
                let is_on_a_face = found.iter().any(|x| x.abs() < 1e-5 || (x - 1.0).abs() < 1e-5);
                let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5);
                let is_right = if is_inside { is_near } else { is_on_a_face };
                assert!(is_right, "{pixel}: {found:?} and {expected:?}");
            }
        }
    }
    assert_eq!(viewer.post("/explain", &json!({"camera": camera, "pixel": [4000, 1]})).status, 422);
}

#[test]
fn every_mode_has_an_image_and_errors_need_a_photograph() {
    let sandbox = Sandbox::new("tiny");
    photographs(&sandbox);
    let viewer = Viewer::start(&sandbox, "view scene.safetensors data --port 0 --backend cpu");
    let scene = viewer.scene();
    let camera = &scene["views"][1]["camera"];
    for mode in ["color", "visibility", "weight", "depth", "normal", "gaussians"] {
        for quality in ["moving", "still", "exact"] {
            viewer.frame(camera, quality, &json!({ "mode": mode })).ok();
        }
    }
    assert_eq!(viewer.frame(camera, "exact", &json!({"mode": "error"})).status, 422);
    let error = viewer.frame(camera, "exact", &json!({"mode": "error", "view": 1})).ok();
    // the photograph is a rendering, so there is no error, and only one color
    let decoded = pixels(&error.body);
    let first = decoded.pixels().next().expect("a pixel");
    assert!(decoded.pixels().all(|pixel| pixel == first), "an error of a rendering");
    let other = viewer.frame(camera, "exact", &json!({"mode": "error", "view": 0})).ok();
    assert!(other.body != error.body, "another photograph");
    let photograph = viewer.get("/photograph/1").ok();
    assert!(photograph.body.starts_with(b"\xff\xd8"));
    assert_eq!(viewer.get("/photograph/99").status, 422);
    assert_eq!(viewer.frame(camera, "exact", &json!({"background": [1.0, 0.0, 2.0]})).status, 400);
}

#[test]
fn keyframes_are_files_that_every_command_reads() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, VIEW);
    let views = viewer.scene()["views"].clone();
    let keyframes: Value =
        views.as_array().unwrap().iter().map(|view| view["camera"].clone()).collect();
    let file = viewer.post("/cameras.json", &keyframes).ok();
    sandbox.write("keyframes.json", &file.body);
    let without_paths = |name: &str| -> Vec<Camera> {
        let cameras = Camera::load_all(sandbox.path(name)).expect("cameras");
        let bare = |camera| Camera { file_path: None, distorted: false, ..camera };
        cameras.into_iter().map(bare).collect()
    };
    assert_eq!(without_paths("keyframes.json"), without_paths("cameras.json"));
    let head = format!("POST /keyframes HTTP/1.1\r\nHost: {}\r\n", viewer.host);
    assert_eq!(viewer.ask(&head, &file.body).json()["cameras"], keyframes);
    let path = viewer.post("/path", &json!({"keyframes": keyframes, "loop": true, "frames": 12}));
    assert_eq!(path.json()["cameras"].as_array().unwrap().len(), 12);
    for bad in [json!([]), json!([{"w": 1}]), json!("x")] {
        assert_eq!(viewer.post("/cameras.json", &bad).status, 400, "{bad}");
    }
    for (keyframes, frames) in [(json!([]), 5), (keyframes, 100_000)] {
        let path = json!({"keyframes": keyframes, "loop": true, "frames": frames});
        assert_eq!(viewer.post("/path", &path).status, 400, "{frames}");
    }
}
