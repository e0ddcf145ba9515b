//! The cases of vectors: each device gives what the components give by themselves, in f64 or integers of 64 bits.

use muslin::glam::{IVec4, UVec4, Vec4};
use muslin_check::number::Number;
use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::vectors::{
    FLOAT_METHODS, FloatVectorsInputs, SIGNED_METHODS, SignedVectorsInputs, UNSIGNED_METHODS,
    UnsignedVectorsInputs,
};

use crate::core_functions::INTEGERS;

/// Numbers at which methods change.
const NUMBERS: [f32; 28] = [
    0.0, -0.0, 0.3, -0.3, 0.5, -0.5, HALF, -HALF, 0.75, 1.0, -1.0, 1.5, -1.5, 2.5, -2.5, 3.5, -3.5,
    7.0, -8.0, 100.25, 8388607.5, -8388607.5, 4194304.5, 8388609.0, 3e9, -3e9, 1e20, -1e20,
];
const HALF: f32 = 0.499_999_97;

/// Items of each kernel.
const COUNT: usize = 400;

/// Four of all pairs of some values, for an item.
fn pairs<T: Copy, const N: usize>(of: [T; N], item: usize) -> [[T; 2]; 4] {
    std::array::from_fn(|component| {
        let pair = (item + 197 * component) % (N * N);
        [of[pair / N], of[pair % N]]
    })
}

/// An output for each method: its rows of the vectors of two, three and four components.
fn by_method(methods: &'static [&'static str], outputs: &[Output]) -> Vec<Output> {
    let rows: Vec<_> = outputs[0].values.chunks(4 * COUNT).collect();
    let output = |(at, &name): (usize, &&'static str)| {
        let values = (0..3).flat_map(|part| rows[part * methods.len() + at]).copied();
        Output { name, values: values.collect(), is_exact: outputs[0].is_exact }
    };
    methods.iter().enumerate().map(output).collect()
}

/// The number of components and the item of each vector of an output.
fn items() -> impl Iterator<Item = (usize, usize)> {
    (2..=4).flat_map(|count| (0..COUNT).map(move |item| (count, item)))
}

/// The four components of a result, which can be a number.
fn four<T: Copy>(of: &[T], zero: T) -> [T; 4] {
    std::array::from_fn(|component| match of {
        [number] => *number,
        vector => vector.get(component).copied().unwrap_or(zero),
    })
}

case!(pub FloatVectors(FloatVectorsInputs));

/// The vectors of an item.
struct Floats<'a> {
    x: &'a [f64],
    y: &'a [f64],
    a: &'a [Rounded],
    b: &'a [Rounded],
    n: &'a [Rounded],
}

fn each(
    of: &[Rounded],
    other: &[Rounded],
    f: impl Fn(Rounded, Rounded) -> Rounded,
) -> Vec<Rounded> {
    of.iter().zip(other).map(|(&a, &b)| f(a, b)).collect()
}

fn dot(a: &[Rounded], b: &[Rounded]) -> Rounded {
    Number::sum(each(a, b, |a, b| a * b))
}

fn length(a: &[Rounded]) -> Rounded {
    dot(a, a).sqrt()
}

/// A vector times a number.
fn times(a: &[Rounded], by: Rounded) -> Vec<Rounded> {
    a.iter().map(|&a| a * by).collect()
}

fn minus(a: &[Rounded], b: &[Rounded]) -> Vec<Rounded> {
    each(a, b, |a, b| a - b)
}

