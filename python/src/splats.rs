//! Files of programs that sort Gaussians.

use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::sync::Arc;

use organza::data::Background;
use organza::splats::{self, Fit, Format, Import, Views};
use organza_core::check_writable;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::cameras::Cameras;
use crate::data::Dataset;
use crate::error::{invalid, raise};
use crate::job;
use crate::renderer::{DeviceScene, Renderer};
use crate::scene::Scene;

/// Writes a scene as Gaussians. `uploaded` is the scene on the renderer's device.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the package names them")]
pub fn export<'py>(
    py: Python<'py>,
    renderer: &Renderer,
    scene: &Scene,
    uploaded: &DeviceScene,
    path: PathBuf,
    cameras: Option<&Cameras>,
    dataset: Option<&Dataset>,
    steps: i64,
    side: i64,
    spz_version: i64,
) -> PyResult<Bound<'py, PyDict>> {
    let fit =
        Fit { steps: within("steps", steps, Fit::STEPS)?, side: within("side", side, Fit::SIDES)? };
    let format = match (Format::from_path(&path).map_err(raise)?, spz_version) {
        (Format::Spz, 2) => Format::Spz2,
        (format, 4) => format,
        _ => {
            let reason = format!("`spz_version` is {spz_version}, expected 4, or 2 for an .spz");
            return Err(invalid(reason));
        }
    };
    check_writable(&path).map_err(raise)?;
    let held = renderer.own(uploaded)?;
    let renderer = renderer.0.clone();
    let scene = Arc::clone(&scene.0);
    let dataset = dataset.map(|data| Arc::clone(&data.dataset));
    let cameras = cameras.map(|cameras| cameras.in_scene(&scene.config));
    let (psnr, gaussians, first_psnr, beside, offset) =
        job::run_while_awaited(py, move |awaited| {
            let placement = scene.config.placement;
            let dataset = dataset.map(|data| {
                let split = scene.config.trained_on.as_ref().and_then(|known| data.split_as(known));
                if data.placement == placement && split.is_none() {
                    return data;
                }
                let mut data = organza::Dataset::clone(&data).placed(placement);
                if let Some([train, held_out]) = split {
                    data.train = train;
                    data.held_out = held_out;
                }
                Arc::new(data)
            });
            let views = match (cameras, &dataset) {
                (Some(cameras), _) => Views::from_cameras(cameras),
                (None, Some(data)) => Views::from_data_set(data),
                (None, None) => Views::around(scene.visible_box())?,
            };
            let uploaded = &held.lock().scene;
            let mut check_signals = |_| awaited();
            let found =
                splats::distill(&renderer, &scene, uploaded, &views, fit, &mut check_signals)?;
            let frames: Vec<_> = dataset.iter().flat_map(|data| data.held_out_frames()).collect();
            awaited()?;
            let up = placement.upward(&[&views.fitted[..], &views.held_out].concat());
            let (written, offset) =
                splats::save_scene(&found.splats, &path, format, up, &placement)?;
            let beside = splats::compare_splats(&renderer, uploaded, &written, &frames)?;
            Ok((found.psnr_of(&written), written.len(), found.first_psnr, beside, offset))
        })?;
    let dict = PyDict::new(py);
    dict.set_item("gaussians", gaussians)?;
    dict.set_item("offset", offset.unwrap_or_default())?;
    dict.set_item("psnr", psnr)?;
    dict.set_item("first_psnr", first_psnr)?;
    dict.set_item("scene_psnr", beside.map(|beside| beside.scene))?;
    dict.set_item("file_psnr", beside.map(|beside| beside.splats))?;
    Ok(dict)
}

/// Makes a scene from a file of Gaussians. Returns the PSNR between its images and the file's, in dB, and warnings.
#[pyfunction]
pub fn import_splats(
    py: Python<'_>,
    renderer: &Renderer,
    path: PathBuf,
    cameras: Option<&Cameras>,
    steps: i64,
    side: i64,
    background: &str,
) -> PyResult<(Scene, Option<f64>, Vec<String>)> {
    let steps = within("steps", steps, Import::STEPS)?;
    let side = within("side", side, Fit::SIDES)?;
    let background = background.parse::<Background>();
    let background =
        background.map_err(|reason| invalid(format!("`background`: {reason}")))?.color();
    let renderer = renderer.0.clone();
    let cameras = cameras.map(|cameras| cameras.0.clone());
    let imported = job::run_while_awaited(py, move |awaited| {
        let file = splats::load(path)?;
        let views = match cameras {
            Some(cameras) => Views::from_cameras(cameras),
            None => file.views()?,
        };
        let options = Import { steps, side, background };
        splats::import(&renderer, file, &views, options, &mut |_| awaited())
    })?;
    Ok((Scene::new(imported.scene), imported.psnr, imported.notes))
}

fn within(name: &str, value: i64, range: RangeInclusive<i64>) -> PyResult<u32> {
    if range.contains(&value) {
        return Ok(value as u32);
    }
    let (min, max) = range.into_inner();
    Err(invalid(format!("`{name}` is {value}, expected {min} to {max}")))
}
