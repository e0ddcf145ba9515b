//! `organza train --view`: the page shows the training, and watching changes nothing.

use std::time::Duration;
use std::{fs, thread};

use serde_json::{Value, json};

use super::client::{Viewer, connect, exchange};
use crate::sandbox::wait_until;
use crate::train::processes::wait_for_end;
use crate::train::runs::{TINY, assert_same, bits, records, sandbox, without_times};

#[test]
fn the_bits_do_not_depend_on_who_watches() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} alone")).assert_ok();
    let words = format!("{TINY} watched --view --port 0 --view-share 75");
    let mut viewer = Viewer::start(&sandbox, &words);
    let board = |viewer: &Viewer| viewer.get("/training.json").json();
    let command = |viewer: &Viewer, name: &str| viewer.post("/training", &json!(name)).ok();
    command(&viewer, "pause");
    let look = |viewer: &Viewer| {
        let scene = viewer.scene();
        let camera = scene["views"][0]["camera"].clone();
        for mode in ["color", "depth", "gaussians", "error"] {
            for quality in ["moving", "exact"] {
                viewer.frame(&camera, quality, &json!({"mode": mode, "view": 0})).ok();
            }
        }
        viewer.post("/explain", &json!({"camera": camera, "pixel": [16, 16]})).ok();
        viewer.frame(&camera, "exact", &json!({})).ok()
    };
    let first = look(&viewer);
    let step = |value: &Value| value["step"].as_u64().expect("a number");
    let paused = board(&viewer);
    assert_eq!(first.about()["version"], paused["step"], "it shows the scene of this step");
    assert!(step(&paused) < 40 && paused["steps"] == 40 && paused["paused"] == true);
    thread::sleep(Duration::from_millis(200));
    assert_eq!(step(&board(&viewer)), step(&paused), "nothing moves while it waits");
    command(&viewer, "step");
    wait_until("one step", || step(&board(&viewer)) == step(&paused) + 1);
    thread::sleep(Duration::from_millis(100));
    assert_eq!(step(&board(&viewer)), step(&paused) + 1, "and no other");
    assert!(look(&viewer).body != first.body, "the scene has changed");
    let curve = board(&viewer)["curve"].clone();
    let length = |name: &str| curve[name].as_array().expect("a list").len();
    assert_eq!([length("step"), length("loss"), length("psnr")], [step(&paused) as usize + 1; 3]);
    command(&viewer, "go");
    // training goes on, even if a client always wants an image
    thread::scope(|scope| {
        let host = &viewer.host;
        let lines = viewer.lines();
        scope.spawn(move || {
            let camera = json!({"camera_to_world": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 4],
                [0, 0, 0, 1]], "fl_x": 40, "fl_y": 40, "cx": 32, "cy": 32, "w": 64, "h": 64});
            let body = |sequence| {
                json!({"client": 5, "sequence": sequence, "camera": camera,
                "mode": "color", "quality": "moving"})
            };
            let mut sequence = 0;
            // the program may end between two connections
            while let Ok(stream) = connect(host) {
                sequence += 1;
                let body = body(sequence).to_string();
                let head = format!(
                    "POST /frame HTTP/1.1\r\n{lines}Content-Length: {}\r\n\
                    Connection: close\r\n\r\n",
                    body.len()
                );
                exchange(stream, &[head.as_bytes(), body.as_bytes()].concat());
            }
        });
    });
    assert_eq!(wait_for_end(&mut viewer.child), Some(0));
    assert_same("watched", &bits(&sandbox, "watched"), &bits(&sandbox, "alone"));
    let told = |run: &str| without_times(&records(&sandbox.path(run)));
    assert_eq!(told("watched"), told("alone"));
}

#[test]
fn the_page_stops_a_training_as_ctrl_c_does() {
    let sandbox = sandbox();
    let mut viewer = Viewer::start(&sandbox, &format!("{TINY} run --view --port 0 --steps 100000"));
    let board = || viewer.get("/training.json").json();
    wait_until("psnr of held-out views", || {
        board()["evaluations"]["psnr"].as_array().is_some_and(|all| all.len() > 2)
    });
    let psnr = board()["evaluations"]["psnr"].clone();
    let psnr: Vec<f64> = serde_json::from_value(psnr).expect("numbers");
    assert!(psnr[2] > psnr[0] - 0.5, "{psnr:?}");
    viewer.post("/training", &json!("stop")).ok();
    assert_eq!(wait_for_end(&mut viewer.child), Some(0));
    let said = viewer.last_words();
    assert!(
        said.iter().any(|line| line.contains("saved; `organza train --resume run`")),
        "{said:?}"
    );
    assert!(fs::exists(sandbox.path("run/checkpoint.safetensors")).unwrap());
}
