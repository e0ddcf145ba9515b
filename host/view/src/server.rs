//! The HTTP server: delivers the page, which is plain modules, and puts its requests in the queue.

use std::convert::Infallible;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::Duration;
use std::{io, thread};

use http_body_util::{BodyExt, Full, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::header::{CONTENT_TYPE, HeaderName, HeaderValue, SET_COOKIE};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, Response, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use serde::de::DeserializeOwned;
use tokio::net::TcpStream;
use tokio::sync::oneshot;
use tokio_io_timeout::TimeoutStream;

use super::about::About;
use super::connections::{Connections, Place};
use super::guard::{Access, Guard};
use super::keyframes::{self, PathRequest};
use super::message::{FrameRequest, PixelRequest, check};
use super::queue::{Answer, FrameJob, Payload, Question, Queue};
use super::training_status::TrainingStatus;
use organza_core::Camera;
use organza_core::error::{self, Error, Result};
use organza_report::{UPLOT_SCRIPT, UPLOT_STYLE};

/// Largest request, in bytes: 1,000 keyframes. Parsed, it can take a hundred times as much.
const MAX_BODY: usize = 1 << 19;
/// Longest time until a request has arrived, and until a client takes a part of an answer.
const PATIENCE: Duration = Duration::from_secs(20);

/// A server that listens, on its own thread, until the program ends.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    guard: Guard,
}

struct Viewer {
    guard: Guard,
    queue: Arc<Queue>,
    about: About,
    training_status: Option<Arc<TrainingStatus>>,
}

impl Viewer {
    fn training(&self) -> Result<&TrainingStatus, Refusal> {
        let reason = || Refusal(StatusCode::NOT_FOUND, "nothing is being trained".to_owned());
        self.training_status.as_deref().ok_or_else(reason)
    }
}

impl Server {
    /// Default port.
    pub const PORT: u16 = 4747;

    /// Opens a port, without answering yet: the default one or a free one, if `port` names none. Without an address of this
    /// machine in `bind`, only this machine is served.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the port is taken, or the address is not one of this machine.
    pub fn listen(bind: Option<IpAddr>, port: Option<u16>) -> Result<Self> {
        let ip = bind.unwrap_or(IpAddr::V4(Ipv4Addr::LOCALHOST));
        let listen = |port| TcpListener::bind(SocketAddr::new(ip, port));
        let (port, listener) = match port {
            Some(port) => (port, listen(port)),
            None => (Self::PORT, listen(Self::PORT).or_else(|_| listen(0))),
        };
        let listener = listener.map_err(|error| {
            let reason = match error.kind() {
                io::ErrorKind::AddrInUse => format!(
                    "port {port} of {ip} is taken by another program; choose another with `--port`, or 0 for \
                     one that is free"
                ),
                _ => format!("cannot listen at port {port} of {ip}: {error}"),
            };
            Error::Invalid { origin: "".into(), reason }
        })?;
        let found = listener.local_addr().map_err(broken)?;
        Ok(Self { listener, guard: Guard::new(found) })
    }

    /// The port at which the server listens.
    pub fn port(&self) -> u16 {
        self.listener.local_addr().map_or(0, |address| address.port())
    }

    /// Address of the page, including the token.
    pub fn url(&self) -> String {
        let address = self.listener.local_addr().map(|address| address.to_string());
        let address = address.unwrap_or_default();
        format!("http://{address}/?token={}", self.guard.token)
    }

    /// Starts to answer requests.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the system cannot start a thread.
    pub fn start(
        self,
        queue: Arc<Queue>,
        about: About,
        training_status: Option<Arc<TrainingStatus>>,
    ) -> Result<()> {
        let Self { listener, guard } = self;
        listener.set_nonblocking(true).map_err(broken)?;
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let runtime = runtime.map_err(broken)?;
        let viewer = Arc::new(Viewer { guard, queue, about, training_status });
        let serve = move || runtime.block_on(accept(listener, viewer));
        thread::Builder::new().name("viewer".to_owned()).spawn(serve).map_err(broken)?;
        Ok(())
    }
}

fn broken(error: io::Error) -> Error {
    Error::Invalid { origin: "".into(), reason: format!("the viewer cannot be served: {error}") }
}

async fn accept(listener: TcpListener, viewer: Arc<Viewer>) {
    let Ok(listener) = tokio::net::TcpListener::from_std(listener) else { return };
    let connections = Arc::new(Connections::default());
    loop {
        let Ok((stream, peer)) = listener.accept().await else {
            // for example, after too many open files
            tokio::time::sleep(Duration::from_millis(100)).await;
            continue;
        };
        let viewer = Arc::clone(&viewer);
        connections.admit(peer.ip(), |place| {
            tokio::spawn(connection(stream, viewer, Arc::new(place))).abort_handle()
        });
    }
}

