//! Foreign, broken, slow, numerous and vanishing clients; occupied ports; signals.

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream, UdpSocket};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::json;

use super::client::{VIEW, Viewer, answer, pixels};
use crate::sandbox::Sandbox;
use crate::train::processes::{signal, wait_for_end};

#[test]
fn pages_of_others_are_refused() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, VIEW);
    let status = |head: &str| viewer.ask(head, b"").status;
    let host = &viewer.host;
    let port = host.split(':').nth(1).unwrap();
    let local = format!("localhost.example.com:{port}");
    for name in ["localhost", "localhost:1", "127.0.0.1:9", "[::1]:1", "[::1]"] {
        let head = format!("GET /?token={} HTTP/1.1\r\nHost: {name}\r\n", viewer.token);
        assert_eq!(status(&head), 200, "{name}");
        assert_eq!(status(&format!("{head}Origin: http://{name}\r\n")), 200, "{name}");
    }
    for path in ["/", "/scene.json", "/main.js", "/points"] {
        assert_eq!(status(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n")), 200, "{path}");
        assert_eq!(status(&format!("GET {path} HTTP/1.1\r\nHost: localhost:1\r\n")), 200, "{path}");
        let same = format!("Host: {host}\r\nOrigin: http://{host}\r\n");
        assert_eq!(status(&format!("GET {path} HTTP/1.1\r\n{same}")), 200, "{path}");
        let evil = format!("evil.example:{port}");
        for foreign in ["evil.example", &evil, &local, "127.0.0.1.example.com", ""] {
            let head = format!("GET {path} HTTP/1.1\r\nHost: {foreign}\r\n");
            assert_eq!(status(&head), 403, "{path} for {foreign}");
        }
        let other = format!("http://localhost:{port}");
        for origin in ["http://evil.example", "null", &other, "http://127.0.0.1:1", host, "\u{e9}"]
        {
            let head = format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nOrigin: {origin}\r\n");
            assert_eq!(status(&head), 403, "{path} from {origin}");
        }
    }
    let page = viewer.get("/").ok();
    assert!(page.headers.contains("content-security-policy: default-src 'self'"));
    let text = String::from_utf8(page.body).expect("text");
    assert!(!text.contains("http://") && !text.contains("https://"), "nothing from elsewhere");
    assert_eq!(viewer.get("/../scene.safetensors").status, 404);
    assert_eq!(viewer.get("/training.json").status, 404);
}

#[test]
fn every_address_needs_a_token() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, VIEW);
    // another user of this machine, and a client that names no host
    let page = format!("/?token={}", viewer.token);
    let named = format!("Host: {}\r\n", viewer.host);
    for (path, lines) in [("/scene.json", &*named), (&*page, "")] {
        // no `send`: the server need not answer a client that has closed its side
        let answer = answer(&viewer.host, &format!("GET {path} HTTP/1.1\r\n{lines}"));
        assert!(answer.starts_with("HTTP/1.1 403"), "{answer:?}");
    }
    let mut viewer = Viewer::start(&sandbox, &format!("{VIEW} --bind 0.0.0.0"));
    let port = viewer.host.strip_prefix("0.0.0.0:").expect("an address");
    let token = &*viewer.token;
    let answer = |path: &str, more: &str| {
        let head = format!("GET {path} HTTP/1.1\r\nHost: machine:{port}\r\n{more}");
        answer(&format!("127.0.0.1:{port}"), &head)
    };
    assert_eq!(token.len(), 32);
    for query in ["", "?token=", "?token=0", &format!("?token={}", &token[..31]), "?a=b"] {
        let answer = answer(&format!("/{query}"), "");
        assert!(answer.starts_with("HTTP/1.1 403"), "{query}: {answer}");
    }
    let given = answer(&format!("/?a=b&token={token}"), "");
    assert!(given.starts_with("HTTP/1.1 200"), "{given}");
    let cookie = format!("set-cookie: organza-token-{port}={token}; HttpOnly; SameSite=Strict;");
    assert!(given.contains(&cookie), "{given}");
    let cookie = |port: &str, token: &str| format!("Cookie: x=y; organza-token-{port}={token}\r\n");
    let foreign = cookie(port, token) + "Origin: http://evil.example\r\n";
    for (lines, status) in [
        (cookie(port, "0"), 403),
        (cookie("1", token), 403),
        (foreign, 403),
        (cookie(port, token), 200),
    ] {
        let answer = answer("/scene.json", &lines);
        assert!(answer.starts_with(&format!("HTTP/1.1 {status}")), "{lines}: {answer}");
    }
    signal(&viewer.child, "INT");
    wait_for_end(&mut viewer.child);
}

