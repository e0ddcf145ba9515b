//! Parts that all pages share: the frame, and the format of numbers.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use sha2::{Digest, Sha256};

use super::charts::Charts;
use super::pictures::{Picture, error_color};
use organza_core::metrics::ERROR_FACTOR;

const STYLE: &str =
    concat!(include_str!("assets/uPlot.min.css"), "\n", include_str!("assets/page.css"));
/// uPlot with its license, and the page's own script.
const SCRIPT: &str = concat!(
    "/*\n",
    include_str!("assets/uPlot.LICENSE"),
    "*/\n",
    include_str!("assets/uPlot.iife.min.js"),
    include_str!("assets/page.js")
);

/// A whole page. Its policy allows no request, and no script but [`SCRIPT`].
pub fn page(title: &str, charts: &Charts, body: &Markup) -> String {
    let hash = STANDARD.encode(Sha256::digest(SCRIPT));
    let policy = format!(
        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{hash}'; \
         base-uri 'none'; form-action 'none'"
    );
    let version = env!("CARGO_PKG_VERSION");
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(policy);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                link rel="icon" href="data:,";
                title { (clean(title)) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                main { (body) }
                footer { "Written by organza " (version) "." }
                script id="data" type="application/json" { (PreEscaped(charts.json())) }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    page.into_string()
}

/// Removes characters that a page must not contain, but names of files may.
pub fn clean(text: &str) -> String {
    let shown = |character: char| match character {
        '\n' | '\t' => character,
        '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
        control if control.is_control() => '\u{fffd}',
        other => other,
    };
    text.chars().map(shown).collect()
}

/// A heading with its content.
pub fn section(heading: &str, content: &Markup) -> Markup {
    html! { section { h2 { (heading) } (content) } }
}

/// The curves, and a choice of their x axis.
pub fn curves(charts: &Charts, note: &Markup) -> Markup {
    if charts.charts.is_empty() {
        return Markup::default();
    }
    html! {
        section {
            div.heading {
                h2 { "Curves" }
                fieldset.over {
                    legend { "Over" }
                    label { input type="radio" name="over" value="step" checked; span { "steps" } }
                    label { input type="radio" name="over" value="seconds"; span { "time" } }
                }
            }
            noscript { p.quiet { "The curves need scripts. Their numbers are in the run's metrics.jsonl." } }
            div.charts {
                @for (at, chart) in charts.charts.iter().enumerate() {
                    figure.chart {
                        figcaption {
                            b { (chart.title) }
                            @if !chart.unit.is_empty() { span.quiet { " " (chart.unit) } }
                        }
                        div data-chart=(at) {}
                    }
                }
            }
            (note)
        }
    }
}

/// A table with a title row. In each row, the first `words` cells are text and the others are numbers.
pub fn table(class: &str, titles: &[String], words: usize, rows: &[Vec<String>]) -> Markup {
    let kind = |column: usize| (column >= words).then_some("number");
    html! {
        div.scroll {
            table class=(class) {
                thead { tr { @for (column, title) in titles.iter().enumerate() {
                    th class=[kind(column)] scope="col" { (clean(title)) }
                } } }
                tbody { @for row in rows { tr { @for (column, cell) in row.iter().enumerate() {
                    td class=[kind(column)] { (clean(cell)) }
                } } } }
            }
        }
    }
}

/// A picture. Small ones are enlarged without smoothing.
pub fn image(picture: &Picture, what: &str) -> Markup {
    let [width, height] = picture.size;
    let small = (width.max(height) < 256).then_some("small");
    html! { img class=[small] src=(picture.data) width=(width) height=(height) alt=(clean(what)); }
}

/// The legend of error pictures.
pub fn error_legend() -> Markup {
    const STOPS: u32 = 16;
    let color = |stop| {
        let [r, g, b] = error_color(f64::from(stop) / f64::from(STOPS));
        format!("#{r:02x}{g:02x}{b:02x}")
    };
    let colors = (0..=STOPS).map(color).collect::<Vec<_>>().join(", ");
    let max = 1.0 / f64::from(ERROR_FACTOR);
    html! {
        div.scale {
            span { "0" }
            span.ramp style=(format!("background: linear-gradient(to right, {colors})")) {}
            span { (format!("≥ {max}")) }
        }
    }
}

/// A score, or a dash for `None`.
pub fn score(value: Option<f64>, digits: usize) -> String {
    value
        .filter(|value| value.is_finite())
        .map_or_else(|| "–".to_owned(), |value| format!("{value:.digits$}"))
}

/// Formats a time for people: `4.2 s`, `12 min 3 s`, `2 h 5 min`.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.max(0.0).round() as u64;
    match whole {
        _ if seconds < 60.0 => format!("{seconds:.1} s"),
        ..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
    }
}

/// Formats a date of the log for people: `2026-01-31 09:30 UTC`.
pub fn date(text: &str) -> String {
    match (text.get(..10), text.get(11..16)) {
        (Some(day), Some(time)) if text.ends_with('Z') => format!("{day} {time} UTC"),
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_readable() {
        let cases = [(0.04, "0.0 s"), (59.9, "59.9 s"), (61.0, "1 min 1 s"), (7500.0, "2 h 5 min")];
        for (seconds, text) in cases {
            assert_eq!(duration(seconds), text);
        }
        assert_eq!(date("2026-01-31T09:30:00Z"), "2026-01-31 09:30 UTC");
        assert_eq!(date("<yesterday>"), "<yesterday>");
    }

    /// Either text would end the element that contains it.
    #[test]
    fn script_and_style_are_whole() {
        assert!(!SCRIPT.contains("</script") && !SCRIPT.contains("<!--") && !SCRIPT.contains('\r'));
        assert!(!STYLE.contains("</style"));
    }
}
