//! Images of scenes that each show a part of the world: a pixel is the mean of their images, by where these show something.

use rayon::prelude::*;

use crate::scene::device_scene::DeviceScene;
use glam::DVec3;
use muslin_device::memory;
use organza_core::scene::{Ground, Placement};
use organza_core::{Camera, Channel, RenderedTiles, Result, Tile, TileBatch};

/// Weight of a pixel that shows no Gaussian.
const NOTHING: f32 = 1e-9;

/// Renders tiles of a scene: its number, itself, cameras in its coordinates, and channels. `None` if it was cancelled.
pub type RenderOne<'r> = dyn FnMut(usize, &DeviceScene, &[Camera], &TileBatch, &[Channel]) -> Result<Option<RenderedTiles>>
    + 'r;

/// Renders each scene alone. A pixel is the mean of their pixels, by [`Ground::weight`] of the place that the depth of each shows. A scene
/// does not count where a pixel's ray does not [come over its ground](Ground::is_met). Where it counts nowhere in a tile, it is not
/// rendered.
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
        let own = cameras.iter().map(|camera| ground.moved(place.own_camera(camera)));
        let own: Vec<_> = own.collect();
        let world = &scene.config.placement;
        let over = own.iter().map(|own| ground.placement.own_camera(&world.world_camera(own)));
        let over: Vec<_> = over.collect();
        let view = |tile: &Tile| {
            // of one camera, the index of a tile does not matter
            let camera = if tile.camera < own.len() { tile.camera } else { 0 };
            View { tile: *tile, side: batch.side, camera: &over[camera], ground }
        };
        let met: Vec<_> = batch.tiles.par_iter().map(|tile| view(tile).met()).collect();
        let seen: Vec<_> = (0..met.len()).filter(|&tile| met[tile].contains(&true)).collect();
        if seen.is_empty() {
            continue;
        }
        let tiles = seen.iter().map(|&tile| batch.tiles[tile]).collect();
        let some = TileBatch { side: batch.side, tiles };
        let Some(found) = render(index, scene, &own, &some, &all)? else { return Ok(None) };
        let depths = found.channels[&Channel::Depth].par_chunks(area).zip(&seen);
        let weights = depths.map(|(depths, &at)| view(&batch.tiles[at]).weights(depths, &met[at]));
        let weights: Vec<_> = weights.collect();
        for (weights, &tile) in weights.iter().zip(&seen) {
            let total = total[tile * area..].iter_mut().zip(weights);
            total.for_each(|(total, weight)| *total += weight);
        }
        add(&mut blended.data, &found.data, &weights, &seen);
        for (channel, values) in &mut blended.channels {
            add(values, &found.channels[channel], &weights, &seen);
        }
        blended.report.add(&found.report);
    }
    let of_planes = |values: &mut Vec<f32>| {
        let planes = values.len() / total.len().max(1);
        for (values, total) in values.chunks_mut(planes.max(1) * area).zip(total.chunks(area)) {
            let totals = total.iter().cycle();
            let pairs = values.iter_mut().zip(totals).filter(|(_, total)| **total > 0.0);
            pairs.for_each(|(value, total)| *value /= total);
        }
    };
    of_planes(&mut blended.data);
    blended.channels.values_mut().for_each(of_planes);
    if let Some(normals) = blended.channels.get_mut(&Channel::Normal) {
        normals.chunks_mut(3 * area).for_each(|tile| lengthen(tile, area));
    }
    Ok(Some(blended))
}

/// A tile of one of the scenes.
struct View<'a> {
    tile: Tile,
    side: u32,
    /// In the coordinates of the ground.
    camera: &'a Camera,
    ground: &'a Ground,
}

impl View<'_> {
    /// The direction of a pixel, with a depth of 1.
    fn ray(&self, at: usize) -> DVec3 {
        let [x, y] = [at as u32 % self.side, at as u32 / self.side].map(|at| f64::from(at) + 0.5);
        self.camera.ray([f64::from(self.tile.origin[0]) + x, f64::from(self.tile.origin[1]) + y])
    }

    /// Whether the ray of each pixel comes over the ground.
    fn met(&self) -> Vec<bool> {
        let eye = self.camera.eye();
        let pixels = 0..(self.side * self.side) as usize;
        pixels.map(|at| self.ground.is_met(eye, self.ray(at).to_array())).collect()
    }

    /// The weights of pixels, whose depths are in world units.
    fn weights(&self, depths: &[f32], met: &[bool]) -> Vec<f32> {
        let eye = DVec3::from(self.camera.eye());
        let Ground { placement, .. } = self.ground;
        let weight = |(at, (&depth, &is_met)): (usize, (&f32, &bool))| {
            if !is_met {
                0.0
            } else if depth > 0.0 {
                let place = eye + self.ray(at) * (f64::from(depth) / placement.scale);
                self.ground.weight(placement.world(place.to_array())) as f32
            } else {
                NOTHING
            }
        };
        depths.iter().zip(met).enumerate().map(weight).collect()
    }
}

/// Adds values `[seen, planes, S, S]` times weights `[seen, S, S]` to the tiles that are seen.
fn add(sum: &mut [f32], values: &[f32], weights: &[Vec<f32>], seen: &[usize]) {
    let size = values.len() / seen.len();
    for ((values, weights), &tile) in values.chunks(size).zip(weights).zip(seen) {
        let sum = sum[tile * size..][..size].iter_mut().zip(values);
        let all = sum.zip(weights.iter().cycle()).filter(|(_, weight)| **weight > 0.0);
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
