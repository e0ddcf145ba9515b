//! A scene on a device, and tiles from there.

use std::sync::{Mutex, MutexGuard, PoisonError};

use numpy::{IntoPyArray, PyArray4, PyArrayMethods};
use organza::RenderedTiles;
use organza::render::SceneGradient;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A scene on a device, with data that belongs to it.
pub struct SceneOnDevice {
    pub scene: organza::DeviceScene,
    /// Created by the first backward pass.
    pub gradient: Option<SceneGradient>,
}

/// Locks, also after a panic.
pub fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
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
