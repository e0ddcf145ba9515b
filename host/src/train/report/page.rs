//! Pieces of HTML that is XML at the same time.

use std::fmt::Write;

use super::picture::{ERROR_FACTOR, error_color};

/// Text as it stands between tags or quotes. Characters that XML does not allow become `\u{fffd}`.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            '\n' | '\t' => escaped.push(character),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            control if control.is_control() => escaped.push('\u{fffd}'),
            other => escaped.push(other),
        }
    }
    escaped
}

/// A whole page.
pub fn page(title: &str, body: &str) -> String {
    let title = escape(title);
    let style = include_str!("style.css");
    format!(
        "<!DOCTYPE html>\n\
         <html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <meta name=\"color-scheme\" content=\"light dark\"/>\n\
         <title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n{body}</main>\n\
         </body>\n</html>\n"
    )
}

/// A heading with what belongs to it; nothing where there is nothing.
pub fn section(heading: &str, content: &str) -> String {
    if content.is_empty() {
        return String::new();
    }
    format!("<section>\n<h2>{}</h2>\n{content}</section>\n", escape(heading))
}

/// A table with titles. Of each row the first `words` cells are words, the others numbers.
pub fn table<const N: usize>(
    class: &str,
    titles: [&str; N],
    words: usize,
    rows: &[[String; N]],
) -> String {
    let cells = |cells: [&str; N], tag: &str| {
        let mut row = String::from("<tr>");
        for (column, cell) in cells.iter().enumerate() {
            let class = if column < words { "" } else { " class=\"number\"" };
            // Writing to a String does not fail.
            let _ = write!(row, "<{tag}{class}>{}</{tag}>", escape(cell));
        }
        row + "</tr>\n"
    };
    let body: String =
        rows.iter().map(|row| cells(row.each_ref().map(String::as_str), "td")).collect();
    format!(
        "<table class=\"{class}\">\n<thead>{}</thead>\n<tbody>\n{body}</tbody>\n</table>\n",
        cells(titles, "th")
    )
}

/// What the colors of error pictures mean.
pub fn error_legend() -> String {
    const STOPS: u32 = 16;
    const TICKS: u32 = 4;
    let hex = |[r, g, b]: [u8; 3]| format!("#{r:02x}{g:02x}{b:02x}");
    let mut svg = String::from(
        "<svg class=\"scale\" viewBox=\"0 0 280 30\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" \
         aria-label=\"Colors of the error\">\n<defs><linearGradient id=\"error\">",
    );
    for stop in 0..=STOPS {
        let place = f64::from(stop) / f64::from(STOPS);
        let color = hex(error_color(place));
        let _ = write!(svg, "<stop offset=\"{place:.4}\" stop-color=\"{color}\"/>");
    }
    svg += "</linearGradient></defs>\n<rect x=\"20\" y=\"0\" width=\"240\" height=\"12\" rx=\"2\" \
            fill=\"url(#error)\"/>\n";
    for tick in 0..=TICKS {
        let place = f64::from(tick) / f64::from(TICKS);
        let (x, value) = (20.0 + 240.0 * place, place / f64::from(ERROR_FACTOR));
        let label = if tick == TICKS { format!("≥ {value:.2}") } else { format!("{value:.2}") };
        let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"25\" text-anchor=\"middle\">{label}</text>");
    }
    svg + "</svg>\n"
}

/// Digits in groups of three.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A time as one says it: `4.2 s`, `12 min 3 s`, `2 h 5 min`.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.max(0.0).round() as u64;
    match whole {
        _ if seconds < 60.0 => format!("{seconds:.1} s"),
        ..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_gets_through() {
        assert_eq!(
            escape("<a b=\"c\">&'\0\u{7}\u{ffff}é"),
            "&lt;a b=&quot;c&quot;&gt;&amp;&#39;\u{fffd}\u{fffd}\u{fffd}é"
        );
        let table = table("x", ["<"], 1, &[["&".to_owned()]]);
        assert!(table.contains("<th>&lt;</th>") && table.contains("<td>&amp;</td>"), "{table}");
    }

    #[test]
    fn times_are_readable() {
        let cases = [(0.04, "0.0 s"), (59.9, "59.9 s"), (61.0, "1 min 1 s"), (7500.0, "2 h 5 min")];
        for (seconds, text) in cases {
            assert_eq!(duration(seconds), text);
        }
    }
}
