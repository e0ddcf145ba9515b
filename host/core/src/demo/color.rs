//! The color field: Blinn-Phong shading in two hidden layers.
//!
//! The part of the color that does not depend on the view is baked into each Gaussian's material as logits. The
//! network adds highlights. Let v be the direction camera -> Gaussian, n the normal and l the direction to a lamp,
//! all of length 1. The half vector is `h = l - v`, and the highlight is a function of
//!
//! `q = n.h - |h|`, which is 0 where n points along h and negative elsewhere: about `-|h| angle^2 / 2`.
//!
//! - v is linear in the spherical harmonics of degree 1.
//! - `n.v = |n + v|^2 / 2 - 1` needs three squares, and a square is a spline of ReLUs. So a network that cannot
//!   multiply multiplies all the same.
//! - `|h| = sqrt(2 - 2 l.v)` is one more spline.
//! - `exp(q / width)` is a spline in the second layer. There, each lobe is switched off on the wrong material and in
//!   the pearl's shadow.
//!
//! The grid holds what happens to light on its way to a place: three logits to subtract for the light that the cloth
//! has absorbed, and the fraction that the pearl blocks.

use glam::Vec3;

use super::light::{self, Surroundings};
use super::network::{Form, Units};
use super::shape::pearl_distance;
use super::volume::Volume;
use crate::scene::Scene;

/// Features of the grid: three logits to subtract, and the pearl's shadow.
pub const FEATURES: usize = 4;

/// Offsets of the network's inputs: spherical harmonics, grid, material.
const HARMONICS: usize = 0;
const GRID: usize = HARMONICS + 4;
const LOGITS: usize = GRID + FEATURES;
const NORMAL: usize = LOGITS + 3;
const CLOTH: usize = NORMAL + 3;
const PEARL: usize = CLOTH + 1;

/// The factor of band 1 of the spherical harmonics.
const BAND_1: f32 = 0.488_602_5;
/// The lowest logit.
const MIN_LOGIT: f32 = -8.0;
/// Knots of a square on each side of 0, and their distance: the spline is off by 1/512 at most.
const SQUARE_KNOTS: usize = 16;
const SQUARE_STEP: f32 = 2.0 / SQUARE_KNOTS as f32;

/// Fills the color field in.
pub fn fill(scene: &mut Scene, surroundings: &Surroundings) {
    let grid = Volume::zeros(&scene.config.color_grid);
    for (index, position) in grid.vertices() {
        let features = &mut scene.color.grid[index * FEATURES..][..FEATURES];
        features.copy_from_slice(&light_at(surroundings, position));
    }
    let [first, second, last] = &mut scene.color.network.layers[..] else {
        unreachable!("the configuration has two hidden layers")
    };
    let geometry = Geometry::new(&mut Units::new(first));
    let logits = shade(&mut Units::new(second), &geometry);
    let mut last = Units::new(last);
    for form in &logits {
        last.take(form);
    }
}

/// The features of a vertex.
fn light_at(surroundings: &Surroundings, position: Vec3) -> [f32; FEATURES] {
    // vertices inside the pearl are interpolated at its surface, so they hold the surface's values
    let depth = (-pearl_distance(position)).max(0.0);
    let position = position + position.normalize_or_zero() * depth;
    // a sheet does not shade itself
    let arrival = surroundings.arrival(position + light::key() * 0.06, light::key());
    let taken = (0.5 + 0.5 * arrival.through_cloth).map(|light| -light.ln());
    [taken.x, taken.y, taken.z, 1.0 - arrival.past_pearl]
}

/// Outputs of the first layer.
struct Geometry {
    logits: [Form; 3],
    /// Logits that the cloth subtracts from the light.
    taken: [Form; 3],
    /// The pearl's shadow.
    shadow: Form,
    cloth: Form,
    pearl: Form,
    /// The cosine of the angle between the normal and the direction to the camera, `-n.v`.
    facing: Form,
    /// `n.l` and `|h|` for both lamps.
    lamps: [(Form, Form); 2],
}

