//! Describes a scene.

use std::fmt;
use std::path::Path;

use organza::error::format_bytes;
use organza::scene::{
    Contraction, GridConfig, GridLevelGeometry, Placement, SceneConfig, TensorSpec,
};
use organza::{DeviceScene, Result, Scene};
use serde::Serialize;

use super::{FileInfo, TensorInfo, table};
use crate::cli::summary::{Table, count, grouped};

#[derive(Debug, Serialize)]
pub struct SceneInfo {
    #[serde(flatten)]
    file: FileInfo,
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
    unused_tensors: Vec<String>,
}

impl SceneInfo {
    pub fn new(path: &Path, scene: &Scene) -> Result<Self> {
        let config = &scene.config;
        let tensors = scene.tensors();
        let info =
            |(spec, data): &(TensorSpec, &[f32])| TensorInfo::new(&spec.name, &spec.shape, data);
        Ok(Self {
            file: FileInfo::new("scene", path),
            gaussians: scene.gaussians.len(),
            values: tensors.iter().map(|(_, data)| data.len()).sum(),
            device_bytes: DeviceScene::bytes_of(scene),
            color_network: config.color_widths(),
            transmittance_network: config.transmittance_widths(),
            color_levels: config.color_grid.levels_geometry(),
            transmittance_levels: config.transmittance_grid.levels_geometry(),
            tensors: tensors.iter().map(info).collect(),
            warnings: scene.warnings(),
            unused_tensors: Scene::unused_tensors(path)?,
            corners: config.aabb.map(|corner| config.placement.world(corner)),
            config: config.clone(),
        })
    }
}

/// Whether a tensor of a checkpoint is for resuming the training.
fn is_state(name: &str) -> bool {
    ["adam.", "train."].iter().any(|prefix| name.starts_with(prefix))
}

impl fmt::Display for SceneInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.file)?;
        self.write_summary(f)?;
        write!(f, "\n{}", table(&self.tensors))?;
        let color = &self.config.color_grid;
        let transmittance = &self.config.transmittance_grid;
        write_grid(f, "color grid", color, &self.color_levels)?;
        write_grid(f, "transmittance grid", transmittance, &self.transmittance_levels)?;
        for warning in &self.warnings {
            writeln!(f, "\nwarning: {warning}")?;
        }
        let (state, unused): (Vec<_>, Vec<_>) =
            self.unused_tensors.iter().map(String::as_str).partition(|name| is_state(name));
        if !state.is_empty() {
            writeln!(
                f,
                "\nwith the state of training, in {}",
                count(state.len() as u64, "tensor")
            )?;
        }
        if !unused.is_empty() {
            writeln!(f, "\nwarning: tensors that are not used: {}", unused.join(", "))?;
        }
        Ok(())
    }
}

impl SceneInfo {
    /// Where the scene lies in the world.
    fn placed(&self) -> [(&'static str, String); 3] {
        let Placement { offset, scale, up, meters, .. } = self.config.placement;
        let meters = meters.map_or(String::new(), |meters| format!(", {} m", scale * meters));
        let [lo, hi] = self.corners;
        [
            ("corners in the world", format!("{lo:?} and {hi:?}")),
            ("its own origin", format!("{offset:?} in the world, up is {up:?}")),
            ("its own unit", format!("{scale} world units{meters}")),
        ]
    }

    fn write_summary(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let config = &self.config;
        let widths = |widths: &[usize]| {
            widths.iter().map(ToString::to_string).collect::<Vec<_>>().join(" -> ")
        };
        let harmonics = config.sh_width();
        let samples = (3_f64.sqrt() / config.step).ceil();
        // Scenes are made in f32, so its digits are the intended ones.
        let [lo, hi] = config.aabb.map(|corner| corner.map(|value| value as f32));
        let [r, g, b] = config.background;
        let outside = match config.contraction {
            Contraction::None => "rays end at the unit cube",
            Contraction::Cube => "contracted to the unit cube",
        };
        let compensated = if config.antialiased { ", antialiased" } else { "" };
        let lines = [
            ("Gaussians", grouped(self.gaussians as u64)),
            ("values", grouped(self.values as u64)),
            ("on the device", format_bytes(self.device_bytes)),
            ("color network", widths(&self.color_network)),
            (
                "its inputs",
                format!(
                    "{harmonics} harmonics (degree {}), {} of the grid, {} of the material",
                    config.sh_degree,
                    config.color_grid.width(),
                    config.material
                ),
            ),
            ("transmittance network", widths(&self.transmittance_network)),
            (
                "its inputs",
                format!(
                    "{} of the grid, {} extra",
                    config.transmittance_grid.width(),
                    config.extra
                ),
            ),
            ("step", format!("{}, at most {samples} samples for a segment", config.step)),
            ("blur", format!("{} px^2{compensated}", config.blur)),
            ("background", format!("{r} {g} {b}")),
            ("box", format!("{lo:?} to {hi:?}")),
            ("outside the box", outside.to_owned()),
        ];
        let placed = (!config.placement.is_identity()).then(|| self.placed()).into_iter().flatten();
        for (label, value) in lines.into_iter().chain(placed) {
            writeln!(f, "{label:<21}  {value}")?;
        }
        Ok(())
    }
}

fn write_grid(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    grid: &GridConfig,
    levels: &[GridLevelGeometry],
) -> fmt::Result {
    let entries = grouped(grid.entries() as u64);
    let features = grid.features;
    writeln!(f, "\n{name}: {entries} entries of {features}")?;
    let mut table = Table::new(0, ["level", "resolution", "entries", "hashed"]);
    for (index, level) in levels.iter().enumerate() {
        let hashed = if level.hashed { "yes" } else { "no" };
        table.row([
            index.to_string(),
            level.resolution.to_string(),
            level.count.to_string(),
            hashed.to_owned(),
        ]);
    }
    write!(f, "{table}")
}
