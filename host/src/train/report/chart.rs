//! Curves as SVG.

use std::fmt::Write;

use super::axis::{Axis, Scale};
use super::page::escape;

/// Size of a chart, and of the margins around its curves, in the units of its view box.
const SIZE: [f64; 2] = [520.0, 260.0];
const LEFT: f64 = 46.0;
const RIGHT: f64 = 54.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 40.0;
/// A curve has at most about so many points: more cannot be seen.
const POINTS: usize = 400;
/// Curves of more points than this are noise, in front of which their running mean is drawn.
const NOISE_FROM: usize = 24;
/// The running mean is over this share of the points.
const MEAN_OVER: usize = 24;
/// Ticks along x and y, about.
const TICKS: [usize; 2] = [7, 5];
/// Labels at the curves' ends are at least this far apart.
const LABEL_HEIGHT: f64 = 13.0;

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    /// As noise, in front of which its running mean is.
    Noise,
    /// With a mark at each point, as the few of an evaluation.
    Marks,
    /// In steps: a value holds until the next.
    Steps,
}

/// A curve.
#[derive(Clone, Debug)]
pub struct Series {
    /// What it shows.
    pub name: &'static str,
    /// The class that gives it its color: `train` or `held-out`.
    pub class: &'static str,
    /// How it is drawn.
    pub style: Style,
    /// Its points, ascending in x. Those that are not finite are gaps.
    pub points: Vec<[f64; 2]>,
}

/// Curves over a common axis.
#[derive(Clone, Debug)]
pub struct Chart {
    pub title: &'static str,
    /// What x is, with its unit.
    pub x: String,
    /// The unit of y; may be empty.
    pub unit: &'static str,
    pub scale: Scale,
    /// What is written at the curves' ends.
    pub label: fn(f64) -> String,
    pub series: Vec<Series>,
}

impl Chart {
    /// The chart, or nothing where there are no points.
    pub fn figure(&self) -> String {
        let drawn: Vec<_> = self.series.iter().filter(|series| series.is_drawn()).collect();
        if drawn.is_empty() {
            return String::new();
        }
        let frame = Frame::new(self.scale, &drawn);
        let mut svg = frame.grid(&self.x, self.unit);
        for series in &drawn {
            svg += &frame.curve(series);
        }
        svg += &frame.end_labels(&drawn, self.label);
        let [width, height] = SIZE;
        let (title, x) = (escape(self.title), escape(&self.x));
        format!(
            "<figure class=\"chart\"><figcaption><b>{title}</b> over {x}{}</figcaption>\n\
             <svg viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" \
             aria-label=\"{title} over {x}\">\n{svg}</svg></figure>\n",
            legend(&drawn)
        )
    }
}

impl Series {
    fn finite(&self) -> impl Iterator<Item = [f64; 2]> + Clone {
        self.points.iter().copied().filter(|point| point.iter().all(|value| value.is_finite()))
    }

    /// Whether there are enough points for a running mean to tell more than they do.
    fn is_noise(&self) -> bool {
        self.style == Style::Noise && self.finite().count() > NOISE_FROM
    }

    /// The points of the curve itself.
    fn line(&self) -> Vec<[f64; 2]> {
        let points: Vec<_> = self.finite().collect();
        if self.is_noise() { running_mean(&points) } else { points }
    }

    fn is_drawn(&self) -> bool {
        self.finite().next().is_some()
    }
}

/// The curves' names and colors, where there is more than one.
fn legend(series: &[&Series]) -> String {
    if series.len() < 2 {
        return String::new();
    }
    let entry = |series: &&Series| {
        format!(" <span class=\"key {}\">{}</span>", series.class, escape(series.name))
    };
    series.iter().map(entry).collect()
}

/// Where values lie in the picture.
struct Frame {
    x: Axis,
    y: Axis,
}

