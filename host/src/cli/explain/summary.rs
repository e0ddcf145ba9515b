//! `organza explain --summary`: the distances of whole views' weight from their surfaces.

use organza::render::{Leakage, Renderer};
use organza::{Camera, DeviceScene, Result};
use serde::Serialize;

use super::super::console::{Console, print, print_json};
use super::super::table::Table;

/// Number of pixels per view that are measured.
const PIXELS: u32 = 1024;

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Summary {
    views: Vec<View>,
    mean: Leakage,
}

#[derive(Debug, Serialize)]
struct View {
    view: usize,
    name: Option<String>,
    #[serde(flatten)]
    leakage: Leakage,
}

/// Measures and prints the views with these indices.
pub fn run(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[Camera],
    views: &[usize],
    json: bool,
    console: Console,
) -> Result<()> {
    let bar = console.progress(views.len() as u64, "views");
    bar.say("summing up");
    let measure = |(done, &view): (usize, &usize)| {
        let leakage = renderer.leakage(scene, cameras, view, PIXELS)?;
        bar.set_of(done + 1, views.len());
        Ok(View { view, name: cameras[view].file_path.clone(), leakage })
    };
    let views = views.iter().enumerate().map(measure).collect::<Result<Vec<_>>>()?;
    drop(bar);
    let parts: Vec<_> = views.iter().map(|view| view.leakage).collect();
    let summary = Summary { views, mean: Leakage::mean(&parts) };
    if json { print_json(&summary) } else { print(&text(&summary)) }
}

fn text(summary: &Summary) -> String {
    let titles = ["view", "image", "pixels", "Gaussians a pixel", "behind", "in front", "S < 0.98"];
    let mut table = Table::new(2, titles);
    let mut row = |view: &str, name: &str, leakage: &Leakage| {
        table.row([
            view.to_owned(),
            name.to_owned(),
            leakage.pixels.to_string(),
            format!("{:.1}", leakage.members),
            percent(leakage.behind),
            percent(leakage.in_front),
            percent(leakage.open),
        ]);
    };
    for view in &summary.views {
        row(&view.view.to_string(), view.name.as_deref().unwrap_or(""), &view.leakage);
    }
    row("mean", "", &summary.mean);
    table.to_string()
}

fn percent(share: f64) -> String {
    format!("{:.1}%", 100.0 * share)
}
