//! `organza train-all`: trains on several captures and compares them in one table.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use organza::metrics::lpips::Lpips;
use organza::train::report::{Run, Summary};
use organza::train::{self, CHECKPOINT, CONFIG, Outcome, REPORT};
use organza::{Result, Scene};
use organza_core::write_inside;
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::device::DeviceArgs;
use super::signals::Signals;
use super::summary::Table;
use super::train::{SettingsArgs, TrainJob};
use super::{eval, refuse};

const EXAMPLES: &str = "\
Examples:
  organza train-all data/fox data/garden -o results --minutes 10
  organza train-all data/* -o small --steps 600 --downscale 4 --seed 1
  organza train-all data/fox -o results --lpips lpips-alex.safetensors

organza writes a training run for each capture to FOLDER, under the name of the capture's folder, and the table to \
results.md and results.csv. After Ctrl-C, the same command continues: it resumes an unfinished run and keeps finished ones.

PSNR and SSIM are those of the held-out views after the last step. MB is the size of the scene, in 10^6 bytes, \
without the state of training. Minutes are those of training, without evaluations. scripts/lpips-weights.py makes \
the file for --lpips.";

/// Train on several captures, and compare them in one table
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The data sets: folders of nerfstudio, Blender or COLMAP
    #[arg(required = true)]
    data: Vec<PathBuf>,
    /// The folder for the runs and the table; created if it does not exist
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Also measure LPIPS, with the weights in this file
    #[arg(long, value_name = "WEIGHTS")]
    lpips: Option<PathBuf>,
    /// Print JSON (docs/json.md)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    settings: SettingsArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Results {
    captures: Vec<Row>,
}

/// The results of a capture.
#[derive(Debug, Serialize)]
struct Row {
    name: String,
    psnr: Option<f64>,
    ssim: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lpips: Option<f64>,
    steps: u64,
    gaussians: usize,
    megabytes: f64,
    minutes: f64,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let signals = Signals::listen()?;
    let names = names(&args.data)?;
    // before training, so that a wrong file costs no time
    let lpips = args.lpips.as_ref().map(Lpips::load).transpose()?;
    let mut rows = Vec::new();
    for (data, name) in args.data.iter().zip(&names) {
        let folder = args.output.join(name);
        let resume = folder.join(CONFIG).exists();
        let config = match resume {
            true => train::settings_of(&folder)?,
            false => args.settings.settings(Some(data))?,
        };
        console.note(&format!("{name}: {}", folder.display()));
        let begin = Instant::now();
        let planned = if resume { None } else { args.settings.planned() };
        let time_limit = None;
        let view = None;
        let job =
            TrainJob { config, folder: &folder, resume, planned, time_limit, view, team: None };
        if job.run(&args.device, console, &signals, &mut |_| ())? == Outcome::Stopped {
            console.note("saved; the same command continues from here");
            return Ok(());
        }
        console
            .note(&format!("{name}: {:.1} minutes in all", begin.elapsed().as_secs_f64() / 60.0));
        let mut row = Row::from_run(name, &folder)?;
        // no PSNR: no view is held out
        if lpips.is_some() && row.psnr.is_some() {
            let eval = eval::Args::for_run(&folder, &args.device);
            row.lpips = eval.evaluate(lpips.as_ref(), console)?.mean.lpips;
        }
        rows.push(row);
        // after each run, so that finished results are there even if a later run fails
        let write = |name: &str, text: String| {
            write_inside(args.output.join(name), |writer| writer.write_all(text.as_bytes()))
        };
        write("results.md", markdown(&rows))?;
        write("results.csv", csv(&rows))?;
    }
    if args.json {
        print_json(&Results { captures: rows })
    } else {
        print(&table(&rows).to_string())
    }
}

/// The runs' names, which are those of the data sets' folders.
fn names(data: &[PathBuf]) -> Result<Vec<String>> {
    let mut taken = HashSet::new();
    data.iter()
        .map(|path| {
            let full = path.canonicalize().unwrap_or_else(|_| path.clone());
            // the folder of a data set's file has a better name than the file
            let full = if full.is_file() { full.parent().unwrap_or(&full) } else { &full };
            let Some(name) = full.file_name() else {
                return refuse(format!(
                    "{} has no name for its run; name the data set's own folder",
                    path.display()
                ));
            };
            let name = name.to_string_lossy().into_owned();
            if taken.insert(name.clone()) {
                return Ok(name);
            }
            refuse(format!("two captures are named {name}; put one into a folder of another name"))
        })
        .collect()
}

impl Row {
    /// Reads the results of a finished run.
    fn from_run(name: &str, folder: &Path) -> Result<Self> {
        let run = Run::load(folder)?;
        let Summary { psnr, ssim, seconds, .. } = run.summary();
        let scene = Scene::load(folder.join(CHECKPOINT))?;
        let bytes: usize = scene.tensors().iter().map(|(_, values)| size_of_val(&**values)).sum();
        Ok(Self {
            name: name.to_owned(),
            psnr,
            ssim,
            lpips: None,
            steps: run.last_step(),
            gaussians: scene.gaussians.len(),
            megabytes: bytes as f64 / 1e6,
            minutes: seconds / 60.0,
        })
    }

    /// The row's numbers as text. `none` replaces a missing one.
    fn cells(&self, none: &str) -> [String; 8] {
        let number = |value: Option<f64>, digits: usize| {
            value.map_or(none.to_owned(), |value| format!("{value:.digits$}"))
        };
        [
            self.name.clone(),
            number(self.psnr, 2),
            number(self.ssim, 4),
            number(self.lpips, 4),
            self.steps.to_string(),
            self.gaussians.to_string(),
            format!("{:.2}", self.megabytes),
            format!("{:.2}", self.minutes),
        ]
    }
}

const TITLES: [&str; 8] =
    ["capture", "PSNR", "SSIM", "LPIPS", "steps", "Gaussians", "MB", "minutes"];

/// A row, without the column of LPIPS if it was not measured.
fn shown<T>(rows: &[Row], cells: [T; 8]) -> Vec<T> {
    let has_lpips = rows.iter().any(|row| row.lpips.is_some());
    let is_shown = |title: &str| has_lpips || title != "LPIPS";
    TITLES
        .into_iter()
        .zip(cells)
        .filter_map(|(title, cell)| is_shown(title).then_some(cell))
        .collect()
}

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new(1, shown(rows, TITLES));
    rows.iter().for_each(|row| table.row(shown(rows, row.cells("-"))));
    table
}

fn markdown(rows: &[Row]) -> String {
    let titles = shown(rows, TITLES);
    let mut text =
        format!("| {} |\n| --- |{}\n", titles.join(" | "), " ---: |".repeat(titles.len() - 1));
    for row in rows {
        let mut cells = shown(rows, row.cells("-"));
        // characters that would end a cell or a link
        let name = cells[0].replace(['|', '[', ']', '\n'], "_");
        let link = row.name.replace(' ', "%20").replace(['(', ')', '|', '\n'], "_");
        cells[0] = if link == row.name.replace(' ', "%20") {
            format!("[{name}]({link}/{REPORT})")
        } else {
            name
        };
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text
}

fn csv(rows: &[Row]) -> String {
    let mut text = shown(rows, TITLES).join(",") + "\n";
    for row in rows {
        let mut cells = shown(rows, row.cells(""));
        cells[0] = format!("\"{}\"", row.name.replace('"', "\"\""));
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}
