//! Sort-free Gaussian rendering in single-source Rust.
//!
//! A scene is a set of 3D Gaussians, whose color and visibility come from small neural fields. Tiles of any number of
//! views are rendered as one tensor `[K, 3, S, S]`, and nothing is ever sorted. The kernels are written once, in
//! Rust. They run on every GPU that wgpu supports, and as the same functions on the CPU.
//!
//! [`Renderer`] renders:
//!
//! ```no_run
//! use organza::{DeviceOptions, Renderer, Scene, TileBatch};
//!
//! let renderer = Renderer::new(organza::open_device(&DeviceOptions::default())?);
//! let scene = Scene::load("scene.safetensors")?;
//! let cameras = scene.load_cameras("cameras.json")?;
//! let scene = renderer.upload(&scene)?;
//! let tiles = renderer.render(&scene, &cameras, &TileBatch::load("tiles.json")?)?; // [K, 3, S, S]
//! renderer.render_view(&scene, &cameras[0])?.save_png("view.png")?;
//! # Ok::<(), organza::Error>(())
//! ```
//!
//! [`Trainer`] trains:
//!
//! ```no_run
//! # use organza::{DeviceOptions, Renderer};
//! # let renderer = Renderer::new(organza::open_device(&DeviceOptions::default())?);
//! use organza::{Dataset, DatasetOptions, TrainConfig, Trainer};
//!
//! let dataset = Dataset::load("data/fox", &DatasetOptions::default())?;
//! let mut trainer = Trainer::start(&renderer, TrainConfig::default(), dataset)?;
//! while !trainer.is_finished() {
//!     trainer.step()?;
//! }
//! println!("{:?}", trainer.evaluate()?.mean);
//! # Ok::<(), organza::Error>(())
//! ```
//!
//! [`Renderer::gradient`] computes the gradient of any loss, and [`Renderer::record`] the tiles as well.
//! [`Trainer::step_with`] trains with a loss of your own.

//! # Features
//!
//! All are on by default. Without them, this is the renderer alone.
//!
//! - `train`: photographs ([`data`]), [training](train), and [files for viewers that sort](splats).
//! - `viewer`: pages of runs, the [viewer](view), and [the page that renders by itself](web). Needs `train`.
//! - `cli`: the program. Needs `viewer`.
//! - `mpi`: ranks that are MPI's processes. Off by default.

#[cfg(feature = "bench")]
#[doc(hidden)]
pub mod bench;
#[cfg(feature = "train")]
#[doc(hidden)]
pub mod fuzz;
pub mod ranks;

#[cfg(feature = "train")]
pub use data::{Dataset, DatasetOptions, still_life};
pub use muslin_device::{
    BackendChoice, Buffer, Device, DeviceOptions, InstructionSet, Modules, SpirvPath,
};
pub use organza_core::{
    Camera, Channel, Error, Gradient, Image, RenderReport, RenderedTiles, Result, Scene, Tile,
    TileBatch, camera, demo, error, image, metrics, scene, tile,
};
#[cfg(feature = "train")]
pub use organza_data as data;
pub use organza_render::{
    self as render, DeviceScene, Inspection, MODULES, Renderer, Stages, Tape, UploadOptions,
    open_device,
};
#[cfg(feature = "train")]
pub use organza_train::{COMMIT, Evaluation, TrainConfig, Trainer, evaluate};
#[cfg(feature = "viewer")]
pub use organza_view::{self as view, web};

/// Gaussians for 3D Gaussian Splatting viewers: their files, the fit of a scene's Gaussians, and scenes made of such files.
#[cfg(feature = "train")]
pub mod splats {
    pub use organza_splats::*;
    pub use organza_train::evaluate::{SplatComparison, compare_splats};
    pub use organza_train::{Import, Imported, import};
}

/// Training: from photographs with poses to a scene.
#[cfg(feature = "train")]
pub mod train {
    #[cfg(feature = "viewer")]
    pub use organza_report as report;
    pub use organza_train::*;
}
