//! The frames of a page, as plans that it replays, and the kernels that they run.

use std::collections::BTreeSet;
use std::iter::repeat_n;

use serde_json::{Value, json};

use muslin::KernelInfo;
use muslin_device::{BufferRange, Step};
use organza_core::{Camera, Result};
use organza_render::{Capacity, DeviceScene, Frame, FrameShape, MODULES, Renderer};

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
pub fn measure(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[Camera],
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
pub fn write_frames(
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
pub fn kernels_of(frames: &[Value]) -> Result<Vec<Value>> {
    let steps = frames.iter().filter_map(|frame| frame["frame"].as_array()).flatten();
    let names = steps.filter_map(|step| step[0].as_str());
    let names: BTreeSet<_> = names.chain(["count_fill"]).collect();
    let kernel = |info: &'static KernelInfo| {
        let compiled = MODULES.compiled_kernel(info, &info.plain())?;
        let code = compiled.to_wgsl()?;
        let access = info.bindings.iter().map(|binding| binding.access.as_str());
        let access: Vec<_> = access.collect();
        Ok(json!({ "name": info.name, "access": access, "code": code }))
    };
    muslin::kernels().filter(|info| names.contains(info.name)).map(kernel).collect()
}
