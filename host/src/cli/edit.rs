//! `organza edit`: removes Gaussians from a scene.

use std::path::PathBuf;

use organza::data::{Background, Dataset};
use organza::edit::Region;
use organza::render::Contributions;
use organza::scene::Placement;
use organza::{Camera, Renderer, Result, Scene};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, DataSet, SceneSource, Split};
use super::output::check_scene_file;
use super::summary::{Table, count, grouped};
use super::{eval, number_in, numbers, refuse, text_of};

const USAGE: &str = "organza edit SCENE DATA -o NEW";

const EXAMPLES: &str = "\
Examples:
  organza edit run -o small.safetensors --min-contribution      without what no photograph shows
  organza edit run -o clean.safetensors --clean 0.3               without floaters; view --edit shows each strength
  organza edit run -o cropped.safetensors --box -1,-1,0,1,1,2
  organza edit run -o rest.safetensors --sphere 0,0,1,0.5 --outside
  organza edit scene.safetensors data/fox -o small.safetensors --min-contribution=0.5
  organza edit run -o in-meters.safetensors --measured 0,0,0,1.2,0,0.4,0.25    two points, 25 cm apart

The rules apply in this order: box and sphere, contribution, floaters. Contribution and floaters are \
measured once, in the scene that box and sphere have left. \
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
    /// Keep what is inside a ball: its center and its radius
    #[arg(long, value_name = "X,Y,Z,R", value_parser = parse_sphere, allow_hyphen_values = true)]
    sphere: Option<([f64; 3], f64)>,
    /// Remove what is inside the box or the ball, instead of what is outside
    #[arg(long)]
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
    #[arg(long, value_name = "METERS", conflicts_with = "measured")]
    #[arg(value_parser = number_in(f64::MIN_POSITIVE.., "meters above 0"))]
    scale: Option<f64>,
    /// The scene's scale, from two points of the data set's space and their distance in meters
    #[arg(long, value_name = "X,Y,Z,X,Y,Z,METERS", value_parser = parse_measured, allow_hyphen_values = true)]
    measured: Option<f64>,
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

fn parse_sphere(text: &str) -> Result<([f64; 3], f64), String> {
    match numbers(text) {
        Some([x, y, z, radius]) if radius > 0.0 => Ok(([x, y, z], radius)),
        _ => Err("expected a center and a radius X,Y,Z,R such as 0,0,1,0.5".to_owned()),
    }
}

/// Meters in one unit, given two points and the meters between them.
fn parse_measured(text: &str) -> Result<f64, String> {
    let scale = numbers(text).map(|[a, b, c, d, e, f, meters]: [f64; 7]| {
        meters / [a - d, b - e, c - f].iter().map(|x| x * x).sum::<f64>().sqrt()
    });
    scale.filter(|scale| scale.is_normal() && *scale > 0.0).ok_or_else(|| {
        "expected two different points and their distance X,Y,Z,X,Y,Z,METERS such as 0,0,0,1,0,0,0.25"
            .to_owned()
    })
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
    /// Of the held-out views, in decibels.
    psnr_before: Option<f64>,
    psnr: Option<f64>,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    args.check()?;
    let source = SceneSource::find(&args.scene)?;
    let inputs: Vec<_> = [source.named()].into_iter().chain(args.data.as_deref()).collect();
    check_scene_file(&args.output, &inputs)?;
    let scene = source.load(console)?;
    let gaussians_before = scene.gaussians.len();
    // before any view is rendered, so that a box beside the scene costs no time
    let mut edited = scene.clone();
    let mut removed = args.crop(&mut edited)?;
    let cameras = match args.renders_views() {
        true => Cameras::load(&source, args.data.as_deref(), &args.data_args, USAGE, console)?.list,
        false => Vec::new(),
    };
    let renderer = args.device.open(console)?;
    let photographs = photographs(args, &source, &scene, &renderer, console)?;
    let psnr = |scene: &Scene| match &photographs {
        Some(photographs) => held_out_psnr(photographs, scene, &renderer, console),
        None => Ok(None),
    };
    let psnr_before = psnr(&scene)?;
    if !cameras.is_empty() {
        args.by_contribution(&mut edited, &cameras, &renderer, &mut removed, console)?;
    }
    let placement = &mut edited.config.placement;
    placement.meters = args.scale.or(args.measured).or(placement.meters);
    edited.save(&args.output)?;
    let report = Report {
        scene: text_of(&args.output),
        gaussians_before,
        removed,
        gaussians: edited.gaussians.len(),
        psnr_before,
        psnr: psnr(&edited)?,
    };
    console.note(&format!("wrote {}", args.output.display()));
    if args.json { print_json(&report) } else { print(&text(&report)) }
}

