//! `organza compare`: training runs side by side.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use organza::Result;
use organza::data::Poses;
use organza::train::report::{Difference, Run, differences};
use organza::train::{Binding, TrainConfig};
use serde_json::json;

use super::console::{Console, print, print_json};
use super::inputs::SceneSource;
use super::summary::{Table, grouped, score};
use super::{refuse, text_of};

/// Compare training runs: their results, and the settings that differ
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/compare.txt"))]
pub struct Args {
    /// The runs' folders
    #[arg(value_name = "RUN", required = true, num_args = 2..)]
    runs: Vec<PathBuf>,
    /// Print the results as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let mut runs = Vec::new();
    let mut seen = HashSet::new();
    for folder in &args.runs {
        let name = text_of(folder);
        // a folder may have several names
        if !seen.insert(fs::canonicalize(folder).unwrap_or_else(|_| folder.clone())) {
            return refuse(format!("the run {name} is named twice"));
        }
        if folder.is_file() {
            return refuse(format!(
                "{name} is a file: name runs by their folders. `organza eval` measures a scene or a checkpoint alone"
            ));
        }
        runs.push((name, Run::load(folder)?));
    }
    warn_of_data(&args.runs, console)?;
    if args.json { print_json(&as_json(&runs)) } else { print(&as_text(&runs)) }
}

/// Warns of runs that were trained on different data, and of data that has changed since.
fn warn_of_data(folders: &[PathBuf], console: Console) -> Result<()> {
    let mut first: Option<(&Path, Binding)> = None;
    for folder in folders {
        // a run that has just begun has no checkpoint
        let Ok(source) = SceneSource::find(folder) else { continue };
        let trained = Binding::load(source.file())?;
        if let Some((other, on)) = &first
            && let Some(what) = trained.data().difference(on.data())
        {
            let other = other.display();
            let run = folder.display();
            console.warn(&format!(
                "{other} and {run} were trained on different data: their {what} differ"
            ));
        }
        let settings = source.settings().ok().flatten();
        let data = settings.and_then(|TrainConfig { data, .. }| {
            Poses::load(data.path.as_ref()?, &data.options()).ok()
        });
        if let Some(poses) = data
            && let Some(what) = poses.difference(trained.data())
        {
            let data = poses.dataset.path.display();
            let run = folder.display();
            console.warn(&format!(
                "{data}: its {what} have changed since {run} was trained, whose scores are of the data as it was"
            ));
        }
        first.get_or_insert((folder, trained));
    }
    Ok(())
}

fn as_json(runs: &[(String, Run)]) -> serde_json::Value {
    let settings = differences(runs.iter().map(|(_, run)| run));
    let setting = |found: Difference| json!({ "name": found.setting, "values": found.values });
    json!({
        "runs": runs.iter().map(result).collect::<Vec<_>>(),
        "settings": settings.into_iter().map(setting).collect::<Vec<_>>(),
    })
}

fn result((name, run): &(String, Run)) -> serde_json::Value {
    let summary = run.summary();
    json!({
        "run": name,
        "psnr": summary.mean.psnr,
        "ssim": summary.mean.ssim,
        "step": summary.step,
        "seconds": summary.seconds,
        "gaussians": summary.gaussians,
        "tiles_per_second": summary.tiles_per_second,
    })
}

fn as_text(runs: &[(String, Run)]) -> String {
    let mut results = Table::new(1, ["run", "PSNR", "SSIM", "steps", "seconds", "Gaussians"]);
    for (name, run) in runs {
        let summary = run.summary();
        results.row([
            name.clone(),
            score(summary.mean.psnr, 2),
            score(summary.mean.ssim, 4),
            grouped(summary.step),
            format!("{:.1}", summary.seconds),
            summary.gaussians.map_or_else(|| "-".to_owned(), grouped),
        ]);
    }
    let mut text = results.to_string();
    let differences = differences(runs.iter().map(|(_, run)| run));
    if differences.is_empty() {
        return text + "\nall settings are the same\n";
    }
    for difference in differences {
        text += &format!("\n{}\n", difference.setting);
        for ((name, _), value) in runs.iter().zip(difference.values) {
            text += &format!("  {name}: {}\n", value.as_deref().unwrap_or("not set"));
        }
    }
    text
}
