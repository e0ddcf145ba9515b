//! The cases of `language.rs`.

use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::language::{
    AS_WRITTEN_ROWS, AsWrittenInputs, BYTES, ByteHistogramInputs, COMPARED_ROWS, ComparedInputs,
    KeepPositiveInputs, MAX_COLUMNS, MAX_ROW, RowParams, ScanAndShuffleInputs, SharesInputs,
    SortParams, SortRowsInputs,
};

case!(pub ByteHistogram(ByteHistogramInputs));

impl Parity for ByteHistogram {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let bytes = (0..count).map(|_| random.bits() as u8).collect();
            let halves = (0..count).map(|_| random.bits() as u16).collect();
            let params = CountParams { count };
            Self(ByteHistogramInputs { params, bytes, halves, bins: vec![0; 2 * BYTES] })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let byte = |half: &u16| usize::from(half / 256);
        let count = match index.checked_sub(BYTES) {
            None => self.bytes.iter().filter(|byte| usize::from(**byte) == index).count(),
            Some(high) => self.halves.iter().map(byte).filter(|byte| *byte == high).count(),
        };
        Some(Rounded::exact(count as f64))
    }
}

case!(pub Shares(SharesInputs));

impl Parity for Shares {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let values = random.values(count as usize, 0.1, 1.0);
            let shares = unwritten(values.len());
            Self(SharesInputs { params: CountParams { count }, values, shares })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let all = self.values.chunks(64).nth(index / 64)?;
        let sum = Rounded::sum(all.iter().map(|value| Rounded::from(*value)));
        Some(Rounded::from(self.values[index]) / sum)
    }
}

case!(pub SortRows(SortRowsInputs));

impl Parity for SortRows {
    fn sets() -> Vec<(String, Self)> {
        let set = |[rows, columns]: [u32; 2]| {
            let mut random = Random::new(columns.into());
            let values = (0..rows * columns).map(|_| random.bits()).collect();
            let params = SortParams { rows, columns };
            (format!("{rows} rows of {columns}"), Self(SortRowsInputs { params, values }))
        };
        [[5, 1], [1, 2], [3, 64], [2, 1024], [1, MAX_ROW]].map(set).into()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let mut sorted = self.values.clone();
        let rows = sorted.chunks_exact_mut(self.params.columns as usize);
        rows.for_each(<[u32]>::sort_unstable);
        listed(sorted)
    }
}

case!(pub KeepPositive(KeepPositiveInputs));

impl Parity for KeepPositive {
    fn sets() -> Vec<(String, Self)> {
        let set = |[rows, columns]: [u32; 2]| {
            let mut random = Random::new(columns.into());
            let number = |bits: u32| (bits % 2049) as f32 / 8.0 - 128.0;
            let values: Vec<_> = (0..rows * columns).map(|_| number(random.bits())).collect();
            let inputs = KeepPositiveInputs {
                params: RowParams { rows, columns },
                kept: unwritten(values.len()),
                output: unwritten(4 * rows as usize),
                values,
            };
            (format!("{rows} rows of {columns}"), Self(inputs))
        };
        [[5, 1], [1, 31], [3, 96], [2, 97], [4, 1000], [1, MAX_COLUMNS]].map(set).into()
    }

    /// The kept values come in any order, so they are sorted.
    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs[0].values.chunks_exact_mut(self.params.columns as usize).for_each(sort);
        outputs
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let of = |row: &[f32]| {
            let values: Vec<_> = row.iter().copied().map(f64::from).collect();
            let mut kept: Vec<_> = values.iter().map(|value| value.max(0.0)).collect();
            let count = kept.iter().filter(|value| **value > 0.0).count() as f64;
            let [low, high] = [f64::min, f64::max]
                .map(|of| values.iter().copied().reduce(of).expect("a row has columns"));
            sort(&mut kept);
            match output {
                "kept" => listed(kept),
                // multiples of 1/8 up to 128: their sums are exact in any order
                _ => listed([count, values.iter().sum(), low, high]),
            }
        };
        self.values.chunks_exact(self.params.columns as usize).flat_map(of).collect()
    }
}

