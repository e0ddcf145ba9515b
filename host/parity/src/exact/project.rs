//! EWA: a Gaussian on the image plane.

use super::numeric::{Number, cross, dot, row};

/// A camera.
#[derive(Clone, Copy, Debug)]
pub struct View<N> {
    /// Axes in the world: right, down, forward.
    pub axes: [[N; 3]; 3],
    /// Center in the world.
    pub eye: [N; 3],
    /// Focal lengths, in pixels.
    pub focal: [f64; 2],
    /// The principal point, in pixels.
    pub center: [f64; 2],
    /// Width and height, in pixels.
    pub size: [f64; 2],
}

impl<N: Number> View<N> {
    /// A camera as the kernels have it.
    pub fn from_camera(camera: &organza_shaders::camera::Camera) -> Self {
        Self {
            axes: camera.rotation.map(|row| row.as_dvec3().to_array().map(N::from)),
            eye: camera.eye.as_dvec3().to_array().map(N::from),
            focal: camera.focal.as_dvec2().to_array(),
            center: camera.center.as_dvec2().to_array(),
            size: camera.size.as_dvec2().to_array(),
        }
    }

    /// A point of the world in the camera's space: right, down, forward.
    pub fn place(&self, position: [N; 3]) -> [N; 3] {
        let offset = std::array::from_fn(|axis| position[axis] - self.eye[axis]);
        self.axes.map(|axis| dot(axis, offset))
    }

    /// The bounds of x/z (axis 0) and y/z (axis 1) in J: the image's border, and 0.3 of half its size.
    pub fn limits(&self, axis: usize) -> [f64; 2] {
        let focal = self.focal[axis];
        let center = self.center[axis];
        let size = self.size[axis];
        let margin = 0.3 * 0.5 * size / focal;
        [-center / focal - margin, (size - center) / focal + margin]
    }
}

/// A Gaussian in the world.
#[derive(Clone, Copy, Debug)]
pub struct Gaussian<N> {
    /// Its center.
    pub position: [N; 3],
    /// A quaternion of any length but zero: w, x, y, z.
    pub rotation: [N; 4],
    /// Logarithms of the axes.
    pub log_scale: [N; 3],
}

impl<N: Number> Gaussian<N> {
    /// Reads a Gaussian from the tensors `position [N, 3]`, `rotation [N, 4]` and `log_scale [N, 3]`.
    pub fn read(position: &[f32], rotation: &[f32], log_scale: &[f32], index: usize) -> Self {
        Self {
            position: row(position, index),
            rotation: row(rotation, index),
            log_scale: row(log_scale, index),
        }
    }

    /// The lengths of its axes.
    pub fn axes(&self) -> [N; 3] {
        self.log_scale.map(N::exp)
    }
}

/// Where a Gaussian lies in an image.
#[derive(Clone, Copy, Debug)]
pub struct Projected<N> {
    /// Center in the camera's space.
    pub place: [N; 3],
    /// Rows of J W.
    pub jacobian: [[N; 3]; 2],
    /// Rows of J W R S. Their Gram matrix is cov2d without the blur.
    pub footprint: [[N; 3]; 2],
    /// Center, in pixels.
    pub mean: [N; 2],
    /// xx, xy, yy of cov2d, the blur included.
    pub covariance: [N; 3],
    /// The determinant of cov2d.
    pub determinant: N,
}

/// `2 ln 255`: the q at which the falloff ends.
pub fn cutoff() -> f64 {
    2.0 * 255f64.ln()
}

/// The depth of the near plane, as an f32 has it.
pub const NEAR: f64 = 0.01_f32 as f64;

/// Projects a Gaussian; `None` if it is behind the near plane.
pub fn project<N: Number>(
    view: &View<N>,
    blur: f64,
    gaussian: &Gaussian<N>,
) -> Option<Projected<N>> {
    let place @ [x, y, z] = view.place(gaussian.position);
    if z.value() <= NEAR {
        return None;
    }
    let ratios = [x / z, y / z];
    let axes = scaled_axes(gaussian);
    let jacobian: [[N; 3]; 2] = std::array::from_fn(|i| {
        // a clamped ratio is constant
        let [low, high] = view.limits(i);
        let ratio =
            ratios[i].above(high, N::from(high), ratios[i].above(low, ratios[i], N::from(low)));
        let focal = N::from(view.focal[i]) / z;
        std::array::from_fn(|k| (view.axes[i][k] - ratio * view.axes[2][k]) * focal)
    });
    let footprint = jacobian.map(|row| axes.map(|axis| dot(row, axis)));
    let [u, v] = footprint;
    let blur = N::from(blur);
    // the determinant of the Gram matrix: `uu vv - uv uv` would cancel for a needle
    let normal = cross(u, v);
    let uu = dot(u, u);
    let uv = dot(u, v);
    let vv = dot(v, v);
    Some(Projected {
        place,
        jacobian,
        footprint,
        mean: std::array::from_fn(|i| N::from(view.focal[i]) * ratios[i] + N::from(view.center[i])),
        covariance: [uu + blur, uv, vv + blur],
        determinant: dot(normal, normal) + blur * (uu + vv) + blur * blur,
    })
}

/// The axes in the world, with the lengths of the scales.
fn scaled_axes<N: Number>(gaussian: &Gaussian<N>) -> [[N; 3]; 3] {
    let axes = unit_axes(gaussian.rotation);
    std::array::from_fn(|k| {
        let scale = gaussian.log_scale[k].exp();
        axes[k].map(|part| part * scale)
    })
}

/// The axes in the world, of length 1: each is turned by the quaternion, `e + 2 w n x e + 2 n x (n x e)`.
pub fn unit_axes<N: Number>(rotation: [N; 4]) -> [[N; 3]; 3] {
    let [w, x, y, z] = rotation;
    let length = (w * w + x * x + y * y + z * z).sqrt();
    let w = w / length;
    let n = [x, y, z].map(|part| part / length);
    let two = N::from(2.0);
    std::array::from_fn(|k| {
        let unit: [N; 3] = std::array::from_fn(|i| N::from(f64::from(u8::from(i == k))));
        let once = cross(n, unit);
        let twice = cross(n, once);
        std::array::from_fn(|i| unit[i] + two * (w * once[i] + twice[i]))
    })
}

impl<N: Number> Projected<N> {
    /// xx, xy, yy of cov2d's inverse.
    pub fn conic(&self) -> [N; 3] {
        let [xx, xy, yy] = self.covariance;
        [yy, -xy, xx].map(|entry| entry / self.determinant)
    }

    /// The radius of the support: `sqrt(2 ln 255 * largest eigenvalue of cov2d)`, in pixels.
    pub fn radius(&self) -> N {
        let [xx, xy, yy] = self.covariance;
        let half = N::from(0.5);
        let apart = half * (xx - yy);
        let largest = half * (xx + yy) + (apart * apart + xy * xy).sqrt();
        (N::from(cutoff()) * largest).sqrt()
    }

    /// Half the size of the support's bounding box, and the margin for rounding that the kernel gives it, in pixels.
    pub fn extent(&self) -> [N; 2] {
        let [xx, _, yy] = self.covariance;
        [xx, yy].map(|square| (N::from(cutoff()) * square).sqrt() * N::from(1.001) + N::from(0.01))
    }
}