#[test]
fn garbage_ends_only_its_connection() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, VIEW);
    let host = &viewer.host;
    let mut noise: Vec<u8> = Vec::new();
    let mut state = 1_u32;
    for _ in 0..200_000 {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        noise.push((state >> 24) as u8);
    }
    let lines = viewer.lines();
    let long = format!("GET /{} HTTP/1.1\r\n{lines}\r\n", "a".repeat(300_000));
    let many = format!("GET / HTTP/1.1\r\n{lines}{}\r\n", "a: b\r\n".repeat(50_000));
    let short = format!("POST /frame HTTP/1.1\r\n{lines}Content-Length: 500\r\n\r\n{{");
    let broken: [&[u8]; 7] = [
        b"",
        b"\0\0\0\0",
        &noise,
        long.as_bytes(),
        many.as_bytes(),
        short.as_bytes(),
        b"GET / HTTP/9.9\r\n\r\n",
    ];
    for bytes in broken {
        let back = viewer.send(bytes);
        let back = String::from_utf8_lossy(&back[..back.len().min(30)]).into_owned();
        assert!(!back.starts_with("HTTP/1.1 2") && !back.starts_with("HTTP/1.1 5"), "{back}");
    }
    // invalid requests
    let camera = viewer.scene()["views"][0]["camera"].clone();
    let edit = |name: &str, value: serde_json::Value| {
        let mut camera = camera.clone();
        camera[name] = value;
        viewer.frame(&camera, "moving", &json!({})).status
    };
    for (name, value) in [
        ("w", json!(0)),
        ("w", json!(-1)),
        ("h", json!(100_000)),
        ("w", json!(60_000)),
        ("fl_x", json!(0.0)),
        ("fl_y", json!(1e300)),
        ("cx", json!(null)),
        ("camera_to_world", json!(vec![[1.0; 4]; 4])),
        ("camera_to_world", json!([])),
        ("unknown", json!(1)),
    ] {
        assert_eq!(edit(name, value.clone()), 400, "{name} {value}");
    }
    let large = vec![b' '; 5 << 20];
    let head = format!("POST /frame HTTP/1.1\r\n{lines}");
    let mut stream = viewer.connect();
    let head = format!("{head}Connection: close\r\nContent-Length: {}\r\n\r\n", large.len());
    let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(&large));
    let mut back = [0; 12];
    if stream.read_exact(&mut back).is_ok() {
        assert_eq!(&back, b"HTTP/1.1 400");
    }
    for (method, path, status) in
        [("DELETE", "/", 405), ("POST", "/nothing", 405), ("GET", "/nothing", 404)]
    {
        let found = viewer.ask(&format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\n"), b"");
        assert_eq!(found.status, status, "{method} {path}");
    }
    viewer.frame(&camera, "exact", &json!({})).ok();
}

