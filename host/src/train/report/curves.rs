//! Which curves a run has.

use super::axis::Scale;
use super::chart::{Chart, Series, Style};
use crate::train::metrics::Record;

/// A value of a record, where it has one.
type Value = fn(&Record) -> Option<f64>;

/// The charts of a run: loss and PSNR over steps and over time, then speed and size over steps.
pub fn charts(records: &[Record]) -> String {
    let mut all = String::new();
    for over in [Over::Steps, Over::time(records)] {
        let batch = vec![series("batch", records, over, loss)];
        all += &chart("Loss", "", Scale::Logarithmic, |loss| format!("{loss:.4}"), over, batch);
        let train = series("training batches", records, over, batch_psnr);
        let held_out = Series {
            class: "held-out",
            style: Style::Marks,
            ..series("held-out views", records, over, held_out_psnr)
        };
        let both = vec![train, held_out];
        all += &chart("PSNR", "decibels", Scale::Linear, |psnr| format!("{psnr:.2}"), over, both);
    }
    let over = Over::Steps;
    let sizes = Series { style: Style::Steps, ..series("Gaussians", records, over, gaussians) };
    all += &chart("Gaussians", "", Scale::FromZero, short, over, vec![sizes]);
    let speed = series("tiles/s", records, over, speed);
    all += &chart(
        "Speed",
        "tiles per second",
        Scale::FromZero,
        |speed| format!("{speed:.1}"),
        over,
        vec![speed],
    );
    if all.is_empty() {
        all
    } else {
        format!("<div class=\"charts\">\n{all}</div>\n{}", growth(records))
    }
}

fn loss(record: &Record) -> Option<f64> {
    if let Record::Step { loss, .. } = record { Some(*loss) } else { None }
}

fn batch_psnr(record: &Record) -> Option<f64> {
    if let Record::Step { psnr, .. } = record { Some(*psnr) } else { None }
}

fn held_out_psnr(record: &Record) -> Option<f64> {
    if let Record::Evaluation { psnr, .. } = record { *psnr } else { None }
}

fn speed(record: &Record) -> Option<f64> {
    if let Record::Step { tiles_per_second, .. } = record { Some(*tiles_per_second) } else { None }
}

fn gaussians(record: &Record) -> Option<f64> {
    match record {
        Record::Step { gaussians, .. } | Record::Growth { gaussians, .. } => {
            Some(*gaussians as f64)
        }
        _ => None,
    }
}

/// A number of things in a few characters.
fn short(number: f64) -> String {
    match number {
        ..1e4 => format!("{number:.0}"),
        ..1e6 => format!("{:.1}k", number / 1e3),
        _ => format!("{:.2}M", number / 1e6),
    }
}

/// What a chart's x axis is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Over {
    Steps,
    /// Seconds divided by so many, and what the unit is called.
    Time(f64, &'static str),
}

impl Over {
    /// Time in a unit of which the run takes a few.
    fn time(records: &[Record]) -> Self {
        let longest = records.iter().filter_map(seconds).fold(0.0, f64::max);
        match longest {
            10_800.0.. => Self::Time(3600.0, "hours"),
            180.0.. => Self::Time(60.0, "minutes"),
            _ => Self::Time(1.0, "seconds"),
        }
    }

    fn label(self) -> String {
        match self {
            Self::Steps => "steps".to_owned(),
            Self::Time(_, unit) => format!("{unit} of training"),
        }
    }

    fn of(self, record: &Record) -> Option<f64> {
        match self {
            Self::Steps => Some(record.step() as f64),
            Self::Time(unit, _) => seconds(record).map(|seconds| seconds / unit),
        }
    }
}

fn seconds(record: &Record) -> Option<f64> {
    match record {
        Record::Step { seconds, .. } | Record::Evaluation { seconds, .. } => Some(*seconds),
        Record::Growth { .. } | Record::Change(_) | Record::Timing { .. } => None,
    }
}

fn series(name: &'static str, records: &[Record], over: Over, value: Value) -> Series {
    let point = |record: &Record| Some([over.of(record)?, value(record)?]);
    let mut points: Vec<[f64; 2]> = records.iter().filter_map(point).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    Series { name, class: "train", style: Style::Noise, points }
}

fn chart(
    title: &'static str,
    unit: &'static str,
    scale: Scale,
    label: fn(f64) -> String,
    over: Over,
    series: Vec<Series>,
) -> String {
    Chart { title, x: over.label(), unit, scale, label, series }.figure()
}

/// What became of the Gaussians, in a sentence.
fn growth(records: &[Record]) -> String {
    let events = records.iter().filter_map(|record| match record {
        Record::Growth { split, cloned, pruned, .. } => Some([split, cloned, pruned]),
        _ => None,
    });
    let (mut sums, mut times) = ([0; 3], 0);
    for event in events {
        sums.iter_mut().zip(event).for_each(|(sum, value)| *sum += value);
        times += 1;
    }
    if times == 0 {
        return String::new();
    }
    let [split, cloned, pruned] = sums.map(super::grouped);
    let times = if times == 1 { "once".to_owned() } else { format!("{times} times") };
    format!(
        "<p class=\"quiet\" style=\"margin-top: 14px\">The set of Gaussians was changed {times}: \
         {split} split, {cloned} cloned, {pruned} pruned.</p>\n"
    )
}