impl Floats<'_> {
    /// A method's value: one for each component, or a number.
    fn value(&self, method: &str) -> Vec<Rounded> {
        let Self { x, y, a, b, n } = *self;
        let exact = |f: &dyn Fn(f64, f64) -> f64| -> Vec<_> {
            x.iter().zip(y).map(|(&x, &y)| Rounded::exact(f(x, y))).collect()
        };
        let is = |f: &dyn Fn(f64, f64) -> bool| exact(&|x, y| f64::from(u8::from(f(x, y))));
        let number = |x: f64| vec![Rounded::exact(x)];
        let truth = |is: bool| number(f64::from(u8::from(is)));
        let pairs = || x.iter().zip(y);
        let position = |of: f64| number(x.iter().position(|&x| x == of).unwrap_or_default() as f64);
        let bits = |f: &dyn Fn(f64, f64) -> bool| -> f64 {
            pairs().enumerate().map(|(at, (&x, &y))| u32::from(f(x, y)) << at).sum::<u32>().into()
        };
        let [low, high] =
            [f64::min, f64::max].map(|f| x.iter().copied().reduce(f).unwrap_or_default());
        let [one, three] = [1.0, 3.0].map(Rounded::from);
        let part = Rounded::from(0.3_f32);
        let more: Vec<_> = b.iter().map(|&b| b + one).collect();
        let signed = |of: &[Rounded]| -> Vec<_> {
            of.iter().map(|&x| x + Rounded::from(x.value.signum())).collect()
        };
        let a_more: Vec<_> = a.iter().map(|&a| a + one).collect();
        let onto = |of: &[Rounded]| times(of, dot(a, of) / dot(of, of));
        let of_length = |size: f64| times(a, Rounded::from(size) / length(a));
        // what is chosen by a length
        let chosen = |size: Rounded, limit: f64, yes: &[Rounded], no: &[Rounded]| {
            each(yes, no, |yes, no| size.above(limit, yes, no))
        };
        let at_most =
            |of: &[Rounded], size: f64| chosen(dot(a, a), size * size, &of_length(size), of);
        let at_least =
            |of: &[Rounded], size: f64| chosen(dot(a, a), size * size, of, &of_length(size));
        let refracted = |eta: f32| {
            let eta = Rounded::from(eta);
            let along = n[0];
            let k = one - eta * eta * (one - along * along);
            let root = k.max(Rounded::exact(0.0)).sqrt();
            let mut bent = times(n, eta);
            bent[0] = bent[0] - (eta * along + root);
            let zeros = vec![Rounded::exact(0.0); n.len()];
            chosen(k, 0.0, &bent, &zeros)
        };
        match method {
            "round" => exact(&|x, _| x.round()),
            "floor" => exact(&|x, _| x.floor()),
            "ceil" => exact(&|x, _| x.ceil()),
            "trunc" => exact(&|x, _| x.trunc()),
            "fract" => exact(&|x, _| x.fract()),
            "fract_gl" => exact(&|x, _| f64::from((x - x.floor()) as f32)),
            "abs" => exact(&|x, _| x.abs()),
            "neg" => exact(&|x, _| -x),
            "signum" => exact(&|x, _| x.signum()),
            "copysign" => exact(&f64::copysign),
            "step" => is(&|x, y| x >= y),
            "min" => exact(&f64::min),
            "max" => exact(&f64::max),
            "clamp" => exact(&|x, _| x.clamp(-1.0, 1.5)),
            "max, min" => exact(&|x, y| x.max(-y.abs()).min(y.abs())),
            "saturate" => exact(&|x, _| x.clamp(0.0, 1.0)),
            "min_element" => number(low),
            "max_element" => number(high),
            "min_position" => position(low),
            "max_position" => position(high),
            "cmpeq" => is(&|x, y| x == y),
            "cmpne" => is(&|x, y| x != y),
            "cmplt" => is(&|x, y| x < y),
            "cmple" => is(&|x, y| x <= y),
            "cmpgt" => is(&|x, y| x > y),
            "cmpge" => is(&|x, y| x >= y),
            "select" => exact(&|x, y| if x >= y { x } else { y }),
            "any" => truth(pairs().any(|(x, y)| x < y)),
            "all" => truth(pairs().all(|(x, y)| x < y)),
            "bitmask" => number(bits(&|x, y| x < y)),
            "==" => truth(x == y),
            "!=" => truth(x != y),
            "is_negative_bitmask" => number(bits(&|x, _| x.is_sign_negative())),
            "is_finite" | "is_nan of 0 / 0" | "try_normalize" => truth(true),
            "is_normalized" => truth((dot(n, n).value - 1.0).abs() <= 2e-4),
            "is_nan" => truth(false),
            "is_nan_mask" => exact(&|x, _| x),
            "abs_diff_eq" => truth(pairs().all(|(x, y)| f64::from((x - y) as f32).abs() <= 0.75)),
            "with_y" => {
                let mut with = exact(&|x, _| x);
                with[1] = Rounded::exact(7.0);
                with
            }
            "as integers" => exact(&|x, _| x.clamp(-1e6, 1e6).trunc()),
            "a + b" => each(a, b, |a, b| a + b),
            "a - b" => minus(a, b),
            "a * b" => each(a, b, |a, b| a * b),
            "a / b" => each(a, &signed(b), |a, b| a / b),
            "a + 1.5" => a.iter().map(|&a| a + 1.5.into()).collect(),
            "2.0 - a" => a.iter().map(|&a| Rounded::from(2.0) - a).collect(),
            "a * 3.0" => times(a, three),
            "a / 3.0" => a.iter().map(|&a| a / three).collect(),
            "1.0 / a" | "recip" => signed(a).into_iter().map(|a| one / a).collect(),
            "sqrt" => a.iter().map(|a| a.abs().sqrt()).collect(),
            "exp" => a.iter().map(|a| a.exp()).collect(),
            "element_sum" => vec![Number::sum(a.iter().copied())],
            "element_product" => vec![a.iter().fold(one, |product, &a| product * a)],
            "dot" => vec![dot(a, b)],
            "dot_into_vec" => vec![dot(a, b); a.len()],
            "length" => vec![length(a)],
            "length_squared" => vec![dot(a, a)],
            "length_recip" => vec![one / length(&a_more)],
            "distance" => vec![length(&minus(a, b))],
            "distance_squared" => vec![dot(&minus(a, b), &minus(a, b))],
            "normalize" => times(&a_more, one / length(&a_more)),
            "normalize_or" | "normalize_or_zero" => of_length(1.0),
            "project_onto" => onto(&more),
            "reject_from" => minus(a, &onto(&more)),
            "project_onto_normalized" => times(n, dot(a, n)),
            "reject_from_normalized" => minus(a, &times(n, dot(a, n))),
            "lerp" => each(a, b, |a, b| a * (one - part) + b * part),
            "lerp_monotonic" => each(a, b, |a, b| a + (b - a) * part),
            "midpoint" => each(a, b, |a, b| (a + b) * 0.5.into()),
            "move_towards" => {
                let apart = length(&minus(b, a));
                let step = each(a, b, |a, b| a + (b - a) / apart * 1.5.into());
                chosen(apart, 1.5, &step, b)
            }
            "clamp_length" => at_most(&at_least(a, 1.0), 5.0),
            "clamp_length_max" => at_most(a, 5.0),
            "clamp_length_min" => at_least(a, 1.0),
            "smoothstep" => {
                let of = |&a: &Rounded| {
                    let t = ((a + 2.0.into()) / 5.0.into()).max(0.0.into()).min(one);
                    t * t * (three - Rounded::from(2.0) * t)
                };
                a.iter().map(of).collect()
            }
            "reflect" => minus(a, &times(n, Rounded::from(2.0) * dot(a, n))),
            "refract" => refracted(0.7),
            "refract beyond" => refracted(1.5),
            "swizzle" => {
                let order: &[usize] = [&[1, 0][..], &[2, 0, 1], &[3, 2, 1, 0]][x.len() - 2];
                order.iter().map(|&at| Rounded::exact(x[at])).collect()
            }
            "product" if a.len() == 2 => {
                let across = a[0] * b[1] - a[1] * b[0];
                let turned = [a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1]];
                vec![turned[0] - a[1] * across, turned[1] + a[0] * across]
            }
            "product" => {
                let of = |at: usize| {
                    let [next, last] = [(at + 1) % 3, (at + 2) % 3];
                    a[next] * b[last] - a[last] * b[next]
                };
                (0..3).map(of).chain(a.get(3).copied()).collect()
            }
            _ => unreachable!("{method} has no equation"),
        }
    }
}

