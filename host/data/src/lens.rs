//! Lens distortion in OpenCV's two models, and panoramas. One model distorts a pinhole's image by radial terms (a
//! quotient of polynomials) and tangential terms. The other is for fisheyes: the radius is a polynomial of the angle to
//! the optical axis. A panorama's columns are longitudes, and its rows latitudes.

use std::f64::consts::PI;

use glam::DVec3;
use organza_core::camera::Camera;

/// Number of steps, in [`Lens::extent`], in the search for the radius at which a lens folds.
const FOLD_STEPS: u32 = 4096;

/// How a lens maps directions. A kind's number is a part of [fingerprints](super::Fingerprint): append new ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Projection {
    /// Onto a plane.
    #[default]
    Plane,
    /// The radius is a function of the angle to the axis. With all coefficients 0, that is an equidistant projection.
    Fisheye,
    /// A panorama of 360 degrees in the equirectangular projection.
    Panorama,
}

/// Distortion coefficients. A pinhole has all 0, and projects onto a plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lens {
    pub projection: Projection,
    /// k1 to k4 of a fisheye. Otherwise k1, k2, k3, and nerfstudio's k4.
    pub radial: [f64; 4],
    /// OpenCV's k4, k5 and k6: the radial terms of the denominator.
    pub denominator: [f64; 3],
    /// p1 and p2, the tangential coefficients.
    pub tangential: [f64; 2],
    /// The photograph that the camera's image is cut from; `None` if the image is the whole photograph.
    pub cut: Option<Reprojection>,
}

/// How a pinhole view is cut from a photograph with too wide a view for one plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reprojection {
    /// The view's axes in the photograph's camera space: right, down and forward.
    pub axes: [DVec3; 3],
    /// Focal lengths of the photograph in pixels; pixels in a radian for a panorama.
    pub focal: [f64; 2],
    /// Its principal point in pixels.
    pub center: [f64; 2],
    /// Its width and height in pixels.
    pub size: [u32; 2],
}

impl Reprojection {
    /// The whole photograph of a camera.
    pub fn whole(camera: &Camera) -> Self {
        Self {
            axes: DVec3::AXES,
            focal: [camera.fl_x, camera.fl_y],
            center: [camera.cx, camera.cy],
            size: [camera.width, camera.height],
        }
    }
}

impl Lens {
    /// Every coefficient.
    pub fn coefficients(&self) -> impl Iterator<Item = f64> {
        self.radial.into_iter().chain(self.denominator).chain(self.tangential)
    }

    /// Whether the photograph is a pinhole image already.
    pub fn is_pinhole(&self) -> bool {
        self.projection == Projection::Plane
            && self.coefficients().all(|coefficient| coefficient == 0.0)
    }

    /// Where a direction is in the photograph, on the plane at depth 1. In a panorama, that is longitude and latitude.
    pub fn project(&self, direction: DVec3) -> [f64; 2] {
        let DVec3 { x, y, z } = direction;
        let square = self.extent(direction);
        let radial = self.radial(square);
        match self.projection {
            Projection::Panorama => [x.atan2(z), y.atan2(x.hypot(z))],
            Projection::Fisheye => {
                let angle = square.sqrt();
                let factor = radial * if angle > 0.0 { angle / x.hypot(y) } else { 1.0 };
                [x * factor, y * factor]
            }
            Projection::Plane => {
                let [x, y] = [x / z, y / z];
                let [p1, p2] = self.tangential;
                [
                    x * radial + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
                    y * radial + p1 * (square + 2.0 * y * y) + 2.0 * p2 * x * y,
                ]
            }
        }
    }

    /// The square of the variable of the radial terms: a fisheye's angle to the axis, or else the radius at depth 1.
    fn extent(&self, DVec3 { x, y, z }: DVec3) -> f64 {
        match self.projection {
            Projection::Fisheye => x.hypot(y).atan2(z).powi(2),
            _ => (x * x + y * y) / (z * z),
        }
    }

    /// The factor of the root of an extent.
    fn radial(&self, square: f64) -> f64 {
        let [k4, k5, k6] = self.denominator;
        polynomial(self.radial, square) / polynomial([k4, k5, k6, 0.0], square)
    }

    /// The extent, at most `farthest`, up to which the radial terms are one-to-one.
    ///
    /// Beyond it the radius shrinks again, and would show the photograph's inside once more. No lens does that: the
    /// coefficients were fitted to points in the photograph, and are wrong beyond.
    fn fold(&self, farthest: f64) -> f64 {
        let square = |step: u32| farthest * f64::from(step) / f64::from(FOLD_STEPS);
        let radius = |step: u32| square(step).sqrt() * self.radial(square(step));
        // NaN does not grow either.
        let grows = |step: u32| radius(step) > radius(step - 1);
        let fold = (1..=FOLD_STEPS).find(|&step| !grows(step));
        fold.map_or(f64::INFINITY, |step| square(step - 1))
    }
}

/// `1 + k1 x + k2 x^2 + k3 x^3 + k4 x^4`
fn polynomial([k1, k2, k3, k4]: [f64; 4], x: f64) -> f64 {
    1.0 + x * (k1 + x * (k2 + x * (k3 + x * k4)))
}

/// Maps an undistorted image to the photograph.
pub(super) struct Undistortion<'a> {
    camera: &'a Camera,
    lens: &'a Lens,
    cut: Reprojection,
    fold: f64,
}

impl<'a> Undistortion<'a> {
    pub fn new(camera: &'a Camera, lens: &'a Lens) -> Self {
        let cut = lens.cut.unwrap_or(Reprojection::whole(camera));
        let mut undistortion = Self { camera, lens, cut, fold: f64::INFINITY };
        let [width, height] = [camera.width, camera.height].map(f64::from);
        let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        let farthest = match lens.projection {
            Projection::Fisheye => PI * PI,
            _ => corners
                .map(|corner| lens.extent(undistortion.direction(corner)))
                .into_iter()
                .fold(0.0, f64::max),
        };
        undistortion.fold = lens.fold(farthest);
        undistortion
    }

    /// The place in the photograph of a place in the undistorted image. Both are in pixels from the upper left
    /// corner. `None` if it is outside of the photograph.
    pub fn source(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let direction = self.direction(place);
        let is_folded =
            self.lens.projection != Projection::Panorama && self.lens.extent(direction) > self.fold;
        let Reprojection { focal, center, size, .. } = self.cut;
        let place = self.lens.project(direction);
        let source = [0, 1].map(|axis| focal[axis] * place[axis] + center[axis]);
        let is_inside = |axis: usize| (0.0..=f64::from(size[axis])).contains(&source[axis]);
        (!is_folded && is_inside(0) && is_inside(1)).then_some(source)
    }

    /// The direction of a place in the undistorted image, in the axes of the photograph's camera.
    fn direction(&self, [x, y]: [f64; 2]) -> DVec3 {
        let Camera { fl_x, fl_y, cx, cy, .. } = *self.camera;
        let [right, down, forward] = self.cut.axes;
        right * ((x - cx) / fl_x) + down * ((y - cy) / fl_y) + forward
    }
}