/// Each client moves through all views, and rests at the last one.
#[test]
fn ten_clients_get_their_images_while_others_are_slow_or_gone() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run("render scene.safetensors cameras.json -o images --backend cpu").assert_ok();
    let viewer = Viewer::start(&sandbox, VIEW);
    let scene = viewer.scene();
    let views = scene["views"].as_array().expect("views");
    let request = |client: u64, camera: &serde_json::Value, quality: &str| {
        let mut camera = camera.clone();
        camera["w"] = json!(1500);
        camera["h"] = json!(1500);
        let body = json!({"client": client, "sequence": 0, "camera": camera, "mode": "color",
            "quality": quality})
        .to_string();
        let lines = viewer.lines();
        let length = body.len();
        format!("POST /frame HTTP/1.1\r\n{lines}Content-Length: {length}\r\n\r\n{body}")
    };
    // one client requests megabytes and never reads, one goes away before its image is done, one never finishes its
    // request
    let mut slow = viewer.connect();
    slow.write_all(request(100, &views[0]["camera"], "exact").as_bytes()).unwrap();
    let mut gone = viewer.connect();
    gone.write_all(request(101, &views[0]["camera"], "exact").as_bytes()).unwrap();
    drop(gone);
    let mut half = viewer.connect();
    half.write_all(b"POST /frame HTTP/1.1\r\nHost: ").unwrap();
    let last = views.len() - 1;
    let images = thread::scope(|scope| {
        let clients = (0..10).map(|client| {
            let viewer = &viewer;
            let views = &views;
            scope.spawn(move || {
                for (sequence, view) in views.iter().enumerate() {
                    let more = json!({"client": client, "sequence": sequence});
                    viewer.frame(&view["camera"], "moving", &more).ok();
                }
                let more = json!({"client": client, "sequence": views.len()});
                viewer.frame(&views[last]["camera"], "exact", &more).ok().body
            })
        });
        let clients: Vec<_> = clients.collect();
        clients.into_iter().map(|client| client.join().expect("an image")).collect::<Vec<_>>()
    });
    let expected = sandbox.read(&format!("images/{last:04}.png"));
    let expected = pixels(&expected);
    assert!(images.iter().all(|image| pixels(image) == expected));
}

/// The latest camera wins.
#[test]
fn replaced_images_are_dropped() {
    let sandbox = Sandbox::new("crowded");
    let viewer = Viewer::start(&sandbox, VIEW);
    let mut camera = viewer.scene()["views"][0]["camera"].clone();
    camera["w"] = json!(4000);
    camera["h"] = json!(4000);
    thread::scope(|scope| {
        // the first is painted, the second waits, and the third replaces it
        let ask = |sequence: u64| {
            let viewer = &viewer;
            let camera = &camera;
            let ask = move || viewer.frame(camera, "exact", &json!({ "sequence": sequence }));
            let asked = scope.spawn(ask);
            thread::sleep(Duration::from_millis(30));
            asked
        };
        let [_, second, third] = [1, 2, 3].map(ask);
        assert_eq!(second.join().unwrap().status, 409);
        third.join().unwrap().ok();
        // a request that arrives after a newer one
        assert_eq!(ask(1).join().unwrap().status, 409);
    });
}

#[test]
fn a_port_that_is_taken_is_named() {
    let sandbox = Sandbox::new("tiny");
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port();
    let words = format!("view scene.safetensors --backend cpu --port {port}");
    sandbox.assert_refuses(&words, &["is taken", &port.to_string(), "--port"]);
    let words = format!("train --backend cpu -o run --view --port {port}");
    sandbox.assert_refuses(&words, &["is taken"]);
    sandbox.assert_refuses("train -o run --port 5", &["--view"]);
    sandbox.assert_refuses("view scene.safetensors --bind 192.0.2.1", &["cannot listen"]);
    sandbox.assert_refuses("view scene.safetensors --split train", &["no data set"]);
}

#[test]
fn a_signal_ends_it_at_once_and_well() {
    let sandbox = Sandbox::new("tiny");
    for name in ["INT", "TERM"] {
        let mut viewer = Viewer::start(&sandbox, VIEW);
        // a client is in the middle of a request
        let mut stream = viewer.connect();
        stream.write_all(b"GET / HTTP/1.1\r\n").unwrap();
        let begin = Instant::now();
        signal(&viewer.child, name);
        assert_eq!(wait_for_end(&mut viewer.child), Some(0), "SIG{name}");
        // the request may take 20 seconds to arrive
        assert!(begin.elapsed() < Duration::from_secs(15));
        let said = viewer.last_words();
        assert!(said.is_empty(), "{said:?}");
    }
}