/// Answers the requests of one client.
async fn connection(stream: TcpStream, viewer: Arc<Viewer>, place: Arc<Place>) {
    let _ = stream.set_nodelay(true);
    // a client that reads nothing would keep its place for ever
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(PATIENCE));
    let answer = |request| {
        let viewer = Arc::clone(&viewer);
        let place = Arc::clone(&place);
        async move { Ok::<_, Infallible>(answer(&viewer, &place, request).await) }
    };
    // a client's mistake only ends its own connection
    let _ = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(PATIENCE)
        .max_buf_size(64 << 10)
        .serve_connection(TokioIo::new(Box::pin(stream)), service_fn(answer))
        .await;
}

type Reply = Response<Full<Bytes>>;

/// Status and reason of a refused request.
struct Refusal(StatusCode, String);

async fn answer(viewer: &Viewer, place: &Place, request: Request<Incoming>) -> Reply {
    let cookie = match viewer.guard.judge(request.headers(), request.uri().query()) {
        Access::Allowed { cookie } => {
            place.keep();
            cookie
        }
        Access::Refused(reason) => {
            return text(StatusCode::FORBIDDEN, "text/plain; charset=utf-8", reason.as_bytes());
        }
    };
    let mut reply = route(viewer, request).await.unwrap_or_else(|Refusal(status, reason)| {
        let reason = serde_json::json!({ "error": reason }).to_string();
        text(status, "application/json", reason.as_bytes())
    });
    if let Some(cookie) = cookie.and_then(|cookie| cookie.parse().ok()) {
        reply.headers_mut().insert(SET_COOKIE, cookie);
    }
    reply
}

async fn route(viewer: &Viewer, request: Request<Incoming>) -> Result<Reply, Refusal> {
    let method = request.method().clone();
    let path = request.uri().path().to_owned();
    let json = |bytes: &[u8]| Ok(text(StatusCode::OK, "application/json", bytes));
    match (&method, path.as_str()) {
        (&Method::GET, "/scene.json") => json(viewer.about.json.as_bytes()),
        (&Method::GET, "/points") => {
            Ok(text(StatusCode::OK, "application/octet-stream", &viewer.about.points))
        }
        (&Method::GET, "/training.json") => json(viewer.training()?.to_json().as_bytes()),
        (&Method::POST, "/training") => {
            viewer.training()?.command(body(request).await?);
            json(b"{}")
        }
        (&Method::POST, "/frame") => {
            let request: FrameRequest = body(request).await?;
            request.check().map_err(refused)?;
            let (reply, answer) = oneshot::channel();
            viewer.queue.post(Box::new(FrameJob { request, reply }));
            rendered(answer).await
        }
        (&Method::POST, "/explain") => {
            let request: PixelRequest = body(request).await?;
            check(&request.camera).map_err(refused)?;
            ask(viewer, Question::Pixel(request.pixel, Box::new(request.camera))).await
        }
        (&Method::POST, "/edit") => ask(viewer, Question::Edit(body(request).await?)).await,
        (&Method::POST, "/places") => ask(viewer, Question::Place(body(request).await?)).await,
        (&Method::POST, "/cameras.json") => {
            let keyframes: Vec<Camera> = body(request).await?;
            json(&keyframes::write(&keyframes, &viewer.about.placement).map_err(refused)?)
        }
        (&Method::POST, "/path") => {
            let path: PathRequest = body(request).await?;
            json(&keyframes::listed(&path.cameras().map_err(refused)?))
        }
        (&Method::POST, "/keyframes") => {
            let file = body(request).await?;
            json(&keyframes::read(&file, &viewer.about.placement).map_err(refused)?)
        }
        (&Method::GET, path) => {
            if let Some((_, kind, content)) = ASSETS.iter().find(|(address, ..)| *address == path) {
                return Ok(text(StatusCode::OK, kind, content.as_bytes()));
            }
            match path.strip_prefix("/photograph/").and_then(|view| view.parse().ok()) {
                Some(view) => ask(viewer, Question::Photograph(view)).await,
                None => Err(Refusal(StatusCode::NOT_FOUND, format!("there is no {path}"))),
            }
        }
        _ => Err(Refusal(StatusCode::METHOD_NOT_ALLOWED, format!("{method} is not for {path}"))),
    }
}

async fn ask(viewer: &Viewer, question: Question) -> Result<Reply, Refusal> {
    let (reply, answer) = oneshot::channel();
    viewer.queue.ask(question, reply);
    rendered(answer).await
}