impl Frame {
    fn new(scale: Scale, series: &[&Series]) -> Self {
        let values = |axis: usize| {
            let points = series.iter().flat_map(|series| series.finite());
            points.map(move |point| point[axis])
        };
        Self {
            x: Axis::new(Scale::FromZero, values(0), TICKS[0]),
            y: Axis::new(scale, values(1), TICKS[1]),
        }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [width, height] = SIZE;
        [
            LEFT + self.x.place(x) * (width - LEFT - RIGHT),
            height - BOTTOM - self.y.place(y) * (height - TOP - BOTTOM),
        ]
    }

    /// Lines at the ticks, and their labels.
    fn grid(&self, x_label: &str, unit: &str) -> String {
        let mut svg = String::new();
        let [width, height] = SIZE;
        let (right, bottom) = (width - RIGHT, height - BOTTOM);
        // Writing to a String does not fail.
        for (value, label) in &self.y.ticks {
            let y = bottom - self.y.place(*value) * (bottom - TOP);
            let _ = writeln!(
                svg,
                "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{right}\"/>\
                 <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
                LEFT - 7.0,
                y + 3.8
            );
        }
        let _ = writeln!(svg, "<path class=\"axis\" d=\"M{LEFT} {bottom}H{right}\"/>");
        for (value, label) in &self.x.ticks {
            let x = LEFT + self.x.place(*value) * (right - LEFT);
            let _ = writeln!(
                svg,
                "<path class=\"axis\" d=\"M{x:.1} {bottom}v4\"/>\
                 <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{label}</text>",
                bottom + 16.0
            );
        }
        let (middle, low) = ((LEFT + right) / 2.0, height - 7.0);
        let (x_label, unit) = (escape(x_label), escape(unit));
        let _ = writeln!(
            svg,
            "<text class=\"label\" x=\"{middle:.1}\" y=\"{low:.1}\" text-anchor=\"middle\">{x_label}</text>"
        );
        if !unit.is_empty() {
            let _ = writeln!(
                svg,
                "<text class=\"label\" transform=\"rotate(-90)\" x=\"{:.1}\" y=\"10\" \
                 text-anchor=\"middle\">{unit}</text>",
                -(TOP + bottom) / 2.0
            );
        }
        svg
    }

    fn curve(&self, series: &Series) -> String {
        let class = series.class;
        let points: Vec<_> = series.finite().collect();
        let mut svg = String::new();
        if series.is_noise() {
            let path = self.path(&extremes(&points), series.style);
            let _ = writeln!(svg, "<path class=\"noise {class}\" d=\"{path}\"/>");
        }
        let line = thinned(&series.line());
        let path = self.path(&line, series.style);
        let _ = writeln!(svg, "<path class=\"curve {class}\" d=\"{path}\"/>");
        let is_marked = series.style == Style::Marks || line.len() == 1;
        let marks = if is_marked { line.as_slice() } else { &[] };
        for &point in marks {
            let [x, y] = self.place(point);
            let _ = writeln!(
                svg,
                "<circle class=\"mark {class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.6\"/>"
            );
        }
        svg
    }

    fn path(&self, points: &[[f64; 2]], style: Style) -> String {
        let mut path = String::new();
        for (index, &point) in points.iter().enumerate() {
            let [x, y] = self.place(point);
            let _ = match (index, style) {
                (0, _) => write!(path, "M{x:.1} {y:.1}"),
                (_, Style::Steps) => write!(path, "H{x:.1}V{y:.1}"),
                _ => write!(path, "L{x:.1} {y:.1}"),
            };
        }
        path
    }

    /// The last value of each curve beside its end.
    fn end_labels(&self, series: &[&Series], label: fn(f64) -> String) -> String {
        let end = |series: &&Series| {
            let last = *series.line().last()?;
            Some((self.place(last), last[1], series.class))
        };
        let mut ends: Vec<_> = series.iter().filter_map(end).collect();
        ends.sort_by(|a, b| a.0[1].total_cmp(&b.0[1]));
        let mut free = f64::NEG_INFINITY;
        let mut svg = String::new();
        for ([x, y], value, class) in ends {
            let y = y.max(free);
            free = y + LABEL_HEIGHT;
            let _ = writeln!(
                svg,
                "<text class=\"end {class}\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                x + 6.0,
                y + 3.8,
                label(value)
            );
        }
        svg
    }
}

