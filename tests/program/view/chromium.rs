//! Chromium without a window, controlled by its DevTools protocol through two pipes.

use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use base64::Engine;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use tempfile::TempDir;

/// Names of the program in distributions.
const PROGRAMS: [&str; 4] =
    ["chromium", "chromium-headless-shell", "chromium-browser", "google-chrome"];

/// A browser with one page.
pub struct Page {
    child: Child,
    input: File,
    output: BufReader<File>,
    session: String,
    next: u64,
    /// Errors that the page has reported.
    pub errors: Vec<String>,
    _folder: TempDir,
}

/// Path of the browser; `None` if there is none, unless `ORGANZA_REQUIRE_BROWSER` requires it.
pub fn program() -> Option<&'static str> {
    let works = |name: &&str| {
        let output = Command::new(name).arg("--version").stderr(Stdio::null()).output();
        output.is_ok_and(|output| output.status.success())
    };
    let found = PROGRAMS.into_iter().find(works);
    if found.is_none() {
        let required = std::env::var_os("ORGANZA_REQUIRE_BROWSER").is_some();
        assert!(!required, "there is no Chromium, and ORGANZA_REQUIRE_BROWSER is set");
        println!("skipped: there is no Chromium");
    }
    found
}

impl Page {
    /// Opens an address in a window of this size.
    pub fn open(program: &str, url: &str, size: [u32; 2]) -> Self {
        Self::launch(program, url, size, &["--disable-gpu"])
    }

    /// Like [`Page::open`], but with WebGPU on the CPU.
    pub fn open_with_webgpu(program: &str, url: &str, size: [u32; 2]) -> Self {
        let adapter = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"];
        // for canvases
        let canvas =
            ["--enable-features=Vulkan", "--use-vulkan=swiftshader", "--use-angle=swiftshader"];
        Self::launch(program, url, size, &[&adapter[..], &canvas].concat())
    }

    fn launch(program: &str, url: &str, size: [u32; 2], flags: &[&str]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        let pipes = ["in", "out"].map(path);
        assert!(Command::new("mkfifo").args(&pipes).status().expect("mkfifo").success());
        let script = "exec \"$0\" \"$@\" 3<\"$IN\" 4>\"$OUT\"";
        let child = Command::new("sh")
            .args(["-c", script, program, "--headless", "--remote-debugging-pipe", "--no-sandbox"])
            .args(flags)
            .args(["--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars"])
            .args(["--force-color-profile=srgb", "--disable-background-networking"])
            // pages stand still unless a test asks otherwise
            .arg("--force-prefers-reduced-motion")
            .arg(format!("--user-data-dir={}", path("profile").display()))
            .env("IN", &pipes[0])
            .env("OUT", &pipes[1])
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("a shell");
        let input = OpenOptions::new().write(true).open(&pipes[0]).expect("a pipe");
        let output = BufReader::new(File::open(&pipes[1]).expect("a pipe"));
        let session = String::new();
        let errors = Vec::new();
        let mut page = Self { child, input, output, session, next: 0, errors, _folder: folder };
        let target = page.call("Target.createTarget", json!({"url": "about:blank"}));
        let target = json!({"targetId": target["targetId"], "flatten": true});
        let session = page.call("Target.attachToTarget", target);
        page.session = session["sessionId"].as_str().expect("a session").to_owned();
        page.call("Runtime.enable", json!({}));
        page.call("Page.enable", json!({}));
        page.resize(size);
        page.go(url);
        page
    }

    /// Navigates to another address.
    pub fn go(&mut self, url: &str) {
        self.call("Page.navigate", json!({ "url": url }));
        self.wait("document.readyState === 'complete' && (document.documentElement.dataset.ready !== undefined || document.scripts.length === 0) && location.href !== 'about:blank'");
    }

    pub fn resize(&mut self, [width, height]: [u32; 2]) {
        let metrics = json!({"width": width, "height": height, "deviceScaleFactor": 1,
            "mobile": false});
        self.call("Emulation.setDeviceMetricsOverride", metrics);
    }

