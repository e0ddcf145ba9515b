//! Images of the built-in scene: training data without a download.

use muslin_device::memory;
use organza_core::{Camera, Result, demo};
use organza_data::{Dataset, Frame, Photograph, Pose};
use organza_render::Renderer;

use super::config::DataConfig;

/// `views` images of `side` x `side` pixels around the built-in scene. Every `hold_out_every`-th is held out.
///
/// # Errors
/// The same errors as [`Renderer::render`].
pub fn dataset(
    renderer: &Renderer,
    views: u32,
    side: u32,
    hold_out_every: usize,
) -> Result<Dataset> {
    let data = DataConfig {
        built_in_views: views,
        built_in_side: side,
        hold_out_every,
        ..DataConfig::default()
    };
    part(renderer, &data, &|_| true, &mut |_, _| {})
}

/// [`dataset`] by settings, but with only the views for which `takes` is true. Its argument is whether the view is held out.
/// `progress` is called with the number of finished views and of all views.
///
/// # Errors
/// The same errors as [`dataset`].
pub fn part(
    renderer: &Renderer,
    data: &DataConfig,
    takes: &dyn Fn(bool) -> bool,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Dataset> {
    let side = u64::from(data.built_in_side);
    let pixels = u64::from(data.built_in_views) * side * side;
    memory::check(3 * pixels, "the views of the built-in scene")?;
    let scene = renderer.upload(&demo::scene())?;
    let mut poses = cameras(data);
    poses.retain(|pose| takes(pose.held_out));
    let mut frames = Vec::with_capacity(poses.len());
    for (index, Pose { camera, .. }) in poses.iter().enumerate() {
        progress(index, poses.len());
        let image = Photograph::from(&renderer.render_view(&scene, camera)?);
        let name = camera.file_path.clone().unwrap_or_default();
        frames.push(Frame { name, camera: Camera { file_path: None, ..camera.clone() }, image });
    }
    progress(poses.len(), poses.len());
    let mut dataset = Dataset::split(frames, |at| poses[at].held_out);
    dataset.background = demo::BACKGROUND;
    Ok(dataset)
}

/// The cameras of [`dataset`], without the images.
#[must_use]
pub fn cameras(data: &DataConfig) -> Vec<Pose> {
    let options = data.options();
    let cameras = demo::turntable(data.built_in_views as usize, data.built_in_side);
    let pose = |(index, camera)| Pose {
        held_out: options.holds_out(index),
        ..Pose::from(Camera { file_path: Some(name(index)), ..camera })
    };
    cameras.into_iter().enumerate().map(pose).collect()
}

fn name(index: usize) -> String {
    format!("view-{index:03}")
}
