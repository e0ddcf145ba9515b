//! Makes the film of a path while the page waits. Its frames are exact images that wait in the queue like all others,
//! so users who look around go first.
//!
//! The answer has a line of JSON for each frame, then a line with the film's length in bytes, then the film. If the
//! page goes away, the work ends.

use std::fs::{self, File};
use std::io::Read;
use std::path::PathBuf;
use std::sync::Arc;

use http_body_util::channel::Sender;
use hyper::body::Bytes;
use serde::Deserialize;
use serde_json::{Value, json};
use tokio::sync::oneshot;

use super::keyframes::PathRequest;
use super::message::{FrameRequest, Mode, Quality, checked_background};
use super::queue::{FrameJob, Queue};
use crate::film::{FilmKind, Frames};
use organza_core::camera::Camera;
use organza_core::error::{self, Result, refuse};

/// Largest frame rate, in frames per second.
const MAX_FPS: u32 = 240;
/// Bytes of a film that are sent at a time.
const PART: u64 = 256 << 10;

/// A request for a film.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FilmRequest {
    path: PathRequest,
    kind: FilmKind,
    fps: u32,
    mode: Mode,
    #[serde(default)]
    background: Option<[f64; 3]>,
}

impl FilmRequest {
    /// The camera of each frame, after everything else was checked.
    pub fn check(&self) -> Result<Vec<Camera>> {
        if !(1..=MAX_FPS).contains(&self.fps) {
            return refuse(format!("a film has 1 to {MAX_FPS} frames a second"));
        }
        if self.kind == FilmKind::Frames {
            return refuse("a film is an `mp4` or a `png`");
        }
        if self.mode == Mode::Error {
            return refuse("a film has no photographs to compare with");
        }
        checked_background(self.background)?;
        let cameras = self.path.cameras(self.kind == FilmKind::Mp4)?;
        let Some(first) = cameras.first() else { return refuse("a film has frames") };
        self.kind.check([first.width, first.height])?;
        Ok(cameras)
    }
}

/// Why a film ends early: an error for the page, or the page is gone.
enum End {
    Error(String),
    Gone,
}

impl From<error::Error> for End {
    fn from(error: error::Error) -> Self {
        Self::Error(error::chain(&error))
    }
}

/// Makes a film and sends it.
pub async fn make(
    queue: &Queue,
    request: &FilmRequest,
    cameras: Vec<Camera>,
    mut sender: Sender<Bytes>,
) {
    if let Err(End::Error(reason)) = send(queue, request, cameras, &mut sender).await {
        let _ = say(&mut sender, &json!({ "error": reason })).await;
    }
}

async fn send(
    queue: &Queue,
    request: &FilmRequest,
    cameras: Vec<Camera>,
    sender: &mut Sender<Bytes>,
) -> Result<(), End> {
    let folder = Arc::new(tempfile::tempdir().map_err(failed)?);
    let mut files = Vec::with_capacity(cameras.len());
    // larger than any page's number
    let client = (1 << 32) + u64::from(rand::random::<u32>());
    let all = cameras.len();
    for (frame, camera) in cameras.into_iter().enumerate() {
        say(sender, &json!({ "frame": frame, "frames": all })).await?;
        let bytes = render(queue, request, client, frame, camera).await?;
        let file = folder.path().join(format!("{frame:05}.png"));
        fs::write(&file, bytes).map_err(failed)?;
        files.push(file);
    }
    say(sender, &json!({ "frame": all, "frames": all })).await?;
    let film = encode(request, files, Arc::clone(&folder)).await?;
    let mut film = File::open(film).map_err(failed)?;
    let size = film.metadata().map_err(failed)?.len();
    say(sender, &json!({ "bytes": size })).await?;
    loop {
        let mut part = Vec::new();
        film.by_ref().take(PART).read_to_end(&mut part).map_err(failed)?;
        if part.is_empty() {
            return Ok(());
        }
        sender.send_data(part.into()).await.map_err(|_| End::Gone)?;
    }
}

fn failed(error: std::io::Error) -> End {
    End::Error(format!("the film cannot be written: {error}"))
}

async fn say(sender: &mut Sender<Bytes>, line: &Value) -> Result<(), End> {
    sender.send_data(format!("{line}\n").into()).await.map_err(|_| End::Gone)
}

/// Renders one frame like `organza render`.
async fn render(
    queue: &Queue,
    request: &FilmRequest,
    client: u64,
    frame: usize,
    camera: Camera,
) -> Result<Vec<u8>, End> {
    let (reply, answer) = oneshot::channel();
    let request = FrameRequest {
        client,
        sequence: frame as u64,
        camera,
        mode: request.mode,
        quality: Quality::Exact,
        background: request.background,
        view: None,
    };
    queue.post(Box::new(FrameJob { request, reply }));
    match answer.await {
        Ok(Ok(rendered)) => Ok(rendered.bytes),
        Ok(Err(reason)) => Err(End::Error(reason)),
        Err(_) => Err(End::Error("too many pages are open".to_owned())),
    }
}

/// Encodes the film on its own thread: the server has only one, and others wait for their images.
async fn encode(
    request: &FilmRequest,
    files: Vec<PathBuf>,
    folder: Arc<tempfile::TempDir>,
) -> Result<PathBuf, End> {
    let kind = request.kind;
    let fps = request.fps;
    let work = move || {
        let film = folder.path().join("film");
        let frames = Frames { files: &files, fps, scratch: folder.path(), progress: &|| {} };
        kind.write(&frames, &film).map(|()| film)
    };
    match tokio::task::spawn_blocking(work).await {
        Ok(film) => Ok(film?),
        Err(error) => Err(End::Error(error.to_string())),
    }
}
