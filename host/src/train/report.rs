//! `report.html`: a run on one page that opens offline.
//!
//! The page holds everything it shows: curves as SVG, pictures as PNG or JPEG in base64. There is no script in it, and
//! nothing is loaded. It is XML, too, so that it can be checked.

mod axis;
mod chart;
mod curves;
mod page;
mod picture;
#[cfg(test)]
mod tests;

use std::path::Path;

use super::metrics::{Record, TimingRow};
use crate::atomic_file::write_atomic;
use crate::data::Photograph;
use crate::error::Result;
use crate::evaluate::ViewScore;
use crate::image::Image;
use page::{duration, escape, grouped, section, table};
use picture::{ERROR_FACTOR, Picture, pictures};

/// Views that a report shows; further ones are left out.
pub const MAX_VIEWS: usize = 8;

/// What a report tells.
#[derive(Clone, Debug, Default)]
pub struct Report<'a> {
    /// The heading: what was trained on.
    pub title: String,
    /// The device, as [`Device::choice`](crate::Device::choice) says it.
    pub device: String,
    /// The settings with their values, in order.
    pub config: Vec<(String, String)>,
    /// The run's records, in the order they were written. The last timing is the one that is shown.
    pub records: &'a [Record],
    /// Held-out views to show, of which the first [`MAX_VIEWS`] are.
    pub views: Vec<ReportView<'a>>,
}

/// A view beside its photograph.
#[derive(Clone, Debug)]
pub struct ReportView<'a> {
    /// The photograph's name.
    pub name: String,
    /// The photograph.
    pub truth: &'a Photograph,
    /// What the scene looks like from there, of the photograph's size.
    pub rendered: Image,
    /// PSNR in decibels, where it exists.
    pub psnr: Option<f64>,
    /// SSIM, where it exists.
    pub ssim: Option<f64>,
}

/// Writes a report, atomically. It takes less than 10 MiB unless there are very many settings or views: pictures are
/// made small enough for that, 800 pixels a side at most.
///
/// # Errors
/// [`Error::WriteFile`](crate::Error::WriteFile); [`Error::Argument`](crate::Error::Argument) where an image is not of
/// its photograph's size.
pub fn write_report(path: impl AsRef<Path>, report: &Report<'_>) -> Result<()> {
    let html = html(report)?;
    write_atomic(path, |writer| writer.write_all(html.as_bytes()))
}

fn html(report: &Report<'_>) -> Result<String> {
    let parts = [
        header(report),
        section("Curves", &curves::charts(report.records)),
        section("Held-out views", &views(report)?),
        section("Where the time went", &timing(report.records)),
        section("Settings", &settings(&report.config)),
        format!("<footer>Written by organza {}.</footer>\n", env!("CARGO_PKG_VERSION")),
    ];
    Ok(page::page(&report.title, &parts.concat()))
}

/// What one wants to know first.
fn header(report: &Report<'_>) -> String {
    let fact = |(name, value, unit): (&str, String, &str)| {
        let (value, unit) = (escape(&value), escape(unit));
        format!("<div><dt>{name}</dt><dd>{value} <small>{unit}</small></dd></div>\n")
    };
    let facts: String = facts(report.records).into_iter().map(fact).collect();
    let facts =
        if facts.is_empty() { facts } else { format!("<dl class=\"facts\">\n{facts}</dl>\n") };
    let (title, device) = (escape(&report.title), escape(&report.device));
    format!("<header>\n<h1>{title}</h1>\n<p class=\"quiet\">{device}</p>\n{facts}</header>\n")
}

fn facts(records: &[Record]) -> Vec<(&'static str, String, &'static str)> {
    let mut facts = Vec::new();
    if let Some((psnr, ssim)) = records.iter().rev().find_map(|record| match record {
        Record::Evaluation { psnr, ssim, .. } => Some((psnr, ssim)),
        _ => None,
    }) {
        facts.push(("Held-out PSNR", score(*psnr, 2), "dB"));
        facts.push(("Held-out SSIM", score(*ssim, 4), ""));
    }
    if let Some((step, seconds, gaussians)) = records.iter().rev().find_map(|record| match record {
        Record::Step { step, seconds, gaussians, .. } => Some((*step, *seconds, *gaussians)),
        _ => None,
    }) {
        facts.push(("Steps", grouped(step), ""));
        facts.push(("Training time", duration(seconds), ""));
        facts.push(("Gaussians", grouped(gaussians), ""));
    }
    let speeds = records.iter().filter_map(|record| match record {
        Record::Step { tiles_per_second, .. } => Some(*tiles_per_second),
        _ => None,
    });
    let mut speeds: Vec<_> = speeds.filter(|speed| speed.is_finite()).collect();
    speeds.sort_by(f64::total_cmp);
    if let Some(median) = speeds.get(speeds.len() / 2) {
        facts.push(("Speed, median", format!("{median:.1}"), "tiles/s"));
    }
    facts
}

