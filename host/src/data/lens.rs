//! How a lens bends light: OpenCV's two models. One bends a pinhole's image, by radial terms (a quotient of polynomials) and
//! tangential ones. The other is for fisheyes, whose radius is a polynomial of the angle to the optical axis.

use crate::camera::Camera;

/// How finely the radius at which a lens folds is looked for, in steps of the squared radius.
const FOLD_STEPS: u32 = 4096;

/// Distortion coefficients. Those of a pinhole are all 0, and it is no fisheye.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lens {
    /// Whether the radius is a function of the angle: an equidistant projection, if all coefficients are 0.
    pub fisheye: bool,
    /// k1 to k4 of a fisheye; otherwise k1, k2, k3 and nerfstudio's k4.
    pub radial: [f64; 4],
    /// k4, k5 and k6 of OpenCV: the radial terms of the denominator.
    pub denominator: [f64; 3],
    /// p1, p2.
    pub tangential: [f64; 2],
}

impl Lens {
    /// Every coefficient.
    pub fn coefficients(&self) -> impl Iterator<Item = f64> {
        self.radial.into_iter().chain(self.denominator).chain(self.tangential)
    }

    /// Whether the photograph is a pinhole image as it is.
    pub fn is_pinhole(&self) -> bool {
        !self.fisheye && self.coefficients().all(|coefficient| coefficient == 0.0)
    }

    /// Where the lens puts a point that a pinhole puts at `[x, y]`, both at depth 1.
    pub fn distort(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let square = x * x + y * y;
        let radial = self.radial(square);
        let [p1, p2] = self.tangential;
        [
            x * radial + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
            y * radial + p1 * (square + 2.0 * y * y) + 2.0 * p2 * x * y,
        ]
    }

    /// The factor by which a radius grows that a pinhole puts at `square`, squared.
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

    /// The squared radius, `farthest` at most, up to which the lens's radial terms are one-to-one.
    ///
    /// Beyond it the radius shrinks again and shows the photograph's inside once more, which no lens does: the
    /// coefficients were fitted to what is in the photograph, and are wrong there.
    fn fold(&self, farthest: f64) -> f64 {
        let square = |step: u32| farthest * f64::from(step) / f64::from(FOLD_STEPS);
        let radius = |step: u32| square(step).sqrt() * self.radial(square(step));
        // A NaN does not grow either.
        let grows = |step: u32| radius(step) > radius(step - 1);
        let fold = (1..=FOLD_STEPS).find(|&step| !grows(step));
        fold.map_or(f64::INFINITY, |step| square(step - 1))
    }
}

/// `1 + k1 x + k2 x^2 + k3 x^3 + k4 x^4`
fn polynomial([k1, k2, k3, k4]: [f64; 4], x: f64) -> f64 {
    1.0 + x * (k1 + x * (k2 + x * (k3 + x * k4)))
}

/// The way from an undistorted image back to the photograph. Both have the camera's intrinsics.
pub(super) struct Undistortion<'a> {
    camera: &'a Camera,
    lens: &'a Lens,
    fold: f64,
}

impl<'a> Undistortion<'a> {
    pub fn new(camera: &'a Camera, lens: &'a Lens) -> Self {
        let [width, height] = [camera.width, camera.height].map(f64::from);
        let mut way = Self { camera, lens, fold: f64::INFINITY };
        let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        let farthest = corners.map(|corner| square_length(way.plane(corner)));
        way.fold = lens.fold(farthest.into_iter().fold(0.0, f64::max));
        way
    }

    /// Where in the photograph a place of the undistorted image is, both in pixels from the upper
    /// left corner; `None` if the photograph does not reach.
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
