//! Data sets.

use std::path::{PathBuf, absolute};
use std::sync::Arc;

use numpy::ndarray::Array3;
use numpy::{IntoPyArray, PyArray3};
use organza::data::{Background, DatasetOptions, Frame};
use organza::train::built_in;
use organza::train::config::DataConfig;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

use crate::cameras::Cameras;
use crate::error::raise;
use crate::job;
use crate::renderer::Renderer;
use crate::scene::Scene;

/// Photographs with poses.
#[pyclass(frozen, module = "organza")]
pub struct Dataset {
    pub dataset: Arc<organza::Dataset>,
    /// Settings with which it was read.
    pub data: DataConfig,
}

#[pymethods]
impl Dataset {
    #[staticmethod]
    #[pyo3(signature = (path, downscale, hold_out_every, background, allow_outside, scene))]
    fn load(
        py: Python<'_>,
        path: PathBuf,
        downscale: u32,
        hold_out_every: usize,
        background: Option<[f32; 3]>,
        allow_outside: bool,
        scene: Option<&Scene>,
    ) -> PyResult<Self> {
        let mut data = DataConfig::default();
        data.path = Some(absolute(&path).unwrap_or(path));
        data.downscale = downscale;
        data.hold_out_every = hold_out_every;
        data.background = background.map_or(Background::Auto, Background::Color);
        data.allow_outside = allow_outside;
        let options = DatasetOptions {
            trained_on: scene.and_then(|scene| scene.0.config.trained_on.clone()),
            ..data.options()
        };
        Self::open(py, data, options, None)
    }

    #[staticmethod]
    fn built_in(
        py: Python<'_>,
        renderer: &Renderer,
        views: u32,
        side: u32,
        hold_out_every: usize,
    ) -> PyResult<Self> {
        let mut data = DataConfig::default();
        data.built_in_views = views;
        data.built_in_side = side;
        data.hold_out_every = hold_out_every;
        let options = data.options();
        Self::open(py, data, options, Some(&renderer.0))
    }

    /// Pixels of a photograph as bytes, `[H, W, 3]`.
    fn image<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let Some(frame) = self.dataset.frames.get(index) else {
            let reason = format!("there are {} photographs", self.dataset.frames.len());
            return Err(PyIndexError::new_err(reason));
        };
        let image = &frame.image;
        let shape = (image.height() as usize, image.width() as usize, 3);
        let pixels = image.pixels().as_flattened().to_vec();
        Ok(Array3::from_shape_vec(shape, pixels).expect("its own size").into_pyarray(py))
    }

    #[getter]
    fn cameras(&self) -> Cameras {
        let organza::Dataset { frames, poses, .. } = &*self.dataset;
        let world = |(frame, &camera_to_world): (&Frame, &[[f64; 4]; 4])| organza::Camera {
            camera_to_world,
            ..frame.camera.clone()
        };
        Cameras(frames.iter().zip(poses).map(world).collect())
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.dataset.frames.iter().map(|frame| frame.name.clone()).collect()
    }

    #[getter]
    fn train(&self) -> Vec<usize> {
        self.dataset.train.clone()
    }

    #[getter]
    fn held_out(&self) -> Vec<usize> {
        self.dataset.held_out.clone()
    }

    #[getter]
    fn background(&self) -> [f64; 3] {
        self.dataset.background
    }

    /// Photographs in the data set whose files do not exist.
    #[getter]
    fn missing(&self) -> Vec<PathBuf> {
        self.dataset.missing.clone()
    }

    /// Warnings about the data set.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.dataset.notes.clone()
    }

    fn __len__(&self) -> usize {
        self.dataset.frames.len()
    }

    fn __repr__(&self) -> String {
        let held_out = self.dataset.held_out.len();
        format!("<organza.Dataset: {} photographs, {held_out} held out>", self.__len__())
    }
}

impl Dataset {
    /// Reads a data set according to the settings and the options made of them. Photographs of the built-in scene are rendered.
    pub fn open(
        py: Python<'_>,
        data: DataConfig,
        options: DatasetOptions,
        renderer: Option<&organza::Renderer>,
    ) -> PyResult<Self> {
        let dataset = match (data.path.clone(), renderer.cloned()) {
            (Some(path), _) => job::run(py, move || organza::Dataset::load(path, &options))?,
            (None, Some(renderer)) => {
                let views = data.built_in_views;
                let side = data.built_in_side;
                let every = data.hold_out_every;
                job::run(py, move || built_in::dataset(&renderer, views, side, every))?
            }
            (None, None) => {
                let reason = "the data set has no path".to_owned();
                return Err(raise(organza::Error::Argument { reason }));
            }
        };
        Ok(Self { dataset: Arc::new(dataset), data })
    }
}