fn score(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format!("{value:.digits$}"))
}

fn views(report: &Report<'_>) -> Result<String> {
    let shown = &report.views[..report.views.len().min(MAX_VIEWS)];
    let mut html = String::new();
    if !shown.is_empty() {
        let (factor, brightest) = (ERROR_FACTOR, 1.0 / f64::from(ERROR_FACTOR));
        html += &format!(
            "<p class=\"quiet\">Photograph, rendered image, and error: the absolute difference of \
             values of 0 to 1, mean of the channels, times {factor}, so that {brightest:.2} and more \
             is brightest. Where the photograph has no pixels, there is no error.</p>\n{}",
            page::error_legend()
        );
    }
    for (view, pictures) in shown.iter().zip(pictures(shown)?) {
        html += &view_figure(view, &pictures);
    }
    Ok(html + &scores(report.records))
}

fn view_figure(view: &ReportView<'_>, pictures: &[Picture; 3]) -> String {
    let name = escape(&view.name);
    let [full_width, full_height] = view.rendered.size();
    let figure = |(picture, what): (&Picture, &str)| {
        let [width, height] = picture.size;
        let class = if width.max(height) < 256 { " class=\"small\"" } else { "" };
        format!(
            "<figure><img{class} src=\"{}\" width=\"{width}\" height=\"{height}\" alt=\"{what} of \
             {name}\"/><figcaption>{what}</figcaption></figure>\n",
            picture.data
        )
    };
    let labels = ["Photograph", "Rendered", "Error"];
    let figures: String = pictures.iter().zip(labels).map(figure).collect();
    let (psnr, ssim) = (score(view.psnr, 2), score(view.ssim, 4));
    let [width, height] = pictures[0].size;
    let shown = if [width, height] == [full_width, full_height] {
        String::new()
    } else {
        format!(", shown at {width} × {height}")
    };
    format!(
        "<div class=\"view\">\n<h3>{name} <span>PSNR {psnr} dB, SSIM {ssim}; {full_width} × \
         {full_height} pixels{shown}</span></h3>\n<div class=\"pictures\">\n{figures}</div>\n</div>\n"
    )
}

/// All views of the last evaluation.
fn scores(records: &[Record]) -> String {
    let last = records.iter().rev().find_map(|record| match record {
        Record::Evaluation { step, views, .. } if !views.is_empty() => Some((step, views)),
        _ => None,
    });
    let Some((step, views)) = last else { return String::new() };
    let row = |view: &ViewScore| {
        [view.name.clone(), score(view.score.psnr, 2), score(view.score.ssim, 4)]
    };
    let rows: Vec<_> = views.iter().map(row).collect();
    format!(
        "<details>\n<summary>Scores of all {} held-out views after step {}</summary>\n\
         <div class=\"scroll\">{}</div>\n</details>\n",
        views.len(),
        grouped(*step),
        table("scores", ["View", "PSNR, dB", "SSIM"], 1, &rows)
    )
}

fn timing(records: &[Record]) -> String {
    let last = records.iter().rev().find_map(|record| match record {
        Record::Timing { rows, .. } if !rows.is_empty() => Some(rows),
        _ => None,
    });
    let Some(rows) = last else { return String::new() };
    let row = |row: &TimingRow| {
        let share = 100.0 * row.share;
        let width = if share.is_finite() { share.clamp(0.0, 100.0) } else { 0.0 };
        format!(
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{share:.1} %</td>\
             <td class=\"bar\"><span style=\"width: {width:.1}%\"></span></td></tr>\n",
            escape(&row.stage),
            duration(row.seconds),
        )
    };
    let rows: String = rows.iter().map(row).collect();
    format!(
        "<div class=\"scroll\"><table class=\"timing\">\n<thead><tr><th>Stage</th>\
         <th class=\"number\">Time</th><th class=\"number\">Share</th><th></th></tr></thead>\n\
         <tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

fn settings(config: &[(String, String)]) -> String {
    if config.is_empty() {
        return String::new();
    }
    let rows: Vec<_> = config.iter().map(|(name, value)| [name.clone(), value.clone()]).collect();
    format!("<div class=\"scroll\">{}</div>\n", table("settings", ["Setting", "Value"], 2, &rows))
}