impl Parity for FloatVectors {
    fn sets() -> Vec<(String, Self)> {
        let mut random = Random::new(3);
        let sides = (0..COUNT).map(|item| pairs(NUMBERS, item));
        let (x, y) = sides
            .map(|of| (Vec4::from(of.map(|[x, _]| x)), Vec4::from(of.map(|[_, y]| y))))
            .unzip();
        let [a, b, n] =
            [(); 3].map(|()| inputs::Fill::Random.vectors(&mut random, COUNT, [-4.0, 4.0], 4.0));
        // each has the length 1 as a whole, or as its first two components
        let unit = |(item, n): (usize, Vec4)| {
            if item % 2 == 0 { n } else { n * Vec4::new(1.0, 1.0, 0.0, 0.0) }
        };
        let n = n.into_iter().enumerate().map(unit).map(Vec4::normalize).collect();
        let values = unwritten(3 * FLOAT_METHODS.len() * COUNT);
        let params = CountParams { count: COUNT as u32 };
        vec![("edges".into(), Self(FloatVectorsInputs { params, x, y, a, b, n, values }))]
    }

    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        by_method(FLOAT_METHODS, &outputs)
    }

    fn exact(&self, method: &str, _: usize) -> Vec<Option<Rounded>> {
        let of = |(count, item): (usize, usize)| {
            let [x, y] = [&self.x, &self.y].map(|of| of[item].to_array().map(f64::from));
            let [a, b, n] =
                [&self.a, &self.b, &self.n].map(|of| of[item].to_array().map(Rounded::from));
            let [a, b, n] = [&a, &b, &n].map(|of| &of[..count]);
            four(
                &Floats { x: &x[..count], y: &y[..count], a, b, n }.value(method),
                Rounded::exact(0.0),
            )
        };
        items().flat_map(of).map(Some).collect()
    }
}

