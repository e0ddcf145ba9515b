//! `organza edit`: removes Gaussians from a scene.

use std::path::PathBuf;

use organza::data::{Frame, Pose};
use organza::error;
use organza::render::Contributions;
use organza::scene::is_in_box;
use organza::view::Photographs;
use organza::{DeviceScene, Renderer, Result, Scene};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::device::DeviceArgs;
use super::eval::measure;
use super::inputs::{Cameras, DataArgs, SceneSource, Split};
use super::output::check_scene_file;
use super::summary::{Table, count, grouped, score};
use super::{number_in, numbers, refuse, text_of};

/// Loss of PSNR that is worth a warning, in dB.
const NOTICED: f64 = 0.3;

/// Remove Gaussians from a scene: crop it, clean it, make it smaller; or give it a scale
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/edit.txt"))]
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
    /// Remove floaters: what most views see through. A strength from 0, which removes nothing, to 1; 0.3 is a start
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

/// How close the scene is to held-out photographs, before and after the rules that look at views.
#[derive(Debug, Serialize)]
struct HeldOut {
    photographs: usize,
    psnr_before: Option<f64>,
    psnr: Option<f64>,
}

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Report {
    scene: String,
    gaussians_before: usize,
    removed: Vec<Removed>,
    gaussians: usize,
    /// `None` if there are no held-out photographs, or if no view was looked at.
    held_out: Option<HeldOut>,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    if args.cuboid.is_none() && !args.renders_views() && args.scale.is_none() {
        return refuse(
            "there is nothing to do: give `--box`, `--min-contribution`, `--clean` or `--scale`",
        );
    }
    let source = SceneSource::find(&args.scene)?;
    check_scene_file(&args.output, [source.named()].into_iter().chain(args.data.as_deref()))?;
    let mut scene = source.load(console)?;
    let gaussians_before = scene.gaussians.len();
    // before any view is rendered, so that a box beside the scene costs no time
    let mut removed = args.crop(&mut scene)?;
    let mut held_out = None;
    if args.renders_views() {
        let mut views = args.views(&source, console)?;
        let renderer = args.device.open(console)?;
        let before = renderer.upload(&scene)?;
        let mut found = Contributions::new(before.len());
        args.look(&before, &mut views, &renderer, &mut found, console)?;
        while let Some(gaussians) = args.clean.filter(|s| *s > 0.0).and_then(|_| found.next_look())
        {
            let scene = Scene { gaussians: scene.gaussians.select(&gaussians), ..scene.clone() };
            args.look(&renderer.upload(&scene)?, &mut views, &renderer, &mut found, console)?;
        }
        args.by_contribution(&mut scene, &found, &mut removed)?;
        let scenes = [&before, &renderer.upload(&scene)?];
        held_out = views.compare(scenes, &renderer, console)?;
    }
    let placement = &mut scene.config.placement;
    placement.meters = args.scale.or(placement.meters);
    scene.save(&args.output)?;
    let report = Report {
        scene: text_of(&args.output),
        gaussians_before,
        removed,
        gaussians: scene.gaussians.len(),
        held_out,
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

    /// The views that count.
    fn views(&self, source: &SceneSource, console: Console) -> Result<Views> {
        let Cameras { list, data, .. } =
            Cameras::load(source, self.data.as_deref(), &self.data_args, console)?;
        let Some(mut data) = data else {
            let poses = list.into_iter().map(Pose::from).collect();
            return Ok(Views { poses, photographs: Photographs::default(), split: Split::All });
        };
        let poses = data.cameras()?;
        if poses.iter().any(|pose| pose.held_out) {
            data.say_doubt(Split::HeldOut, console);
        }
        let photographs = data.photographs().0;
        Ok(Views { poses, photographs, split: self.data_args.split(Split::All) })
    }

    /// Adds what Gaussians contribute to the views.
    fn look(
        &self,
        scene: &DeviceScene,
        views: &mut Views,
        renderer: &Renderer,
        found: &mut Contributions,
        console: Console,
    ) -> Result<()> {
        let Views { poses, photographs, split } = views;
        let chosen = poses.iter().enumerate().filter(|(_, pose)| split.takes(pose.held_out));
        let chosen: Vec<_> = chosen.collect();
        let what = match found.looks() {
            1 => "measuring what Gaussians contribute",
            _ => "looking for floaters again",
        };
        let bar = console.progress(what, chosen.len(), "views");
        for view in chosen {
            match self.clean {
                Some(_) => photographs.add_contributions(renderer, scene, view, found)?,
                None => renderer.add_contributions(scene, &view.1.camera, None, found)?,
            }
            bar.advance(1);
        }
        Ok(())
    }

    /// The rules for which views are rendered.
    fn by_contribution(
        &self,
        scene: &mut Scene,
        found: &Contributions,
        removed: &mut Vec<Removed>,
    ) -> Result<()> {
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

/// The views that count, and their photographs.
struct Views {
    poses: Vec<Pose>,
    photographs: Photographs,
    split: Split,
}

impl Views {
    /// Compares the scene before and after with the held-out photographs, if there are any.
    fn compare(
        self,
        scenes: [&DeviceScene; 2],
        renderer: &Renderer,
        console: Console,
    ) -> Result<Option<HeldOut>> {
        let Self { poses, mut photographs, .. } = self;
        let mut frames = Vec::new();
        let views = poses.iter().enumerate().filter(|(_, pose)| pose.held_out);
        for (view, Pose { camera, .. }) in views {
            // the scene is edited also where a photograph has changed
            match photographs.get(renderer, view) {
                Ok(image) => frames.push(Frame {
                    name: camera.file_path.clone().unwrap_or_default(),
                    camera: camera.clone(),
                    image: image.as_ref().clone(),
                }),
                Err(error) => console.warn(&format!("not measured: {}", error::chain(&error))),
            }
        }
        let frames: Vec<_> = frames.iter().filter(|frame| !frame.image.is_hidden()).collect();
        if frames.is_empty() {
            return Ok(None);
        }
        let mut psnr = [None; 2];
        for (psnr, scene) in psnr.iter_mut().zip(scenes) {
            *psnr = measure(renderer, scene, &frames, false, console)?.mean.psnr;
        }
        let [psnr_before, psnr] = psnr;
        let found = HeldOut { photographs: frames.len(), psnr_before, psnr };
        if let Some(gain) = found.gain().filter(|gain| *gain < -NOTICED) {
            console.warn(&format!(
                "this costs {:.2} dB on photographs that training has not seen: look at the scene, or remove less",
                -gain
            ));
        }
        Ok(Some(found))
    }
}

impl HeldOut {
    fn gain(&self) -> Option<f64> {
        self.psnr.zip(self.psnr_before).map(|(after, before)| after - before)
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
    let mut text = table.to_string();
    if let Some(found) = &report.held_out {
        let photographs = count(found.photographs as u64, "held-out photograph");
        let psnr = score(found.psnr, 2);
        let gain = found.gain().map_or("-".to_owned(), |gain| format!("{gain:+.2}"));
        text += &format!("\non {photographs}: {psnr} dB, {gain} dB\n");
    }
    text
}
