//! Describes a scene.

use std::path::Path;

use organza::scene::{GridLevelGeometry, SceneConfig, TensorSpec};
use organza::{DeviceScene, Result, Scene};
use serde::Serialize;

use super::TensorInfo;
use crate::cli::text_of;

#[derive(Debug, Serialize)]
pub struct SceneInfo {
    kind: &'static str,
    file: String,
    file_bytes: u64,
    gaussians: usize,
    values: usize,
    device_bytes: u64,
    config: SceneConfig,
    /// Two opposite corners of the box, in the world.
    corners: [[f64; 3]; 2],
    color_network: Vec<usize>,
    transmittance_network: Vec<usize>,
    color_levels: Vec<GridLevelGeometry>,
    transmittance_levels: Vec<GridLevelGeometry>,
    tensors: Vec<TensorInfo>,
    warnings: Vec<String>,
    /// Number of tensors that a training goes on with.
    state_tensors: usize,
    unused_tensors: Vec<String>,
}

impl SceneInfo {
    pub fn new(path: &Path, scene: &Scene) -> Result<Self> {
        let config = &scene.config;
        let tensors = scene.tensors();
        let info =
            |(spec, data): &(TensorSpec, &[f32])| TensorInfo::new(&spec.name, &spec.shape, data);
        let others = Scene::unused_tensors(path)?;
        let (state, unused_tensors): (Vec<_>, Vec<_>) =
            others.into_iter().partition(|name| is_state(name));
        Ok(Self {
            kind: "scene",
            file: text_of(path),
            file_bytes: super::file_bytes(path),
            gaussians: scene.gaussians.len(),
            values: tensors.iter().map(|(_, data)| data.len()).sum(),
            device_bytes: DeviceScene::bytes_of(scene),
            color_network: config.color_widths(),
            transmittance_network: config.transmittance_widths(),
            color_levels: config.color_grid.levels_geometry(),
            transmittance_levels: config.transmittance_grid.levels_geometry(),
            tensors: tensors.iter().map(info).collect(),
            warnings: scene.warnings(),
            state_tensors: state.len(),
            unused_tensors,
            corners: config.aabb.map(|corner| config.placement.world(corner)),
            config: config.clone(),
        })
    }
}

/// Whether a tensor of a checkpoint is for resuming the training.
fn is_state(name: &str) -> bool {
    ["adam.", "train."].iter().any(|prefix| name.starts_with(prefix))
}