/// The vectors of integers of an item: two with the limits of the type, two that are small, and one without zeros.
struct Integers {
    x: Vec<i64>,
    y: Vec<i64>,
    a: Vec<i64>,
    b: Vec<i64>,
    n: Vec<i64>,
    /// The lower limit of `clamp`.
    low: i64,
}

impl Integers {
    /// A method's value, modulo 2^32: one for each component, or a number.
    fn value(&self, method: &str) -> Vec<i64> {
        let Self { x, y, a, b, n, low: low_limit } = self;
        let each = |of: &[i64], other: &[i64], f: &dyn Fn(i64, i64) -> i64| -> Vec<_> {
            of.iter().zip(other).map(|(&x, &y)| f(x, y)).collect()
        };
        let edges = |f: &dyn Fn(i64, i64) -> i64| each(x, y, f);
        let small = |f: &dyn Fn(i64, i64) -> i64| each(a, b, f);
        let is = |f: &dyn Fn(i64, i64) -> bool| edges(&|x, y| i64::from(f(x, y)));
        let [low, high] = [x.iter().min(), x.iter().max()].map(|of| *of.expect("components"));
        let position = |of: i64| x.iter().position(|&x| x == of).expect("a component") as i64;
        let pairs = || x.iter().zip(y);
        let sum = |of: Vec<i64>| vec![of.iter().sum()];
        match method {
            "wrapping_add" => edges(&|x, y| x + y),
            "wrapping_sub" => edges(&|x, y| x - y),
            "wrapping_mul" => edges(&|x, y| x.wrapping_mul(y)),
            "min" => edges(&i64::min),
            "max" => edges(&i64::max),
            "clamp" => edges(&|x, _| x.clamp(*low_limit, 1000)),
            "min_element" => vec![low],
            "max_element" => vec![high],
            "min_position" => vec![position(low)],
            "max_position" => vec![position(high)],
            "signum" => edges(&|x, _| x.signum()),
            "cmpeq" => is(&|x, y| x == y),
            "cmpne" => is(&|x, y| x != y),
            "cmplt" => is(&|x, y| x < y),
            "cmple" => is(&|x, y| x <= y),
            "cmpgt" => is(&|x, y| x > y),
            "cmpge" => is(&|x, y| x >= y),
            "select" => edges(&|x, y| if x >= y { x } else { y }),
            "any" => vec![pairs().any(|(x, y)| x < y).into()],
            "all" => vec![pairs().all(|(x, y)| x < y).into()],
            "bitmask" => vec![pairs().enumerate().map(|(at, (x, y))| i64::from(x < y) << at).sum()],
            "==" => vec![(x == y).into()],
            "is_negative_bitmask" => {
                vec![x.iter().enumerate().map(|(at, x)| i64::from(*x < 0) << at).sum()]
            }
            "x & y" => edges(&|x, y| x & y),
            "x | y" => edges(&|x, y| x | y),
            "x ^ y" => edges(&|x, y| x ^ y),
            "!x" => edges(&|x, _| !x),
            "x >> 3" => edges(&|x, _| x.div_euclid(8)),
            "x << 3" => edges(&|x, _| x * 8),
            "x >> of each" => each(x, n, &|x, n| x >> (n & 7)),
            "as floats" => edges(&|x, _| x.div_euclid(256)),
            "a + b" => small(&|a, b| a + b),
            "a - b" => small(&|a, b| a - b),
            "a * b" => small(&|a, b| a * b),
            "x / n" => each(x, n, &|x, n| x / n),
            "x % n" => each(x, n, &|x, n| x % n),
            "x % 7" => edges(&|x, _| x % 7),
            "-a" => small(&|a, _| -a),
            "2 - a" => small(&|a, _| 2 - a),
            "abs" => small(&|a, _| a.abs()),
            "dot" => sum(small(&|a, b| a * b)),
            "length_squared" => sum(small(&|a, _| a * a)),
            "distance_squared" => sum(small(&|a, b| (a - b) * (a - b))),
            "manhattan_distance" => sum(small(&|a, b| (a - b).abs())),
            "element_sum" => vec![a.iter().sum()],
            "element_product" => vec![a.iter().product()],
            "div_euclid" => each(a, n, &i64::div_euclid),
            "rem_euclid" => each(a, n, &i64::rem_euclid),
            _ => unreachable!("{method} has no equation"),
        }
    }
}

