//! The sums of the fields' and the poses' gradients, added over ranks.

use organza_shaders::hash_grid_backward::VALUES_PER_FLAG;

use crate::scene::device_scene::DeviceScene;
use crate::stages::field::hash_grid::HashGridGradient;
use crate::stages::gradient::SceneGradient;
use muslin_device::{Buffer, Count, Device};
use organza_core::error::{Error, Result};
use organza_core::ranks::Ranks;

fn tables(gradient: &SceneGradient) -> [&HashGridGradient; 2] {
    [&gradient.color.table, &gradient.transmittance.table]
}

/// One scale for all that ranks will add to the hash grids: its bound is the largest of all ranks' bounds. `samples` are
/// those of the color and of the transmittance field, of this rank.
pub fn set_scales(
    device: &Device,
    ranks: Option<&dyn Ranks>,
    scene: &DeviceScene,
    gradient: &SceneGradient,
    mut samples: [i64; 2],
) -> Result<()> {
    ranks.map_or(Ok(()), |ranks| ranks.sum(&mut samples))?;
    if let Some(ranks) = ranks.filter(|ranks| ranks.size() > 1) {
        let [color, transmittance] = tables(gradient).map(|table| device.read(&table.bound));
        let color = color?;
        let transmittance = transmittance?;
        let mut bounds = [&color[..], &transmittance[..]].concat();
        ranks.max(&mut bounds)?;
        let (first, second) = bounds.split_at(color.len());
        for (table, bound) in tables(gradient).into_iter().zip([first, second]) {
            device.write(&table.bound, 0, bound)?;
        }
    }
    let fields = [&scene.color, &scene.transmittance];
    for ((table, field), samples) in tables(gradient).into_iter().zip(fields).zip(samples) {
        let Ok(samples) = u32::try_from(samples) else {
            let reason = format!(
                "the step has {samples} samples, and their gradients are counted in 32 bits: use fewer tiles in a step"
            );
            return Err(Error::Argument { reason });
        };
        table.set_scale(device, field, &Count::known(samples))?;
    }
    Ok(())
}

/// Adds the sums of all ranks, and makes gradients of them.
pub fn finish(device: &Device, ranks: Option<&dyn Ranks>, gradient: &SceneGradient) -> Result<()> {
    if let Some(ranks) = ranks.filter(|ranks| ranks.size() > 1) {
        sum(device, ranks, gradient)?;
    }
    gradient.finish(device)
}

/// Integers on the device that all ranks have some of.
struct Sums<'a> {
    buffer: &'a Buffer<u32>,
    values: Vec<i64>,
    /// Not 0 where a block of [`VALUES_PER_FLAG`] values was added to.
    touched: Vec<u32>,
}

impl<'a> Sums<'a> {
    /// `touched` is known of a hash grid. Elsewhere, it says which blocks are not zero.
    fn read(device: &Device, buffer: &'a Buffer<u32>, touched: Option<Vec<u32>>) -> Result<Self> {
        let values: Vec<i64> = bytemuck::pod_collect_to_vec(&device.read(buffer)?);
        let blocks = values.chunks(VALUES_PER_FLAG as usize);
        let look = || blocks.map(|block| u32::from(block.iter().any(|&sum| sum != 0))).collect();
        let touched = touched.unwrap_or_else(look);
        Ok(Self { buffer, values, touched })
    }

    /// The blocks that were touched.
    fn blocks(&mut self) -> impl Iterator<Item = &mut [i64]> {
        let blocks = self.values.chunks_mut(VALUES_PER_FLAG as usize).zip(&self.touched);
        blocks.filter(|(_, touched)| **touched != 0).map(|(block, _)| block)
    }
}

/// Only blocks that some rank has touched travel.
fn sum(device: &Device, ranks: &dyn Ranks, gradient: &SceneGradient) -> Result<()> {
    let mut all = Vec::new();
    let mut flags = Vec::new();
    for table in tables(gradient) {
        let touched = device.read(&table.touched)?;
        all.push(Sums::read(device, &table.sum, Some(touched))?);
        flags.extend(device.read(&table.status)?);
    }
    let networks = [&gradient.color.network, &gradient.transmittance.network];
    for binned in networks.into_iter().chain(&gradient.poses) {
        all.push(Sums::read(device, &binned.sum, None)?);
    }
    flags.extend(all.iter().flat_map(|sums| &sums.touched));
    ranks.or(&mut flags)?;
    let (status, mut rest) = flags.split_at(tables(gradient).len());
    for sums in &mut all {
        let (touched, after) = rest.split_at(sums.touched.len());
        sums.touched.copy_from_slice(touched);
        rest = after;
    }
    let mut packed = Vec::new();
    all.iter_mut().for_each(|sums| sums.blocks().for_each(|block| packed.extend(&*block)));
    ranks.sum(&mut packed)?;
    let mut rest = &packed[..];
    for sums in &mut all {
        for block in sums.blocks() {
            let (values, after) = rest.split_at(block.len());
            block.copy_from_slice(values);
            rest = after;
        }
        device.write(sums.buffer, 0, bytemuck::cast_slice::<i64, u32>(&sums.values))?;
    }
    for ((table, sums), status) in tables(gradient).into_iter().zip(&all).zip(status) {
        device.write(&table.touched, 0, &sums.touched)?;
        device.write(&table.status, 0, &[*status])?;
    }
    Ok(())
}