    /// Calls a method, and waits for its result.
    pub fn call(&mut self, method: &str, params: Value) -> Value {
        self.next += 1;
        let mut message = json!({"id": self.next, "method": method, "params": params});
        if !self.session.is_empty() {
            message["sessionId"] = json!(self.session);
        }
        let bytes = [message.to_string().as_bytes(), b"\0"].concat();
        self.input.write_all(&bytes).expect("the browser listens");
        loop {
            let mut bytes = Vec::new();
            self.output.read_until(0, &mut bytes).expect("the browser answers");
            assert_eq!(bytes.pop(), Some(0), "the browser has ended");
            let message: Value = serde_json::from_slice(&bytes).expect("JSON");
            if message["method"] == "Runtime.exceptionThrown" {
                self.errors.push(message["params"]["exceptionDetails"].to_string());
            }
            if message["id"] == self.next {
                assert!(message["error"].is_null(), "{method}: {}", message["error"]);
                return message["result"].clone();
            }
        }
    }

    /// The value of an expression. A promise is awaited.
    #[track_caller]
    pub fn eval(&mut self, expression: &str) -> Value {
        let params = json!({"expression": expression, "awaitPromise": true, "returnByValue": true});
        let result = self.call("Runtime.evaluate", params);
        assert!(result["exceptionDetails"].is_null(), "{expression}: {result}");
        result["result"]["value"].clone()
    }

    /// The value of an expression, of a type.
    #[track_caller]
    pub fn value<T: DeserializeOwned>(&mut self, expression: &str) -> T {
        serde_json::from_value(self.eval(expression)).expect(expression)
    }

    /// Waits until an expression is true.
    #[track_caller]
    pub fn wait(&mut self, expression: &str) {
        let begin = Instant::now();
        while self.eval(&format!("Boolean({expression})")) != json!(true) {
            let seconds = begin.elapsed().as_secs();
            assert!(seconds < 240, "{expression} is never true; {:?}", self.errors);
            thread::sleep(Duration::from_millis(15));
        }
    }

    /// Sends a mouse event.
    pub fn mouse(&mut self, kind: &str, [x, y]: [f64; 2]) {
        let held = u32::from(kind != "mouseReleased" && kind != "mouseWheel");
        let mut event = json!({"type": kind, "x": x, "y": y, "button": "left", "buttons": held,
            "clickCount": 1});
        if kind == "mouseWheel" {
            event["deltaX"] = json!(0);
            event["deltaY"] = json!(-120);
        }
        self.call("Input.dispatchMouseEvent", event);
    }

    pub fn drag(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.mouse("mousePressed", from);
        for step in 1..=8 {
            let part = f64::from(step) / 8.0;
            self.mouse(
                "mouseMoved",
                [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis])),
            );
        }
        self.mouse("mouseReleased", to);
    }

    pub fn click(&mut self, at: [f64; 2]) {
        self.mouse("mousePressed", at);
        self.mouse("mouseReleased", at);
    }

    pub fn key(&mut self, key: &str) {
        for kind in ["keyDown", "keyUp"] {
            self.call("Input.dispatchKeyEvent", json!({"type": kind, "key": key, "text": key}));
        }
    }

    /// Presses or releases a letter's key.
    pub fn letter(&mut self, kind: &str, letter: char) {
        let code = format!("Key{}", letter.to_ascii_uppercase());
        let event = json!({"type": kind, "code": code, "key": letter, "text": letter});
        self.call("Input.dispatchKeyEvent", event);
    }

    /// Touches the page with fingers, moves them in equal steps, and lifts them. Each finger has a start and an end.
    pub fn fingers(&mut self, ways: &[[[f64; 2]; 2]]) {
        let places = |part: f64| -> Vec<Value> {
            let way = |(id, [from, to]): (usize, &[[f64; 2]; 2])| {
                let [x, y] = [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
                json!({"x": x, "y": y, "id": id})
            };
            ways.iter().enumerate().map(way).collect()
        };
        let events = (0..=8).map(|step| {
            let kind = if step == 0 { "touchStart" } else { "touchMove" };
            json!({"type": kind, "touchPoints": places(f64::from(step) / 8.0)})
        });
        for event in events.chain([json!({"type": "touchEnd", "touchPoints": []})]) {
            self.call("Input.dispatchTouchEvent", event);
        }
    }

    /// Takes a screenshot for people, if `ORGANZA_SCREENSHOTS` names a folder.
    pub fn screenshot(&mut self, name: &str) {
        let Some(folder) = std::env::var_os("ORGANZA_SCREENSHOTS") else { return };
        let picture = self.call("Page.captureScreenshot", json!({"format": "png"}));
        let bytes = base64(picture["data"].as_str().expect("a picture"));
        std::fs::write(Path::new(&folder).join(format!("{name}.png")), bytes).expect("a file");
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Decodes base64.
pub fn base64(text: &str) -> Vec<u8> {
    base64::engine::general_purpose::STANDARD.decode(text).expect("base64")
}