impl Args {
    fn check(&self) -> Result<()> {
        let has_region = self.cuboid.is_some() || self.sphere.is_some();
        if self.outside && !has_region {
            return refuse("`--outside` needs `--box` or `--sphere`");
        }
        let has_scale = self.scale.is_some() || self.measured.is_some();
        if has_region || self.renders_views() || has_scale {
            return Ok(());
        }
        refuse(
            "there is nothing to do: give `--box`, `--sphere`, `--min-contribution`, `--clean`, \
             `--scale` or `--measured`",
        )
    }

    /// Whether a rule looks at what Gaussians contribute to views.
    fn renders_views(&self) -> bool {
        self.min_contribution.is_some() || self.clean.is_some()
    }

    /// Box and sphere, in the scene's coordinates.
    fn regions(&self, placement: &Placement) -> Vec<(Region, &'static str)> {
        let own = |place| placement.own(place).map(|x| x as f32);
        let cuboid = self.cuboid.map(|corners| {
            let [a, b] = corners.map(own);
            let low = std::array::from_fn(|axis| a[axis].min(b[axis]));
            let high = std::array::from_fn(|axis| a[axis].max(b[axis]));
            (Region::Box { low, high }, "box")
        });
        let sphere = self.sphere.map(|(center, radius)| {
            let radius = (radius / placement.scale) as f32;
            (Region::Sphere { center: own(center), radius }, "ball")
        });
        cuboid.into_iter().chain(sphere).collect()
    }

    /// Applies box and sphere.
    fn crop(&self, scene: &mut Scene) -> Result<Vec<Removed>> {
        let mut removed = Vec::new();
        let side = if self.outside { "inside" } else { "outside" };
        for (region, name) in self.regions(&scene.config.placement) {
            let is_kept = |i: usize, scene: &Scene| {
                region.contains(scene.gaussians.position[i]) != self.outside
            };
            removed.push(keep(scene, format!("{side} the {name}"), is_kept)?);
        }
        Ok(removed)
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

/// The held-out photographs, if there are any.
fn photographs(
    args: &Args,
    source: &SceneSource,
    scene: &Scene,
    renderer: &Renderer,
    console: Console,
) -> Result<Option<Dataset>> {
    let named = args.data.as_deref();
    let has_photographs = match named {
        Some(named) => args.data_args.names_photographs(named),
        None => source.settings()?.is_some(),
    };
    if !has_photographs {
        return Ok(None);
    }
    let mut settings = args.data_args.settings(source, named, USAGE)?;
    let of_scene = scene.config.background.map(|value| value.clamp(0.0, 1.0) as f32);
    settings.background = Background::Color(of_scene);
    let data = DataSet::of(source, named, settings, console)?;
    if !data.cameras()?.iter().any(|pose| pose.held_out) {
        console.note("no photograph is held out, so PSNR is not measured");
        return Ok(None);
    }
    data.only(Split::HeldOut)?.read(renderer, console).map(Some)
}

fn held_out_psnr(
    photographs: &Dataset,
    scene: &Scene,
    renderer: &Renderer,
    console: Console,
) -> Result<Option<f64>> {
    let uploaded = renderer.upload(scene)?;
    let frames: Vec<_> = photographs.held_out_frames().collect();
    let measured = eval::measure(renderer, &uploaded, &frames, false, console)?;
    Ok(measured.mean.psnr)
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
    let mut text = table.to_string();
    if let (Some(before), Some(after)) = (report.psnr_before, report.psnr) {
        let change = after - before;
        text += &format!(
            "\nheld-out PSNR: {before:.3} dB before, {after:.3} dB after ({change:+.3})\n"
        );
    }
    text
}
