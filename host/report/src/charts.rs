//! The curves of a run: numbers that `page.js` draws with uPlot.

use serde::Serialize;

use super::run::Run;
use organza_train::metrics::Record;

/// Largest number of points in a curve. A longer one is thinned to every second, third, ... point.
const MAX_POINTS: usize = 4000;

/// The data that `page.js` reads.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(super) struct Charts {
    pub tables: Vec<Table>,
    pub charts: Vec<Chart>,
}

/// Columns that several curves share.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(super) struct Table {
    pub step: Vec<u64>,
    pub seconds: Vec<Number>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Chart {
    pub title: &'static str,
    pub unit: &'static str,
    pub scale: Scale,
    /// Digits after the point for the value under the pointer. `None` means four digits in all.
    pub digits: Option<usize>,
    pub series: Vec<Series>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Scale {
    Linear,
    Log,
    /// Linear, starting at 0.
    Zero,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Style {
    /// Values, with their running mean in front.
    Noise,
    /// A mark at each value.
    Marks,
    /// A step curve: each value holds until the next.
    Steps,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Series {
    pub name: &'static str,
    /// A variable of the style sheet.
    pub color: &'static str,
    pub style: Style,
    /// Index of the curve's table.
    pub table: usize,
    pub y: Vec<Number>,
}

/// A number of the log, with the digits of the `f32` that it was computed from. Null if it is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub(super) struct Number(pub Option<f32>);

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        let value = value as f32;
        Self(value.is_finite().then_some(value))
    }
}

/// Reads a curve's value from a record.
type Value = fn(&Record) -> f64;

const STEP_CHARTS: [(&str, &str, Scale, Option<usize>, Value); 4] = [
    ("Loss", "", Scale::Log, None, |record| step(record, |values| values[0])),
    ("PSNR", "dB", Scale::Linear, Some(2), |record| step(record, |values| values[1])),
    ("L1", "", Scale::Log, None, |record| step(record, |values| values[2])),
    ("SSIM", "", Scale::Linear, Some(4), |record| step(record, |values| values[3])),
];

/// Loss, PSNR, L1 and SSIM of a step.
fn step(record: &Record, value: fn([f64; 4]) -> f64) -> f64 {
    match record {
        Record::Step { loss, psnr, l1, ssim, .. } => value([*loss, *psnr, *l1, *ssim]),
        _ => f64::NAN,
    }
}

fn gaussians(record: &Record) -> f64 {
    if let Record::Step { gaussians, .. } = record { *gaussians as f64 } else { f64::NAN }
}

fn speed(record: &Record) -> f64 {
    if let Record::Step { tiles_per_second, .. } = record { *tiles_per_second } else { f64::NAN }
}

/// Records of steps and of evaluations, thinned for drawing: tables 0 and 1.
struct Source<'a> {
    steps: Vec<&'a Record>,
    evaluations: Vec<&'a Record>,
}

impl<'a> Source<'a> {
    fn new(run: &'a Run) -> Self {
        let of = |is: fn(&Record) -> bool| -> Vec<&Record> {
            thinned(run.records.iter().filter(|record| is(record)).collect(), MAX_POINTS)
        };
        Self {
            steps: of(|record| matches!(record, Record::Step { .. })),
            evaluations: of(|record| matches!(record, Record::Evaluation { .. })),
        }
    }

    fn of_steps(&self, name: &'static str, style: Style, scale: Scale, value: Value) -> Series {
        let y = self.steps.iter().map(|record| drawn(value(record), scale)).collect();
        Series { name, color: "--batch", style, table: 0, y }
    }

    /// PSNR or SSIM of the held-out views.
    fn held_out(&self, is_psnr: bool) -> Series {
        let value = |record: &&Record| match record {
            Record::Evaluation { mean, .. } => {
                (if is_psnr { mean.psnr } else { mean.ssim }).unwrap_or(f64::NAN).into()
            }
            _ => Number(None),
        };
        let y = self.evaluations.iter().map(value).collect();
        Series { name: "held-out views", color: "--held-out", style: Style::Marks, table: 1, y }
    }
}

impl Table {
    fn new(records: &[&Record]) -> Self {
        let seconds = |record: &&Record| match record {
            Record::Step { seconds, .. } | Record::Evaluation { seconds, .. } => (*seconds).into(),
            _ => Number(None),
        };
        let step = records.iter().map(|record| record.step()).collect();
        Self { step, seconds: records.iter().map(seconds).collect() }
    }
}

/// The value as a scale can show it.
fn drawn(value: f64, scale: Scale) -> Number {
    if scale == Scale::Log && value <= 0.0 { Number(None) } else { value.into() }
}

/// About `max` of the elements: every nth, and the last.
pub(super) fn thinned<T>(all: Vec<T>, max: usize) -> Vec<T> {
    let every = all.len().div_ceil(max.max(1)).max(1);
    let last = all.len().saturating_sub(1);
    let chosen =
        all.into_iter().enumerate().filter(|(at, _)| at.is_multiple_of(every) || *at == last);
    chosen.map(|(_, item)| item).collect()
}

impl Charts {
    /// The charts of a run.
    pub fn from_run(run: &Run) -> Self {
        let source = Source::new(run);
        let tables = [&source.steps, &source.evaluations].map(|records| Table::new(records));
        let mut charts = Self { tables: tables.into(), charts: Vec::new() };
        for (title, unit, scale, digits, value) in STEP_CHARTS {
            let mut series = vec![source.of_steps("training batch", Style::Noise, scale, value)];
            if ["PSNR", "SSIM"].contains(&title) {
                series.push(source.held_out(title == "PSNR"));
            }
            charts.add(Chart { title, unit, scale, digits, series });
        }
        let scale = Scale::Zero;
        let series = vec![source.of_steps("Gaussians", Style::Steps, scale, gaussians)];
        charts.add(Chart { title: "Gaussians", unit: "", scale, digits: Some(0), series });
        let series = vec![source.of_steps("tiles", Style::Noise, scale, speed)];
        let unit = "tiles per second";
        charts.add(Chart { title: "Speed", unit, scale, digits: Some(1), series });
        charts
    }

    /// Adds a chart, without curves that have no value.
    fn add(&mut self, mut chart: Chart) {
        chart.series.retain(|series| series.y.iter().any(|value| value.0.is_some()));
        if !chart.series.is_empty() {
            self.charts.push(chart);
        }
    }

    /// JSON that is safe inside a page: no `<` can end its element.
    pub fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default().replace('<', "\\u003c")
    }
}
