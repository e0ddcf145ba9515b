//! How a lens bends light: OpenCV's model, with up to three radial terms and two tangential ones.

use crate::camera::Camera;

/// How finely the radius at which a lens folds is looked for, in steps of the squared radius.
const FOLD_STEPS: u32 = 4096;

/// Distortion coefficients; all are zero for a pinhole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lens {
    /// k1, k2, k3.
    pub radial: [f64; 3],
    /// p1, p2.
    pub tangential: [f64; 2],
}

impl Lens {
    /// Whether the photograph is a pinhole image as it is.
    pub fn is_pinhole(&self) -> bool {
        self.radial.iter().chain(&self.tangential).all(|&coefficient| coefficient == 0.0)
    }

    /// Where the lens puts a point that a pinhole puts at `[x, y]`, both at depth 1.
    pub fn distort(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([k1, k2, k3], [p1, p2]) = (self.radial, self.tangential);
        let square = x * x + y * y;
        let radial = 1.0 + square * (k1 + square * (k2 + square * k3));
        [
            x * radial + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
            y * radial + p1 * (square + 2.0 * y * y) + 2.0 * p2 * x * y,
        ]
    }

    /// The squared radius, `farthest` at most, up to which the lens's radial terms are one-to-one.
    ///
    /// Beyond it the polynomial turns around and shows the photograph's inside once more, which no
    /// lens does: the coefficients were fitted to what the photograph has and mean nothing there.
    fn fold(&self, farthest: f64) -> f64 {
        let [k1, k2, k3] = self.radial;
        let grows = |s: f64| 1.0 + s * (3.0 * k1 + s * (5.0 * k2 + s * 7.0 * k3)) > 0.0;
        let square = |step: u32| farthest * f64::from(step) / f64::from(FOLD_STEPS);
        let fold = (1..=FOLD_STEPS).find(|&step| !grows(square(step)));
        fold.map_or(f64::INFINITY, |step| square(step - 1))
    }
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
    /// left corner; none where the photograph does not reach.
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