impl Geometry {
    fn new(units: &mut Units) -> Self {
        // band 1 is 0.4886025 * (-y, z, -x)
        let view = [(3, -1.0), (1, -1.0), (2, 1.0)]
            .map(|(index, sign)| Form::input(HARMONICS + index).times(sign / BAND_1));
        let normal = [0, 1, 2].map(|axis| Form::input(NORMAL + axis));
        let logits = [0, 1, 2].map(|c| units.pass(&Form::input(LOGITS + c), MIN_LOGIT));
        let [taken_r, taken_g, taken_b, shadow, cloth, pearl] =
            [GRID, GRID + 1, GRID + 2, GRID + 3, CLOTH, PEARL]
                .map(|index| units.pass(&Form::input(index), 0.0));
        let mut facing = Form::constant(1.0);
        for axis in 0..3 {
            let sum = normal[axis].clone().plus(1.0, &view[axis]);
            facing = facing.plus(-0.5, &square(units, &sum));
        }
        let lamps = [light::key(), light::fill()].map(|lamp| {
            let dot = |a: &[Form; 3]| {
                let product = |sum: Form, axis| sum.plus(lamp[axis], &a[axis]);
                (0..3).fold(Form::default(), product)
            };
            let normal_lamp = units.pass(&dot(&normal), -1.0);
            // denser where the square root is steep
            let knots =
                [-1.0, -0.4, 0.1, 0.5, 0.78, 0.94, 1.0].map(|x: f32| (x, (2.0 - 2.0 * x).sqrt()));
            (normal_lamp, units.spline(&dot(&view), &knots))
        });
        Self { logits, taken: [taken_r, taken_g, taken_b], shadow, cloth, pearl, facing, lamps }
    }
}

/// x^2 for x in -2..2. Chords lie above a parabola; half of their largest error is taken off.
fn square(units: &mut Units, x: &Form) -> Form {
    let knots: Vec<_> =
        (0..=SQUARE_KNOTS).map(|knot| knot as f32 * SQUARE_STEP).map(|x| (x, x * x)).collect();
    let right = units.spline(x, &knots);
    let left = units.spline(&x.clone().times(-1.0), &knots);
    right.plus(1.0, &left).offset(-SQUARE_STEP * SQUARE_STEP / 8.0)
}

/// Highlights of one lamp on one kind of surface.
struct Highlight<'g> {
    lamp: &'g (Form, Form),
    kind: &'g Form,
    /// 1 for the side that the normal points to, -1 for the back side.
    side: f32,
    width: f32,
    /// Fraction of the highlight that the pearl's shadow removes.
    shadow: f32,
}

impl Highlight<'_> {
    /// `exp(q / width)`.
    fn lobe(&self, units: &mut Units, geometry: &Geometry) -> Form {
        let (normal_lamp, half_length) = self.lamp;
        let normal_half = normal_lamp.clone().plus(1.0, &geometry.facing);
        let q = normal_half.times(self.side).plus(-1.0, half_length);
        let x = q.times(1.0 / self.width).plus(-self.shadow, &geometry.shadow).gated(self.kind);
        let mut knots = [-4.5, -2.6, -1.5, -0.75, -0.25, 0.0].map(|x: f32| (x, x.exp()));
        knots[0].1 = 0.0;
        units.spline(&x, &knots)
    }
}

/// The logits of the color.
fn shade(units: &mut Units, geometry: &Geometry) -> [Form; 3] {
    let Geometry { logits, taken, shadow, cloth, pearl, facing, lamps } = geometry;
    let mut color: [Form; 3] = std::array::from_fn(|c| {
        // the cloth is tinted less: it glows with the light that other surfaces lose
        let light = logits[c].clone().plus(-1.0, &taken[c]);
        let glow = units.take(&taken[c].clone().gated(cloth));
        units.pass(&light, MIN_LOGIT - 4.0).plus(0.6, &glow)
    });
    let mut add = |form: &Form, gain: [f32; 3]| {
        for (color, gain) in color.iter_mut().zip(gain) {
            *color = color.clone().plus(gain, form);
        }
    };
    add(&units.take(&shadow.clone().gated(cloth)), [-0.1, -0.2, -0.1]);
    let [key, fill] = lamps;
    for side in [1.0, -1.0] {
        let sheen = Highlight { lamp: key, kind: cloth, side, width: 0.1, shadow: 4.0 };
        add(&sheen.lobe(units, geometry), [2.6; 3]);
        let sheen = Highlight { lamp: fill, width: 0.05, shadow: 0.0, ..sheen };
        add(&sheen.lobe(units, geometry), [2.2; 3]);
    }
    let gloss = Highlight { lamp: key, kind: pearl, side: 1.0, width: 0.022, shadow: 8.0 };
    add(&gloss.lobe(units, geometry), [3.4; 3]);
    let gloss = Highlight { lamp: fill, width: 0.05, shadow: 0.0, ..gloss };
    add(&gloss.lobe(units, geometry), [0.7; 3]);
    // the pearl's luster: rose, then blue towards its rim
    for (knot, gain) in [(0.75, [0.5, -0.3, 0.1]), (0.4, [-0.6, 0.9, 1.3])] {
        let rim = facing.clone().times(-1.0).offset(knot).gated(pearl);
        add(&units.take(&rim), gain);
    }
    color
}
