//! The page of one run.

use std::path::Path;

use maud::{Markup, html};

use super::MAX_VIEWS;
use super::charts::{Charts, thinned};
use super::page::{
    clean, curves, date, duration, error_legend, image, page, score, section, table,
};
use super::pictures::{Content, Picture};
use super::run::{Evaluation, Run};
use muslin_device::grouped;
use organza_core::metrics::ERROR_FACTOR;
use organza_core::{Result, write_inside};
use organza_train::config::TrainConfig;
use organza_train::evaluate::{Score, ViewScore};
use organza_train::metrics::TimingRow;

/// Largest number of pictures over time.
const MAX_TIMES: usize = 24;
/// Largest number of evaluations in the table.
const MAX_ROWS: usize = 100;

/// Writes a run's page, atomically. It takes a few MiB: pictures and curves are thinned out to fit.
///
/// # Errors
/// [`Error::WriteFile`](organza_core::Error::WriteFile).
pub fn write_report(path: impl AsRef<Path>, run: &Run) -> Result<()> {
    let html = html(run);
    write_inside(path, |writer| writer.write_all(html.as_bytes()))
}

pub(super) fn html(run: &Run) -> String {
    let charts = Charts::from_run(run);
    let evaluations = run.evaluations();
    let last = evaluations.last();
    let body = html! {
        (header(run))
        @if let Some(last) = last { (views(run, last)) }
        (over_time(run, &evaluations))
        (curves(&charts, &densification(run)))
        (scores(&evaluations))
        (sessions(run))
        (timing(run))
        (settings(run))
    };
    page(&format!("{} – organza", run.data()), &charts, &body)
}

/// The facts that a reader wants first.
fn header(run: &Run) -> Markup {
    let summary = run.summary();
    let mut facts = Vec::new();
    let mut add = |name: &'static str, value: String, unit: String| facts.push((name, value, unit));
    if summary.mean.psnr.is_some() || summary.mean.ssim.is_some() {
        add("Held-out PSNR", score(summary.mean.psnr, 2), "dB".to_owned());
        if summary.mean.psnr_fitted.is_some() {
            add("With exposures fitted", score(summary.mean.psnr_fitted, 2), "dB".to_owned());
        }
        add("Held-out SSIM", score(summary.mean.ssim, 4), String::new());
    }
    if summary.step > 0 {
        let all = format!("of {}", grouped(u64::from(run.config.run.steps)));
        add("Steps", grouped(summary.step), all);
        add("Training time", duration(summary.seconds), String::new());
    }
    if let Some(gaussians) = summary.gaussians {
        add("Gaussians", grouped(gaussians), String::new());
    }
    if let Some(speed) = summary.tiles_per_second {
        add("Speed, median", format!("{speed:.1}"), "tiles/s".to_owned());
    }
    let last = run.last_step();
    html! {
        header {
            p.quiet { "Training run in the folder " (clean(&run.name())) }
            h1 { (clean(&run.data())) }
            @if !facts.is_empty() {
                dl.facts { @for (name, value, unit) in &facts {
                    div { dt { (name) } dd { (value) @if !unit.is_empty() { " " small { (unit) } } } }
                } }
            }
            @if last > summary.step && summary.mean.psnr.is_some() {
                p.quiet {
                    "These numbers are of the last evaluation. Training went on to step " (grouped(last)) "."
                }
            }
        }
    }
}

/// A sentence about the changes of the Gaussians.
fn densification(run: &Run) -> Markup {
    let ([split, pruned], times) = run.densification();
    if times == 0 {
        return Markup::default();
    }
    let times = if times == 1 { "once".to_owned() } else { format!("{times} times") };
    let [split, pruned] = [split, pruned].map(grouped);
    html! { p.quiet.note {
        "The set of Gaussians changed " (times) ": " (split) " split, " (pruned) " pruned."
    } }
}