/// Clients without the token make room for one that has it, from another address or from its own.
#[test]
fn clients_without_the_token_make_room() {
    let sandbox = Sandbox::new("tiny");
    let viewer = Viewer::start(&sandbox, &format!("{VIEW} --bind 0.0.0.0"));
    let port: u16 = viewer.host.rsplit_once(':').expect("a port").1.parse().expect("a number");
    // another address of this machine; connecting a UDP socket sends nothing
    let other = UdpSocket::bind("0.0.0.0:0").and_then(|socket| {
        socket.connect("192.0.2.1:9")?;
        Ok(socket.local_addr()?.ip())
    });
    let Ok(other) = other else { return println!("skipped: this machine has no other address") };
    let own: std::net::IpAddr = [127, 0, 0, 1].into();
    let connect = |peer| TcpStream::connect((peer, port)).expect("the system accepts it");
    let greedy: Vec<_> = (0..300).flat_map(|_| [other, own].map(connect)).collect();
    thread::sleep(Duration::from_millis(300));
    let head = format!("GET /scene.json HTTP/1.1\r\n{}", viewer.lines());
    let back = answer(&format!("127.0.0.1:{port}"), &head);
    assert!(back.starts_with("HTTP/1.1 200"), "{back}");
    drop(greedy);
}

/// Pages change a scene only if the program was told where to save it. Nothing is replaced, and no request names a file.
#[test]
fn a_scene_is_edited_only_where_that_is_allowed() {
    let sandbox = Sandbox::new("basic");
    let viewer = Viewer::start(&sandbox, VIEW);
    let refused = viewer.post("/edit", &json!("undo"));
    assert_eq!((refused.status, viewer.scene()["purpose"].as_str()), (422, Some("look")));
    drop(viewer);
    sandbox.assert_refuses(&format!("{VIEW} --edit scene.safetensors"), &["exists", "replaces"]);
    sandbox.assert_refuses(&format!("{VIEW} --edit no/cut.safetensors"), &["no/cut.safetensors"]);

    let viewer = Viewer::start(&sandbox, &format!("{VIEW} --edit cut.safetensors"));
    assert_eq!(viewer.scene()["purpose"], "edit");
    let all = viewer.post("/edit", &json!("look")).json()["left"].as_u64().unwrap();
    let camera = viewer.scene()["home"].clone();
    let paint = |radius: f64| json!({"paint": {"camera": camera, "places": [[1.0, 2.0]], "radius": radius}});
    let everything =
        json!({"crop": {"low": [-1e9, -1e9, -1e9], "high": [1e9, 1e9, 1e9], "outside": false}});
    let mut long = paint(1.0);
    long["paint"]["places"] = json!(vec![[1.0, 2.0]; 1001]);
    for (request, status) in [
        (json!({"save": "/tmp/other.safetensors"}), 400),
        (json!("format"), 400),
        (json!({"paint": {"camera": camera, "places": [[null]], "radius": 1}}), 400),
        (json!({"meters": 0}), 422),
        (paint(-1.0), 422),
        (paint(1e9), 422),
        (long, 422),
        (everything, 422),
        (paint(9.0), 200),
        (json!("undo"), 200),
    ] {
        assert_eq!(viewer.post("/edit", &request).status, status, "{request}");
    }
    assert_eq!(viewer.post("/edit", &json!("look")).json()["left"], all);
    // every save is a file of its own
    let saved = |viewer: &Viewer| viewer.post("/edit", &json!("save")).json()["saved"].clone();
    assert_eq!(saved(&viewer), "cut.safetensors");
    std::os::unix::fs::symlink("/dev/null", sandbox.path("cut-2.safetensors")).unwrap();
    assert_eq!(saved(&viewer), "cut-3.safetensors");
    assert_eq!(sandbox.read("cut.safetensors"), sandbox.read("cut-3.safetensors"));
}

