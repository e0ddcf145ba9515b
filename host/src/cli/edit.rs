//! `organza edit`: removes Gaussians from a scene.

use std::path::PathBuf;

use organza::render::Contributions;
use organza::scene::is_in_box;
use organza::{Camera, Renderer, Result, Scene};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, SceneSource};
use super::output::check_scene_file;
use super::summary::{Table, count, grouped};
use super::{number_in, numbers, refuse, text_of};

const EXAMPLES: &str = "\
Examples:
  organza edit run -o small.safetensors --min-contribution    without what no photograph shows
  organza edit run -o clean.safetensors --clean 0.3           without floaters, as view --edit shows
  organza edit run -o cropped.safetensors --box -1,-1,0,1,1,2
  organza edit run -o rest.safetensors --box -1,-1,0,1,1,2 --outside
  organza edit scene.safetensors data/fox -o small.safetensors --min-contribution=0.5
  organza edit run -o in-meters.safetensors --scale 0.2       a unit of the data set is 20 cm

The rules apply in this order: box, contribution, floaters. Contribution and floaters are measured once, in the scene \
that the box has left. \
The result is a scene's file, for every command that takes a scene.";

/// Remove Gaussians from a scene: crop it, clean it, make it smaller; or give it a scale
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The views that count: nerfstudio's transforms.json, or a data set [default: the run's]
    data: Option<PathBuf>,
    /// The file of the new scene, safetensors; an older file of this name is replaced
    #[arg(short, long, value_name = "NEW")]
    output: PathBuf,
    /// Keep what is inside an upright box: two opposite corners. Its edges lie along the scene's own axes
    #[arg(long = "box", value_name = "X,Y,Z,X,Y,Z", value_parser = parse_box, allow_hyphen_values = true)]
    cuboid: Option<[[f64; 3]; 2]>,
    /// Remove what is inside the box, instead of what is outside
    #[arg(long, requires = "cuboid")]
    outside: bool,
    /// Remove Gaussians that contribute no more than this to all views together, in pixels. With 0, the views stay as
    /// they are, to the bit
    #[arg(long, value_name = "PIXELS", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "0", value_parser = number_in(0.0.., "pixels, 0 or more"))]
    min_contribution: Option<f64>,
    /// Remove floaters: what few views support. A strength from 0, which removes nothing, to 1; 0.3 is a start
    #[arg(long, value_name = "STRENGTH", value_parser = number_in(0.0..=1.0, "a number from 0 to 1"))]
    clean: Option<f64>,
    /// The scene's scale: meters in one unit of its data set. Exported files are then in meters
    #[arg(long, value_name = "METERS")]
    #[arg(value_parser = number_in(f64::MIN_POSITIVE.., "meters above 0"))]
    scale: Option<f64>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data_args: DataArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

fn parse_box(text: &str) -> Result<[[f64; 3]; 2], String> {
    let corners = numbers(text).map(|[a, b, c, d, e, f]| [[a, b, c], [d, e, f]]);
    corners.ok_or_else(|| "expected two corners X,Y,Z,X,Y,Z such as -1,-1,0,1,1,2".to_owned())
}

/// The Gaussians that a rule has removed.
#[derive(Debug, Serialize)]
struct Removed {
    rule: String,
    gaussians: usize,
    /// Their share of the views' pixels, 0 to 1, if that was measured.
    weight: Option<f64>,
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Report {
    scene: String,
    gaussians_before: usize,
    removed: Vec<Removed>,
    gaussians: usize,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    if args.cuboid.is_none() && !args.renders_views() && args.scale.is_none() {
        return refuse(
            "there is nothing to do: give `--box`, `--min-contribution`, `--clean` or `--scale`",
        );
    }
    let source = SceneSource::find(&args.scene)?;
    let inputs: Vec<_> = [source.named()].into_iter().chain(args.data.as_deref()).collect();
    check_scene_file(&args.output, &inputs)?;
    let mut scene = source.load(console)?;
    let gaussians_before = scene.gaussians.len();
    // before any view is rendered, so that a box beside the scene costs no time
    let mut removed = args.crop(&mut scene)?;
    if args.renders_views() {
        let data = args.data.as_deref();
        let cameras = Cameras::load(&source, data, &args.data_args, console)?.list;
        let renderer = args.device.open(console)?;
        args.by_contribution(&mut scene, &cameras, &renderer, &mut removed, console)?;
    }
    let placement = &mut scene.config.placement;
    placement.meters = args.scale.or(placement.meters);
    scene.save(&args.output)?;
    let report = Report {
        scene: text_of(&args.output),
        gaussians_before,
        removed,
        gaussians: scene.gaussians.len(),
    };
    console.note(&format!("wrote {}", args.output.display()));
    if args.json { print_json(&report) } else { print(&text(&report)) }
}

impl Args {
    /// Whether a rule looks at what Gaussians contribute to views.
    fn renders_views(&self) -> bool {
        self.min_contribution.is_some() || self.clean.is_some()
    }

