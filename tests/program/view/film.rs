//! Films of the page must equal `organza film`'s.

use std::io::Write;
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::client::{Reply, VIEW, Viewer};
use crate::sandbox::Sandbox;

/// Requests a film. An HTTP/1.0 answer comes in one piece.
fn film(viewer: &Viewer, request: &Value) -> Reply {
    let head = format!("POST /film HTTP/1.0\r\nHost: {}\r\n", viewer.host);
    viewer.ask(&head, request.to_string().as_bytes())
}

fn request(keyframes: &Value, frames: usize) -> Value {
    let path = json!({"keyframes": keyframes, "loop": true, "frames": frames});
    json!({"path": path, "kind": "png", "fps": 12, "mode": "color"})
}

fn keyframes(viewer: &Viewer) -> Value {
    let scene = viewer.scene();
    let views = scene["views"].as_array().expect("views");
    views.iter().map(|view| view["camera"].clone()).collect()
}

#[test]
fn a_film_of_keyframes_is_the_commands() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, VIEW);
    let keyframes = keyframes(&viewer);
    let file = viewer.post("/cameras.json", &keyframes).ok();
    sandbox.write("keyframes.json", &file.body);
    let words = "film scene.safetensors keyframes.json -o film.png --loop --frames 5 --fps 12 --backend cpu";
    sandbox.run(words).assert_ok();
    let expected = sandbox.read("film.png");

    let mut body = &film(&viewer, &request(&keyframes, 5)).ok().body[..];
    let mut lines = Vec::new();
    let size = loop {
        let end = body.iter().position(|byte| *byte == b'\n').expect("a line");
        let line: Value = serde_json::from_slice(&body[..end]).expect("JSON");
        body = &body[end + 1..];
        if let Some(size) = line["bytes"].as_u64() {
            break size;
        }
        lines.push(line);
    };
    let progress: Vec<_> = (0..=5).map(|frame| json!({"frame": frame, "frames": 5})).collect();
    assert_eq!(lines, progress);
    assert_eq!(size as usize, body.len());
    assert!(body == expected, "{} and {} bytes", body.len(), expected.len());

    let kinds = viewer.scene()["films"].clone();
    assert!(kinds.as_array().unwrap().contains(&json!("png")));
    for (name, bad) in [
        ("fps", json!(0)),
        ("kind", json!("frames")),
        ("kind", json!("avi")),
        ("mode", json!("error")),
        ("background", json!([0.0, 0.0, 2.0])),
        ("path", json!({"keyframes": [], "loop": true, "frames": 5})),
        ("path", json!({"keyframes": keyframes, "loop": true, "frames": 0})),
        ("path", json!({"keyframes": keyframes, "loop": true, "frames": 100_000})),
    ] {
        let mut request = request(&keyframes, 5);
        request[name] = bad;
        assert_eq!(film(&viewer, &request).status, 400, "{request}");
    }
}

/// At most two films are made at once. When a page goes away, it makes room.
#[test]
fn a_page_that_goes_away_ends_its_film() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, VIEW);
    let keyframes = keyframes(&viewer);
    let body = request(&keyframes, 10_000).to_string();
    let begin = || {
        let mut stream = viewer.connect();
        let head = format!("POST /film HTTP/1.1\r\n{}", viewer.lines());
        let head = format!("{head}Content-Length: {}\r\n\r\n", body.len());
        stream.write_all(&[head.as_bytes(), body.as_bytes()].concat()).expect("a request");
        let mut first = [0; 1];
        std::io::Read::read_exact(&mut stream, &mut first).expect("an answer");
        stream
    };
    let films = [begin(), begin()];
    assert_eq!(film(&viewer, &request(&keyframes, 2)).status, 503);
    // other pages get images meanwhile
    viewer.frame(&keyframes[0], "moving", &json!({})).ok();
    drop(films);
    let since = Instant::now();
    while film(&viewer, &request(&keyframes, 2)).status != 200 {
        assert!(since.elapsed() < Duration::from_secs(30), "films go on without their pages");
        thread::sleep(Duration::from_millis(20));
    }
}
