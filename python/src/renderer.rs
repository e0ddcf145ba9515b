//! Renderers, and scenes on their devices.

use std::collections::HashMap;
use std::sync::Arc;

use numpy::PyArray4;
use organza::{BackendChoice, Channel, DeviceOptions};
use parking_lot::Mutex;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::cameras::{Cameras, Tiles};
use crate::error::{invalid, raise};
use crate::job;
use crate::scene::{Scene, array};
use crate::tape::{SceneOnDevice, Tape, into_batch};

/// Renders on a device.
#[pyclass(frozen, subclass, module = "organza._organza")]
pub struct Renderer(pub organza::Renderer);

/// A scene on a device: `Renderer.upload` makes one.
#[pyclass(frozen, module = "organza")]
pub struct DeviceScene {
    renderer: organza::Renderer,
    held: Arc<Mutex<SceneOnDevice>>,
    gaussians: usize,
}

#[pymethods]
impl Renderer {
    #[new]
    #[pyo3(signature = (backend = "auto", threads = None, adapter = None, place = 0))]
    fn new(
        py: Python<'_>,
        backend: &str,
        threads: Option<usize>,
        adapter: Option<String>,
        place: usize,
    ) -> PyResult<Self> {
        let backend = match backend {
            "auto" => BackendChoice::Auto,
            "gpu" => BackendChoice::Gpu,
            "cpu" => BackendChoice::Cpu,
            other => {
                let reason =
                    format!("there is no backend `{other}`; expected `auto`, `gpu` or `cpu`");
                return Err(invalid(reason));
            }
        };
        if threads == Some(0) {
            return Err(invalid("`threads` is 0, expected at least 1"));
        }
        let options = DeviceOptions::default().backend(backend).threads(threads);
        let options = options.adapter(adapter).place(place);
        job::run(py, move || organza::open_device(&options).map(organza::Renderer::new)).map(Self)
    }

    #[getter]
    fn device(&self) -> &str {
        self.0.device().choice()
    }

    fn upload(&self, py: Python<'_>, scene: &Scene) -> PyResult<DeviceScene> {
        let renderer = self.0.clone();
        let scene = Arc::clone(&scene.0);
        let gaussians = scene.gaussians.len();
        let uploaded = job::run(py, move || renderer.upload(&scene))?;
        let held = Arc::new(Mutex::new(SceneOnDevice { scene: uploaded, gradient: None }));
        Ok(DeviceScene { renderer: self.0.clone(), held, gaussians })
    }

    /// Renders Y `[K, 3, S, S]`, and the requested channels.
    fn render_tiles<'py>(
        &self,
        py: Python<'py>,
        scene: &DeviceScene,
        cameras: &Cameras,
        tiles: &Tiles,
        channels: Vec<String>,
    ) -> PyResult<(Bound<'py, PyArray4<f32>>, Bound<'py, PyDict>)> {
        let held = self.own(scene)?;
        let renderer = self.0.clone();
        let cameras = Cameras(cameras.0.clone());
        let batch = tiles.0.clone();
        let channels = channels_of(&channels)?;
        let rendered = job::run(py, move || {
            let scene = &held.lock().scene;
            let cameras = cameras.in_scene(scene.config());
            renderer.render_channels(scene, &cameras, &batch, &channels, &mut |_, _| {})
        })?;
        into_batch(py, rendered)
    }

    fn record(
        &self,
        py: Python<'_>,
        scene: &DeviceScene,
        cameras: &Cameras,
        tiles: &Tiles,
        channels: Vec<String>,
    ) -> PyResult<Tape> {
        let held = self.own(scene)?;
        let renderer = self.0.clone();
        let cameras = Cameras(cameras.0.clone());
        let batch = tiles.0.clone();
        let shape = batch.output_shape();
        let number = cameras.0.len();
        let channels = channels_of(&channels)?;
        let tape = job::run(py, move || {
            let scene = &held.lock().scene;
            let cameras = cameras.in_scene(scene.config());
            renderer.record_channels(scene, &cameras, &batch, &channels)
        })?;
        let renderer = self.0.clone();
        let held = Arc::clone(&scene.held);
        let tape = Arc::new(Mutex::new(tape));
        Ok(Tape { renderer, held, tape, shape, cameras: number })
    }
}

impl Renderer {
    /// The scene, which must be on this device.
    pub fn own(&self, scene: &DeviceScene) -> PyResult<Arc<Mutex<SceneOnDevice>>> {
        if !std::ptr::eq(self.0.device(), scene.renderer.device()) {
            return Err(invalid("the scene is on another renderer's device: upload it here"));
        }
        Ok(Arc::clone(&scene.held))
    }
}

#[pymethods]
impl DeviceScene {
    /// Replaces the values of tensors, given by name, in place. Tapes of the old scene have no gradient anymore.
    ///
    /// Raises `ValueError` if a tensor is unknown, of another shape or not finite. Tensors before it are written
    /// then.
    fn write(&self, py: Python<'_>, tensors: HashMap<String, Bound<'_, PyAny>>) -> PyResult<()> {
        let specs = py.detach(|| self.held.lock().scene.config().tensors(self.gaussians));
        for (name, value) in tensors {
            let Some(spec) = specs.iter().find(|spec| spec.name == name) else {
                return Err(invalid(format!("a scene has no tensor `{name}`")));
            };
            let array = array(spec, &value)?;
            let values = array.as_slice()?;
            let device = self.renderer.device();
            let write = || self.held.lock().scene.write(device, &name, values);
            py.detach(write).map_err(raise)?;
        }
        Ok(())
    }

    /// Copies the current scene from the device.
    fn download(&self, py: Python<'_>) -> PyResult<Scene> {
        let held = Arc::clone(&self.held);
        let renderer = self.renderer.clone();
        job::run(py, move || held.lock().scene.download(renderer.device())).map(Scene::new)
    }

    fn __len__(&self) -> usize {
        self.gaussians
    }
}

fn channels_of(names: &[String]) -> PyResult<Vec<Channel>> {
    let channel = |name: &String| {
        let found = Channel::ALL.into_iter().find(|channel| channel.name() == name);
        found.ok_or_else(|| {
            let names = Channel::ALL.map(Channel::name).join("`, `");
            invalid(format!("there is no channel `{name}`; expected `{names}`"))
        })
    };
    names.iter().map(channel).collect()
}
