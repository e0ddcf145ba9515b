//! The base of all other crates of organza: scenes and their files, cameras, tiles, ranks, and errors.
//!
//! Use it through the crate [`organza`](https://crates.io/crates/organza).

mod atomic_file;
pub mod camera;
pub mod demo;
pub mod error;
pub mod halves;
pub mod image;
pub mod input;
pub mod metrics;
pub mod ranks;
mod rendered;
pub mod scene;
pub mod tile;

pub use atomic_file::{
    check_folder, check_inside, check_writable, remove_leftovers, write_atomic, write_inside,
};
pub use camera::Camera;
pub use error::{Error, Result};
pub use image::Image;
pub use muslin_error::memory;
pub use rendered::{Channel, RenderReport, RenderedTiles};
pub use scene::{Gradient, Scene};
pub use tile::{Tile, TileBatch};
