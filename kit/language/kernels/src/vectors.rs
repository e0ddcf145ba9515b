//! Methods of glam's vectors. The compiler makes one instruction of what is done to all components, and GLSL leaves something open in some of these, such as
//! where `Round` has halves.

use muslin::glam::swizzles::{Vec2Swizzles, Vec3Swizzles, Vec4Swizzles};
use muslin::prelude::*;

use crate::{CountParams, rows};

/// What a method gives, as four numbers.
trait Four<T> {
    /// The components, and zeros.
    fn four(self) -> T;
}

macro_rules! four {
    ($four:ident, $number:ident: $($of:ty, $value:ident => $result:expr;)*) => {$(
        impl Four<$four> for $of {
            #[inline(always)]
            fn four(self) -> $four {
                let $value = self;
                $result
            }
        }
    )*};
}

macro_rules! four_of {
    ($four:ident, $three:ident, $two:ident, $number:ident) => {
        four! { $four, $number:
            $four, v => v;
            $three, v => v.extend(0 as $number);
            $two, v => v.extend(0 as $number).extend(0 as $number);
            $number, x => $four::splat(x);
            bool, is => $four::splat(is as u32 as $number);
        }
    };
}

four_of!(Vec4, Vec3, Vec2, f32);
four_of!(IVec4, IVec3, IVec2, i32);
four_of!(UVec4, UVec3, UVec2, u32);

/// A vector's first components.
trait First<T> {
    /// As many as the type has.
    fn first(self) -> T;
}

macro_rules! first {
    ($four:ident, $three:ident, $two:ident) => {
        impl First<$four> for $four {
            #[inline(always)]
            fn first(self) -> $four {
                self
            }
        }
        impl First<$three> for $four {
            #[inline(always)]
            fn first(self) -> $three {
                self.truncate()
            }
        }
        impl First<$two> for $four {
            #[inline(always)]
            fn first(self) -> $two {
                self.truncate().truncate()
            }
        }
    };
}

first!(Vec4, Vec3, Vec2);
first!(IVec4, IVec3, IVec2);
first!(UVec4, UVec3, UVec2);

/// Methods whose names have the number of components.
trait OfSize: Copy {
    /// Integers, and back.
    fn through_integers(self) -> Self;
    /// The components in another order.
    fn turned(self) -> Self;
    /// The cross product of three components; of two, the rotated vector and its right angle.
    fn product(self, other: Self) -> Self;
}

macro_rules! of_size {
    ($($type:ident, $integers:ident, $floats:ident, $order:ident, [$a:ident, $b:ident] => $product:expr;)*) => {$(
        impl OfSize for $type {
            #[inline(always)]
            fn through_integers(self) -> Self {
                self.$integers().$floats()
            }

            #[inline(always)]
            fn turned(self) -> Self {
                self.$order()
            }

            #[inline(always)]
            fn product(self, other: Self) -> Self {
                let [$a, $b] = [self, other];
                $product
            }
        }
    )*};
}

of_size! {
    Vec2, as_ivec2, as_vec2, yx, [a, b] => a.rotate(b) + a.perp() * a.perp_dot(b);
    Vec3, as_ivec3, as_vec3, zxy, [a, b] => a.cross(b);
    Vec4, as_ivec4, as_vec4, wzyx, [a, b] => a.truncate().cross(b.truncate()).extend(a.w);
}

/// Floats that are integers, and back.
trait ThroughFloats {
    /// The same numbers, of 24 bits.
    fn through_floats(self) -> Self;
}

macro_rules! through_floats {
    ($($type:ident, $floats:ident, $back:ident;)*) => {$(
        impl ThroughFloats for $type {
            #[inline(always)]
            fn through_floats(self) -> Self {
                self.$floats().$back()
            }
        }
    )*};
}