case!(pub ScanAndShuffle(ScanAndShuffleInputs));

impl Parity for ScanAndShuffle {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let values = (0..count).map(|_| random.bits()).collect();
            let found = unwritten(5 * count as usize);
            Self(ScanAndShuffleInputs { params: CountParams { count }, values, found })
        })
    }

    fn exact_at(&self, _: &str, _: usize) -> Option<Rounded> {
        Some(Rounded::exact(0.0))
    }
}

fn sort(row: &mut [f64]) {
    row.sort_unstable_by(f64::total_cmp);
}

/// Rounds to an `f32`.
fn rounded(x: f64) -> f64 {
    f64::from(x as f32)
}

/// A number in which NaN, infinity and the sign of zero are numbers, too.
fn shown(x: f64) -> f64 {
    match x {
        _ if x.is_nan() => 3e40,
        _ if x.is_infinite() => x.signum() * 2e40,
        _ if x == 0.0 && x.is_sign_negative() => -1e-60,
        _ => x,
    }
}

/// Numbers of all kinds. No pair of one of these and a [`LATER`] has a sum, a product or a quotient that is a denormal.
const NUMBERS: [f32; 18] = [
    0.0, -0.0, 0.4, -0.6, 0.3, 1.0, 1.5, -3.0, 49.0, 12345.678, -7.5e6, TWO_24, 1e8, 1e30, 3e38,
    -3e38, ENDLESS, NONE,
];
const LATER: [f32; 12] = [0.0, -0.0, 0.4, 1.0, -1.0, 3.0, 49.0, -0.7, TWO_24, 1e8, -ENDLESS, NONE];
const TWO_24: f32 = 16_777_216.0;
const ENDLESS: f32 = f32::INFINITY;
const NONE: f32 = f32::NAN;

/// The error of what nothing is known about, beyond all that [`shown`] gives.
const UNKNOWN: f64 = 1e41;

/// All pairs of [`NUMBERS`] and [`LATER`].
fn pairs() -> [Vec<f32>; 2] {
    let all = NUMBERS.into_iter().flat_map(|x| LATER.map(|y| (x, y)));
    let (x, y) = all.unzip();
    [x, y]
}

case!(pub AsWritten(AsWrittenInputs));

impl AsWritten {
    /// Whether a row divides by a number above 2^126, of which Vulkan says nothing: an NVIDIA H200 gives 0.
    fn is_unknown(&self, row: usize, at: usize) -> bool {
        let divisor = match row {
            4 => self.y[at],
            10 | 12 | 19 => self.x[at],
            _ => return false,
        };
        divisor.is_finite() && divisor.abs() > 2.0_f32.powi(126)
    }

    #[expect(clippy::eq_op, reason = "of NaN and infinity they are neither 0 nor 1")]
    fn row(row: usize, x: f64, y: f64) -> f64 {
        let r = rounded;
        let c = |x: f32| f64::from(x);
        let times = |a: f64, b: f64| r(a * b);
        match row {
            0 => r(r(x + 12_582_912.0) - 12_582_912.0),
            1 => r(r(x - y) + y),
            2 => r(r(x + y) - y),
            3 => r(x - r(x - y)),
            4 => times(r(x / y), y),
            5 => times(times(x, c(1e-30)), c(1e-30)),
            6 => times(times(x, c(0.1)), 3.0),
            7 => r(r(x + c(0.1)) + c(0.2)),
            8 => r(r(c(0.1) - x) - c(0.2)),
            9 => x * 0.0,
            10 => 0.0 / x,
            11 => x - x,
            12 => x / x,
            13 => x + 0.0,
            14 => 0.0 - x,
            15 => -r(x - y),
            16 => times(times(x, 2.0), 0.5),
            17 => r(times(x, y) + times(x, c(0.3))),
            18 => r(r(x / 3.0) / 7.0),
            19 => r(3.0 / r(7.0 / x)),
            20 => r(x + 0.0 * r(y - x)),
            21 => times(times(y, c(0.1)), 3.0),
            22 => r(r(y + c(0.1)) - c(0.1)),
            _ => times(times(x, c(0.7)).min(1.0), c(1.0 / 0.7)),
        }
    }
}