/// Places that are asked for are checked, and none but the last good one is shown.
#[test]
fn places_of_scenes_are_checked() {
    let sandbox = Sandbox::new("tiny");
    let alone = Viewer::start(&sandbox, VIEW);
    assert_eq!(alone.post("/places", &json!({"scene": 1, "place": {}})).status, 422);
    assert_eq!(alone.post("/places", &json!(null)).json(), json!([]));
    drop(alone);
    sandbox.copy_file("scene.safetensors", "b.safetensors");
    sandbox.write("b.json", "{}");
    let words = "view scene.safetensors b.safetensors@b.json cameras.json --port 0 --backend cpu";
    let viewer = Viewer::start(&sandbox, words);
    assert_eq!(viewer.scene()["scenes"], 2);
    let camera = viewer.scene()["home"].clone();
    let exact = || pixels(&viewer.frame(&camera, "exact", &json!({})).ok().body);
    let before = exact();
    for (request, status) in [
        (json!({"scene": 0, "place": {}}), 422),
        (json!({"scene": 2, "place": {}}), 422),
        (json!({"scene": 1, "place": {"scale": 0}}), 422),
        (json!({"scene": 1, "place": {"offset": [1e300, 0, 0]}}), 422),
        (json!({"scene": 1, "place": {"size": 2}}), 400),
        (json!({"scene": 0}), 400),
    ] {
        assert_eq!(viewer.post("/places", &request).status, status, "{request}");
    }
    assert!(exact() == before);
    let place = json!({"offset": [0.1, 0.0, 0.2], "turn": [0.0, 0.0, 90.0], "scale": 0.5});
    let told = viewer.post("/places", &json!({"scene": 1, "place": place})).json();
    assert_eq!((&told[0]["name"], &told[0]["place"]), (&json!("b.safetensors"), &place));
    assert!(exact() != before);
    viewer.post("/places", &json!({"scene": 1, "place": {}})).ok();
    assert!(exact() == before);
}

/// The page's slider: it looks at view after view, hides, undoes, and keeps what `organza edit` keeps, to the bit.
#[test]
fn floaters_are_hidden_and_removed_as_by_the_command() {
    let sandbox = Sandbox::new("tiny");
    // 24 views of 64 x 64 pixels take two minutes
    let all = crate::edit::plant_floaters(&sandbox, 8, 32).len();
    let words = "edit planted.safetensors demo --clean 0.5 -o edited.safetensors --backend cpu";
    sandbox.run(words).assert_ok();
    let read = |name: &str| sandbox.read(name);
    assert!(read("edited.safetensors").len() < read("planted.safetensors").len(), "none has gone");
    let view = "view planted.safetensors --port 0 --backend cpu --edit alone.safetensors";
    let viewer = Viewer::start(&sandbox, view);
    assert_eq!(viewer.post("/edit", &json!({"clean": 0.5})).status, 422, "without views");
    let words = "view planted.safetensors demo --port 0 --backend cpu --edit cleaned.safetensors";
    let viewer = Viewer::start(&sandbox, words);
    let ask = |request: serde_json::Value| viewer.post("/edit", &request).json();
    for (request, status) in [(json!({"clean": 1.5}), 422), (json!({"clean": "all"}), 400)] {
        assert_eq!(viewer.post("/edit", &request).status, status, "{request}");
    }
    let mut answer = ask(json!({"clean": 0.9}));
    while answer["clean"]["seen"] != answer["clean"]["views"] {
        assert_eq!(answer["clean"]["hidden"], 0, "{answer}");
        answer = ask(json!({"clean": 0.9}));
    }
    let many = answer["clean"]["hidden"].as_u64();
    assert!(answer["clean"]["weight"].as_f64() > Some(0.0), "{answer}");
    answer = ask(json!("undo"));
    assert_eq!((answer["left"].as_u64(), answer["removals"].as_u64()), (Some(all as u64), Some(0)));
    answer = ask(json!({"clean": 0.5}));
    assert!(answer["clean"]["hidden"].as_u64() < many, "{answer}");
    answer = ask(json!("keep"));
    assert_eq!((&answer["clean"]["hidden"], &answer["removals"]), (&json!(0), &json!(1)));
    ask(json!("save"));
    assert!(read("cleaned.safetensors") == read("edited.safetensors"), "another scene");
}
