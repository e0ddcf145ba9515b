//! The unit cube: the space of the networks and the rays.
//!
//! An f32 near 1 has an ulp of 6e-8, and a grid of resolution 4,096 multiplies that error by 4,096. So coordinates
//! are kept in two parts that f32 arithmetic keeps exact; only products of numbers with few enough bits, truncations
//! and differences of neighbors are used, which no compiler may round otherwise.

use glam::Vec3;

use crate::camera::read3;
use muslin::prelude::*;

/// Parts of the cube that a coarse coordinate counts: 12 bits.
pub const PARTS: f32 = 4096.0;

/// Parts that a coarse place on a ray counts: 10 bits, so that its products with coarse coordinates and with numbers of
/// samples are exact.
pub const RAY_PARTS: f32 = 1024.0;

/// A coordinate in two parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split<L = f32> {
    /// A multiple of 1 / [`PARTS`].
    pub coarse: L,
    /// The rest: less than 1 / [`PARTS`], with the coordinate's sign.
    pub fine: L,
}

impl<L: Lane> Split<L> {
    /// The parts of `main + rest`, if `main` has few bits and `rest` is small.
    #[inline(always)]
    pub fn new(main: L, rest: L) -> Self {
        let parts = ((main + rest) * L::splat(PARTS)).truncate();
        let coarse = parts * L::splat(1.0 / PARTS);
        Self { coarse, fine: (main - coarse) + rest }
    }

    /// A number that has no more bits than a coarse coordinate.
    #[inline(always)]
    pub fn whole(coarse: L) -> Self {
        Self { coarse, fine: L::splat(0.0) }
    }

    /// The value, as far as one number can hold it.
    #[inline(always)]
    pub fn value(self) -> L {
        self.coarse + self.fine
    }

    /// `self - other`
    #[inline(always)]
    pub fn minus(self, other: Self) -> Self {
        Self { coarse: self.coarse - other.coarse, fine: self.fine - other.fine }
    }

    /// `self / divisor` limited to [0, 1], a place on a ray: its coarse part is a multiple of 1 / [`RAY_PARTS`].
    #[inline(always)]
    pub fn divide(self, divisor: Self) -> Self {
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        let parts = L::splat(RAY_PARTS);
        let whole = divisor.value();
        let quotient = (self.value() / whole).max(zero).min(one);
        let coarse = (quotient * parts).truncate() * L::splat(1.0 / RAY_PARTS);
        // the product is exact, and so is the difference of neighbors
        let rest = (self.coarse - coarse * divisor.coarse) + (self.fine - coarse * divisor.fine);
        let inside = L::both(zero.less(quotient), quotient.less(one));
        Self { coarse, fine: L::select(inside, rest / whole, zero) }
    }

    /// `self + t v`, for a [place](Self::divide) t.
    #[inline(always)]
    pub fn along(self, t: Self, v: Self) -> Self {
        let rest = self.fine + (t.coarse * v.fine + t.fine * v.value());
        Self::new(self.coarse + t.coarse * v.coarse, rest)
    }

    /// The coordinate, limited to [0, 1].
    #[inline(always)]
    pub fn clamped(self) -> Self {
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        let x = self.coarse + self.fine;
        let inside = L::both(zero.less(x), x.less(one));
        let border = L::select(one.less_equal(x), one, zero);
        Self {
            coarse: L::select(inside, self.coarse, border),
            fine: L::select(inside, self.fine, zero),
        }
    }
}

/// World space -> the unit cube's space: `x' = m + (1 - 2m) (x - lo) / (hi - lo)`, per axis, as `scale (x - low)`.
///
/// The [margin](SceneBox::new) m is 0.05, and 0.25 where what lies outside the box is [contracted](contract).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneBox {
    /// A power of two, about the 4,096th part of the box: world space's coarse coordinates are its multiples.
    pub part: Vec3,
    /// `1 / part`: a GPU's division is not exact.
    pub parts: Vec3,
    /// `lo - m (hi - lo) / (1 - 2m)`, the multiple of `part` below it.
    pub low: Vec3,
    /// The rest of it.
    pub low_rest: Vec3,
    /// `(1 - 2m) / (hi - lo)`, its first 11 bits.
    pub scale: Vec3,
    /// The rest of it.
    pub scale_rest: Vec3,
}

impl SceneBox {
    /// Floats that a box takes in a buffer.
    pub const FLOATS: usize = 18;

