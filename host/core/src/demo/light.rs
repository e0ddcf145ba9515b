//! The light that comes through the cloth.

use glam::Vec3;

use super::drapery::SHEETS;
use super::lattice::cells;
use super::shape::{HALF_BOX, pearl_distance, smoothstep};
use super::volume::Volume;
use crate::scene::SceneConfig;

/// Standard deviation of a sheet's density along its normal: as small as the grid can represent.
pub const SHEET_THICKNESS: f32 = 0.012;
/// Distance of the density from the hems. The density is blurred, and must not dim anything beside the cloth.
const INSET: f32 = 0.012;
/// Points along and across a sheet that make up its density.
const POINTS: [usize; 2] = [420, 90];
/// Step of a ray of light, in world units.
const STEP: f32 = 0.035;
/// Steps after which every ray has left the box.
const STEPS: usize = 60;
/// Sharpness of the pearl's shadow.
const SHARPNESS: f32 = 3.5;

/// Direction to the lamp above.
pub fn key() -> Vec3 {
    Vec3::new(-0.28, -0.3, 0.9).normalize()
}

/// Direction to the lamp at the side, which only makes highlights.
pub fn fill() -> Vec3 {
    Vec3::new(-0.45, -0.85, 0.3).normalize()
}

/// The volumes that light passes through.
#[derive(Debug)]
pub struct Surroundings {
    /// Density of each sheet: optical depth per world unit.
    pub sheets: [Volume; 2],
}

/// Light that arrives at a place.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// Fraction of red, green and blue light that the cloth lets through.
    pub through_cloth: Vec3,
    /// Fraction of the light that the pearl does not block.
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
    /// The penumbra is Quilez's: how near the ray passes the pearl, divided by how far away that is.
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
            // both volumes have the same grid
            let Some(place) = self.sheets[0].place(point) else { continue };
            for (sheet, volume) in SHEETS.iter().zip(&self.sheets) {
                depth += sheet.absorption * (volume.sample(place) * STEP);
            }
        }
        Arrival { through_cloth: (-depth).exp(), past_pearl: smoothstep(past_pearl) }
    }
}
