//! B3. The division of a pixel's sums, or the background (Eq. 13), for all tiles of a part at once (Eq. 16), and its
//! derivative: pixels along x and y, tiles along z.

use crate::composite::SUM_PLANES;
use crate::tile::Tile;
use muslin::prelude::*;

/// Parameters of [`resolve`] and [`resolve_backward`].
#[params]
pub struct ResolveParams {
    /// S, in pixels.
    pub side: u32,
    /// Background, red.
    pub background_r: f32,
    /// Background, green.
    pub background_g: f32,
    /// Background, blue.
    pub background_b: f32,
    /// The weight above which a sum is divided: [`DIVIDE_ABOVE`].
    pub divide_above: f32,
}

/// Eq. 13: a sum is divided by its weight if that exceeds 1.
pub const DIVIDE_ABOVE: f32 = 1.0;

/// Three channels of a pixel.
#[derive(Clone, Copy)]
struct Color<L> {
    r: L,
    g: L,
    b: L,
}

impl<L: Lane> Color<L> {
    /// A pixel of three planes; its value in the first plane is at `at`.
    #[inline(always)]
    fn read(planes: Read<f32>, at: u32, area: u32) -> Self {
        Self {
            r: L::read(planes, at),
            g: L::read(planes, at + area),
            b: L::read(planes, at + 2 * area),
        }
    }

    #[inline(always)]
    fn write(self, planes: Write<f32>, at: u32, area: u32) {
        self.r.write(planes, at);
        self.g.write(planes, at + area);
        self.b.write(planes, at + 2 * area);
    }

    #[inline(always)]
    fn dot(self, other: Self) -> L {
        self.r * other.r + self.g * other.g + self.b * other.b
    }

    #[inline(always)]
    fn scale(self, factor: L) -> Self {
        Self { r: self.r * factor, g: self.g * factor, b: self.b * factor }
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { r: self.r + other.r, g: self.g + other.g, b: self.b + other.b }
    }

    #[inline(always)]
    fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self {
            r: L::select(mask, yes.r, no.r),
            g: L::select(mask, yes.g, no.g),
            b: L::select(mask, yes.b, no.b),
        }
    }
}

impl ResolveParams {
    /// Which branch of Eq. 13 a weight takes.
    #[inline(always)]
    fn is_divided<L: Lane>(&self, weight: L) -> L::Mask {
        L::splat(self.divide_above).less(weight)
    }

    #[inline(always)]
    fn background<L: Lane>(&self) -> Color<L> {
        Color {
            r: L::splat(self.background_r),
            g: L::splat(self.background_g),
            b: L::splat(self.background_b),
        }
    }
}

/// Writes `image [K, 3, S, S]` (Eq. 13 and 16) from `sum [tiles, 4, S, S]`: the sum divided by its weight if that exceeds 1,
/// and over the background otherwise.
///
/// A tile begins at `3 S S` times its [`output`](Tile::output).
#[kernel(threads(16, 4), over(params.side, params.side, tile.len() / 4), lanes(side))]
pub fn resolve<L: Lane>(
    id: Invocation,
    params: &ResolveParams,
    tile: Read<i32>,
    sum: Read<f32>,
    image: Write<f32>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let t = id.workgroup.z;
        let at = place.y * params.side + place.x;
        let area = params.side * params.side;
        let first = t * SUM_PLANES * area + at;
        let color = Color::<L>::read(sum, first, area);
        let weight = L::read(sum, first + 3 * area);
        let one = L::splat(1.0);
        let covered = color.add(params.background::<L>().scale(one - weight));
        let pixel = Color::select(params.is_divided(weight), color.scale(one / weight), covered);
        pixel.write(image, Tile::read(tile, t).output * 3 * area + at, area);
    }
}

/// The derivative of [`resolve`]: `sum_gradient [tiles, 4, S, S]`, dL/dC and dL/dS, from `image_gradient [K, 3, S, S]`,
/// dL/dI, which has the layout of `image`.
///
/// Of the branch of Eq. 13 that was taken: `dL/dC = dL/dI / S` and `dL/dS = -(dL/dI . C) / S^2` where S passes 1,
/// `dL/dC = dL/dI` and `dL/dS = -(dL/dI . b)` where it does not.
#[kernel(threads(16, 4), over(params.side, params.side, tile.len() / 4), lanes(side))]
pub fn resolve_backward<L: Lane>(
    id: Invocation,
    params: &ResolveParams,
    tile: Read<i32>,
    sum: Read<f32>,
    image_gradient: Read<f32>,
    sum_gradient: Write<f32>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let t = id.workgroup.z;
        let at = place.y * params.side + place.x;
        let area = params.side * params.side;
        let first = t * SUM_PLANES * area + at;
        let color = Color::<L>::read(sum, first, area);
        let weight = L::read(sum, first + 3 * area);
        let output = Tile::read(tile, t).output * 3 * area + at;
        let gradient = Color::<L>::read(image_gradient, output, area);
        let one = L::splat(1.0);
        let is_divided = params.is_divided(weight);
        let inverse = one / weight;
        let divided = gradient.scale(inverse);
        let by_weight = L::select(
            is_divided,
            divided.dot(color) * inverse,
            gradient.dot(params.background::<L>()),
        );
        Color::select(is_divided, divided, gradient).write(sum_gradient, first, area);
        (-by_weight).write(sum_gradient, first + 3 * area);
    }
}
