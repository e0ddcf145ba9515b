//! Where Gaussians are: a grid of the unit cube, found anew whenever they move.

use organza_shaders::occupancy::{
    FULL, OccupancyAddKernel, OccupancyKernel, OccupancyParams, OccupancyTableParams,
    entries_of_side,
};
use organza_shaders::unit_cube::SceneBox;

use crate::scene::device_shard::SceneBlocks;
use muslin_device::{Buffer, Device};
use organza_core::error::Result;
use organza_core::ranks::Ranks;
use organza_core::scene::SceneConfig;

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

    /// A scene without a grid has a single entry, because a binding must be bound.
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
}

impl SceneBlocks<'_> {
    /// Finds where Gaussians are. `ranks` have the other Gaussians of a shard.
    pub(crate) fn update_occupancy(
        &self,
        device: &Device,
        ranks: Option<&dyn Ranks>,
    ) -> Result<()> {
        let fields = self.fields;
        let side = fields.config.occupancy;
        if side == 0 {
            return Ok(());
        }
        let Occupancy { cell, counts, table } = &fields.occupancy;
        for block in self.blocks {
            let of = &block.tensors.gaussians;
            let kernel = OccupancyAddKernel {
                params: OccupancyParams {
                    gaussians: block.gaussians,
                    side,
                    cell: *cell,
                    contracted: fields.config.contraction.for_kernels(),
                },
                scene_box: &fields.scene_box,
                position: &of.position,
                rotation: &of.rotation,
                log_scale: &of.log_scale,
                opacity: &of.opacity,
                counts,
            };
            device.run(&kernel, block.gaussians, 1)?;
        }
        if let Some(ranks) = ranks.filter(|ranks| ranks.size() > 1) {
            let mut sums: Vec<_> = device.read(counts)?.into_iter().map(i64::from).collect();
            ranks.sum(&mut sums)?;
            let sums: Vec<_> = sums.iter().map(|&sum| sum.min(i64::from(FULL)) as u32).collect();
            device.write(counts, 0, &sums)?;
        }
        let entries = table.len() as u32;
        let kernel = OccupancyKernel { params: OccupancyTableParams { entries }, counts, table };
        Ok(device.run(&kernel, entries, 1)?)
    }
}
