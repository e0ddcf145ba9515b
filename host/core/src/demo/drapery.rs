//! The two sheets of cloth: ribbons in orbit around the pearl, with folds.

use std::f32::consts::{PI, TAU};

use glam::{Mat3, Vec3};

use super::shape::smoothstep;

/// Alpha of one layer of cloth, seen head-on.
const COVERAGE: f32 = 0.45;

/// A sheet over the parameters t along it and v across it, each from 0 to 1.
///
/// Its center line runs around a tilted axis from one radius to another. Across, the sheet leans away from the axis
/// by an angle that changes along it. Folds displace it along its normal: a billow, slanted pleats, and ruffles that
/// grow toward the loose edge at v = 1.
#[derive(Debug)]
pub struct Sheet {
    /// Rotations of the axis around x and y, in radians.
    pub tilt: [f32; 2],
    /// Azimuth at t = 0, and the further angle up to t = 1, in radians.
    pub azimuth: [f32; 2],
    /// Distance from the axis at t = 0 and t = 1.
    pub radius: [f32; 2],
    /// Height that the center line climbs along the axis.
    pub rise: f32,
    pub width: f32,
    /// Leaning angle at t = 0, and its increase up to t = 1, in radians.
    pub lean: [f32; 2],
    /// Height of the billow.
    pub fold: f32,
    /// Number of pleats from end to end.
    pub pleats: f32,
    /// Colors of its two ends.
    pub hue: [Vec3; 2],
    /// Optical depth for red, green and blue light, relative to the visible depth.
    pub absorption: Vec3,
}

/// Coral outside, blue inside.
pub const SHEETS: [Sheet; 2] = [
    Sheet {
        tilt: [0.48, -0.32],
        azimuth: [1.49, 6.82],
        radius: [0.87, 0.86],
        rise: 0.29,
        width: 0.72,
        lean: [-0.23, -0.22],
        fold: 0.077,
        pleats: 7.2,
        hue: [Vec3::new(0.96, 0.34, 0.40), Vec3::new(1.0, 0.62, 0.38)],
        absorption: Vec3::new(0.12, 1.25, 1.0),
    },
    Sheet {
        tilt: [0.1, -0.2],
        azimuth: [-0.4, 5.0],
        radius: [0.70, 0.86],
        rise: 0.30,
        width: 0.55,
        lean: [0.0, 1.2],
        fold: 0.081,
        pleats: 4.0,
        hue: [Vec3::new(0.14, 0.42, 0.84), Vec3::new(0.14, 0.70, 0.78)],
        absorption: Vec3::new(1.4, 0.6, 0.15),
    },
];

impl Sheet {
    /// The point at (t, v).
    pub fn at(&self, t: f32, v: f32) -> Vec3 {
        let [start, sweep] = self.azimuth;
        let (sin, cos) = (start + sweep * t).sin_cos();
        let outward = Vec3::new(cos, sin, 0.0);
        let radius = self.radius[0] + (self.radius[1] - self.radius[0]) * t;
        let lean = self.lean[0] + self.lean[1] * (t + 0.25 * (TAU * t).sin());
        let across = Vec3::Z * lean.cos() + outward * lean.sin();
        let normal = outward * lean.cos() - Vec3::Z * lean.sin();

        // the ends taper and have no folds
        let taper = (PI * t.clamp(0.0, 1.0)).sin().max(0.0).sqrt();
        let calm = smoothstep(t / 0.22) * smoothstep((1.0 - t) / 0.22);
        let middle = outward * radius + Vec3::Z * (self.rise * (t - 0.5));
        let point = middle
            + across * ((v - 0.5) * self.width * taper)
            + normal * (self.fold * calm * self.folds(t, v));
        Mat3::from_rotation_x(self.tilt[0]) * Mat3::from_rotation_y(self.tilt[1]) * point
    }

    /// Displacement along the normal, in units of the billow's height.
    fn folds(&self, t: f32, v: f32) -> f32 {
        let s = v - 0.5;
        // evenly spaced pleats would look like corrugated iron
        let pace = self.pleats * (t + 0.018 * (TAU * 2.7 * t + self.azimuth[0]).sin());
        let wave =
            |pleats: f32, slant: f32, phase: f32| (TAU * (pleats * pace + slant * s) + phase).sin();
        let fixed_edge = (1.0 - v) * (1.0 - v);
        wave(0.5, 0.35, 0.4)
            + 0.55 * wave(1.0, 0.65, 1.0) * (0.3 + 0.7 * v)
            + 0.55 * wave(2.1, -0.6, 1.3) * v * v
            + 0.22 * wave(4.3, 0.4, 2.1) * v * v * v
            + 0.16 * wave(3.2, -0.3, 0.3) * fixed_edge
    }

    /// Alpha of the sheet seen head-on; its ends fade out.
    pub fn coverage(&self, t: f32) -> f32 {
        COVERAGE * smoothstep(t / 0.09) * smoothstep((1.0 - t) / 0.09)
    }

    /// Optical depth of the sheet seen head-on: it lets `1 - coverage` through.
    pub fn depth(&self, t: f32) -> f32 {
        -(1.0 - self.coverage(t)).ln()
    }

    /// The sheet's own color. It changes along the sheet, and a little across.
    pub fn color(&self, t: f32, v: f32) -> Vec3 {
        let place = 0.15 + 0.7 * t + 0.3 * (v - 0.5);
        self.hue[0].lerp(self.hue[1], place.clamp(0.0, 1.0))
    }
}

/// Optical depth of one full layer, seen head-on.
pub fn full_depth() -> f32 {
    -(1.0 - COVERAGE).ln()
}
