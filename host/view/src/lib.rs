//! The viewer of `organza view` and `organza train --view`: a small HTTP server, whose page requests one image at a
//! time.
//!
//! There are two threads. The [server](Server) reads requests and puts them on a [`Queue`]. The thread that owns the
//! scene takes them from there, one at a time, and [renders](FrameRenderer). A client has at most one image in the queue: a
//! newer request replaces an older one, so the latest camera wins. An image that no client waits for is not rendered.
//!
//! [`web`] makes a page that renders by itself, without a server.

mod about;
mod connections;
mod editor;
mod explanation;
mod frame_renderer;
mod guard;
mod home;
mod keyframes;
mod message;
mod pace;
mod photographs;
mod picture;
mod places;
mod queue;
mod server;
mod stage;
mod training;
mod training_status;
pub mod web;

pub use about::{About, Purpose};
pub use editor::Editor;
pub use frame_renderer::FrameRenderer;
pub use photographs::{PhotographSource, Photographs};
pub use places::Places;
pub use queue::Queue;
pub use server::Server;
pub use stage::Stage;
pub use training::TrainingView;
