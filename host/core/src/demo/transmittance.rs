//! The transmittance field: the pearl blocks light, the cloth dims it.
//!
//! The grid holds two features: the cloth's optical depth per step, and the depth inside the pearl. The latter is a
//! signed distance, which trilinear interpolation keeps far sharper than an occupancy. The network turns them into
//! the logit a of Eq. 10. For an optical depth d per step, `-ln sigmoid(a) = d`, so `a(d) = -ln(exp(d) - 1)`, a
//! spline. Inside the pearl, a falls without limit.
//!
//! Adding to a divides d. With the extra vector the network knows which piece's Gaussian it evaluates: the cloth is
//! denser for the pearl, and thinner for the floor.

use std::f32::consts::TAU;

use super::drapery;
use super::light::{SHEET_THICKNESS, Surroundings};
use super::network::{Form, Units};
use super::shape::{SurfaceKind, pearl_distance};
use super::volume::{Volume, WORLD_PER_UNIT};
use crate::scene::Scene;

/// Values of an extra vector: whether it is the pearl, whether it is the floor.
pub const EXTRA: usize = 2;
/// Features of the grid: the cloth's optical depth per step, depth inside the pearl.
pub const FEATURES: usize = 2;

/// Logit a in empty space: a whole ray of steps loses about a hundredth.
const CLEAR: f32 = 9.5;
/// Slope of a with the depth inside the pearl: opaque within a hair's breadth.
const SOLID: f32 = 20_000.0;
/// Depth below the surface from which the pearl's own Gaussians still see out, in world units.
const SKIN: f32 = 0.001;
/// Part of the cloth's density that is left out, as a fraction of a sheet's peak. The grid blurs the density, and its
/// tails would dim what is beside a fold and not behind it.
const TAILS: f32 = 0.3;
/// Factor that compensates for the missing tails.
const GAIN: f32 = 1.35;
/// Added to a for the pearl. Its alphas add up to more than 1, so the cloth needs more weight to show in front of it.
const FOR_PEARL: f32 = -0.6;
/// Added to a for the floor's shadows, which are seen through the cloth together with the background.
const FOR_FLOOR: f32 = 0.72;
/// Knots of a(d), each at 2.3 times the one before.
const KNOTS: usize = 14;
const KNOT_RATIO: f32 = 2.3;

impl SurfaceKind {
    /// The Gaussian's extra vector.
    pub fn extra(self) -> [f32; EXTRA] {
        [Self::Pearl, Self::Floor].map(|kind| f32::from(u8::from(self == kind)))
    }
}

/// Fills the transmittance field in.
pub fn fill(scene: &mut Scene, surroundings: &Surroundings) {
    let world_per_step = scene.config.step as f32 * WORLD_PER_UNIT;
    let grid = Volume::zeros(&scene.config.transmittance_grid);
    // interpolation only needs a few cells around the surface
    let band = 2.5 * grid.cell();
    for (index, position) in grid.vertices() {
        let density: f32 = surroundings.sheets.iter().map(|sheet| sheet.values[index]).sum();
        let depth = (-pearl_distance(position)).max(-band);
        let features = [density * world_per_step, depth];
        scene.transmittance.grid[index * FEATURES..][..FEATURES].copy_from_slice(&features);
    }

    // a sheet's profile is a Gaussian, widened by interpolation with a deviation of 0.41 cells
    let deviation = SHEET_THICKNESS.hypot(0.41 * grid.cell());
    let peak = drapery::full_depth() * world_per_step / (TAU.sqrt() * deviation);
    let [first, last] = &mut scene.transmittance.network.layers[..] else {
        unreachable!("the configuration has one hidden layer")
    };
    let mut units = Units::new(first);
    let [cloth, depth, pearl, floor] = [0, 1, 2, 3].map(Form::input);
    let density = cloth.offset(-TAILS * peak).times(GAIN);
    let inside = depth.plus(-SKIN, &pearl);
    let logit = units.spline(&density, &knots());
    let logit = logit.plus(-SOLID, &units.take(&inside));
    let logit = logit.plus(FOR_PEARL, &units.take(&pearl)).plus(FOR_FLOOR, &units.take(&floor));
    Units::new(last).take(&logit);
}

/// Knots of a(d), from the depth of [`CLEAR`] on, evenly spaced in its logarithm.
fn knots() -> Vec<(f32, f32)> {
    // release builds would compute all of this ahead, with other roundings
    let [clear, ratio] = std::hint::black_box([CLEAR, KNOT_RATIO]);
    let min = (-clear).exp().ln_1p();
    (0..KNOTS as i32)
        .map(|knot| min * ratio.powi(knot))
        .map(|depth| (depth, -depth.exp_m1().ln()))
        .collect()
}
