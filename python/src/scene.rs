//! Scenes, and their tensors as numpy arrays.

use std::path::PathBuf;
use std::sync::Arc;

use numpy::ndarray::{ArrayViewD, ArrayViewMutD};
use numpy::{PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use organza::DeviceOptions;
use organza::camera::Orbit;
use organza::scene::{SceneConfig, TensorSpec};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};

use crate::error::{invalid, raise};
use crate::job;

/// Width and height of a scene's picture in a notebook, in pixels.
const PICTURE: [u32; 2] = [360, 270];

/// A scene in the host's memory: N Gaussians and the two fields of color and transmittance. It never changes;
/// `from_tensors` makes a new one.
#[pyclass(frozen, module = "organza")]
pub struct Scene(pub Arc<organza::Scene>);

#[pymethods]
impl Scene {
    /// Reads a scene file (safetensors), or the scene in the folder of a training run.
    ///
    /// Raises `FileNotFoundError`, `ValueError` for a file that is damaged or no scene, and `MemoryError`.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let file = if path.is_dir() { path.join(organza::train::CHECKPOINT) } else { path };
        job::run(py, move || organza::Scene::load(file)).map(Self::new)
    }

    /// The built-in scene, which needs no file.
    #[staticmethod]
    fn built_in(py: Python<'_>) -> PyResult<Self> {
        job::run(py, || Ok(organza::demo::scene())).map(Self::new)
    }

    /// Makes a scene from arrays, which are copied as `float32`. Names are those in a scene file: `gaussians.position
    /// [N, 3]` in world units, `gaussians.rotation [N, 4]` (quaternions w x y z, not normalized),
    /// `gaussians.log_scale [N, 3]` (natural logarithms), `gaussians.opacity [N]` (logits), `gaussians.material`,
    /// `gaussians.extra`, where `slope` is 9 `gaussians.slope [N, 9]`, where `shape` is 1 `gaussians.shape [N, 1]`, and for each
    /// field a `grid` and the `mlp`.
    ///
    /// `config` is the scene's configuration, as a dictionary like `Scene.config` or as JSON. Raises `ValueError` if
    /// a tensor is missing, unknown, of another shape or not finite.
    #[staticmethod]
    fn from_tensors(tensors: &Bound<'_, PyDict>, config: &Bound<'_, PyAny>) -> PyResult<Self> {
        let config = read_config(config)?;
        let Some(position) = tensors.get_item("gaussians.position")? else {
            return Err(invalid("tensor `gaussians.position` is missing"));
        };
        let mut scene = organza::Scene::zeros(config, position.len()?).map_err(raise)?;
        let mut used = 0;
        for (spec, target) in scene.tensors_mut() {
            let Some(value) = tensors.get_item(&spec.name)? else {
                spec.check_shape(None).map_err(raise)?;
                continue;
            };
            target.copy_from_slice(array(&spec, &value)?.as_slice()?);
            used += 1;
        }
        if used < tensors.len() {
            let specs = scene.config.tensors(0);
            for name in tensors.keys() {
                let name: String = name.extract()?;
                if specs.iter().all(|spec| spec.name != name) {
                    return Err(invalid(format!("a scene has no tensor `{name}`")));
                }
            }
        }
        scene.validate().map_err(raise)?;
        Ok(Self::new(scene))
    }

    /// Writes a scene file. An old file of that name is kept until the new one is complete.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let scene = Arc::clone(&self.0);
        job::run(py, move || scene.save(path))
    }

    /// Every tensor by name, `float32`. The arrays are the scene's own memory, so they are read-only.
    ///
    /// Positions and scales are in the scene's own coordinates. `config["placement"]` says where these lie in the world:
    /// `world = offset + scale R own`, where R has the columns right, up x right and up. A scene without one lies where it is.
    fn tensors<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(slf.py());
        for (spec, values) in slf.get().0.tensors() {
            let view = ArrayViewD::from_shape(&spec.shape[..], values).expect("its own shape");
            // SAFETY: the array keeps the scene alive, which never changes, and cannot be written to
            let array = unsafe { PyArrayDyn::borrow_from_array(&view, slf.clone().into_any()) };
            array.call_method1("setflags", (false,))?;
            dict.set_item(spec.name, array)?;
        }
        Ok(dict)
    }

    /// The configuration, as a new dictionary.
    #[getter]
    fn config<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        json(py, &serde_json::to_string(&self.0.config).expect("numbers and strings"))
    }

    fn __len__(&self) -> usize {
        self.0.gaussians.len()
    }

    /// The picture for a notebook: the scene from outside, as PNG.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyBytes>>> {
        let scene = Arc::clone(&self.0);
        let png = job::run(py, move || {
            let Ok(cameras) = Orbit::from_box(scene.visible_box(), PICTURE).cameras(1) else {
                return Ok(None);
            };
            let renderer = organza::Renderer::new(organza::open_device(&DeviceOptions::default())?);
            Ok(renderer.render_view(&renderer.upload(&scene)?, &cameras[0])?.encode_png().ok())
        })?;
        Ok(png.map(|png| PyBytes::new(py, &png)))
    }

    fn __repr__(&self) -> String {
        let values: usize = self.0.tensors().iter().map(|(_, values)| values.len()).sum();
        format!("<organza.Scene: {} Gaussians, {values} values>", self.0.gaussians.len())
    }
}

impl Scene {
    pub fn new(scene: organza::Scene) -> Self {
        Self(Arc::new(scene))
    }
}

/// A configuration: a dictionary, or its JSON.
fn read_config(config: &Bound<'_, PyAny>) -> PyResult<SceneConfig> {
    let text: String = match config.cast::<PyString>() {
        Ok(text) => text.extract()?,
        Err(_) => config.py().import("json")?.call_method1("dumps", (config,))?.extract()?,
    };
    SceneConfig::from_json(&text, "").map_err(raise)
}

/// Parses JSON into a Python object.
fn json<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (text,))
}

/// Anything like an array as `f32`, row-major. It is only copied if it is not that already.
pub fn array<'py>(
    spec: &TensorSpec,
    value: &Bound<'py, PyAny>,
) -> PyResult<PyReadonlyArrayDyn<'py, f32>> {
    let numpy = value.py().import("numpy")?;
    let value = numpy.call_method1("ascontiguousarray", (value, "float32"))?;
    let array: PyReadonlyArrayDyn<'py, f32> = value.extract()?;
    // numpy turns a number into [1]
    if !(spec.values() == 1 && array.len() == 1) {
        spec.check_shape(Some(array.shape())).map_err(raise)?;
    }
    Ok(array)
}

/// Keeps the memory of arrays alive.
#[pyclass(module = "organza")]
struct Values(organza::Scene);

/// A scene's values as writable arrays, without copies.
pub fn into_arrays(py: Python<'_>, values: organza::Scene) -> PyResult<Bound<'_, PyDict>> {
    let values = Bound::new(py, Values(values))?;
    let dict = PyDict::new(py);
    for (spec, tensor) in values.borrow_mut().0.tensors_mut() {
        let view = ArrayViewMutD::from_shape(&spec.shape[..], tensor).expect("its own shape");
        // SAFETY: the array keeps `values` alive, and nothing else uses it
        let array = unsafe { PyArrayDyn::borrow_from_array(&view, values.clone().into_any()) };
        dict.set_item(spec.name, array)?;
    }
    Ok(dict)
}
