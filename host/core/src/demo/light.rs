//! How the light comes through the cloth.

use glam::Vec3;

use super::drapery::SHEETS;
use super::lattice::cells;
use super::volume::Volume;
use super::{HALF_BOX, pearl_distance};
use crate::scene::SceneConfig;

/// Standard deviation of a sheet's density along its normal: as thin as the grid can hold.
pub const SHEET_THICKNESS: f32 = 0.012;
/// How far the density stays off the hems: it is blurred, and must not dim what lies beside the cloth.
const INSET: f32 = 0.012;
/// Points that draw a sheet's density, along and across.
const POINTS: [usize; 2] = [420, 90];
/// Step of a ray of light.
const STEP: f32 = 0.035;
/// Steps after which a ray has left the box.
const STEPS: usize = 60;
/// How sharp the pearl's shadow is.
const SHARPNESS: f32 = 3.5;

/// Towards the lamp above.
pub fn key() -> Vec3 {
    Vec3::new(-0.28, -0.3, 0.9).normalize()
}

/// Towards the lamp beside, which makes highlights alone.
pub fn fill() -> Vec3 {
    Vec3::new(-0.45, -0.85, 0.3).normalize()
}

/// What light meets on its way.
#[derive(Debug)]
pub struct Surroundings {
    /// Density of each sheet: optical depth per world unit.
    pub sheets: [Volume; 2],
}

/// Light that arrives somewhere.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// What the cloth has let through of red, green and blue.
    pub through_cloth: Vec3,
    /// What the pearl has not held up.
    pub past_pearl: f32,
}

impl Surroundings {
    pub fn new(config: &SceneConfig) -> Self {
        let sheets = SHEETS.each_ref().map(|sheet| {
            let mut volume = Volume::zeros(&config.transmittance_grid);
            for cell in cells(POINTS, |t, v| sheet.at(t, v)) {
                let width = cell.along_v.length() * POINTS[1] as f32;
                let from_hem = cell.v.min(1.0 - cell.v) * width;
                let inside = (from_hem / INSET - 0.5).clamp(0.0, 1.0);
                let depth = inside * sheet.depth(cell.u);
                volume.add_gaussian(cell.position, depth * cell.area(), SHEET_THICKNESS);
            }
            volume
        });
        Self { sheets }
    }

    /// Follows light back from `position` to a lamp in `direction`.
    ///
    /// The penumbra is Quilez's: how near the ray comes to the pearl, by how far away that happens.
    pub fn arrival(&self, position: Vec3, direction: Vec3) -> Arrival {
        let mut depth = Vec3::ZERO;
        let mut past_pearl = 1.0_f32;
        for step in 0..STEPS {
            let t = (step as f32 + 0.5) * STEP;
            let point = position + direction * t;
            if point.z > HALF_BOX {
                break;
            }
            past_pearl = past_pearl.min(0.5 + SHARPNESS * pearl_distance(point) / t);
            for (sheet, volume) in SHEETS.iter().zip(&self.sheets) {
                depth += sheet.absorption * (volume.sample(point) * STEP);
            }
        }
        Arrival { through_cloth: (-depth).exp(), past_pearl: super::smoothstep(past_pearl) }
    }
}