macro_rules! integers {
    ($case:ident($inputs:ident), $methods:ident, $four:ident, $number:ident, $low:literal, [$($divisor:literal),*]) => {
        case!(pub $case($inputs));

        impl Parity for $case {
            fn sets() -> Vec<(String, Self)> {
                let mut random = Random::new(5);
                let sides = (0..COUNT).map(|item| pairs(INTEGERS, item).map(|of| of.map(|of| of as $number)));
                let (x, y) = sides.map(|of| ($four::from(of.map(|[x, _]| x)), $four::from(of.map(|[_, y]| y)))).unzip();
                let mut of = |values: &[i64]| -> Vec<$four> {
                    let mut one = || values[random.below(values.len() as u32) as usize] as $number;
                    (0..COUNT).map(|_| $four::new(one(), one(), one(), one())).collect()
                };
                let small: Vec<i64> = ($low..100).collect();
                let [a, b, n] = [&small, &small, &vec![$($divisor),*]].map(|values| of(values));
                let values = unwritten(3 * $methods.len() * COUNT);
                let params = CountParams { count: COUNT as u32 };
                vec![("edges".into(), Self($inputs { params, x, y, a, b, n, values }))]
            }

            fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
                by_method($methods, &outputs)
            }

            fn exact(&self, method: &str, _: usize) -> Vec<Option<Rounded>> {
                let of = |(count, item): (usize, usize)| {
                    let of = |vectors: &[$four]| vectors[item].to_array()[..count].iter().map(|&x| x.into()).collect();
                    let [x, y, a, b, n] = [&self.x, &self.y, &self.a, &self.b, &self.n].map(|vectors| of(vectors));
                    let low = if $low < 0 { -100 } else { 100 };
                    four(&Integers { x, y, a, b, n, low }.value(method), 0)
                };
                items().flat_map(of).map(|value| Some(Rounded::exact((value as $number).into()))).collect()
            }
        }
    };
}

integers!(
    SignedVectors(SignedVectorsInputs),
    SIGNED_METHODS,
    IVec4,
    i32,
    -100,
    [1, 2, 3, -2, 7, -4, 100, -1000, 65_537]
);
integers!(
    UnsignedVectors(UnsignedVectorsInputs),
    UNSIGNED_METHODS,
    UVec4,
    u32,
    0,
    [1, 2, 3, 7, 100, 65_537, 3_000_000_000]
);
