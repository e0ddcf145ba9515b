//! Eq. 12: what a pair adds to a pixel.

use glam::Vec4;

use super::numeric::{Number, Rounded};
use super::project::cutoff;

/// A pair in the image.
#[derive(Clone, Copy, Debug)]
pub struct Splat<N> {
    /// Center, in pixels.
    pub mean: [N; 2],
    /// `opacity T`
    pub weight: N,
    /// xx, xy, yy of cov2d's inverse.
    pub conic: [N; 3],
    /// c
    pub color: [N; 3],
    /// How c grows along x and y (Eq. 17), if it does.
    pub growth: Option<[[N; 3]; 2]>,
    /// k of Eq. 18, if the falloff has a shape.
    pub flatness: Option<N>,
}

/// `opacity T`, from the opacity's logit: alpha without the falloff.
pub fn weight<N: Number>(logit: N, transmittance: N) -> N {
    logit.sigmoid() * transmittance
}

/// The factor of a compensated weight, `sqrt(det(cov2d) / det(cov2d + blur I))`, from the conic of the blurred covariance. At
/// least 1/255; there it is constant.
pub fn compensation<N: Number>([xx, xy, yy]: [N; 3], blur: f64) -> N {
    let min = N::from(1.0 / 255.0);
    let blur = N::from(blur);
    let determinant = xx * yy - xy * xy;
    // cov2d, without the blur
    let a = yy / determinant - blur;
    let b = xx / determinant - blur;
    let c = xy / determinant;
    let quotient = (a * b - c * c) * determinant;
    quotient.above((min * min).value(), quotient.sqrt(), min)
}

/// `exp(-q/2)` up to the cutoff, and 0 behind it. Rounding may have taken q of a needle below 0.
pub fn falloff<N: Number>(q: N) -> N {
    let inside = if q.value() < 0.0 { q - N::from(q.value()) } else { q };
    let inside = (N::from(-0.5) * inside).exp().between(0.0, 1.0);
    q.above(cutoff(), N::from(0.0), inside)
}

/// k of Eq. 18, of the tensor's value.
pub fn flatness<N: Number>(shape: N) -> N {
    let e = (-shape.abs()).exp();
    let [one, two] = [1.0, 2.0].map(N::from);
    shape.above(0.0, (one - e) / (one + two * e), (e - one) / (e + two))
}

/// dk/ds, of k.
pub fn flatness_slope(flatness: f32) -> Rounded {
    let [k, one] = [f64::from(flatness), 1.0].map(Rounded::from);
    (k + Rounded::from(0.5)) * (one - k) * Rounded::from(2.0 / 3.0)
}

/// Eq. 18: a falloff f with a shape.
pub fn shaped<N: Number>(f: N, flatness: N) -> N {
    let g = f * (N::from(2.0) - f);
    let disc = g * g * (N::from(3.0) - N::from(2.0) * g);
    f + flatness * (disc - f)
}

impl<N: Number> Splat<N> {
    /// A splat as the kernels have it.
    pub fn from_vectors(vectors: &[Vec4; 3]) -> Self {
        let numbers = vectors.map(|vector| vector.to_array().map(|x| N::from(x.into())));
        let [[x, y, weight, _], [xx, xy, yy, _], [r, g, b, _]] = numbers;
        let [conic, color] = [[xx, xy, yy], [r, g, b]];
        Self { mean: [x, y], weight, conic, color, growth: None, flatness: None }
    }

    /// The same, with a color that grows as the kernels have it.
    pub fn growing(self, vectors: &[Vec4]) -> Self {
        let growth = [0, 1].map(|at| vectors[at].truncate().to_array().map(|x| N::from(x.into())));
        Self { growth: Some(growth), ..self }
    }

    /// `q = d^T cov2d^-1 d`, d from the center to a place of the image.
    pub fn q(&self, place: [f64; 2]) -> N {
        let [dx, dy] = [0, 1].map(|axis| N::from(place[axis]) - self.mean[axis]);
        let [xx, xy, yy] = self.conic;
        xx * dx * dx + N::from(2.0) * xy * dx * dy + yy * dy * dy
    }

    /// `alpha c` and alpha at the center of a pixel.
    pub fn term(&self, place: [f64; 2]) -> [N; 4] {
        let falloff = falloff(self.q(place));
        let alpha = self.weight * self.flatness.map_or(falloff, |k| shaped(falloff, k));
        let [dx, dy] = [0, 1].map(|axis| N::from(place[axis]) - self.mean[axis]);
        let color = match self.growth {
            Some([x, y]) => std::array::from_fn(|c| self.color[c] + y[c] * dy + x[c] * dx),
            None => self.color,
        };
        let [r, g, b] = color.map(|c| alpha * c);
        [r, g, b, alpha]
    }
}
