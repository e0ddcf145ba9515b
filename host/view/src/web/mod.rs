//! A page that renders a scene by itself, in any browser with WebGPU: the kernels as WGSL, and frames as plans.

use std::collections::BTreeSet;
use std::io::Write;
use std::iter::repeat_n;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use glam::DVec3;
use maud::{DOCTYPE, PreEscaped, html};
use serde_json::{Value, json};

use crate::home::home;
use crate::picture::encode_jpeg;
use muslin::KernelInfo;
use muslin_device::{BufferRange, Device, PlannedBuffer, Step};
use organza_core::camera::{Camera, Orbit};
use organza_core::{Result, Scene};
use organza_render::{Capacity, DeviceScene, Frame, FrameShape, MODULES, OCCUPANCY, Renderer};

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
        let orbit = match cameras {
            [] => Orbit::from_box(scene.visible_box(), options.size),
            _ => Orbit { size: options.size, ..Orbit::around(cameras)? },
        };
        // a box without size has no outside, and cameras right above their center have no orbit
        let around = orbit.cameras(ORBIT).unwrap_or_default();
        let every = cameras.len().div_ceil(VIEWS).max(1);
        let measured: Vec<_> = around.iter().chain(cameras.iter().step_by(every)).collect();
        let mut way = match cameras {
            [] => orbit.cameras(PLACES),
            _ => Orbit::among(cameras, PLACES),
        }
        .unwrap_or_default();
        let gaussians = &scene.gaussians;
        let best = home(cameras, &gaussians.position, &gaussians.opacity);
        let home = best.or(way.first()).cloned();
        let home =
            home.unwrap_or_else(|| organza_core::demo::turntable(1, options.size[1]).remove(0));
        let away = |camera: &Camera| DVec3::from(camera.eye()).distance(home.eye().into());
        let nearest = (0..way.len()).min_by(|a, b| away(&way[*a]).total_cmp(&away(&way[*b])));
        way.rotate_left(nearest.unwrap_or(0));
        let pose = |camera: &Camera| camera.camera_to_world.map(|row| row.map(|x| x as f32));

        let planner = Renderer::new(Device::planner());
        let planned = upload(&planner)?;
        let mut buffers = planner.device().take_plan().buffers;
        let there = upload(measuring)?;
        // a planner computes nothing, and a page shows scenes that do not change
        let grids = buffers.iter_mut().filter(|buffer| buffer.label == OCCUPANCY);
        for (buffer, scene) in grids.zip(there.all()) {
            let occupancy = measuring.device().read(scene.occupancy())?;
            let mut contents = bytemuck::cast_slice(&occupancy).to_vec();
            contents.resize(buffer.bytes as usize, 0);
            buffer.contents = Some(contents);
        }
        let ladder = measure(measuring, &there, &measured, options.size)?;
        let frames = write_frames(&planner, &planned, &ladder, buffers.len() as u32)?;
        let kernels = kernels_of(&frames)?;
        let poster = measuring.render_view(&there, &within(&home, options.size))?;
        let poster = encode_jpeg(&poster)?;
        let header = json!({
            "title": options.title,
            "version": env!("CARGO_PKG_VERSION"),
            "gaussians": there.all().map(DeviceScene::len).sum::<usize>(),
            "aabb": scene.config.aabb,
            "background": scene.config.background,
            "up": orbit.up,
            "center": orbit.center,
            "home": home,
            // the eyes of a slow turn, which begins and ends near home and looks at the center
            "way": way.iter().map(Camera::eye).collect::<Vec<_>>(),
            // where photographs were taken
            "poses": cameras.iter().map(pose).collect::<Vec<_>>(),
            // the length of each buffer of the scene, in bytes
            "buffers": buffers.iter().map(|buffer| buffer.bytes).collect::<Vec<_>>(),
            "kernels": kernels,
            "plans": frames,
        });
        let payload = pack(&header, &buffers);
        Ok(Self { title: options.title.clone(), payload, poster })
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

/// A camera with its image's shape, in as many pixels as fit into a size.
fn within(camera: &Camera, size: [u32; 2]) -> Camera {
    let own = [camera.width, camera.height].map(f64::from);
    let factor = (f64::from(size[0]) / own[0]).min(f64::from(size[1]) / own[1]);
    camera.with_size(own.map(|side| (side * factor).round().max(1.0) as u32))
}

// All data of a page, packed: gzip in base64, so that it can be part of a script and needs no server.
//
// Unpacked, it has the length of the JSON in bytes (u32, little endian), the JSON, zeros up to a multiple of 4, and
// the buffers of the scene. The bytes of a buffer are sorted by their place in a 32-bit word, because the high bytes
// of floats are similar.

