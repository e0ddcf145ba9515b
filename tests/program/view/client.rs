//! A running viewer, and a small HTTP client.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::process::{Child, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use image::RgbImage;
use serde_json::{Value, json};

use super::declared::assert_answer;
use crate::sandbox::Sandbox;

/// Serves a sandbox's scene.
pub const VIEW: &str = "view scene.safetensors cameras.json --port 0 --backend cpu";

/// A program that serves a page. It ends with the test.
pub struct Viewer {
    pub child: Child,
    /// Host and port: `127.0.0.1:port`
    pub host: String,
    /// The token of the page's address.
    pub token: String,
    /// The program's output after its address.
    said: Mutex<Receiver<String>>,
}

/// The answer of a server.
#[derive(Debug)]
pub struct Reply {
    pub status: u16,
    pub headers: String,
    pub body: Vec<u8>,
}

impl Viewer {
    /// Starts the program with some words, and waits until it prints the address of its page.
    pub fn start(sandbox: &Sandbox, words: &str) -> Self {
        let mut command = sandbox.command(words);
        let mut child =
            command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("it starts");
        let mut lines = BufReader::new(child.stderr.take().expect("piped")).lines();
        let mut before = String::new();
        let (host, token) = loop {
            let Some(Ok(line)) = lines.next() else { panic!("it has ended: {before}") };
            if let Some((_, rest)) = line.split_once("the page is at http://") {
                let url = rest.split_whitespace().next().expect("an address");
                let (host, token) = url.split_once("/?token=").expect("a token");
                break (host.to_owned(), token.to_owned());
            }
            before += &(line + "\n");
        };
        let (sender, said) = channel();
        thread::spawn(move || lines.map_while(Result::ok).try_for_each(|line| sender.send(line)));
        Self { child, host, token, said: Mutex::new(said) }
    }

    /// The lines that the program printed after its address, once it has ended.
    pub fn last_words(&self) -> Vec<String> {
        self.said.lock().expect("no thread has panicked").iter().collect()
    }

    /// The address of the page.
    pub fn url(&self) -> String {
        format!("http://{}/?token={}", self.host, self.token)
    }

    /// The lines of a request that say to whom it goes, and that it may.
    pub fn lines(&self) -> String {
        format!("Host: {}\r\n{}", self.host, self.cookie(&self.host))
    }

    /// The line with the cookie that a browser has for a host.
    fn cookie(&self, host: &str) -> String {
        let port = host.rsplit_once(':').map_or("80", |(_, port)| port);
        format!("Cookie: organza-token-{port}={}\r\n", self.token)
    }

    pub fn connect(&self) -> TcpStream {
        connect(&self.host).expect("it listens")
    }

    /// Sends bytes unchanged. Returns the bytes that come back until the server closes.
    pub fn send(&self, bytes: &[u8]) -> Vec<u8> {
        exchange(self.connect(), bytes)
    }

    pub fn get(&self, path: &str) -> Reply {
        self.ask(&format!("GET {path} HTTP/1.1\r\nHost: {}\r\n", self.host), b"")
    }

    pub fn post(&self, path: &str, value: &Value) -> Reply {
        let head = format!("POST {path} HTTP/1.1\r\nHost: {}\r\n", self.host);
        self.ask(&head, value.to_string().as_bytes())
    }

    /// Sends a request with a head, to which missing lines are added, and a body.
    pub fn ask(&self, head: &str, body: &[u8]) -> Reply {
        let mut stream = self.connect();
        let host = head.lines().find_map(|line| line.strip_prefix("Host: "));
        let head = format!("{head}{}", self.cookie(host.expect("a host")));
        let head = format!("{head}Connection: close\r\nContent-Length: {}\r\n\r\n", body.len());
        stream.write_all(&[head.as_bytes(), body].concat()).expect("a request");
        let mut back = Vec::new();
        stream.read_to_end(&mut back).expect("an answer");
        let reply = Reply::from_bytes(&back);
        if reply.status == 200 {
            let path = head.split(' ').nth(1).expect("a path");
            assert_answer(path, &reply.headers, &reply.body);
        }
        reply
    }

    pub fn scene(&self) -> Value {
        self.get("/scene.json").json()
    }

    /// Requests an image.
    pub fn frame(&self, camera: &Value, quality: &str, more: &Value) -> Reply {
        let mut request = json!({"client": 1, "sequence": 0, "camera": camera, "mode": "color", "quality": quality});
        let more = more.as_object().cloned().unwrap_or_default();
        request.as_object_mut().unwrap().extend(more);
        self.post("/frame", &request)
    }
}

/// Connects, if a server listens.
pub fn connect(host: &str) -> io::Result<TcpStream> {
    let stream = TcpStream::connect(host)?;
    stream.set_read_timeout(Some(Duration::from_secs(240)))?;
    Ok(stream)
}

/// Sends the head of a request, and returns the answer as text.
pub fn answer(host: &str, head: &str) -> String {
    let mut stream = connect(host).expect("it listens");
    write!(stream, "{head}Connection: close\r\n\r\n").expect("a request");
    io::read_to_string(stream).expect("an answer")
}

/// Like [`Viewer::send`].
pub fn exchange(mut stream: TcpStream, bytes: &[u8]) -> Vec<u8> {
    let mut back = Vec::new();
    // a server may close before it has read everything
    let _ = stream.write_all(bytes);
    let _ = stream.shutdown(Shutdown::Write);
    let _ = stream.read_to_end(&mut back);
    back
}

impl Drop for Viewer {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Reply {
    #[track_caller]
    fn from_bytes(bytes: &[u8]) -> Self {
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n");
        let end = end.unwrap_or_else(|| panic!("no head: {:?}", String::from_utf8_lossy(bytes)));
        let headers = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = headers.split(' ').nth(1).and_then(|status| status.parse().ok());
        Self { status: status.expect("a status"), headers, body: bytes[end + 4..].to_vec() }
    }

    #[track_caller]
    pub fn ok(self) -> Self {
        assert_eq!(self.status, 200, "{}: {}", self.headers, String::from_utf8_lossy(&self.body));
        self
    }

    #[track_caller]
    pub fn json(self) -> Value {
        serde_json::from_slice(&self.ok().body).expect("JSON")
    }

    /// The facts about an image.
    #[track_caller]
    pub fn about(&self) -> Value {
        let line = self.headers.lines().find_map(|line| line.strip_prefix("x-organza: "));
        serde_json::from_str(line.expect("a header")).expect("JSON")
    }
}

/// The pixels of an image. A file that the program wrote also says what it was made from.
pub fn pixels(png: &[u8]) -> RgbImage {
    image::load_from_memory(png).expect("an image").into_rgb8()
}
