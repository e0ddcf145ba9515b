//! B3. The weighted sum over a tile's members (Eq. 12) and its division or background (Eq. 13), for all tiles of
//! a batch at once (Eq. 16): pixels along x and y, tiles along z.

use glam::{Vec2, Vec3, Vec4};

use crate::limits::MAX_MEMBERS;
use crate::prelude::*;
use crate::project::{falloff, mahalanobis};
use crate::splat::VECTORS;
use crate::tile::Tile;

/// Parameters of [`composite`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct CompositeParams {
    /// S, in pixels.
    pub side: u32,
    /// Members of each tile that earlier dispatches have summed up.
    pub skip: u32,
}

/// Alpha of a splat at a pixel: `sigmoid(opacity) T falloff` (Eq. 12).
///
/// The shift of Eq. 15 cancels here: the distance is taken in the image, where pixel centers are exact in f32, so that
/// it does not depend on how the image was cut.
#[inline(always)]
pub fn alpha(placed: Vec4, conic: Vec4, pixel: Vec2) -> f32 {
    let d = Vec2::new(pixel.x - placed.x, pixel.y - placed.y);
    placed.z * falloff(mahalanobis(Vec3::new(conic.x, conic.y, conic.z), d))
}

/// Center of a tile's pixel, in the image.
#[inline(always)]
pub fn pixel_center(tile: &Tile, column: u32, row: u32) -> Vec2 {
    Vec2::new(
        (tile.origin[0] + column as i32) as f32 + 0.5,
        (tile.origin[1] + row as i32) as f32 + 0.5,
    )
}

/// Adds up to [`MAX_MEMBERS`] members to `sum [tiles, S, S]`, which holds (C, S) of Eq. 12.
///
/// The members of tile t are `tile_first[t] .. tile_first[t + 1]`, in ascending order.
#[kernel(threads(8, 8), iterations = MAX_MEMBERS)]
pub fn composite(
    id: Invocation,
    params: &CompositeParams,
    tile: Read<i32>,
    tile_first: Read<u32>,
    member: Read<u32>,
    splat: Read<Vec4>,
    sum: Write<Vec4>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let t = id.workgroup.z;
        let pixel = pixel_center(&Tile::read(tile, t), place.x, place.y);
        let begin = tile_first.read(t) + params.skip;
        let all = tile_first.read(t + 1);
        let end = if all < begin + MAX_MEMBERS { all } else { begin + MAX_MEMBERS };
        let at = (t * params.side + place.y) * params.side + place.x;
        let mut total = sum.read(at);
        let mut next = begin;
        while next < end {
            let first = member.read(next) * VECTORS;
            let a = alpha(splat.read(first), splat.read(first + 1), pixel);
            let c = splat.read(first + 2);
            total += Vec4::new(a * c.x, a * c.y, a * c.z, a);
            next += 1;
        }
        sum.write(at, total);
    }
}

/// Eq. 13: the sum divided by its weight where that passes 1, over the background where it does not.
#[inline(always)]
pub fn resolve_pixel(sum: Vec4, background: Vec3) -> Vec3 {
    let c = Vec3::new(sum.x, sum.y, sum.z);
    if sum.w > 1.0 { c * (1.0 / sum.w) } else { c + background * (1.0 - sum.w) }
}

/// Parameters of [`resolve`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ResolveParams {
    /// S, in pixels.
    pub side: u32,
    /// Background, red.
    pub background_r: f32,
    /// Background, green.
    pub background_g: f32,
    /// Background, blue.
    pub background_b: f32,
}

/// Writes `image [K, 3, S, S]` (Eq. 13 and 16); tile t of the batch begins at `t * 3 S S`.
#[kernel(threads(8, 8))]
pub fn resolve(
    id: Invocation,
    params: &ResolveParams,
    tile: Read<i32>,
    sum: Read<Vec4>,
    image: Write<f32>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let t = id.workgroup.z;
        let background = Vec3::new(params.background_r, params.background_g, params.background_b);
        let at = place.y * params.side + place.x;
        let area = params.side * params.side;
        let color = resolve_pixel(sum.read(t * area + at), background);
        let first = Tile::read(tile, t).output * 3 * area + at;
        image.write(first, color.x);
        image.write(first + area, color.y);
        image.write(first + 2 * area, color.z);
    }
}