    /// The box of a scene's `aabb`, and whether what lies outside is contracted.
    #[cfg(not(target_arch = "spirv"))]
    pub fn new([low, high]: [[f64; 3]; 2], is_contracted: bool) -> Self {
        let (margin, inside) = if is_contracted { (0.25, 0.5) } else { (0.05, 0.9) };
        let [mut part, mut coarse, mut low_rest, mut scale, mut scale_rest] = [Vec3::ZERO; 5];
        for axis in 0..3 {
            let extent = (high[axis] - low[axis]) / inside;
            let begin = low[axis] - margin * extent;
            let unit = libm::exp2(libm::ceil(libm::log2(extent))) / f64::from(PARTS);
            part[axis] = unit as f32;
            coarse[axis] = (libm::floor(begin / unit) * unit) as f32;
            low_rest[axis] = (begin - f64::from(coarse[axis])) as f32;
            scale[axis] = leading_bits(1.0 / extent, 11);
            scale_rest[axis] = (1.0 / extent - f64::from(scale[axis])) as f32;
        }
        Self { part, parts: part.recip(), low: coarse, low_rest, scale, scale_rest }
    }

    /// The box as it lies in a buffer; [`SceneBox::read`] is its counterpart.
    pub fn pack(&self) -> [f32; Self::FLOATS] {
        let rows = [self.part, self.parts, self.low, self.low_rest, self.scale, self.scale_rest];
        core::array::from_fn(|index| rows[index / 3][index % 3])
    }

    /// The box that a buffer holds.
    #[inline(always)]
    pub fn read(buffer: Read<f32>) -> Self {
        Self {
            part: read3(buffer, 0),
            parts: read3(buffer, 3),
            low: read3(buffer, 6),
            low_rest: read3(buffer, 9),
            scale: read3(buffer, 12),
            scale_rest: read3(buffer, 15),
        }
    }

    /// A position in the unit cube's space, in two parts, per axis.
    #[inline(always)]
    pub fn split<L: Lane>(&self, [x, y, z]: [L; 3]) -> [Split<L>; 3] {
        let Self { part, parts, low, low_rest, scale, scale_rest } = *self;
        [
            split_axis(x, [part.x, parts.x, low.x, low_rest.x, scale.x, scale_rest.x]),
            split_axis(y, [part.y, parts.y, low.y, low_rest.y, scale.y, scale_rest.y]),
            split_axis(z, [part.z, parts.z, low.z, low_rest.z, scale.z, scale_rest.z]),
        ]
    }
}

/// A coordinate of [`SceneBox::split`], with the box's values of its axis.
#[inline(always)]
fn split_axis<L: Lane>(x: L, of_axis: [f32; 6]) -> Split<L> {
    let number = L::splat;
    let [part, parts, low, low_rest, scale, scale_rest] = of_axis;
    // exact, and so is the rest: `part` is a power of two
    let coarse = (x * number(parts)).truncate() * number(part);
    let offset = coarse - number(low);
    let rest = (x - coarse) - number(low_rest);
    let rest = offset * number(scale_rest) + rest * number(scale + scale_rest);
    Split::new(offset * number(scale), rest)
}

/// A point of the unit cube's space, seen from the cube's center.
#[inline(always)]
pub fn from_center<L: Lane>([x, y, z]: [Split<L>; 3]) -> [L; 3] {
    let half = Split::whole(L::splat(0.5));
    [x.minus(half).value(), y.minus(half).value(), z.minus(half).value()]
}

/// Mip-NeRF 360's contraction with the maximum norm: all of space to the unit cube, the scene's box to itself.
///
/// Of the offset q from the cube's center it makes `1/2 + q (1/2 - 1/(16 n)) / n`, with `n = max(|q|, 1/4)`. The result is
/// known as well as one f32 knows q.
#[inline(always)]
pub fn contract<L: Lane>([x, y, z]: [L; 3]) -> [Split<L>; 3] {
    let number = L::splat;
    let n = size(x).max(size(y)).max(size(z)).max(number(0.25));
    let factor = (number(0.5) - number(0.0625) / n) / n;
    // 1 within the box: nothing is lost there
    let factor = L::select(number(0.25).less(n), factor, number(1.0));
    let half = number(0.5);
    [Split::new(half, x * factor), Split::new(half, y * factor), Split::new(half, z * factor)]
}

/// |x|
#[inline(always)]
fn size<L: Lane>(x: L) -> L {
    L::select(x.less(L::splat(0.0)), -x, x)
}

/// The first bits of a positive number.
#[cfg(not(target_arch = "spirv"))]
pub fn leading_bits(x: f64, bits: u32) -> f32 {
    f64::from_bits(x.to_bits() >> (53 - bits) << (53 - bits)) as f32
}
