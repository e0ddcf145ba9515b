//! Cameras and batches of tiles.

use std::path::PathBuf;

use numpy::ndarray::{Array2, Array3};
use numpy::{IntoPyArray, PyArray2, PyArray3, PyReadonlyArray2, PyReadonlyArray3};
use organza::camera::MAX_IMAGE_SIDE;
use organza::data::{DatasetOptions, Poses};
use organza::scene::{Placement, SceneConfig};
use pyo3::prelude::*;

use crate::error::{invalid, raise};

/// Pinhole cameras, in the world.
#[pyclass(frozen, module = "organza")]
pub struct Cameras(pub Vec<organza::Camera>);

#[pymethods]
impl Cameras {
    /// The cameras of a file, or of a data set's folder.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        if !path.is_dir() {
            return organza::Camera::load_all(path).map(Self).map_err(raise);
        }
        let world = Some(Placement::default());
        let options = DatasetOptions { placement: world, ..DatasetOptions::default() };
        let poses = Poses::load(&path, &options).and_then(|poses| poses.cameras());
        Ok(Self(poses.map_err(raise)?.into_iter().map(|pose| pose.camera).collect()))
    }

    fn save(&self, path: PathBuf) -> PyResult<()> {
        organza::Camera::save_all(path, &self.0).map_err(raise)
    }

    #[staticmethod]
    fn turntable(views: usize, side: u32) -> PyResult<Self> {
        if !(1..=100_000).contains(&views) || !(1..=MAX_IMAGE_SIDE).contains(&side) {
            return Err(invalid(format!(
                "expected 1 to 100,000 views, and a side of 1 to {MAX_IMAGE_SIDE} pixels"
            )));
        }
        Self(organza::demo::turntable(views, side)).checked()
    }

    /// `poses [C, 4, 4]`: camera to world, x right, y up, looking along -z; `ks [C, 3, 3]`.
    #[staticmethod]
    fn from_poses(
        poses: PyReadonlyArray3<'_, f64>,
        ks: PyReadonlyArray3<'_, f64>,
        width: u32,
        height: u32,
    ) -> PyResult<Self> {
        let poses = poses.as_array();
        let ks = ks.as_array();
        let camera = |(pose, k): (numpy::ndarray::ArrayView2<'_, f64>, _)| {
            let k: numpy::ndarray::ArrayView2<'_, f64> = k;
            let pose = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|at| pose[[row, at]]));
            let focal = [k[[0, 0]], k[[1, 1]]];
            organza::Camera::pinhole(pose, focal, [k[[0, 2]], k[[1, 2]]], [width, height])
        };
        Self(poses.outer_iter().zip(ks.outer_iter()).map(camera).collect()).checked()
    }

    /// Camera to world, `[C, 4, 4]`.
    fn poses<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray3<f64>> {
        let value = |(camera, row, column): (usize, usize, usize)| {
            self.0[camera].camera_to_world[row][column]
        };
        Array3::from_shape_fn((self.0.len(), 4, 4), value).into_pyarray(py)
    }

    /// Intrinsics, `[C, 3, 3]`.
    fn intrinsics<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray3<f64>> {
        let value = |(camera, row, column): (usize, usize, usize)| {
            let camera = &self.0[camera];
            let rows =
                [[camera.fl_x, 0.0, camera.cx], [0.0, camera.fl_y, camera.cy], [0.0, 0.0, 1.0]];
            rows[row][column]
        };
        Array3::from_shape_fn((self.0.len(), 3, 3), value).into_pyarray(py)
    }

    /// Width and height of each camera's image, in pixels.
    fn sizes(&self) -> Vec<(u32, u32)> {
        self.0.iter().map(|camera| (camera.width, camera.height)).collect()
    }

    fn names(&self) -> Vec<Option<String>> {
        self.0.iter().map(|camera| camera.file_path.clone()).collect()
    }

    /// The cameras with these indices.
    fn select(&self, indices: Vec<usize>) -> Self {
        Self(indices.into_iter().map(|index| self.0[index].clone()).collect())
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }
}

impl Cameras {
    /// The cameras in a scene's coordinates. Here they have the world's.
    pub fn in_scene(&self, config: &SceneConfig) -> Vec<organza::Camera> {
        self.0.iter().map(|camera| config.placement.own_camera(camera)).collect()
    }

    fn checked(self) -> PyResult<Self> {
        for (index, camera) in self.0.iter().enumerate() {
            camera.validate(index).map_err(raise)?;
        }
        Ok(self)
    }
}

/// A batch of square tiles.
#[pyclass(frozen, module = "organza")]
pub struct Tiles(pub organza::TileBatch);

#[pymethods]
impl Tiles {
    /// `tiles [K, 3]` has the camera, and x and y of the upper left corner.
    #[new]
    fn new(side: u32, tiles: PyReadonlyArray2<'_, i64>) -> PyResult<Self> {
        let tile = |(index, row): (usize, numpy::ndarray::ArrayView1<'_, i64>)| {
            let numbers = (usize::try_from(row[0]), i32::try_from(row[1]), i32::try_from(row[2]));
            let (Ok(camera), Ok(x), Ok(y)) = numbers else {
                return Err(invalid(format!("tile {index} is {row}: a number is out of range")));
            };
            Ok(organza::Tile { camera, origin: [x, y] })
        };
        let tiles = tiles.as_array();
        let tiles = tiles.outer_iter().enumerate().map(tile).collect::<PyResult<_>>()?;
        Ok(Self(organza::TileBatch { side, tiles }))
    }

    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        organza::TileBatch::load(path).map(Self).map_err(raise)
    }

    fn save(&self, path: PathBuf) -> PyResult<()> {
        self.0.save(path).map_err(raise)
    }

    /// Tiles that cover the images of cameras, one camera after the other, row by row.
    #[staticmethod]
    fn cover(cameras: &Cameras, side: u32) -> PyResult<Self> {
        let mut tiles = Vec::new();
        for (index, camera) in cameras.0.iter().enumerate() {
            let batch = organza::TileBatch::cover(index, camera.width, camera.height, side);
            tiles.extend(batch.map_err(raise)?.tiles);
        }
        let batch = organza::TileBatch { side, tiles };
        batch.validate(&cameras.0).map_err(raise)?;
        Ok(Self(batch))
    }

    /// Camera, and x and y of the upper left corner, `[K, 3]`.
    fn array<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i64>> {
        let value = |(index, column): (usize, usize)| {
            let tile = &self.0.tiles[index];
            [tile.camera as i64, tile.origin[0].into(), tile.origin[1].into()][column]
        };
        Array2::from_shape_fn((self.0.tiles.len(), 3), value).into_pyarray(py)
    }

    #[getter]
    fn side(&self) -> u32 {
        self.0.side
    }

    fn __len__(&self) -> usize {
        self.0.tiles.len()
    }

    fn __repr__(&self) -> String {
        format!("<organza.Tiles: {} of side {}>", self.0.tiles.len(), self.0.side)
    }
}
