//! The viewer of `organza view` and `organza train --view`: a small HTTP server whose page asks for one image at a time.
//!
//! Two threads work. The [server](Server) reads requests and puts them on a [`Desk`]; the one that owns the scene takes them
//! from there, one at a time, and [paints](Painter). A client has one image on the desk at most: a newer one takes the place
//! of an older one, so that the latest camera wins. What nobody waits for is not painted.

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
