//! The camera model: where a point of the camera's space lies in the image, and how the image moves with it.
//!
//! A lens is a file of `lens/`: the projection, its Jacobian and their derivatives.  Kernels are compiled for the one that
//! is called [`Lens`] here.  It is a struct with
//!
//! - `fn sees(t: Vec3) -> bool`: whether a point of the camera's space can be projected.  Others are culled;
//! - `fn new(camera: &Camera, t: Vec3) -> Self`: the projection of a point.  It must also take a point that is not seen,
//!   and divide by nothing that is zero there;
//! - `pixel`: where the point lies in the image, in pixels;
//! - `row_x`, `row_y`: the rows of `J W`, the derivatives of `pixel` with respect to a position in world space, as EWA takes
//!   them (Zwicker et al. 2002): W is the camera's rotation;
//! - `fn backward(&self, camera: &Camera, pixel: Vec2, row_x: Vec3, row_y: Vec3) -> Vec3`: a loss's gradient with respect
//!   to t, of its gradients with respect to `pixel`, `row_x` and `row_y`.

mod pinhole;

pub use pinhole::Pinhole as Lens;

/// A Gaussian at this depth or nearer is culled.
pub const NEAR_PLANE: f32 = 0.01;
