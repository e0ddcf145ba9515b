//! The viewer of `organza view` and `organza train --view`: a small HTTP server, whose page requests one image at a
//! time.
//!
//! There are two threads. The [server](Server) reads requests and puts them on a [`Desk`]. The thread that owns the
//! scene takes them from there, one at a time, and [paints](Painter). A client has at most one image on the desk: a
//! newer request replaces an older one, so the latest camera wins. An image that nobody waits for is not painted.

mod about;
mod assets;
mod board;
mod desk;
mod explain;
mod film;
mod guard;
mod keyframes;
mod message;
mod pace;
mod painter;
mod photographs;
mod picture;
mod server;
mod training;

pub use about::About;
pub use desk::Desk;
pub(crate) use message::Lens;
pub use painter::{Painter, Stage};
pub use photographs::Photographs;
pub use server::{Address, Server};
pub use training::TrainingView;
