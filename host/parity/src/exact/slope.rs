//! Eq. 17: how a pair's color grows per pixel.

use super::numeric::Number;
use super::project::Projected;

/// Where a Gaussian is densest along a pixel's ray, in standard deviations along its own axes: per pixel to the right, and
/// per pixel down. `conic` is xx, xy, yy of cov2d's inverse.
pub fn axes<N: Number>(projected: &Projected<N>, [xx, xy, yy]: [N; 3]) -> [[N; 3]; 2] {
    let [u, v] = projected.footprint;
    [[xx, xy], [xy, yy]].map(|[by_u, by_v]| std::array::from_fn(|k| u[k] * by_u + v[k] * by_v))
}

/// The growth of red, green and blue along x and y, of the slope `[axis, channel]`.
pub fn growth<N: Number>(slope: [[N; 3]; 3], axes: [[N; 3]; 2]) -> [[N; 3]; 2] {
    axes.map(|axes| {
        std::array::from_fn(|channel| Number::sum((0..3).map(|k| slope[k][channel] * axes[k])))
    })
}
