//! The pieces of the scene as Gaussians: the pearl, the cloth with its hems, and the shadows on the floor.

use std::f32::consts::PI;

use glam::Vec3;

use super::drapery::{SHEETS, Sheet};
use super::lattice::{Cell, Look, Splats, cells};
use super::light::{self, Surroundings};
use super::shape::{BACKGROUND, FLOOR, HALF_BOX, Material, PEARL, SurfaceKind};

/// Number of Gaussians of the pearl.
const PEARL_POINTS: usize = 6400;
/// Sum of the pearl's alphas. Behind one layer of cloth its surface must still have weight 1, or the background would
/// shine through.
const PEARL_COVERAGE: f32 = 2.2;
/// Number of Gaussians of a sheet, along and across.
const SHEET_POINTS: [usize; 2] = [290, 39];
/// Number of Gaussians of a hem.
const HEM_POINTS: usize = 420;
/// Width of a hem.
const HEM_WIDTH: f32 = 0.0045;
/// Number of Gaussians of the floor, along each side.
const FLOOR_POINTS: usize = 52;
/// Darkest shadow on the floor.
const SHADOW: f32 = 0.44;
/// Fraction of red, green and blue light that the pearl's shadow removes: the shadow is a little violet.
const PEARL_SHADOW: Vec3 = Vec3::new(0.62, 0.70, 0.56);
/// Radius of the lamp that casts the floor's shadows, as a tangent.
const LAMP: f32 = 0.3;
/// Rays to that lamp.
const LAMP_RAYS: usize = 24;

/// Angle between two points of a Fibonacci spiral.
fn golden_angle() -> f32 {
    PI * (3.0 - 5.0_f32.sqrt())
}

/// The pearl: points of a Fibonacci sphere, lit from above, with the cloth's rose in its shade.
pub fn pearl(splats: &mut Splats) {
    let light = Vec3::new(0.985, 0.91, 0.80);
    let shade = Vec3::new(0.60, 0.31, 0.33);
    let spacing = PEARL * (4.0 * PI / PEARL_POINTS as f32).sqrt();
    for point in 0..PEARL_POINTS {
        let z = 1.0 - (2 * point + 1) as f32 / PEARL_POINTS as f32;
        let (sin, cos) = (point as f32 * golden_angle()).sin_cos();
        let normal = Vec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + Vec3::Z * z;
        let tangent = normal.any_orthonormal_vector();
        let cell = Cell {
            u: 0.0,
            v: 0.0,
            position: normal * PEARL,
            along_u: tangent * spacing,
            along_v: normal.cross(tangent) * spacing,
        };
        // light that wraps around, as if it scattered under the surface
        let wrapped = (0.5 + 0.5 * normal.dot(light::key())).powf(1.2);
        let color = shade.lerp(light, (1.25 * wrapped - 0.05).clamp(0.0, 1.0));
        let material = Material { color, normal, kind: SurfaceKind::Pearl };
        splats.push(&cell, &Look { thickness: 0.12 * spacing, coverage: PEARL_COVERAGE, material });
    }
}

/// Both sheets.
pub fn cloth(splats: &mut Splats) {
    for sheet in &SHEETS {
        for cell in cells(SHEET_POINTS, |t, v| sheet.at(t, v)) {
            let normal = cell.normal();
            // lit from either side; cloth that is turned away has a deeper color, but is not darker
            let lit = normal.dot(light::key()).abs();
            let deep = sheet.color(cell.u, cell.v).powf(1.45 - 0.45 * lit);
            let material =
                Material { color: deep * (0.80 + 0.22 * lit), normal, kind: SurfaceKind::Cloth };
            // some thickness, so that a fold seen edge-on is denser than one seen head-on
            let thickness = 0.3 * cell.area().sqrt().max(1e-4);
            splats.push(&cell, &Look { thickness, coverage: sheet.coverage(cell.u), material });
        }
        hem(splats, sheet, 0.0);
        hem(splats, sheet, 1.0);
    }
}

/// The hem along an edge of a sheet, as thin needles.
fn hem(splats: &mut Splats, sheet: &Sheet, v: f32) {
    for edge in cells([HEM_POINTS, 1], |t, _| sheet.at(t, v)) {
        let t = edge.u;
        let across = sheet.at(t, v) - sheet.at(t, 1.0 - v);
        let along = edge.along_u.normalize_or_zero();
        let across = (across - along * across.dot(along)).normalize_or_zero();
        let cell = Cell { along_v: across * HEM_WIDTH, ..edge };
        let normal = cell.normal();
        let lit = normal.dot(light::key()).abs();
        let color = sheet.color(t, v).powf(1.3) * (0.75 + 0.25 * lit);
        let material = Material { color, normal, kind: SurfaceKind::Cloth };
        splats.push(&cell, &Look { thickness: 0.002, coverage: 1.8 * sheet.coverage(t), material });
    }
}

/// The shadows on the floor. Nothing else of the floor is visible.
///
/// Over a background b, Gaussians of alpha a and color c give `a c + (1 - a) b`. The background in a light l is `l
/// b`. Both are equal for `a = 1 - min(l)` and `c = b (1 - (1 - l) / a)`.
pub fn floor(splats: &mut Splats, surroundings: &Surroundings) {
    let background = Vec3::from_array(BACKGROUND.map(|channel| channel as f32));
    let square = |u: f32, v: f32| Vec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0) * HALF_BOX;
    for mut cell in cells([FLOOR_POINTS, FLOOR_POINTS], square) {
        cell.position.z = FLOOR;
        // the shadows fade before the floor ends
        let from_middle = cell.position.truncate().length() / HALF_BOX;
        let fade = (1.0 - from_middle.powi(4)).max(0.0);
        let lost = SHADOW * fade * (Vec3::ONE - floor_light(surroundings, cell.position));
        let alpha = lost.max_element();
        let color = background * (Vec3::ONE - lost / alpha.max(1e-3));
        let material = Material { color, normal: Vec3::Z, kind: SurfaceKind::Floor };
        splats.push(&cell, &Look { thickness: 0.002, coverage: alpha, material });
    }
}

/// Light of a round lamp that arrives at a place of the floor.
fn floor_light(surroundings: &Surroundings, position: Vec3) -> Vec3 {
    let ray = |index: usize| {
        let radius = LAMP * ((index as f32 + 0.5) / LAMP_RAYS as f32).sqrt();
        let (sin, cos) = (index as f32 * golden_angle()).sin_cos();
        let direction = (light::key() + Vec3::new(cos, sin, 0.0) * radius).normalize();
        let arrival = surroundings.arrival(position, direction);
        arrival.through_cloth * (Vec3::ONE - PEARL_SHADOW * (1.0 - arrival.past_pearl))
    };
    (0..LAMP_RAYS).map(ray).sum::<Vec3>() / LAMP_RAYS as f32
}
