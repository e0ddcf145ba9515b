//! The plans of a page, for several image sizes, lengths of T's steps and amounts of memory.

use std::collections::BTreeSet;

use muslin::KernelInfo;
use muslin_device::{Part, Step};
use serde::Serialize;
use serde_json::{Value, json};

use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_render::MODULES;
use organza_render::{Capacity, DeviceScene, Frame, FrameShape, Renderer};

/// Side of a page's tiles, in pixels.
const SIDE: u32 = 32;
/// Divisors of images' sides: while the camera moves, an image is smaller.
const SHRINKS: [u32; 3] = [4, 2, 1];
/// Lengths of T's steps, as multiples of sigma. Longer ones miss thin surfaces.
const STEPS: [u16; 2] = [2, 1];
/// Capacities, as multiples of the measured cameras' needs.
const LEVELS: [f64; 3] = [1.2, 3.0, 8.0];
/// Added to every capacity.
const LEAST: u32 = 1024;

/// A frame in the form that the page replays.
#[derive(Debug, Serialize)]
pub struct PlannedFrame {
    tiles: u32,
    side: u32,
    steps: u16,
    /// Capacities for pairs, members and samples.
    capacity: [u32; 3],
    /// Length of each of the plan's own buffers, in bytes. Their numbers follow those of the scene's buffers.
    buffers: Vec<u64>,
    /// Buffers with initial content, as words.
    contents: Vec<(u32, Vec<u32>)>,
    camera: u32,
    tile: u32,
    counts: u32,
    image: u32,
    /// Steps in the form of [`step`].
    frame: Vec<Value>,
}

/// A kernel that a page compiles.
#[derive(Debug, Serialize)]
pub struct Kernel {
    name: &'static str,
    /// Access of each binding: `uniform`, `read` or `write`.
    access: Vec<&'static str>,
    code: &'static str,
}

/// Measures the capacities of a page's frames: each size with each length of steps, from small to large capacities.
pub fn measure(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[&Camera],
    size: [u32; 2],
) -> Result<Vec<FrameShape>> {
    let mut shapes = Vec::new();
    for shrink in SHRINKS {
        let size = size.map(|side| side.div_ceil(shrink));
        let mut most = [Capacity { pairs: 0, members: 0, samples: 0 }; STEPS.len()];
        for camera in cameras {
            let found = renderer.capacities(scene, &camera.with_size(size), SIDE, &STEPS)?;
            for (most, found) in most.iter_mut().zip(found) {
                most.pairs = most.pairs.max(found.pairs);
                most.members = most.members.max(found.members);
                most.samples = most.samples.max(found.samples);
            }
        }
        let [columns, rows] = size.map(|side| side.div_ceil(SIDE));
        for (steps, most) in STEPS.into_iter().zip(most) {
            shapes.extend(LEVELS.map(|factor| {
                let room = |number| (f64::from(number) * factor) as u32 + LEAST;
                let gaussians = scene.len() as u32;
                let capacity = Capacity {
                    // one camera sees at most all Gaussians
                    pairs: room(most.pairs).min(gaussians),
                    members: room(most.members),
                    samples: room(most.samples),
                };
                FrameShape { tiles: columns * rows, side: SIDE, steps, capacity }
            }));
        }
    }
    Ok(shapes)
}

/// Records a frame of each shape that fits into a browser's memory, and at least the first for each size and length
/// of steps. `scene_buffers` is the number of the scene's buffers.
pub fn write(
    planner: &Renderer,
    scene: &DeviceScene,
    shapes: &[FrameShape],
    scene_buffers: u32,
) -> Result<Vec<PlannedFrame>> {
    let mut frames = Vec::new();
    for (index, shape) in shapes.iter().enumerate() {
        match planner.plan_frame(scene, shape) {
            Ok(frame) => frames.push(PlannedFrame::new(shape, &frame, scene_buffers)),
            // frames above the measured capacity are only a reserve
            Err(error) if error.is_out_of_memory() && index % LEVELS.len() > 0 => {}
            Err(error) => return Err(error),
        }
    }
    Ok(frames)
}

impl PlannedFrame {
    /// `scene_buffers` is the number of the scene's buffers, which the planner made first.
    fn new(shape: &FrameShape, frame: &Frame, scene_buffers: u32) -> Self {
        let plan = &frame.plan;
        let number = |buffer: u32| match buffer.checked_sub(plan.first_buffer) {
            Some(own) => scene_buffers + own,
            None => buffer,
        };
        let contents = plan.buffers.iter().zip(plan.first_buffer..).filter_map(|(buffer, at)| {
            let words = bytemuck::pod_collect_to_vec(buffer.contents.as_deref()?);
            Some((number(at), words))
        });
        let Capacity { pairs, members, samples } = shape.capacity;
        Self {
            tiles: shape.tiles,
            side: shape.side,
            steps: shape.steps,
            capacity: [pairs, members, samples],
            buffers: plan.buffers.iter().map(|buffer| buffer.bytes).collect(),
            contents: contents.collect(),
            camera: number(frame.camera),
            tile: number(frame.tiles),
            counts: number(frame.counts),
            image: number(frame.image),
            frame: plan.steps.iter().map(|planned| step(planned, &number)).collect(),
        }
    }
}

/// A step in the form that the page reads:
/// - `[kernel, params, [[word, counts, place, first, most], ..], [[buffer, begin, bytes], ..], workgroups]`
/// - `["clear", buffer, begin, bytes]`
/// - `["copy", from, begin, bytes, to, at]`
/// - `["publish"]`
fn step(step: &Step, number: &impl Fn(u32) -> u32) -> Value {
    let part = |part: &Part| json!([number(part.buffer), part.begin, part.bytes]);
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
pub fn kernels(frames: &[PlannedFrame]) -> Result<Vec<Kernel>> {
    let names = frames.iter().flat_map(|frame| &frame.frame).filter_map(|step| step[0].as_str());
    let names: BTreeSet<_> = names.chain(["count_fill"]).collect();
    let kernel = |info: &'static KernelInfo| {
        let compiled = MODULES.compiled_kernel(info, &info.plain())?;
        let Some(code) = compiled.wgsl() else {
            let reason = format!("`{}` is not there in WGSL", info.name);
            return Err(muslin_device::Error::StaleKernels { reason }.into());
        };
        let access = info.bindings.iter().map(|binding| binding.access.as_str()).collect();
        Ok(Kernel { name: info.name, access, code })
    };
    let used = muslin::kernels().filter(|info| names.contains(info.name));
    used.map(kernel).collect()
}