async fn rendered(answer: oneshot::Receiver<Answer>) -> Result<Reply, Refusal> {
    match answer.await {
        Ok(Ok(Payload { kind, bytes, about })) => {
            let mut reply = whole(StatusCode::OK, kind, bytes.into());
            if let Ok(about) = HeaderValue::from_str(&about) {
                reply.headers_mut().insert(HeaderName::from_static("x-organza"), about);
            }
            Ok(reply)
        }
        Ok(Err(reason)) => Err(Refusal(StatusCode::UNPROCESSABLE_ENTITY, reason)),
        // a newer request has replaced it
        Err(_) => Err(Refusal(StatusCode::CONFLICT, "this is no longer needed".to_owned())),
    }
}

/// The JSON of a request's body.
async fn body<T: DeserializeOwned>(request: Request<Incoming>) -> Result<T, Refusal> {
    let all = Limited::new(request.into_body(), MAX_BODY).collect();
    let bytes = match tokio::time::timeout(PATIENCE, all).await {
        Ok(Ok(all)) => all.to_bytes(),
        Ok(Err(error)) => return Err(Refusal(StatusCode::BAD_REQUEST, error.to_string())),
        Err(_) => return Err(Refusal(StatusCode::REQUEST_TIMEOUT, "it took too long".to_owned())),
    };
    serde_json::from_slice(&bytes).map_err(|error| {
        Refusal(StatusCode::BAD_REQUEST, format!("this is not the JSON that was expected: {error}"))
    })
}

fn refused(error: Error) -> Refusal {
    Refusal(StatusCode::BAD_REQUEST, error::chain(&error))
}

fn text(status: StatusCode, kind: &'static str, content: &[u8]) -> Reply {
    whole(status, kind, Bytes::copy_from_slice(content))
}

/// Headers of every answer: no caching, no content from elsewhere, and no embedding in other pages.
const HEADERS: [(&str, &str); 6] = [
    ("cache-control", "no-store"),
    (
        "content-security-policy",
        "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; frame-ancestors 'none'; \
         base-uri 'none'; form-action 'none'",
    ),
    ("cross-origin-opener-policy", "same-origin"),
    ("cross-origin-resource-policy", "same-origin"),
    ("referrer-policy", "no-referrer"),
    ("x-content-type-options", "nosniff"),
];

fn whole(status: StatusCode, kind: &'static str, content: Bytes) -> Reply {
    let mut reply = Response::new(Full::new(content));
    *reply.status_mut() = status;
    let headers = reply.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    for (name, value) in HEADERS {
        headers.insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    reply
}

/// A file of the page: its address, its media type, and its content.
type Asset = (&'static str, &'static str, &'static str);

const PAGE: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";

/// Every file of the page.
const ASSETS: [Asset; 24] = [
    ("/", PAGE, include_str!("page/index.html")),
    ("/icon.svg", "image/svg+xml", include_str!("page/icon.svg")),
    ("/page.css", STYLE, include_str!("page/page.css")),
    ("/main.js", SCRIPT, include_str!("page/main.js")),
    ("/blocks.js", SCRIPT, include_str!("page/blocks.js")),
    ("/camera.js", SCRIPT, include_str!("page/camera.js")),
    ("/cameras.js", SCRIPT, include_str!("page/cameras.js")),
    ("/controls.js", SCRIPT, include_str!("page/controls.js")),
    ("/edit.js", SCRIPT, include_str!("page/edit.js")),
    ("/explain.js", SCRIPT, include_str!("page/explain.js")),
    ("/frames.js", SCRIPT, include_str!("page/frames.js")),
    ("/keyframes.js", SCRIPT, include_str!("page/keyframes.js")),
    ("/keys.js", SCRIPT, include_str!("page/keys.js")),
    ("/lens.js", SCRIPT, include_str!("page/lens.js")),
    ("/measure.js", SCRIPT, include_str!("page/measure.js")),
    ("/modes.js", SCRIPT, include_str!("page/modes.js")),
    ("/overlay.js", SCRIPT, include_str!("page/overlay.js")),
    ("/places.js", SCRIPT, include_str!("page/places.js")),
    ("/status.js", SCRIPT, include_str!("page/status.js")),
    ("/tool.js", SCRIPT, include_str!("page/tool.js")),
    ("/page.js", SCRIPT, include_str!("page/page.js")),
    ("/training.js", SCRIPT, include_str!("page/training.js")),
    ("/uplot.js", SCRIPT, UPLOT_SCRIPT),
    ("/uplot.css", STYLE, UPLOT_STYLE),
];
