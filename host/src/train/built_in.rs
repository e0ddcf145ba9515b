//! Photographs of the built-in scene: something to train on that nobody has to download.

use crate::camera::Camera;
use crate::data::{Dataset, Frame, Photograph, Pose, is_held_out};
use crate::demo;
use crate::error::Result;
use crate::evaluate;
use crate::image::{Image, bands};
use crate::render::Renderer;
use organza_device::memory;

/// `views` images of `side` pixels around the built-in scene, of which every `hold_out_every`-th is held out.
///
/// # Errors
/// As [`Renderer::render`].
pub fn dataset(
    renderer: &Renderer,
    views: u32,
    side: u32,
    hold_out_every: usize,
    progress: &dyn Fn(usize, usize),
) -> Result<Dataset> {
    let pixels = u64::from(views) * u64::from(side) * u64::from(side);
    memory::check(3 * pixels, "the views of the built-in scene")?;
    let scene = renderer.upload(&demo::scene())?;
    let cameras = demo::turntable(views as usize, side);
    let mut frames = Vec::with_capacity(cameras.len());
    for (index, camera) in cameras.iter().enumerate() {
        progress(index, cameras.len());
        let mut image = Image::new(side, side)?;
        for batch in bands(index, [side, side], evaluate::TILE_SIDE) {
            let batch = batch?;
            image.paste(&batch, &renderer.render(&scene, &cameras, &batch)?)?;
        }
        let (name, image) = (name(index), Photograph::from(&image));
        frames.push(Frame { name, camera: camera.clone(), image });
    }
    progress(cameras.len(), cameras.len());
    Ok(Dataset::from_frames(frames, hold_out_every))
}

/// The cameras of [`dataset`], without the images.
#[must_use]
pub fn cameras(views: u32, side: u32, hold_out_every: usize) -> Vec<Pose> {
    let cameras = demo::turntable(views as usize, side).into_iter().enumerate();
    let pose = |(index, camera)| Pose {
        camera: Camera { file_path: Some(name(index)), ..camera },
        held_out: is_held_out(index, hold_out_every),
        photograph: None,
    };
    cameras.map(pose).collect()
}

fn name(index: usize) -> String {
    format!("view-{index:03}")
}

/// What the built-in scene is in front of.
#[must_use]
pub fn background() -> [f64; 3] {
    demo::BACKGROUND
}
