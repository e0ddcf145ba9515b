//! The page that compares runs.

use std::collections::BTreeSet;
use std::path::Path;

use maud::{Markup, html};

use super::MAX_VIEWS;
use super::charts::Charts;
use super::page::{clean, curves, duration, image, page, score, section, table};
use super::pictures::{Content, Picture};
use super::run::Run;
use muslin_device::grouped;
use organza_core::{Result, write_atomic};

/// Largest number of pictures on the page: with many runs it shows few views.
const MAX_PICTURES: usize = 48;

/// A setting that differs between runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The setting's name.
    pub setting: String,
    /// Value in each run, as in `config.toml`; `None` if it is not set.
    pub values: Vec<Option<String>>,
}

/// The settings that differ between runs, in the order of `config.toml`, without `run.schedule`: no user sets it.
pub fn differences<'a>(runs: impl IntoIterator<Item = &'a Run>) -> Vec<Difference> {
    let lists: Vec<_> = runs.into_iter().map(|run| run.config.list()).collect();
    let mut seen = BTreeSet::new();
    let names = lists.iter().flatten().map(|(name, _)| name);
    let names = names.filter(|name| *name != "run.schedule" && seen.insert(*name));
    let value = |list: &Vec<(String, String)>, name: &str| {
        list.iter().find(|(other, _)| other == name).map(|(_, value)| value.clone())
    };
    let difference = |name: &String| {
        let values: Vec<_> = lists.iter().map(|list| value(list, name)).collect();
        let is_one = values.windows(2).all(|pair| pair[0] == pair[1]);
        (!is_one).then(|| Difference { setting: name.clone(), values })
    };
    names.filter_map(difference).collect()
}

/// Writes a page that shows runs side by side, each with its name, atomically.
///
/// # Errors
/// [`Error::WriteFile`](organza_core::Error::WriteFile).
pub fn write_comparison(path: impl AsRef<Path>, runs: &[(String, Run)]) -> Result<()> {
    let html = html(runs);
    write_atomic(path, |writer| writer.write_all(html.as_bytes()))
}

pub(super) fn html(runs: &[(String, Run)]) -> String {
    let charts = Charts::from_runs(runs);
    let names: Vec<_> = runs.iter().map(|(name, _)| clean(name)).collect();
    let body = html! {
        header {
            p.quiet { "Comparison of " (runs.len()) " training runs" }
            h1 { (names.join(", ")) }
        }
        (finals(runs))
        (views(runs))
        (settings(runs))
        (curves(&charts, &Markup::default()))
    };
    page(&format!("{} – organza", names.join(", ")), &charts, &body)
}

fn finals(runs: &[(String, Run)]) -> Markup {
    let titles =
        ["Run", "PSNR, dB", "SSIM", "Steps", "Time", "Gaussians", "Tiles/s"].map(str::to_owned);
    let row = |(name, run): &(String, Run)| {
        let summary = run.summary();
        vec![
            name.clone(),
            score(summary.psnr, 2),
            score(summary.ssim, 4),
            grouped(summary.step),
            duration(summary.seconds),
            summary.gaussians.map_or_else(|| "–".to_owned(), grouped),
            score(summary.tiles_per_second, 1),
        ]
    };
    let rows: Vec<_> = runs.iter().map(row).collect();
    section(
        "Results",
        &html! {
            p.quiet { "Means of the held-out views at each run's last evaluation, with the steps and the time until then." }
            (table("finals", &titles, 1, &rows))
        },
    )
}

fn settings(runs: &[(String, Run)]) -> Markup {
    let differences = differences(runs.iter().map(|(_, run)| run));
    let mut titles = vec!["Setting".to_owned()];
    titles.extend(runs.iter().map(|(name, _)| name.clone()));
    let row = |difference: Difference| {
        let values = difference.values.into_iter();
        let values = values.map(|value| value.unwrap_or_else(|| "–".to_owned()));
        std::iter::once(difference.setting).chain(values).collect()
    };
    let rows: Vec<Vec<String>> = differences.into_iter().map(row).collect();
    section(
        "Settings that differ",
        &html! {
            @if rows.is_empty() {
                p.quiet { "All settings are the same." }
            } @else {
                (table("settings", &titles, titles.len(), &rows))
            }
        },
    )
}

/// The views that all runs hold out: each run's image beside the photograph.
fn views(runs: &[(String, Run)]) -> Markup {
    let evaluations: Vec<_> =
        runs.iter().map(|(_, run)| run.evaluations().last().copied()).collect();
    let Some(Some(first)) = evaluations.first() else { return Markup::default() };
    let truth = runs[0].1.truth();
    let rows = (MAX_PICTURES / (runs.len() + 1)).clamp(1, MAX_VIEWS);
    let row = |name: &String| {
        let mut photograph = None;
        let mut pictures: Vec<(Picture, Option<f64>)> = Vec::new();
        for ((_, run), evaluation) in runs.iter().zip(&evaluations) {
            let evaluation = evaluation.as_ref()?;
            let index = evaluation.views.iter().position(|view| view.name == *name)?;
            let rendered = run.pictures.view(index, Content::Rendered(evaluation.step))?;
            photograph = photograph.or_else(|| run.pictures.view(index, Content::Photograph));
            pictures.push((rendered, evaluation.views[index].score.psnr));
        }
        Some((name.clone(), photograph?, pictures))
    };
    let names = first.views.iter().map(|view| &view.name);
    let rows: Vec<_> = names.filter_map(row).take(rows).collect();
    if rows.is_empty() {
        return section(
            "Held-out views",
            &html! { p.quiet { "The runs have no held-out view in common." } },
        );
    }
    section(
        "Held-out views",
        &html! {
            @for (name, photograph, pictures) in &rows {
                div.view {
                    h3 { span { (clean(name)) } }
                    div.row {
                        figure {
                            (image(photograph, &format!("{truth} of {name}")))
                            figcaption { span { (truth) } }
                        }
                        @for ((run, _), (picture, psnr)) in runs.iter().zip(pictures) {
                            figure {
                                (image(picture, &format!("{name}, rendered by {run}")))
                                figcaption { span { (clean(run)) } span { (score(*psnr, 2)) " dB" } }
                            }
                        }
                    }
                }
            }
        },
    )
}
