//! The occupancy grid of the unit cube: which cells Gaussians lie in. It is recomputed whenever they move.

use organza_shaders::occupancy::{
    OccupancyAddKernel, OccupancyKernel, OccupancyParams, OccupancyTableParams, entries_of_side,
};
use organza_shaders::unit_cube::SceneBox;

use muslin_device::{Buffer, Device};
use organza_core::scene::{GaussianTensors, SceneConfig};

/// Label of the buffer of an occupancy grid.
pub const OCCUPANCY: &str = "occupancy grid";

/// The occupancy grid of a scene.
#[derive(Clone, Debug)]
pub struct Occupancy {
    /// Length of a cell's side in world units.
    cell: f32,
    /// `[entries]`: 0 between updates.
    counts: Buffer<u32>,
    /// `[entries]`
    pub table: Buffer<f32>,
}

impl Occupancy {
    /// An empty grid.
    pub fn new(
        device: &Device,
        config: &SceneConfig,
        scene_box: &SceneBox,
    ) -> muslin_device::Result<Self> {
        let entries = Self::entries(config);
        let scale = scene_box.scale.as_dvec3() + scene_box.scale_rest.as_dvec3();
        // the geometric mean over the axes
        let cube = scale.element_product().cbrt().recip();
        Ok(Self {
            cell: (cube / f64::from(config.occupancy.max(1))) as f32,
            counts: device.zeros("counts of the occupancy grid", entries)?,
            table: device.zeros(OCCUPANCY, entries)?,
        })
    }

    /// A scene without a grid has a single entry, because every binding needs a buffer.
    fn entries(config: &SceneConfig) -> usize {
        match config.occupancy {
            0 => 1,
            side => entries_of_side(side).pow(3) as usize,
        }
    }

    /// Bytes that the grid takes on a device.
    pub fn bytes(config: &SceneConfig) -> usize {
        Self::entries(config) * (size_of::<u32>() + size_of::<f32>())
    }

    /// Recomputes the grid.
    pub fn update(
        &self,
        device: &Device,
        config: &SceneConfig,
        scene_box: &Buffer<f32>,
        gaussians: &GaussianTensors<Buffer<f32>>,
    ) -> muslin_device::Result<()> {
        if config.occupancy == 0 {
            return Ok(());
        }
        let Self { cell, counts, table } = self;
        let count = gaussians.opacity.len() as u32;
        let kernel = OccupancyAddKernel {
            params: OccupancyParams {
                gaussians: count,
                side: config.occupancy,
                cell: *cell,
                contracted: config.contraction.for_kernels(),
            },
            scene_box,
            position: &gaussians.position,
            rotation: &gaussians.rotation,
            log_scale: &gaussians.log_scale,
            opacity: &gaussians.opacity,
            counts,
        };
        device.run_all(&kernel)?;
        let entries = table.len() as u32;
        let kernel = OccupancyKernel { params: OccupancyTableParams { entries }, counts, table };
        device.run_all(&kernel)
    }
}
