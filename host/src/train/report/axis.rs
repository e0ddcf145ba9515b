//! Axes: which values they reach, and where their ticks are.

/// How an axis runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// From 0, or from below it, to the largest value.
    FromZero,
    /// Around the values.
    Linear,
    /// In powers of ten, where all values are positive and lie far enough apart; else as `Linear`.
    Logarithmic,
}

/// An axis with ticks at round values.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    low: f64,
    high: f64,
    is_logarithmic: bool,
    /// Value and label of each tick, ascending.
    pub ticks: Vec<(f64, String)>,
}

/// Values less than this factor apart are drawn linearly.
const LOGARITHMIC_FROM: f64 = 4.0;

impl Axis {
    /// An axis for some values with about `count` ticks. Values that are not finite do not count.
    pub fn new(scale: Scale, values: impl Iterator<Item = f64> + Clone, count: usize) -> Self {
        let values = values.filter(|value| value.is_finite());
        let low = values.clone().reduce(f64::min).unwrap_or(0.0);
        let high = values.reduce(f64::max).unwrap_or(1.0);
        match scale {
            Scale::FromZero => {
                let (low, high) = (low.min(0.0), high.max(0.0));
                Self::linear(low, if high > low { high } else { 1.0 }, count, false)
            }
            Scale::Logarithmic if low > 0.0 && high > LOGARITHMIC_FROM * low => {
                Self::logarithmic(low, high, count)
            }
            Scale::Linear | Scale::Logarithmic => {
                // a single value has room around it
                let room = if high > low { 0.0 } else { (0.05 * high.abs()).max(0.5) };
                Self::linear(low - room, high + room, count, true)
            }
        }
    }

    /// Where a value lies on the axis: 0 at its beginning, 1 at its end.
    pub fn place(&self, value: f64) -> f64 {
        let map = |value: f64| if self.is_logarithmic { value.log10() } else { value };
        (map(value) - map(self.low)) / (map(self.high) - map(self.low))
    }

    /// `round` ends the axis at ticks.
    fn linear(low: f64, high: f64, count: usize, round: bool) -> Self {
        let step = step((high - low) / count as f64);
        let (first, last) = if round {
            ((low / step).floor(), (high / step).ceil())
        } else {
            // a value just beside a tick is on it
            ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor())
        };
        let ticks = (0..=(last - first) as usize)
            .map(|tick| (first + tick as f64) * step)
            .map(|value| (value, label(value, step)))
            .collect();
        let (low, high) = if round { (first * step, last * step) } else { (low, high) };
        Self { low, high, is_logarithmic: false, ticks }
    }

    fn logarithmic(low: f64, high: f64, count: usize) -> Self {
        let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
        let ticks = |steps: &[f64]| -> Vec<f64> {
            let decade = |power| steps.iter().map(move |step| step * 10_f64.powi(power));
            let all: Vec<_> = (first..=last).flat_map(decade).collect();
            // from the tick below the values to the one above
            let begin = all.iter().rposition(|tick| *tick <= low * (1.0 + 1e-9)).unwrap_or(0);
            let end = all.iter().position(|tick| *tick >= high * (1.0 - 1e-9));
            all[begin..=end.unwrap_or(all.len() - 1)].to_vec()
        };
        let choices = [ticks(&[1.0, 2.0, 5.0]), ticks(&[1.0, 3.0]), ticks(&[1.0])];
        let values = choices.iter().find(|ticks| ticks.len() <= count + 2);
        let values = values.unwrap_or(&choices[2]);
        let (low, high) = (values[0], values[values.len() - 1]);
        let each = values.len().div_ceil(count + 2);
        let ticks =
            values.iter().step_by(each).map(|&value| (value, label(value, value))).collect();
        Self { low, high, is_logarithmic: true, ticks }
    }
}

/// The next of 1, 2 and 5 times a power of ten.
fn step(rough: f64) -> f64 {
    let power = 10_f64.powf(rough.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * power >= rough * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// A value with as many digits as `step` needs.
fn label(value: f64, step: f64) -> String {
    let (size, digits) = (value.abs().max(step), (-step.log10().floor()).max(0.0) as usize);
    match size {
        _ if value == 0.0 => "0".to_owned(),
        1e-4..1e4 => format!("{value:.digits$}"),
        1e4..1e6 if step >= 1e3 => format!("{:.0}k", value / 1e3),
        1e6..1e9 if step >= 1e6 => format!("{:.0}M", value / 1e6),
        1e6..1e9 if step >= 1e5 => format!("{:.1}M", value / 1e6),
        _ => format!("{value:.0e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, values: &[f64], count: usize) -> Vec<String> {
        let axis = Axis::new(scale, values.iter().copied(), count);
        axis.ticks.into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round() {
        use Scale::{FromZero, Linear, Logarithmic};
        let cases: [(Scale, &[f64], &[&str]); 11] = [
            (FromZero, &[3.0, 1000.0], &["0", "200", "400", "600", "800", "1000"]),
            (FromZero, &[30_000.0], &["0", "10k", "20k", "30k"]),
            (FromZero, &[5e6], &["0", "1M", "2M", "3M", "4M", "5M"]),
            (FromZero, &[], &["0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
            (Linear, &[17.3, 24.9], &["16", "18", "20", "22", "24", "26"]),
            (Linear, &[20.0], &["19.0", "19.5", "20.0", "20.5", "21.0"]),
            (
                Linear,
                &[0.013, 0.014, f64::NAN],
                &["0.0130", "0.0132", "0.0134", "0.0136", "0.0138", "0.0140"],
            ),
            (Logarithmic, &[0.03, 0.5], &["0.02", "0.05", "0.1", "0.2", "0.5"]),
            (Logarithmic, &[0.0001, 0.5], &["0.0001", "0.001", "0.01", "0.1", "1"]),
            (Logarithmic, &[0.5, 1.0], &["0.5", "0.6", "0.7", "0.8", "0.9", "1.0"]),
            (Logarithmic, &[0.0, 10.0], &["0", "2", "4", "6", "8", "10"]),
        ];
        for (scale, values, expected) in cases {
            let found = labels(scale, values, 5);
            let found: Vec<_> = found.iter().map(String::as_str).collect();
            assert_eq!(found, expected, "{scale:?} {values:?}");
        }
    }

    #[test]
    fn every_value_lies_on_the_axis() {
        for scale in [Scale::FromZero, Scale::Linear, Scale::Logarithmic] {
            for low in [-1e9, -3.7, 0.0, 1e-300, 1e-12, 0.3, 7.0, 1e15] {
                for span in [0.0, 1e-12, 0.01, 4.2, 1e4, 1e20] {
                    let values = [low, low + span];
                    let axis = Axis::new(scale, values.into_iter(), 5);
                    assert!((1..=9).contains(&axis.ticks.len()), "{scale:?} {values:?} {axis:?}");
                    for place in values.map(|value| axis.place(value)) {
                        assert!(
                            (-1e-6..=1.0 + 1e-6).contains(&place),
                            "{scale:?} {values:?}: {place}"
                        );
                    }
                }
            }
        }
    }
}
