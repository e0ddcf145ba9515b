//! Lens distortion in OpenCV's two models. One distorts a pinhole's image by radial terms (a quotient of polynomials)
//! and tangential terms. The other is for fisheyes: the radius is a polynomial of the angle to the optical axis.

use organza_core::camera::Camera;

/// Number of steps, in squared radius, in the search for the radius at which a lens folds.
const FOLD_STEPS: u32 = 4096;

/// Distortion coefficients. A pinhole has all 0, and is no fisheye.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lens {
    /// Whether the radius is a function of the angle. With all coefficients 0, that is an equidistant projection.
    pub fisheye: bool,
    /// k1 to k4 of a fisheye. Otherwise k1, k2, k3, and nerfstudio's k4.
    pub radial: [f64; 4],
    /// OpenCV's k4, k5 and k6: the radial terms of the denominator.
    pub denominator: [f64; 3],
    /// p1 and p2, the tangential coefficients.
    pub tangential: [f64; 2],
}

impl Lens {
    /// Every coefficient.
    pub fn coefficients(&self) -> impl Iterator<Item = f64> {
        self.radial.into_iter().chain(self.denominator).chain(self.tangential)
    }

    /// Whether the photograph is a pinhole image already.
    pub fn is_pinhole(&self) -> bool {
        !self.fisheye && self.coefficients().all(|coefficient| coefficient == 0.0)
    }

    /// The distorted place of a point that a pinhole shows at `[x, y]`, both at depth 1.
    pub fn distort(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let square = x * x + y * y;
        let radial = self.radial(square);
        let [p1, p2] = self.tangential;
        [
            x * radial + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
            y * radial + p1 * (square + 2.0 * y * y) + 2.0 * p2 * x * y,
        ]
    }

    /// The factor of a point's radius, whose square is `square` in a pinhole's image.
    fn radial(&self, square: f64) -> f64 {
        if self.fisheye {
            let radius = square.sqrt();
            let angle = radius.atan();
            let ratio = if radius > 0.0 { angle / radius } else { 1.0 };
            return ratio * polynomial(self.radial, angle * angle);
        }
        let [k4, k5, k6] = self.denominator;
        polynomial(self.radial, square) / polynomial([k4, k5, k6, 0.0], square)
    }

    /// The squared radius, at most `farthest`, up to which the radial terms are one-to-one.
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

/// Maps an undistorted image to the photograph. Both have the camera's intrinsics.
pub(super) struct Undistortion<'a> {
    camera: &'a Camera,
    lens: &'a Lens,
    fold: f64,
}

impl<'a> Undistortion<'a> {
    pub fn new(camera: &'a Camera, lens: &'a Lens) -> Self {
        let [width, height] = [camera.width, camera.height].map(f64::from);
        let mut undistortion = Self { camera, lens, fold: f64::INFINITY };
        let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        let farthest = corners.map(|corner| square_length(undistortion.plane(corner)));
        undistortion.fold = lens.fold(farthest.into_iter().fold(0.0, f64::max));
        undistortion
    }

    /// The place in the photograph of a place in the undistorted image. Both are in pixels from the upper left
    /// corner. `None` if it is outside of the photograph.
    pub fn source(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let Camera { fl_x, fl_y, cx, cy, width, height, .. } = *self.camera;
        let plane = self.plane(place);
        if square_length(plane) > self.fold {
            return None;
        }
        let [x, y] = self.lens.distort(plane);
        let source = [fl_x * x + cx, fl_y * y + cy];
        let inside = |place: f64, side: u32| (0.0..=f64::from(side)).contains(&place);
        (inside(source[0], width) && inside(source[1], height)).then_some(source)
    }

    fn plane(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [(x - self.camera.cx) / self.camera.fl_x, (y - self.camera.cy) / self.camera.fl_y]
    }
}

fn square_length([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
}