/// The mean of each point's neighbors: as many on either side, fewer near the ends. The last points have more of them
/// before, so that the end is no less smooth than the rest.
fn running_mean(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let reach = points.len() / MEAN_OVER / 2 + 1;
    let mean = |at: usize| {
        let after = reach.min(at.max(1)).min(points.len() - 1 - at);
        let before = reach.min(at).min(after.max(reach.div_ceil(2)));
        let part = &points[at - before..=at + after];
        let sum: f64 = part.iter().map(|point| point[1]).sum();
        [points[at][0], sum / part.len() as f64]
    };
    (0..points.len()).map(mean).collect()
}

/// At most about [`POINTS`] points, the last among them.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let each = points.len().div_ceil(POINTS).max(1);
    let mut kept: Vec<_> = points.iter().rev().step_by(each).copied().collect();
    kept.reverse();
    if let (Some(&first), true) = (points.first(), kept.first() != points.first()) {
        kept.insert(0, first);
    }
    kept
}

/// The lowest and the highest point of each of some hundred parts, in order.
fn extremes(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let part = points.len().div_ceil(POINTS / 2).max(1);
    let pick = |part: &[[f64; 2]]| {
        let order = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let mut both: Vec<_> = part
            .iter()
            .min_by(order)
            .into_iter()
            .chain(part.iter().max_by(order))
            .copied()
            .collect();
        both.sort_by(|a, b| a[0].total_cmp(&b[0]));
        both.dedup();
        both
    };
    points.chunks(part).flat_map(pick).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_points_become_few_and_keep_their_extremes() {
        let mut points: Vec<_> =
            (0..100_000).map(|x| [f64::from(x), (f64::from(x)).sin()]).collect();
        points[12_345][1] = 9.0;
        points[54_321][1] = -9.0;
        let few = extremes(&points);
        assert!(few.len() <= POINTS + 2, "{}", few.len());
        assert!(few.contains(&points[12_345]) && few.contains(&points[54_321]));
        assert!(few.is_sorted_by(|a, b| a[0] <= b[0]));
        let few = thinned(&points);
        assert!(few.len() <= POINTS + 2, "{}", few.len());
        assert_eq!((few.first(), few.last()), (points.first(), points.last()));
    }

    #[test]
    fn a_running_mean_keeps_lines_straight() {
        let points: Vec<_> = (0..100).map(|x| [f64::from(x), 3.0 * f64::from(x)]).collect();
        for (mean, point) in running_mean(&points).iter().zip(&points).skip(1).take(96) {
            assert!((mean[1] - point[1]).abs() < 1e-9, "{mean:?} for {point:?}");
        }
    }

    #[test]
    fn gaps_and_emptiness_are_no_problem() {
        let series = |points: Vec<[f64; 2]>| Series {
            name: "train",
            class: "train",
            style: Style::Noise,
            points,
        };
        let figure = |points| {
            let (title, unit) = ("Loss", "");
            let (x, series) = ("steps".to_owned(), vec![series(points)]);
            Chart {
                title,
                x,
                unit,
                scale: Scale::Logarithmic,
                label: |value| format!("{value:.3}"),
                series,
            }
            .figure()
        };
        assert_eq!(figure(vec![]), "");
        assert_eq!(figure(vec![[1.0, f64::NAN]]), "");
        for points in [vec![[0.0, 0.0]], vec![[1.0, 2.0], [2.0, f64::NAN], [3.0, 2.0]]] {
            let text = figure(points);
            assert!(
                text.contains("curve") && !text.contains("NaN") && !text.contains("inf"),
                "{text}"
            );
        }
    }
}