    /// Applies the box, which is given in coordinates of the world.
    fn crop(&self, scene: &mut Scene) -> Result<Vec<Removed>> {
        let Some(corners) = self.cuboid else { return Ok(Vec::new()) };
        let [a, b] = corners.map(|place| scene.config.placement.own(place).map(|x| x as f32));
        let low = std::array::from_fn(|axis| a[axis].min(b[axis]));
        let high = std::array::from_fn(|axis| a[axis].max(b[axis]));
        let side = if self.outside { "inside" } else { "outside" };
        let is_kept = |i: usize, scene: &Scene| {
            is_in_box([low, high], scene.gaussians.position[i]) != self.outside
        };
        Ok(vec![keep(scene, format!("{side} the box"), is_kept)?])
    }

    /// The rules for which views are rendered.
    fn by_contribution(
        &self,
        scene: &mut Scene,
        cameras: &[Camera],
        renderer: &Renderer,
        removed: &mut Vec<Removed>,
        console: Console,
    ) -> Result<()> {
        let uploaded = renderer.upload(scene)?;
        let mut found = Contributions::new(scene.gaussians.len());
        let bar = console.progress("measuring what Gaussians contribute", cameras.len(), "views");
        for (done, camera) in cameras.iter().enumerate() {
            renderer.add_contributions(&uploaded, camera, self.clean.is_some(), &mut found)?;
            bar.set_of(done + 1, cameras.len());
        }
        drop(bar);
        let mut rules = Vec::new();
        if let Some(min) = self.min_contribution {
            // a Gaussian that contributes NaN is visible, so it stays
            let is_removed = (0..scene.gaussians.len()).map(|i| found.pixels(i) <= min);
            let rule = match min {
                0.0 => "in no view".to_owned(),
                min => format!("{min} pixels or less in all views"),
            };
            rules.push((rule, is_removed.collect::<Vec<_>>()));
        }
        if let Some(strength) = self.clean {
            rules.push((format!("floaters, strength {strength}"), found.floaters(strength)));
        }
        // indices of the Gaussians that are left
        let mut left: Vec<_> = (0..scene.gaussians.len()).collect();
        for (rule, is_removed) in rules {
            let weight = found.weight(left.iter().copied().filter(|&i| is_removed[i]));
            let kept = keep(scene, rule, |i, _| !is_removed[left[i]])?;
            removed.push(Removed { weight: Some(weight), ..kept });
            left.retain(|&i| !is_removed[i]);
        }
        Ok(())
    }
}

/// Removes the other Gaussians. Fails if none would be left.
fn keep(
    scene: &mut Scene,
    rule: String,
    is_kept: impl Fn(usize, &Scene) -> bool,
) -> Result<Removed> {
    let before = scene.gaussians.len();
    let kept: Vec<_> = (0..before).filter(|&i| is_kept(i, scene)).collect();
    if kept.is_empty() {
        let all = count(before as u64, "Gaussian");
        return refuse(format!("nothing would be left: the rule `{rule}` removes all {all}"));
    }
    scene.gaussians = scene.gaussians.select(&kept);
    Ok(Removed { rule, gaussians: before - kept.len(), weight: None })
}

fn text(report: &Report) -> String {
    let mut table = Table::new(1, ["", "Gaussians", "of the views"]);
    let mut row = |name: &str, gaussians: String, weight: Option<f64>| {
        let weight = weight.map(|weight| format!("{:.2}%", 100.0 * weight));
        table.row([name.to_owned(), gaussians, weight.unwrap_or_default()]);
    };
    row("before", grouped(report.gaussians_before as u64), None);
    for Removed { rule, gaussians, weight } in &report.removed {
        let sign = if *gaussians > 0 { "-" } else { "" };
        row(rule, format!("{sign}{}", grouped(*gaussians as u64)), *weight);
    }
    row("after", grouped(report.gaussians as u64), None);
    table.to_string()
}
