//! A `Vec4` of lanes: four numbers for each of several samples.

use glam::Vec4;

use crate::lane::Lane;
use crate::samples::Samples;

/// Four numbers for each sample: a `Vec4` of lanes, such as four outputs of a layer.
#[derive(Clone, Copy)]
pub struct LaneVec4<L> {
    /// First number.
    pub x: L,
    /// Second number.
    pub y: L,
    /// Third number.
    pub z: L,
    /// Fourth number.
    pub w: L,
}

impl<S: Samples> LaneVec4<S> {
    /// The same four values in every lane.
    #[inline(always)]
    pub fn splat(values: Vec4) -> Self {
        let number = S::splat;
        Self { x: number(values.x), y: number(values.y), z: number(values.z), w: number(values.w) }
    }

    /// `self + weight x`
    #[inline(always)]
    pub fn add_product(self, weight: Vec4, x: S) -> Self {
        Self {
            x: x.mul_add(S::splat(weight.x), self.x),
            y: x.mul_add(S::splat(weight.y), self.y),
            z: x.mul_add(S::splat(weight.z), self.z),
            w: x.mul_add(S::splat(weight.w), self.w),
        }
    }
}

impl<L: Lane> LaneVec4<L> {
    /// The same numbers, each of them [materialized](Lane::materialize).
    #[inline(always)]
    #[must_use]
    pub fn materialize(self) -> Self {
        let Self { x, y, z, w } = self;
        Self { x: x.materialize(), y: y.materialize(), z: z.materialize(), w: w.materialize() }
    }
}