through_floats! {
    IVec2, as_vec2, as_ivec2;
    IVec3, as_vec3, as_ivec3;
    IVec4, as_vec4, as_ivec4;
    UVec2, as_vec2, as_uvec2;
    UVec3, as_vec3, as_uvec3;
    UVec4, as_vec4, as_uvec4;
}

/// A kernel that writes each method of the vectors of two, three and four components.
macro_rules! methods {
    (
        $(#[$doc:meta])*
        $kernel:ident, $names:ident, $four:ident, $three:ident, $two:ident,
        [$x:ident, $y:ident, $a:ident, $b:ident, $n:ident, $vector:ident];
        $($name:literal: $value:expr,)*
    ) => {
        #[doc = concat!("The methods in each part of [`", stringify!($kernel), "`].")]
        pub const $names: &[&str] = &[$($name),*];

        $(#[$doc])*
        #[kernel(threads(64), over(params.count))]
        pub fn $kernel(
            id: Invocation,
            params: &CountParams,
            x: Read<$four>,
            y: Read<$four>,
            a: Read<$four>,
            b: Read<$four>,
            n: Read<$four>,
            values: Write<$four>,
        ) {
            let index = id.index();
            if index < params.count {
                methods! { @of $two, 0, index, params, [x, y, a, b, n], values; [$x, $y, $a, $b, $n, $vector, $four, $names]; $($value,)* }
                methods! { @of $three, 1, index, params, [x, y, a, b, n], values; [$x, $y, $a, $b, $n, $vector, $four, $names]; $($value,)* }
                methods! { @of $four, 2, index, params, [x, y, a, b, n], values; [$x, $y, $a, $b, $n, $vector, $four, $names]; $($value,)* }
            }
        }
    };
    (
        @of $type:ident, $part:literal, $index:ident, $params:ident,
        [$of_x:ident, $of_y:ident, $of_a:ident, $of_b:ident, $of_n:ident], $values:ident;
        [$x:ident, $y:ident, $a:ident, $b:ident, $n:ident, $vector:ident, $four:ident, $names:ident];
        $($value:expr,)*
    ) => {
        {
            type $vector = $type;
            let $x: $type = $of_x.read($index).first();
            let $y: $type = $of_y.read($index).first();
            let $a: $type = $of_a.read($index).first();
            let $b: $type = $of_b.read($index).first();
            let $n: $type = $of_n.read($index).first();
            const ROWS: u32 = $names.len() as u32;
            rows! { $values [$params.count] at $index + $part * $params.count * ROWS; $(Four::<$four>::four($value),)* }
        }
    };
}

methods! {
    /// `values [3, FLOAT_METHODS, count]` of `x` and `y`, of `a` and `b`, which are moderate, and of `n`, which has the length 1; all `[count]`.
    float_vectors, FLOAT_METHODS, Vec4, Vec3, Vec2, [x, y, a, b, n, V];
    "round": x.round(),
    "floor": x.floor(),
    "ceil": x.ceil(),
    "trunc": x.trunc(),
    "fract": x.fract(),
    "fract_gl": x.fract_gl(),
    "abs": x.abs(),
    "neg": -x,
    "signum": x.signum(),
    "copysign": x.copysign(y),
    "step": y.step(x),
    "min": x.min(y),
    "max": x.max(y),
    "clamp": x.clamp(V::splat(-1.0), V::splat(1.5)),
    "max, min": x.max(-y.abs()).min(y.abs()),
    "saturate": x.saturate(),
    "min_element": x.min_element(),
    "max_element": x.max_element(),
    "min_position": x.min_position() as u32 as f32,
    "max_position": x.max_position() as u32 as f32,
    "cmpeq": V::select(x.cmpeq(y), V::ONE, V::ZERO),
    "cmpne": V::select(x.cmpne(y), V::ONE, V::ZERO),
    "cmplt": V::select(x.cmplt(y), V::ONE, V::ZERO),
    "cmple": V::select(x.cmple(y), V::ONE, V::ZERO),
    "cmpgt": V::select(x.cmpgt(y), V::ONE, V::ZERO),
    "cmpge": V::select(x.cmpge(y), V::ONE, V::ZERO),
    "select": V::select(x.cmpge(y), x, y),
    "any": x.cmplt(y).any(),
    "all": x.cmplt(y).all(),
    "bitmask": x.cmplt(y).bitmask() as f32,
    "==": x == y,
    "!=": x != y,
    "is_negative_bitmask": x.is_negative_bitmask() as f32,
    "is_finite": x.is_finite(),
    "is_nan": x.is_nan(),
    "is_nan of 0 / 0": ((x - x.min(x)) / (x.max(x) - x)).is_nan(),
    "is_nan_mask": V::select(x.is_nan_mask(), V::ZERO, x),
    "abs_diff_eq": x.abs_diff_eq(y, 0.75),
    "with_y": x.with_y(7.0),
    "as integers": x.clamp(V::splat(-1e6), V::splat(1e6)).through_integers(),
    "a + b": a + b,
    "a - b": a - b,
    "a * b": a * b,
    "a / b": a / (b + b.signum()),
    "a + 1.5": a + 1.5,
    "2.0 - a": 2.0 - a,
    "a * 3.0": a * 3.0,
    "a / 3.0": a / 3.0,
    "1.0 / a": 1.0 / (a + a.signum()),
    "recip": (a + a.signum()).recip(),
    "sqrt": a.abs().sqrt(),
    "exp": a.exp(),
    "element_sum": a.element_sum(),
    "element_product": a.element_product(),
    "dot": a.dot(b),
    "dot_into_vec": a.dot_into_vec(b),
    "length": a.length(),
    "length_squared": a.length_squared(),
    "length_recip": (a + V::ONE).length_recip(),
    "distance": a.distance(b),
    "distance_squared": a.distance_squared(b),
    "normalize": (a + V::ONE).normalize(),
    "try_normalize": a.try_normalize().is_some(),
    "normalize_or": a.normalize_or(n),
    "normalize_or_zero": a.normalize_or_zero(),
    "is_normalized": n.is_normalized(),
    "project_onto": a.project_onto(b + V::ONE),
    "reject_from": a.reject_from(b + V::ONE),
    "project_onto_normalized": a.project_onto_normalized(n),
    "reject_from_normalized": a.reject_from_normalized(n),
    "lerp": a.lerp(b, 0.3),
    "lerp_monotonic": a.lerp_monotonic(b, 0.3),
    "midpoint": a.midpoint(b),
    "move_towards": a.move_towards(b, 1.5),
    "clamp_length": a.clamp_length(1.0, 5.0),
    "clamp_length_max": a.clamp_length_max(5.0),
    "clamp_length_min": a.clamp_length_min(1.0),
    "smoothstep": a.smoothstep(V::splat(-2.0), V::splat(3.0)),
    "reflect": a.reflect(n),
    "refract": n.refract(V::X, 0.7),
    "refract beyond": n.refract(V::X, 1.5),
    "swizzle": x.turned(),
    "product": a.product(b),
}

methods! {
    /// `values [3, SIGNED_METHODS, count]` of `x` and `y`, of `a` and `b`, which are small, and of `n`, which has no zeros; all `[count]`.
    signed_vectors, SIGNED_METHODS, IVec4, IVec3, IVec2, [x, y, a, b, n, V];
    "wrapping_add": x.wrapping_add(y),
    "wrapping_sub": x.wrapping_sub(y),
    "wrapping_mul": x.wrapping_mul(y),
    "min": x.min(y),
    "max": x.max(y),
    "clamp": x.clamp(V::splat(-100), V::splat(1000)),
    "min_element": x.min_element(),
    "max_element": x.max_element(),
    "min_position": x.min_position() as u32 as i32,
    "max_position": x.max_position() as u32 as i32,
    "signum": x.signum(),
    "cmpeq": V::select(x.cmpeq(y), V::ONE, V::ZERO),
    "cmpne": V::select(x.cmpne(y), V::ONE, V::ZERO),
    "cmplt": V::select(x.cmplt(y), V::ONE, V::ZERO),
    "cmple": V::select(x.cmple(y), V::ONE, V::ZERO),
    "cmpgt": V::select(x.cmpgt(y), V::ONE, V::ZERO),
    "cmpge": V::select(x.cmpge(y), V::ONE, V::ZERO),
    "select": V::select(x.cmpge(y), x, y),
    "any": x.cmplt(y).any(),
    "all": x.cmplt(y).all(),
    "bitmask": x.cmplt(y).bitmask() as i32,
    "==": x == y,
    "is_negative_bitmask": x.is_negative_bitmask() as i32,
    "x & y": x & y,
    "x | y": x | y,
    "x ^ y": x ^ y,
    "!x": !x,
    "x >> 3": x >> 3,
    "x << 3": x << 3,
    "x >> of each": x >> (n & V::splat(7)),
    "as floats": V::through_floats(x >> 8),
    "a + b": a + b,
    "a - b": a - b,
    "a * b": a * b,
    "x / n": x / n,
    "x % n": x % n,
    "x % 7": x % 7,
    "-a": -a,
    "2 - a": 2 - a,
    "abs": a.abs(),
    "dot": a.dot(b),
    "length_squared": a.length_squared(),
    "distance_squared": a.distance_squared(b),
    "manhattan_distance": a.manhattan_distance(b) as i32,
    "element_sum": a.element_sum(),
    "element_product": a.element_product(),
    "div_euclid": a.div_euclid(n),
    "rem_euclid": a.rem_euclid(n),
}

methods! {
    /// `values [3, UNSIGNED_METHODS, count]` of `x` and `y`, of `a` and `b`, which are small, and of `n`, which has no zeros; all `[count]`.
    unsigned_vectors, UNSIGNED_METHODS, UVec4, UVec3, UVec2, [x, y, a, b, n, V];
    "wrapping_add": x.wrapping_add(y),
    "wrapping_sub": x.wrapping_sub(y),
    "wrapping_mul": x.wrapping_mul(y),
    "min": x.min(y),
    "max": x.max(y),
    "clamp": x.clamp(V::splat(100), V::splat(1000)),
    "min_element": x.min_element(),
    "max_element": x.max_element(),
    "min_position": x.min_position() as u32,
    "max_position": x.max_position() as u32,
    "cmpeq": V::select(x.cmpeq(y), V::ONE, V::ZERO),
    "cmpne": V::select(x.cmpne(y), V::ONE, V::ZERO),
    "cmplt": V::select(x.cmplt(y), V::ONE, V::ZERO),
    "cmple": V::select(x.cmple(y), V::ONE, V::ZERO),
    "cmpgt": V::select(x.cmpgt(y), V::ONE, V::ZERO),
    "cmpge": V::select(x.cmpge(y), V::ONE, V::ZERO),
    "select": V::select(x.cmpge(y), x, y),
    "any": x.cmplt(y).any(),
    "all": x.cmplt(y).all(),
    "bitmask": x.cmplt(y).bitmask(),
    "==": x == y,
    "x & y": x & y,
    "x | y": x | y,
    "x ^ y": x ^ y,
    "!x": !x,
    "x >> 3": x >> 3_u32,
    "x << 3": x << 3_u32,
    "x >> of each": x >> (n & V::splat(7)),
    "as floats": V::through_floats(x >> 8_u32),
    "a + b": a + b,
    "a * b": a * b,
    "x / n": x / n,
    "x % n": x % n,
    "x % 7": x % 7,
    "dot": a.dot(b),
    "length_squared": a.length_squared(),
    "manhattan_distance": a.manhattan_distance(b),
    "element_sum": a.element_sum(),
    "element_product": a.element_product(),
}
