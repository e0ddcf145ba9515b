//! The camera model: from a point in the camera's space to a pixel, and back to gradients.
//!
//! Each lens is a file in `lens/`, with the projection, its Jacobian J and the derivatives of both.  Kernels are compiled
//! for the lens that this file names [`Lens`].  A lens is a struct with
//!
//! - `fn sees<L: Lane>(t: [L; 3]) -> L::Mask`: whether points t of the camera's space can be projected.  Gaussians elsewhere are
//!   culled;
//! - `fn place<L: Lane>(camera: &Camera, t: [L; 3]) -> ([L; 2], L)`: `pixel` of points that the lens sees, and the sum of the squares of
//!   J, or more. It shows which Gaussians end before the tiles;
//! - `fn new(camera: &Camera, t: Vec3) -> Self`: the projection of t.  If the lens does not see t, the result is any finite
//!   value;
//! - `pixel`: the projected point, in pixels;
//! - `row_x`, `row_y`: the rows of `J W`, as EWA uses them (Zwicker et al. 2002): the derivatives of `pixel` with respect
//!   to a position in world space.  W is the camera's rotation;
//! - `fn backward(&self, camera: &Camera, pixel: Vec2, row_x: Vec3, row_y: Vec3) -> Vec3`: the gradient of a loss with
//!   respect to t, from its gradients with respect to `pixel`, `row_x` and `row_y`.

mod pinhole;

pub use pinhole::Pinhole as Lens;

/// A Gaussian at this depth or nearer is culled.
pub const NEAR_PLANE: f32 = 0.01;
