//! Eq. 14 and 15: which Gaussians intersect a tile.

use glam::Vec4;
use organza_shaders::tile::Tile;

use super::numeric::{Number, Rounded};

/// Whether a support, of a center and a radius, reaches a tile: `dist(x, B_t)`, to the closed box, is at most the radius with the
/// kernel's margin for rounding. It is negative where the Gaussian is culled. `None` if rounding decides.
pub fn reaches(support: Vec4, tile: &Tile, side: u32) -> Option<bool> {
    let [x, y, radius, _] = support.to_array().map(Rounded::from);
    let outside = |x: Rounded, low: i32| {
        let low = f64::from(low);
        (Rounded::from(low) - x).max(x - (low + f64::from(side)).into()).max(0.0.into())
    };
    let [dx, dy] = [outside(x, tile.origin[0]), outside(y, tile.origin[1])];
    let reach = radius * 1.001.into() + 0.01.into();
    match radius.value < 0.0 {
        true => Some(false),
        false => (reach - (dx * dx + dy * dy).sqrt()).is_above(0.0),
    }
}
