//! A page that renders a scene by itself, in any browser with WebGPU: the kernels as WGSL, and frames as plans.

mod bundle;
mod gallery;
mod payload;
mod plans;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use crate::message::CameraMessage;
use crate::picture::encode_jpeg;
use muslin_device::Device;
use organza_core::camera::{Camera, Orbit};
use organza_core::error::Result;
use organza_core::scene::Scene;
use organza_render::{OCCUPANCY, Renderer, UploadOptions};

pub use gallery::{Card, embedding, gallery};

/// Options of a page.
#[derive(Clone, Debug)]
pub struct PageOptions {
    /// Title of the page.
    pub title: String,
    /// Largest image that the page renders, in pixels. A larger window shows it enlarged.
    pub size: [u32; 2],
    /// Whether to store the hash grids as 16-bit floats.
    pub half_grids: bool,
}

/// The files of a page.
#[derive(Clone, Debug)]
pub struct WebPage {
    title: String,
    /// The scene, its plans and its kernels, packed.
    payload: String,
    /// The first image, JPEG.
    poster: Vec<u8>,
    /// Facts measured while making the page.
    pub facts: Facts,
}

/// Facts about a page.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// Number of plans of a frame.
    pub plans: usize,
    /// Number of kernels.
    pub kernels: usize,
    /// Number of cameras for which the plans' capacities were measured.
    pub measured: usize,
}

/// Data for the page besides its plans.
#[derive(Serialize)]
struct About<'a> {
    title: &'a str,
    version: &'static str,
    gaussians: usize,
    aabb: [[f64; 3]; 2],
    up: [f64; 3],
    center: [f64; 3],
    home: CameraMessage,
    /// The eyes of a slow turn, which begins and ends at home and looks at the center.
    way: Vec<[f64; 3]>,
}

/// Number of cameras on an orbit for which capacities are measured.
const ORBIT: usize = 12;
/// Number of the scene's own cameras for which capacities are measured, too.
const VIEWS: usize = 24;
/// Number of places on the way of the slow turn.
const PLACES: usize = 120;

impl WebPage {
    /// Names of [`Self::files`]. A browser opens the first one.
    pub const FILES: [&str; 4] = ["index.html", "page.js", "scene.js", "poster.jpg"];

    /// Makes the page of a scene. `cameras` are those that it was trained on, or empty. `measuring` measures the
    /// memory that their images need.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload`]; [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory)
    /// if the scene is larger than a browser can bind.
    pub fn new(
        scene: &Scene,
        cameras: &[Camera],
        measuring: &Renderer,
        options: &PageOptions,
    ) -> Result<Self> {
        let orbit = match cameras {
            [] => Orbit::from_box(scene.visible_box(), options.size),
            _ => Orbit { size: options.size, ..Orbit::around(cameras)? },
        };
        // a box without size has no outside, and cameras right above their center have no orbit
        let around = orbit.cameras(ORBIT).unwrap_or_default();
        let every = cameras.len().div_ceil(VIEWS).max(1);
        let measured: Vec<_> = around.iter().chain(cameras.iter().step_by(every)).collect();
        let way = match cameras {
            [] => orbit.cameras(PLACES),
            _ => Orbit::among(cameras, PLACES),
        }
        .unwrap_or_default();
        let home = way.first().or(cameras.first()).cloned();
        let home =
            home.unwrap_or_else(|| organza_core::demo::turntable(1, options.size[1]).remove(0));

        let upload = UploadOptions::default().half_grids(options.half_grids);
        let planner = Renderer::new(Device::planner());
        let planned = planner.upload_with(scene, upload)?;
        let mut buffers = planner.device().take_plan().buffers;
        let there = measuring.upload_with(scene, upload)?;
        // a planner computes nothing, and a page shows a scene that does not change
        let occupancy = measuring.device().read(there.occupancy())?;
        for buffer in buffers.iter_mut().filter(|buffer| buffer.label == OCCUPANCY) {
            buffer.contents = Some(bytemuck::cast_slice(&occupancy).to_vec());
        }
        let ladder = plans::measure(measuring, &there, &measured, options.size)?;
        let frames = plans::write(&planner, &planned, &ladder, buffers.len() as u32)?;
        let kernels = plans::kernels(&frames)?;
        let about = About {
            title: &options.title,
            version: env!("CARGO_PKG_VERSION"),
            gaussians: scene.gaussians.len(),
            aabb: scene.config.aabb,
            up: orbit.up,
            center: orbit.center,
            home: CameraMessage::from(&home),
            way: way.iter().map(Camera::eye).collect(),
        };
        let poster = measuring.render_view(&there, &within(&home, options.size))?;
        let poster = encode_jpeg(&poster)?;
        let facts = Facts { plans: frames.len(), kernels: kernels.len(), measured: measured.len() };
        let payload = payload::pack(&about, &buffers, &frames, &kernels);
        Ok(Self { title: options.title.clone(), payload, poster, facts })
    }

    /// The whole page as one file.
    #[must_use]
    pub fn single_file(&self) -> String {
        let scripts = format!(
            "<script>{}</script>\n<script>{}</script>",
            self.scene_script(),
            bundle::script()
        );
        let poster = format!("data:image/jpeg;base64,{}", STANDARD.encode(&self.poster));
        bundle::html(&self.title, &poster, &scripts)
    }

    /// The files of the page's folder, by name.
    #[must_use]
    pub fn files(&self) -> [(&'static str, Vec<u8>); 4] {
        let scripts = "<script src=\"scene.js\"></script>\n<script src=\"page.js\"></script>";
        let [index, page, scene, poster] = Self::FILES;
        [
            (index, bundle::html(&self.title, poster, scripts).into_bytes()),
            (page, bundle::script().into_bytes()),
            (scene, self.scene_script().into_bytes()),
            (poster, self.poster.clone()),
        ]
    }

    fn scene_script(&self) -> String {
        format!("const ORGANZA_SCENE = \"{}\";\n", self.payload)
    }
}

/// A camera with its image's shape, in as many pixels as fit into a size.
fn within(camera: &Camera, size: [u32; 2]) -> Camera {
    let own = [camera.width, camera.height].map(f64::from);
    let factor = (f64::from(size[0]) / own[0]).min(f64::from(size[1]) / own[1]);
    camera.with_size(own.map(|side| (side * factor).round().max(1.0) as u32))
}