/// Packs a page's data.
fn pack(header: &Value, buffers: &[PlannedBuffer]) -> String {
    let mut json = serde_json::to_vec(header).expect("numbers and names");
    let length = json.len() as u32;
    json.resize(json.len().next_multiple_of(4), 0);
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    let mut write = |bytes: &[u8]| packed.write_all(bytes).expect("memory can be written to");
    write(&length.to_le_bytes());
    write(&json);
    for buffer in buffers {
        match &buffer.contents {
            Some(contents) => write(&by_place(contents)),
            None => write(&vec![0; buffer.bytes as usize]),
        }
    }
    STANDARD.encode(packed.finish().expect("memory can be written to"))
}

/// The first bytes of all words, followed by all second bytes, and so on.
fn by_place(bytes: &[u8]) -> Vec<u8> {
    (0..4).flat_map(|place| bytes.iter().skip(place).step_by(4).copied()).collect()
}

/// The modules. Each comes after those that it imports.
const SCRIPTS: [&str; 6] = [
    include_str!("../page/camera.js"),
    include_str!("../page/controls.js"),
    include_str!("page/player.js"),
    include_str!("page/screen.js"),
    include_str!("page/pace.js"),
    include_str!("page/main.js"),
];
const STYLE: &str = concat!(include_str!("../page/page.css"), include_str!("page/page.css"));
const BODY: &str = include_str!("page/body.html");
const ICON: &str = include_str!("../page/icon.svg");

/// All modules as one script.
fn script() -> String {
    let own = SCRIPTS.map(|module| {
        let lines = module.lines().filter(|line| !line.starts_with("import "));
        lines
            .map(|line| line.strip_prefix("export ").unwrap_or(line))
            .collect::<Vec<_>>()
            .join("\n")
    });
    format!("\"use strict\";\n(async () => {{\n{}\n}})();\n", own.join("\n"))
}

/// The document. `poster` is the address of the picture to show before the scene; `scripts` are elements that load the scene and
/// the page's script.
fn html(title: &str, poster: &str, scripts: &str) -> String {
    let picture = html! {
        div id="poster" role="img" aria-label=(title) style={ "--picture: url(" (poster) ")" } {}
        h1 id="title" { (title) }
    };
    let body = BODY.replacen("<!-- poster and title -->", &picture.into_string(), 1);
    let icon = STANDARD.encode(ICON);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="generator" content=(concat!("organza ", env!("CARGO_PKG_VERSION")));
                title { (title) " · organza" }
                link rel="icon" href={ "data:image/svg+xml;base64," (icon) };
                style { (PreEscaped(STYLE)) }
            }
            body { (PreEscaped(body)) (PreEscaped(scripts)) }
        }
    };
    page.into_string()
}

/// Side of a page's tiles, in pixels.
const SIDE: u32 = 32;
/// Divisors of images' sides: while the camera moves, an image is smaller.
const SHRINKS: [u32; 3] = [4, 2, 1];
/// Lengths of T's steps, as multiples of sigma. Longer ones miss thin surfaces.
const STEPS: [u16; 2] = [2, 1];
/// Capacities, as multiples of the measured cameras' needs.
const LEVELS: [f64; 3] = [1.2, 3.0, 8.0];
/// Added to every capacity.
const MIN_CAPACITY: u32 = 1024;

/// Measures the capacities of a page's frames: each size with each length of steps, from small to large capacities.
fn measure(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[&Camera],
    size: [u32; 2],
) -> Result<Vec<FrameShape>> {
    let mut shapes = Vec::new();
    let scenes = scene.all().count();
    // one camera sees at most all Gaussians
    let gaussians = scene.all().flat_map(|scene| repeat_n(scene.len() as u32, scenes));
    let gaussians: Vec<_> = gaussians.collect();
    for shrink in SHRINKS {
        let size = size.map(|side| side.div_ceil(shrink));
        let mut max = vec![vec![Capacity::default(); gaussians.len()]; STEPS.len()];
        for camera in cameras {
            let found = renderer.capacities(scene, &camera.with_size(size), SIDE, &STEPS)?;
            for (max, found) in max.iter_mut().flatten().zip(found.into_iter().flatten()) {
                *max = max.max(found);
            }
        }
        let [columns, rows] = size.map(|side| side.div_ceil(SIDE));
        for (steps, max) in STEPS.into_iter().zip(max) {
            shapes.extend(LEVELS.map(|factor| {
                let room = |number| (f64::from(number) * factor) as u32 + MIN_CAPACITY;
                let capacity = |(max, gaussians): (&Capacity, &u32)| Capacity {
                    pairs: room(max.pairs).min(*gaussians),
                    intersections: room(max.intersections),
                    samples: room(max.samples),
                };
                let capacities = max.iter().zip(&gaussians).map(capacity).collect();
                FrameShape { tiles: columns * rows, side: SIDE, steps, capacities }
            }));
        }
    }
    Ok(shapes)
}

