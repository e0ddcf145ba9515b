//! The case of `loops`.

use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::loops::LoopsInputs;

case!(pub Loops(LoopsInputs));

impl Parity for Loops {
    fn sets() -> Vec<(String, Self)> {
        let pairs = (0..8).flat_map(|a| (0..8).map(move |b| (a, b)));
        let (a, b): (Vec<u32>, Vec<u32>) = pairs.unzip();
        let params = CountParams { count: a.len() as u32 };
        let output = unwritten(8 * a.len());
        vec![("pairs".into(), Self(LoopsInputs { params, a, b, output }))]
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let at = index % self.a.len();
        let [a, b] = [self.a[at], self.b[at]];
        let value = match index / self.a.len() {
            0 => 7 + a * b,
            1 => {
                let rounds = if b == 0 { 0 } else { a.min(2) };
                7 + rounds * b + 100 * rounds
            }
            2 => 10 + (a.max(1) - 1) * b + 100 * a.max(1),
            3 => {
                let rounds = (1..=a).find(|n| 7 + n * b >= 12).unwrap_or(a);
                7 + rounds * b + 100 * rounds
            }
            4 => (0..a).fold(7, |sum, n| {
                let rounds = (0..n).take_while(|k| sum + k * b < 40).count() as u32;
                sum + rounds * (b + 1)
            }),
            5 => 7 + b * [3, 2, 2, 1][a as usize % 4],
            6 => 7 + (1..=a).map(|n| 60 / (b + n)).sum::<u32>(),
            _ => 7 + (0..a).flat_map(|n| (n..b).map(move |k| n + 10 * k)).sum::<u32>(),
        };
        Some(value.into())
    }
}
