//! Images of scenes that each show a part of the world: a pixel is the mean of their images, by where these show something.

use rayon::prelude::*;

use crate::scene::device_scene::DeviceScene;
use muslin_device::memory;
use organza_core::scene::{Ground, Placement};
use organza_core::{Camera, Channel, RenderedTiles, Result, Tile, TileBatch};

/// Weight of a pixel that shows no Gaussian.
const NOTHING: f32 = 1e-9;

/// Renders a scene: its number, itself, cameras in its coordinates, and channels. `None` if it was cancelled.
pub type RenderOne<'r> =
    dyn FnMut(usize, &DeviceScene, &[Camera], &[Channel]) -> Result<Option<RenderedTiles>> + 'r;

/// Renders each scene alone. A pixel is the mean of their pixels, by [`Ground::weight`] of the place that the depth of each shows.
pub fn blend(
    scenes: &[(DeviceScene, Placement, &Ground)],
    cameras: &[Camera],
    batch: &TileBatch,
    channels: &[Channel],
    render: &mut RenderOne<'_>,
) -> Result<Option<RenderedTiles>> {
    let mut all = channels.to_vec();
    if !all.contains(&Channel::Depth) {
        all.push(Channel::Depth);
    }
    let mut blended = RenderedTiles::new(batch, channels)?;
    let area = (batch.side * batch.side) as usize;
    let zeros = |planes: usize| memory::zeros(planes * area * batch.tiles.len(), "a blended batch");
    let mut total: Vec<f32> = zeros(1)?;
    blended.data = zeros(3)?;
    for (channel, values) in &mut blended.channels {
        *values = zeros(channel.planes())?;
    }
    for (index, (scene, place, ground)) in scenes.iter().enumerate() {
        let own: Vec<_> = cameras.iter().map(|camera| place.own_camera(camera)).collect();
        let Some(found) = render(index, scene, &own, &all)? else { return Ok(None) };
        let depths = found.channels[&Channel::Depth].par_chunks(area);
        let world = &scene.config.placement;
        let weights: Vec<_> = depths
            .zip(&batch.tiles)
            .flat_map_iter(|(depths, tile)| {
                // of one camera, the index of a tile does not matter
                let camera = own.get(tile.camera).unwrap_or(&own[0]);
                weights(depths, tile, batch.side, camera, world, ground)
            })
            .collect();
        total.iter_mut().zip(&weights).for_each(|(total, weight)| *total += weight);
        add(&mut blended.data, &found.data, &weights, area);
        for (channel, values) in &mut blended.channels {
            add(values, &found.channels[channel], &weights, area);
        }
        blended.report.add(&found.report);
    }
    let of_planes = |values: &mut Vec<f32>| {
        let planes = values.len() / total.len().max(1);
        for (values, total) in values.chunks_mut(planes.max(1) * area).zip(total.chunks(area)) {
            let totals = total.iter().cycle();
            values.iter_mut().zip(totals).for_each(|(value, total)| *value /= total);
        }
    };
    of_planes(&mut blended.data);
    blended.channels.values_mut().for_each(of_planes);
    if let Some(normals) = blended.channels.get_mut(&Channel::Normal) {
        normals.chunks_mut(3 * area).for_each(|tile| lengthen(tile, area));
    }
    Ok(Some(blended))
}

/// The weights of a tile's pixels, whose depths are in world units.
fn weights(
    depths: &[f32],
    tile: &Tile,
    side: u32,
    camera: &Camera,
    world: &Placement,
    ground: &Ground,
) -> Vec<f32> {
    let eye = glam::DVec3::from(camera.eye());
    let weight = |(at, &depth): (usize, &f32)| {
        if depth > 0.0 {
            let [x, y] = [at as u32 % side, at as u32 / side].map(|at| f64::from(at) + 0.5);
            let ray = camera.ray([f64::from(tile.origin[0]) + x, f64::from(tile.origin[1]) + y]);
            let place = eye + ray * (f64::from(depth) / world.scale);
            ground.weight(world.world(place.to_array())) as f32
        } else {
            NOTHING
        }
    };
    depths.iter().enumerate().map(weight).collect()
}

/// Adds values `[K, planes, S, S]` times weights `[K, S, S]`.
fn add(sum: &mut [f32], values: &[f32], weights: &[f32], area: usize) {
    let planes = (sum.len() / weights.len().max(1)).max(1);
    let tiles = sum.chunks_mut(planes * area).zip(values.chunks(planes * area));
    for ((sum, values), weights) in tiles.zip(weights.chunks(area)) {
        let weights = weights.iter().cycle();
        let all = sum.iter_mut().zip(values).zip(weights);
        all.for_each(|((sum, value), weight)| *sum += value * weight);
    }
}

/// Gives a tile's normals `[3, S, S]` the length 1, except for 0.
fn lengthen(tile: &mut [f32], area: usize) {
    for at in 0..area {
        let normal = glam::Vec3::from([0, 1, 2].map(|axis| tile[axis * area + at]));
        let normal = normal.normalize_or_zero();
        (0..3).for_each(|axis| tile[axis * area + at] = normal[axis]);
    }
}