/// Records a frame of each shape that fits into a browser's memory, and at least the first for each size and length
/// of steps. `scene_buffers` is the number of the scene's buffers.
fn write_frames(
    planner: &Renderer,
    scene: &DeviceScene,
    shapes: &[FrameShape],
    scene_buffers: u32,
) -> Result<Vec<Value>> {
    let mut frames = Vec::new();
    for (index, shape) in shapes.iter().enumerate() {
        match planner.plan_frame(scene, shape) {
            Ok(frame) => frames.push(replayed(shape, &frame, scene_buffers)),
            // frames above the measured capacity are only a reserve
            Err(error) if error.is_out_of_memory() && index % LEVELS.len() > 0 => {}
            Err(error) => return Err(error),
        }
    }
    Ok(frames)
}

/// A frame in the form that the page replays. `scene_buffers` is the number of the scene's buffers, which the planner
/// made first.
fn replayed(shape: &FrameShape, frame: &Frame, scene_buffers: u32) -> Value {
    let plan = &frame.plan;
    let number = |buffer: u32| match buffer.checked_sub(plan.first_buffer) {
        Some(own) => scene_buffers + own,
        None => buffer,
    };
    let contents = plan.buffers.iter().zip(plan.first_buffer..).filter_map(|(buffer, at)| {
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(buffer.contents.as_deref()?);
        Some((number(at), words))
    });
    let cameras = frame.cameras.iter().map(|(at, place)| json!([number(*at), place]));
    json!({
        "tiles": shape.tiles,
        "side": shape.side,
        "steps": shape.steps,
        // the room for each of the counts
        "capacity": shape.capacities.iter().flat_map(|room| room.slots()).collect::<Vec<_>>(),
        // lengths of the plan's own buffers, in bytes; they are numbered after the scene's buffers
        "buffers": plan.buffers.iter().map(|buffer| buffer.bytes).collect::<Vec<_>>(),
        // buffers with initial content, as words
        "contents": contents.collect::<Vec<_>>(),
        "cameras": cameras.collect::<Vec<_>>(),
        "places": frame.tiles.iter().map(|at| number(*at)).collect::<Vec<_>>(),
        "counts": number(frame.counts),
        "image": number(frame.image),
        "frame": plan.steps.iter().map(|planned| step(planned, &number)).collect::<Vec<_>>(),
    })
}

/// A step in the form that the page reads:
/// - `[kernel, params, [[word, counts, place, first, max], ..], [[buffer, begin, bytes], ..], workgroups]`
/// - `["clear", buffer, begin, bytes]`
/// - `["copy", from, begin, bytes, to, at]`
/// - `["publish"]`
fn step(step: &Step, number: &impl Fn(u32) -> u32) -> Value {
    let part = |part: &BufferRange| json!([number(part.buffer), part.begin, part.bytes]);
    match step {
        Step::Dispatch { kernel, params, counts, buffers, workgroups } => {
            let counts = counts.iter().map(|count| {
                let counts = number(count.counts);
                json!([count.offset / 4, counts, count.place, count.first, count.upper_bound])
            });
            let params: Vec<u32> = bytemuck::pod_collect_to_vec(params);
            let counts: Vec<_> = counts.collect();
            let buffers: Vec<_> = buffers.iter().map(part).collect();
            json!([kernel, params, counts, buffers, workgroups])
        }
        Step::Clear(part) => json!(["clear", number(part.buffer), part.begin, part.bytes]),
        Step::Copy { from, to, begin } => {
            json!(["copy", number(from.buffer), from.begin, from.bytes, number(*to), begin])
        }
        Step::PublishCounts => json!(["publish"]),
    }
}

/// The kernels of some frames, in WGSL, and the kernel that fills in counts.
///
/// Each has its name, its code, and the access of each binding: `uniform`, `read` or `write`.
fn kernels_of(frames: &[Value]) -> Result<Vec<Value>> {
    let steps = frames.iter().filter_map(|frame| frame["frame"].as_array()).flatten();
    let names = steps.filter_map(|step| step[0].as_str());
    let names: BTreeSet<_> = names.chain(["count_fill"]).collect();
    let kernel = |info: &'static KernelInfo| {
        let compiled = MODULES.compiled_kernel(info, &info.plain())?;
        let Some(code) = compiled.wgsl() else {
            let reason = format!("`{}` is not there in WGSL", info.name);
            return Err(muslin_device::Error::StaleKernels { reason }.into());
        };
        let access = info.bindings.iter().map(|binding| binding.access.as_str());
        let access: Vec<_> = access.collect();
        Ok(json!({ "name": info.name, "access": access, "code": code }))
    };
    let used = muslin::kernels().filter(|info| names.contains(info.name));
    used.map(kernel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_script_is_no_module_and_ends_no_element() {
        let script = script();
        for word in ["\nimport ", "\nexport ", "</script", "<!--"] {
            assert!(!script.contains(word), "{word}");
        }
        let page = html("<i>&\"", "poster.jpg", "");
        assert!(page.contains("<title>&lt;i&gt;&amp;&quot; · organza</title>"));
        assert!(page.contains("<h1 id=\"title\">&lt;i&gt;&amp;&quot;</h1>"));
        assert!(page.contains("url(poster.jpg)"));
    }
}
