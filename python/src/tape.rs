//! Recorded batches, and their gradients.

use std::sync::Arc;

use numpy::{
    IntoPyArray, PyArray2, PyArray4, PyArrayMethods, PyReadonlyArray4, PyUntypedArrayMethods,
};
use organza::RenderedTiles;
use organza::render::{POSE, SceneGradient};
use parking_lot::Mutex;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::invalid;
use crate::job;
use crate::scene::into_arrays;

/// A scene on a device, with data that belongs to it.
pub struct SceneOnDevice {
    pub scene: organza::DeviceScene,
    /// Created by the first backward pass.
    pub gradient: Option<SceneGradient>,
}

/// A rendered batch that keeps what its gradient needs: `Renderer.record` makes one.
#[pyclass(frozen, weakref, module = "organza")]
pub struct Tape {
    pub renderer: organza::Renderer,
    pub held: Arc<Mutex<SceneOnDevice>>,
    pub tape: Arc<Mutex<organza::Tape>>,
    #[pyo3(get)]
    pub shape: [usize; 4],
    pub cameras: usize,
}

#[pymethods]
impl Tape {
    /// The tiles Y `[K, 3, S, S]`, and a dictionary of the requested channels, `[K, planes, S, S]`.
    fn tiles<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyArray4<f32>>, Bound<'py, PyDict>)> {
        into_batch(py, py.detach(|| self.tape.lock().tiles().clone()))
    }

    /// The gradient of a loss L with respect to every tensor, by name, given `grad_tiles [K, 3, S, S]`, dL/dY. Nothing is
    /// rendered again.
    ///
    /// Raises `ValueError` if the shape differs or the scene has been written to since, and `organza.Error` if a
    /// gradient is not finite.
    fn backward<'py>(
        &self,
        py: Python<'py>,
        grad_tiles: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let grad_tiles = self.values(grad_tiles)?;
        let held = Arc::clone(&self.held);
        let renderer = self.renderer.clone();
        let tape = Arc::clone(&self.tape);
        let values = job::run(py, move || {
            let held = &mut *held.lock();
            let device = renderer.device();
            let gradient = match held.gradient.take() {
                Some(gradient) => gradient,
                None => SceneGradient::new(device, &held.scene)?,
            };
            let gradient = held.gradient.insert(gradient);
            tape.lock().backward_into(gradient, &grad_tiles)?;
            Ok(gradient.download(device, held.scene.config(), held.scene.len())?.into_values())
        })?;
        into_arrays(py, values)
    }

    /// Like `backward`, with the gradients of the cameras' poses `[C, 6]`: by a rotation vector w in radians, then by a
    /// shift v in world units, in the camera's space with OpenCV's axes. A point t moves to `exp([w]x) t + v`, and both
    /// are 0. The networks see the camera's center as a constant.
    fn backward_with_poses<'py>(
        &self,
        py: Python<'py>,
        grad_tiles: &Bound<'py, PyAny>,
    ) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyArray2<f32>>)> {
        let grad_tiles = self.values(grad_tiles)?;
        let held = Arc::clone(&self.held);
        let renderer = self.renderer.clone();
        let tape = Arc::clone(&self.tape);
        let cameras = self.cameras;
        let (values, poses) = job::run(py, move || {
            let held = &*held.lock();
            let device = renderer.device();
            let gradient = SceneGradient::new(device, &held.scene)?.with_poses(device, cameras)?;
            tape.lock().backward_into(&gradient, &grad_tiles)?;
            let config = held.scene.config();
            let values = gradient.download(device, config, held.scene.len())?.into_values();
            let mut poses = gradient.read_poses(device)?;
            // a shift in world units is a smaller or larger one in the scene
            for slope in poses.iter_mut().flat_map(|pose| &mut pose[3..]) {
                *slope /= config.placement.scale as f32;
            }
            Ok((values, poses))
        })?;
        let poses = poses.into_flattened().into_pyarray(py).reshape([self.cameras, POSE])?;
        Ok((into_arrays(py, values)?, poses))
    }

    /// Frees the recorded data. `backward` then renders again.
    fn release(&self, py: Python<'_>) {
        py.detach(|| self.tape.lock().release());
    }
}

impl Tape {
    /// The values of `grad_tiles [K, 3, S, S]`, dL/dY, checked.
    fn values(&self, grad_tiles: &Bound<'_, PyAny>) -> PyResult<Vec<f32>> {
        let numpy = grad_tiles.py().import("numpy")?;
        let grad_tiles = numpy.call_method1("ascontiguousarray", (grad_tiles, "float32"))?;
        let Ok(grad_tiles) = grad_tiles.extract::<PyReadonlyArray4<'_, f32>>() else {
            return Err(invalid(format!("the gradient must be {:?}", self.shape)));
        };
        if grad_tiles.shape() != self.shape {
            let found = grad_tiles.shape();
            let expected = self.shape;
            return Err(invalid(format!("the gradient is {found:?}, expected {expected:?}")));
        }
        Ok(grad_tiles.as_slice()?.to_vec())
    }
}

/// Tiles `[K, 3, S, S]` as an array, and their channels by name.
pub fn into_batch(
    py: Python<'_>,
    tiles: RenderedTiles,
) -> PyResult<(Bound<'_, PyArray4<f32>>, Bound<'_, PyDict>)> {
    let count = tiles.count;
    let side = tiles.side as usize;
    let channels = PyDict::new(py);
    for (channel, values) in tiles.channels {
        let shape = [count, channel.planes(), side, side];
        channels.set_item(channel.name(), values.into_pyarray(py).reshape(shape)?)?;
    }
    Ok((tiles.data.into_pyarray(py).reshape([count, 3, side, side])?, channels))
}
