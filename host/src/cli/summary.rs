//! The cost of rendering, in one line. Aligned columns, and numbers in them.

use std::time::Instant;

pub use muslin_device::{Table, grouped};
use organza::{RenderReport, Renderer};
use serde::Serialize;

use super::console::Console;

/// The cost of rendering, as `--json` prints it.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    device: String,
    seconds: f64,
    #[serde(flatten)]
    report: RenderReport,
    not_finite: u64,
}

/// Adds up the reports of renderings.
#[derive(Debug)]
pub struct Summary {
    start: Instant,
    report: RenderReport,
}

impl Summary {
    /// Starts the clock.
    pub fn start() -> Self {
        Self { start: Instant::now(), report: RenderReport::default() }
    }

    pub fn add(&mut self, report: &RenderReport) {
        self.report.add(report);
    }

    /// All numbers. `not_finite` values were NaN or infinite.
    pub fn cost(&self, renderer: &Renderer, not_finite: u64) -> Cost {
        Cost {
            device: renderer.device().choice().to_owned(),
            seconds: self.start.elapsed().as_secs_f64(),
            report: self.report,
            not_finite,
        }
    }

    /// Says what was rendered, and in how much time. `what` names the rendered things.
    pub fn say(&self, what: &str, console: Console) {
        let report = &self.report;
        let seconds = self.start.elapsed().as_secs_f64();
        let time = if seconds < 1.0 {
            format!("{:.0} ms", seconds * 1e3)
        } else {
            format!("{seconds:.1} s")
        };
        console.note(&format!("rendered {what} in {time}"));
        console.detail(&format!(
            "{}, {}, {}, {}; {} culled as degenerate",
            count(report.parts as u64, "part"),
            count(report.pairs, "pair"),
            count(report.intersections, "intersection"),
            count(report.samples, "sample"),
            count(report.degenerate, "pair"),
        ));
    }
}

/// A number with its noun: `1 tile`, `12,345 tiles`.
pub fn count(number: u64, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{} {thing}{plural}", grouped(number))
}

/// A score with some digits after the point; a dash for `None`.
pub fn score(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

/// A number with five significant digits.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    if !(1e-4..1e6).contains(&size) {
        return format!("{value:.4e}");
    }
    let digits = (4 - size.log10().floor() as i32).clamp(0, 8) as usize;
    format!("{value:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_grouped_and_counted() {
        for (number, text) in [(0, "0"), (999, "999"), (1000, "1,000"), (1_234_567, "1,234,567")] {
            assert_eq!(grouped(number), text);
        }
        assert_eq!([0, 1, 2000].map(|n| count(n, "tile")), ["0 tiles", "1 tile", "2,000 tiles"]);
    }

    #[test]
    fn numbers_have_five_digits() {
        let cases = [
            (-0.0, "0"),
            (1.0, "1.0000"),
            (-12.345678, "-12.346"),
            (0.00123456, "0.0012346"),
            (123_456.7, "123457"),
            (1.5e-7, "1.5000e-7"),
            (f64::NAN, "NaN"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
