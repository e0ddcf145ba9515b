//! The case of `vector_methods`: each device gives the bits of the CPU.

use muslin::glam::Vec4;
use muslin_check::prelude::*;
use muslin_language_kernels::vectors::{METHODS, VectorMethodsInputs, VectorParams};

case!(pub VectorMethods(VectorMethodsInputs));

/// Numbers at which methods change.
const NUMBERS: [f32; 28] = [
    0.0, -0.0, 0.3, -0.3, 0.5, -0.5, HALF, -HALF, 0.75, 1.0, -1.0, 1.5, -1.5, 2.5, -2.5, 3.5, -3.5,
    7.0, -8.0, 100.25, 8388607.5, -8388607.5, 4194304.5, 8388609.0, 3e9, -3e9, 1e20, -1e20,
];
const HALF: f32 = 0.499_999_97;

/// The bits of a number, of which 0 has one sign.
fn without_negative_zero(bits: u32) -> u32 {
    if f32::from_bits(bits) == 0.0 { 0 } else { bits }
}

impl Parity for VectorMethods {
    // the CPU's other values are glam's, with which devices are compared
    const COMPARED: f64 = 0.0;

    fn sets() -> Vec<(String, Self)> {
        let pairs =
            NUMBERS.into_iter().flat_map(|x| NUMBERS.map(|y| (Vec4::splat(x), Vec4::splat(y))));
        let (x, y): (Vec<_>, Vec<_>) = pairs.unzip();
        let params = VectorParams { count: x.len() as u32 };
        let bits = unwritten(METHODS.len() * x.len());
        vec![("edges".into(), Self(VectorMethodsInputs { params, x, y, bits }))]
    }

    /// An output for each method. A vector has SIMD on some CPUs, which loses the sign of zero.
    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        let words = outputs[0].words();
        let output = |(&method, row): (&&'static str, &[u32])| match method.starts_with("math::") {
            true => Output::exact(method, row.to_vec()),
            false => Output::exact(method, row.iter().copied().map(without_negative_zero)),
        };
        METHODS.iter().zip(words.chunks(self.x.len())).map(output).collect()
    }

    fn exact_at(&self, method: &str, index: usize) -> Option<Rounded> {
        let [x, y] = [&self.x, &self.y].map(|values| f64::from(values[index].x));
        let value = match method {
            "round" | "round of Vec3" | "math::round" => x.round(),
            "floor" | "math::floor" => x.floor(),
            "ceil" | "math::ceil" => x.ceil(),
            "trunc" | "math::truncate" => x.trunc(),
            "fract" => x.fract(),
            "fract_gl" => f64::from((x - x.floor()) as f32),
            "abs" => x.abs(),
            "signum" => x.signum(),
            "copysign" => x.copysign(y),
            "step" => f64::from(u8::from(x >= y)),
            // too short, or too long, for the square of a length
            "normalize_or_zero" if x == 0.0 || x.abs() > 1e19 => 0.0,
            "normalize_or_zero" => 8.0 * x.signum(),
            _ => return Some(Rounded::UNKNOWN),
        };
        let bits = (value as f32).to_bits();
        let is_of_vector = !method.starts_with("math::");
        Some(if is_of_vector { without_negative_zero(bits) } else { bits }.into())
    }
}