/// The first held-out view over time, starting before the first step.
fn over_time(run: &Run, evaluations: &[Evaluation<'_>]) -> Markup {
    let steps = std::iter::once(0).chain(evaluations.iter().map(|evaluation| evaluation.step));
    let steps = thinned(steps.collect(), MAX_TIMES);
    let picture = |step: u64| Some((step, run.pictures.thumbnail(step)?));
    let pictures: Vec<(u64, Picture)> = steps.into_iter().filter_map(picture).collect();
    let Some(view) = evaluations.last().and_then(|last| last.views.first()) else {
        return Markup::default();
    };
    if pictures.len() < 2 {
        return Markup::default();
    }
    let caption = |step: u64| {
        let found = evaluations.iter().find(|evaluation| evaluation.step == step);
        let psnr = found.and_then(|found| found.views.first()?.score.psnr);
        psnr.map_or_else(String::new, |psnr| format!("{psnr:.2} dB"))
    };
    section(
        "Over time",
        &html! {
            p.quiet { "The held-out view " (clean(&view.name)) " before the first step and after each evaluation." }
            div.film { @for (step, picture) in &pictures {
                figure {
                    (image(picture, &format!("{} after {step} steps", view.name)))
                    figcaption { span { "step " (grouped(*step)) } span { (caption(*step)) } }
                }
            } }
        },
    )
}

fn views(run: &Run, last: &Evaluation<'_>) -> Markup {
    let view = |(index, view): (usize, &ViewScore)| {
        let kinds = [Content::Photograph, Content::Rendered(last.step), Content::Error(last.step)];
        let [photograph, rendered, error] = kinds.map(|kind| run.pictures.view(index, kind));
        Some(figure_of(view, run.truth(), [photograph?, rendered?, error?]))
    };
    let figures: Vec<_> = last.views.iter().enumerate().take(MAX_VIEWS).filter_map(view).collect();
    if figures.is_empty() {
        return Markup::default();
    }
    section(
        "Held-out views",
        &html! {
            p.quiet {
                "After step " (grouped(last.step)) ". The error is the absolute difference of values from 0 to 1, averaged \
                 over the channels, times " (ERROR_FACTOR) "."
                @if run.config.data.path.is_some() {
                    " Where the photograph has no valid pixel, such as behind a mask, the error is 0."
                }
            }
            (error_legend())
            @for figure in &figures { (figure) }
        },
    )
}

/// A view's pictures. With scripts, the truth lies over the rendered image, and a slider moves the border.
fn figure_of(view: &ViewScore, truth: &str, [shown, rendered, error]: [Picture; 3]) -> Markup {
    let name = &view.name;
    let [width, height] = rendered.size;
    html! {
        div.view {
            h3 {
                span { (clean(name)) }
                span.quiet { "PSNR " (score(view.score.psnr, 2)) " dB" }
                @if let fitted @ Some(_) = view.score.psnr_fitted {
                    span.quiet { (score(fitted, 2)) " dB with its exposure fitted" }
                }
                span.quiet { "SSIM " (score(view.score.ssim, 4)) }
            }
            div.pictures {
                div.slider style=(format!("--ratio: {width} / {height}")) {
                    figure { (image(&shown, &format!("{truth} of {name}"))) figcaption { (truth) } }
                    figure { (image(&rendered, &format!("Trained scene in {name}"))) figcaption { "Trained scene" } }
                    input type="range" min="0" max="100" value="50" step="0.5"
                        aria-label=(format!("Share of the {} in {}", truth.to_lowercase(), clean(name)));
                }
                figure.error { (image(&error, &format!("Error of {name}"))) figcaption { "Error" } }
            }
        }
    }
}

fn titles<const N: usize>(titles: [&str; N]) -> Vec<String> {
    titles.map(str::to_owned).to_vec()
}

/// All evaluations, and all views of the last one.
fn scores(evaluations: &[Evaluation<'_>]) -> Markup {
    let Some(last) = evaluations.last() else { return Markup::default() };
    // a run that learns exposures also has scores with exposures fitted
    let scores = if last.mean.psnr_fitted.is_some() { 3 } else { 2 };
    let heads = |first: &[&str]| {
        let all = [first, &["PSNR, dB", "SSIM", "PSNR with exposures fitted, dB"]].concat();
        all.into_iter().take(first.len() + scores).map(str::to_owned).collect::<Vec<_>>()
    };
    let row = |mut cells: Vec<String>, found: &Score| {
        let all = [(found.psnr, 2), (found.ssim, 4), (found.psnr_fitted, 2)];
        cells.extend(all.into_iter().take(scores).map(|(value, digits)| score(value, digits)));
        cells
    };
    let mean =
        |one: &Evaluation<'_>| row(vec![grouped(one.step), duration(one.seconds)], &one.mean);
    let means: Vec<_> = thinned(evaluations.to_vec(), MAX_ROWS).iter().map(mean).collect();
    let view = |view: &ViewScore| row(vec![view.name.clone()], &view.score);
    let views: Vec<_> = last.views.iter().map(view).collect();
    section(
        "Scores",
        &html! {
            details open[means.len() <= 12] {
                summary { "Mean of the held-out views at each evaluation" }
                (table("scores", &heads(&["Step", "Time"]), 0, &means))
            }
            details {
                summary { "Each of the " (views.len()) " held-out views after step " (grouped(last.step)) }
                (table("scores", &heads(&["View"]), 1, &views))
            }
        },
    )
}

/// A row for each start or resume: program, date and device.
fn sessions(run: &Run) -> Markup {
    let sessions = run.sessions();
    if sessions.is_empty() {
        return Markup::default();
    }
    section(
        "How it was run",
        &html! {
            @for (step, session) in &sessions {
                dl.session {
                    dt { "Began" }
                    dd { (clean(&date(&session.date))) @if *step > 0 { ", after step " (grouped(*step)) } }
                    @if let Some(command) = &session.command { dt { "Command" } dd { code { (clean(command)) } } }
                    dt { "Device" }
                    dd { (clean(&session.device)) }
                    dt { "Organza" }
                    dd {
                        (clean(&session.version))
                        @if let Some(commit) = &session.commit { ", commit " code { (clean(commit)) } }
                    }
                }
            }
        },
    )
}

fn timing(run: &Run) -> Markup {
    /// Number of longest stages that are shown without unfolding.
    const LONGEST: usize = 8;
    let rows = run.timing();
    let (first, rest) = rows.split_at(rows.len().min(LONGEST));
    if first.is_empty() {
        return Markup::default();
    }
    section(
        "Where the time went",
        &html! {
            p.quiet { "Kernels in the last session, the longest first." }
            (timing_table(first))
            @if !rest.is_empty() {
                details { summary { (rest.len()) " more" } (timing_table(rest)) }
            }
        },
    )
}

fn timing_table(rows: &[TimingRow]) -> Markup {
    html! { div.scroll { table.timing {
        thead { tr {
            th scope="col" { "Stage" } th.number scope="col" { "Time" }
            th.number scope="col" { "Share" } th.bar {}
        } }
        tbody { @for row in rows {
            @let share = 100.0 * row.share;
            @let width = if share.is_finite() { share.clamp(0.0, 100.0) } else { 0.0 };
            tr {
                td { (clean(&row.stage)) }
                td.number { (duration(row.seconds)) }
                td.number { (format!("{share:.1} %")) }
                td.bar { span style=(format!("width: {width:.1}%")) {} }
            }
        } }
    } } }
}

/// The settings as in `config.toml`: first the ones that differ from the defaults.
fn settings(run: &Run) -> Markup {
    let all = run.config.list();
    let defaults = TrainConfig::default().list();
    let default = |name: &str| {
        let found = defaults.iter().find(|(other, _)| other == name);
        found.map_or_else(|| "–".to_owned(), |(_, value)| value.clone())
    };
    let changed = all.iter().filter(|(name, value)| default(name) != *value);
    let changed: Vec<_> =
        changed.map(|(name, value)| vec![name.clone(), value.clone(), default(name)]).collect();
    let rows: Vec<_> = all.iter().map(|(name, value)| vec![name.clone(), value.clone()]).collect();
    section(
        "Settings",
        &html! {
            @for change in run.changes() {
                p.quiet {
                    "After step " (grouped(change.step)) ", a resume changed " code { (clean(&change.name)) }
                    " from " (clean(&change.from.to_string())) " to " (clean(&change.to.to_string())) "."
                }
            }
            @if changed.is_empty() {
                p.quiet { "All settings have their defaults." }
            } @else {
                (table("settings changed", &titles(["Changed setting", "Value", "Default"]), 3, &changed))
            }
            details {
                summary { "All " (rows.len()) " settings" }
                (table("settings", &titles(["Setting", "Value"]), 2, &rows))
            }
        },
    )
}