impl Parity for AsWritten {
    fn sets() -> Vec<(String, Self)> {
        let [x, y] = pairs();
        let params = CountParams { count: x.len() as u32 };
        let bits = vec![0; AS_WRITTEN_ROWS * x.len()];
        vec![("pairs".into(), Self(AsWrittenInputs { params, x, y, bits }))]
    }

    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        let bits = outputs[0].words().into_iter();
        vec![Output::float("bits", bits.map(|bits| shown(f32::from_bits(bits).into())))]
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [row, at] = [index / self.x.len(), index % self.x.len()];
        let value = shown(Self::row(row, self.x[at].into(), self.y[at].into()));
        Some(match row {
            _ if self.is_unknown(row, at) => Rounded::within(value, UNKNOWN),
            // the sign of zero
            13 | 14 => Rounded::within(value, 1e-50),
            // divisions, of which a GPU may be off by 2.5 ulp
            4 | 10 | 12 | 18 | 19 => Rounded::within(value, 4e-7 * value.abs() + f64::from(TINY)),
            _ => Rounded::exact(value),
        })
    }

    /// Nothing is known of drivers that regroup.
    fn exact_regrouped(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        let all = self.exact(output, len).into_iter();
        all.map(|exact| exact.map(|exact| Rounded::within(exact.value, UNKNOWN))).collect()
    }
}

case!(pub Compared(ComparedInputs));

impl Parity for Compared {
    fn sets() -> Vec<(String, Self)> {
        let [x, y] = pairs();
        let params = CountParams { count: x.len() as u32 };
        let found = vec![0; COMPARED_ROWS * x.len()];
        vec![("pairs".into(), Self(ComparedInputs { params, x, y, found }))]
    }

    /// The bits of NaN are not known, and zeros are equal.
    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        let flags = 17 * self.x.len();
        let value = |(index, word)| match index < flags {
            true => f64::from(word),
            false => shown(f64::from(f32::from_bits(word)) + 0.0),
        };
        let words = outputs[0].words().into_iter().enumerate();
        vec![Output::float("found", words.map(value))]
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        use core::cmp::Ordering::{Equal, Greater, Less};
        let [row, at] = [index / self.x.len(), index % self.x.len()];
        let [x, y] = [&self.x, &self.y].map(|values| f64::from(values[at]));
        let [has_nan, x_is_nan] = [x.is_nan() || y.is_nan(), x.is_nan()];
        let order = x.partial_cmp(&y);
        let is = |orders: &[_]| order.is_some_and(|order| orders.contains(&order));
        let flag = match row {
            0 => is(&[Less]),
            1 => is(&[Greater]),
            2 => is(&[Less, Equal]),
            3 => is(&[Greater, Equal]),
            4 => is(&[Equal]),
            5 => has_nan || is(&[Less, Greater]),
            6 => x_is_nan || (x - 1.0).abs() > 0.0,
            7 => has_nan || is(&[Greater, Equal]),
            8 => has_nan || is(&[Less, Equal]),
            9 => has_nan || is(&[Greater]),
            10 => has_nan || is(&[Less]),
            11 | 13 => !x_is_nan,
            12 | 14..=16 => x_is_nan,
            _ => {
                let takes_x = y.is_nan() || is(if row == 17 { &[Greater] } else { &[Less] });
                return Some(Rounded::exact(shown(if takes_x { x } else { y } + 0.0)));
            }
        };
        Some(Rounded::exact(f64::from(u8::from(flag))))
    }
}
