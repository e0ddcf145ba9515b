//! The gradients of both fields, added over ranks.

use glam::Vec4;
use organza_shaders::hash_grid_backward::VALUES_PER_FLAG;

use super::gradient::SceneGradient;
use super::hash_grid::HashGridGradient;
use super::scene::DeviceScene;
use crate::error::{Error, Result};
use crate::ranks::Ranks;
use organza_device::{Count, Device};

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
        let (color, transmittance) = (color?, transmittance?);
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

/// Replaces the gradients of both networks.
pub fn write_networks(device: &Device, gradient: &SceneGradient, values: &[f32]) -> Result<()> {
    let (first, second) = values.split_at(4 * gradient.color.parameters.len());
    for (field, values) in
        [&gradient.color, &gradient.transmittance].into_iter().zip([first, second])
    {
        let values: Vec<Vec4> = bytemuck::pod_collect_to_vec(values);
        device.write(&field.parameters, 0, &values)?;
    }
    Ok(())
}

/// Adds the sums of the hash grids of all ranks, and makes gradients of them.
pub fn add_grids(
    device: &Device,
    ranks: Option<&dyn Ranks>,
    gradient: &SceneGradient,
) -> Result<()> {
    if let Some(ranks) = ranks.filter(|ranks| ranks.size() > 1) {
        sum_grids(device, ranks, gradient)?;
    }
    tables(gradient).into_iter().try_for_each(|table| Ok(table.finish(device)?))
}

/// Only blocks that some rank has touched travel.
fn sum_grids(device: &Device, ranks: &dyn Ranks, gradient: &SceneGradient) -> Result<()> {
    const BLOCK: usize = VALUES_PER_FLAG as usize;
    let mut flags = Vec::new();
    for table in tables(gradient) {
        flags.extend(device.read(&table.touched)?);
        flags.extend(device.read(&table.status)?);
    }
    ranks.or(&mut flags)?;
    let mut sums: Vec<Vec<i64>> = Vec::new();
    let (mut touched, mut packed) = (Vec::new(), Vec::new());
    let mut rest = &flags[..];
    for table in tables(gradient) {
        let (flags, after) = rest.split_at(table.touched.len());
        let (status, after) = after.split_at(1);
        rest = after;
        device.write(&table.touched, 0, flags)?;
        device.write(&table.status, 0, status)?;
        let sum: Vec<i64> = bytemuck::pod_collect_to_vec(&device.read(&table.sum)?);
        let blocks: Vec<_> = (0..flags.len()).filter(|&block| flags[block] != 0).collect();
        let range = |block: &usize| block * BLOCK..sum.len().min((block + 1) * BLOCK);
        packed.extend(blocks.iter().flat_map(|block| &sum[range(block)]));
        sums.push(sum);
        touched.push(blocks);
    }
    ranks.sum(&mut packed)?;
    let mut rest = &packed[..];
    for ((table, mut sum), blocks) in tables(gradient).into_iter().zip(sums).zip(touched) {
        for block in blocks {
            let end = sum.len().min((block + 1) * BLOCK);
            let target = &mut sum[block * BLOCK..end];
            let (values, after) = rest.split_at(target.len());
            target.copy_from_slice(values);
            rest = after;
        }
        device.write(&table.sum, 0, bytemuck::cast_slice::<i64, u32>(&sum))?;
    }
    Ok(())
}
