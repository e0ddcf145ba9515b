//! A page that renders a scene by itself, in any browser with WebGPU: the kernels as WGSL, and frames as plans.

mod document;
mod frames;
mod payload;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::DVec3;
use maud::html;
use serde_json::json;

use crate::home::home;
use crate::picture::encode_jpeg;
use document::{html, script};
use frames::{kernels_of, measure, write_frames};
use muslin_device::{Device, PlannedBuffer};
use organza_core::camera::{Camera, Orbit};
use organza_core::{Result, Scene, demo};
use organza_render::{DeviceScene, OCCUPANCY, Renderer};
use payload::pack;

/// Options of a page.
#[derive(Clone, Debug)]
pub struct PageOptions {
    /// Title of the page.
    pub title: String,
    /// Largest image that the page renders, in pixels. A larger window shows it enlarged.
    pub size: [u32; 2],
}

/// The files of a page.
#[derive(Clone, Debug)]
pub struct WebPage {
    title: String,
    /// The scene, its plans and its kernels, packed.
    payload: String,
    /// The first image, JPEG.
    poster: Vec<u8>,
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

    /// Makes the page of a scene. `upload` copies it to a device, and [others](DeviceScene::put) that are shown with it.
    /// `cameras` are those that it was trained on, or empty. `measuring` measures the memory that their images need.
    ///
    /// # Errors
    /// The same errors as `upload`; [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory)
    /// if the scene is larger than a browser can bind.
    pub fn new(
        scene: &Scene,
        upload: &dyn Fn(&Renderer) -> Result<DeviceScene>,
        cameras: &[Camera],
        measuring: &Renderer,
        options: &PageOptions,
    ) -> Result<Self> {
        let tour = Tour::new(scene, cameras, options.size)?;
        let planner = Renderer::new(Device::planner());
        let planned = upload(&planner)?;
        let mut buffers = planner.device().take_plan().buffers;
        let uploaded = upload(measuring)?;
        fill_occupancy(&mut buffers, &uploaded)?;
        let ladder = measure(measuring, &uploaded, &tour.measured, options.size)?;
        let frames = write_frames(&planner, &planned, &ladder, buffers.len() as u32)?;
        let kernels = kernels_of(&frames)?;
        let pose = |camera: &Camera| camera.camera_to_world.map(|row| row.map(|x| x as f32));
        let poster = measuring.render_view(&uploaded, &within(&tour.home, options.size))?;
        let poster = encode_jpeg(&poster)?;
        let header = json!({
            "title": options.title,
            "version": env!("CARGO_PKG_VERSION"),
            "gaussians": uploaded.all().map(DeviceScene::len).sum::<usize>(),
            "aabb": scene.config.aabb,
            "background": scene.config.background,
            "up": tour.orbit.up,
            "center": tour.orbit.center,
            "home": tour.home,
            // the eyes of a slow turn, which begins and ends near home and looks at the center
            "way": tour.way.iter().map(Camera::eye).collect::<Vec<_>>(),
            // where photographs were taken
            "poses": cameras.iter().map(pose).collect::<Vec<_>>(),
            // the length of each buffer of the scene, in bytes
            "buffers": buffers.iter().map(|buffer| buffer.bytes).collect::<Vec<_>>(),
            "kernels": kernels,
            "plans": frames,
        });
        Ok(Self { title: options.title.clone(), payload: pack(&header, &buffers), poster })
    }

    /// The whole page as one file.
    pub fn single_file(&self) -> String {
        let scripts =
            format!("<script>{}</script>\n<script>{}</script>", self.scene_script(), script());
        let poster = format!("data:image/jpeg;base64,{}", STANDARD.encode(&self.poster));
        html(&self.title, &poster, &scripts)
    }

    /// The files of the page's folder, by name.
    pub fn files(&self) -> [(&'static str, Vec<u8>); 4] {
        let [index, page, scene, poster] = Self::FILES;
        // nothing else can say so
        let missing = format!(
            "document.getElementById('status').hidden = true; \
             const message = document.getElementById('message'); \
             message.hidden = false; message.className = 'plain'; \
             message.textContent = 'This is a picture. To turn the scene, the page needs {page} beside it: copy the whole \
             folder.'; \
             document.documentElement.dataset.ready = ''"
        );
        let scripts = html! {
            script src=(scene) {}
            script src=(page) onerror=(missing) {}
        };
        let scripts = &scripts.into_string();
        [
            (index, html(&self.title, poster, scripts).into_bytes()),
            (page, script().into_bytes()),
            (scene, self.scene_script().into_bytes()),
            (poster, self.poster.clone()),
        ]
    }

    fn scene_script(&self) -> String {
        format!("const ORGANZA_SCENE = \"{}\";\n", self.payload)
    }
}

/// Gives the scenes' occupancy grids their contents: a planner computes nothing, and a page shows scenes that do not change.
fn fill_occupancy(buffers: &mut [PlannedBuffer], scene: &DeviceScene) -> Result<()> {
    let grids = buffers.iter_mut().filter(|buffer| buffer.label == OCCUPANCY);
    for (buffer, scene) in grids.zip(scene.all()) {
        let mut contents = bytemuck::cast_slice(&scene.device().read(scene.occupancy())?).to_vec();
        contents.resize(buffer.bytes as usize, 0);
        buffer.contents = Some(contents);
    }
    Ok(())
}

/// The cameras of a page: from where it begins, and turns.
struct Tour {
    orbit: Orbit,
    /// The cameras for which capacities are measured.
    measured: Vec<Camera>,
    /// The first camera.
    home: Camera,
    /// The cameras of the slow turn, of which the first is the nearest to `home`.
    way: Vec<Camera>,
}

impl Tour {
    /// `cameras` are those of the scene's data set, or empty; `size` is the largest image's.
    fn new(scene: &Scene, cameras: &[Camera], size: [u32; 2]) -> Result<Self> {
        let orbit = match cameras {
            [] => Orbit::from_box(scene.visible_box(), size),
            _ => Orbit { size, ..Orbit::around(cameras)? },
        };
        // a box without size has no outside, and cameras right above their center have no orbit
        let mut measured = orbit.cameras(ORBIT).unwrap_or_default();
        measured.extend(cameras.iter().step_by(cameras.len().div_ceil(VIEWS).max(1)).cloned());
        let mut way = match cameras {
            [] => orbit.cameras(PLACES),
            _ => Orbit::among(cameras, PLACES),
        }
        .unwrap_or_default();
        let gaussians = &scene.gaussians;
        let best = home(cameras, &gaussians.position, &gaussians.opacity);
        let home = best.or(way.first()).cloned();
        let home = home.unwrap_or_else(|| demo::turntable(1, size[1]).remove(0));
        let away = |camera: &Camera| DVec3::from(camera.eye()).distance(home.eye().into());
        let nearest = (0..way.len()).min_by(|a, b| away(&way[*a]).total_cmp(&away(&way[*b])));
        way.rotate_left(nearest.unwrap_or(0));
        Ok(Self { orbit, measured, home, way })
    }
}

/// A camera with its image's shape, in as many pixels as fit into a size.
fn within(camera: &Camera, size: [u32; 2]) -> Camera {
    let own = [camera.width, camera.height].map(f64::from);
    let factor = (f64::from(size[0]) / own[0]).min(f64::from(size[1]) / own[1]);
    camera.with_size(own.map(|side| (side * factor).round().max(1.0) as u32))
}
